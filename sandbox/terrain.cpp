#include "core/files.h"
#include "core/log.h"
#include "sandbox/commands.h"

namespace alpenglow {

int terrain(TerrainCommandOptions const& options) {
    require_writable_folder(options.out.parent_path());
    write_terrain(options.terrain, options.out);
    log_info("wrote " + options.out.string());
    return 0;
}

} // namespace alpenglow
