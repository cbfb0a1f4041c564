#pragma once

#include "terrain/gltf_writer.h"

#include <span>
#include <string_view>

namespace alpenglow {

/// A scene that throws shadows through the air. East is ahead of the camera, which stands near the scene's origin.
struct ShaftScene {
    std::string_view name; ///< also of its file, assets/scenes/NAME.glb
    GltfWriter (*make)();  ///< the same bytes at each call and on each machine
};

std::span<ShaftScene const> shaft_scenes();

} // namespace alpenglow
