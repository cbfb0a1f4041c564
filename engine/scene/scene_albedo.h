#pragma once

#include "scene/scene.h"

namespace alpenglow {

/// Mean base colour of a scene as seen from straight above, each surface by the area of its outline on the map, 0 to 1.
/// Pictures count by their mean. 0 where nothing faces up.
glm::vec3 albedo_from_above(Scene const& scene);

} // namespace alpenglow
