#include "core/log.h"
#include "sandbox/commands.h"
#include "sandbox/inspection.h"

#include <cstdio>

namespace alpenglow {

int inspect(InspectOptions const& options) {
    GltfSummary summary;
    Scene const scene = load_gltf(options.scene, {.scene_index = options.scene_index}, &summary);
    std::string const text = options.json ? inspection_json(scene, summary) : inspection_text(scene, summary);
    std::fputs(text.c_str(), stdout);
    return 0;
}

} // namespace alpenglow
