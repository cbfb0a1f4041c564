#pragma once

#include "scene/scene.h"
#include "scene/view.h"

#include <optional>

namespace alpenglow {

/// The view's scene, bent to the planet where its placement says so; the generated terrain is made where it is not
/// there yet. Nothing where the view has no scene. Throws Error(bad_input).
std::optional<Scene> load_scene(View const& view, double planet_radius);

} // namespace alpenglow
