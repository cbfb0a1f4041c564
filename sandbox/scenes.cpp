#include "core/files.h"
#include "core/log.h"
#include "sandbox/commands.h"
#include "terrain/shaft_scenes.h"

namespace alpenglow {

int scenes(ScenesOptions const& options) {
    require_writable_folder(options.out);
    for (ShaftScene const& scene : shaft_scenes()) {
        std::filesystem::path const file = options.out / (std::string(scene.name) + ".glb");
        scene.make().write(file);
        log_info("wrote " + file.string());
    }
    return 0;
}

} // namespace alpenglow
