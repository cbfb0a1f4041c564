#pragma once

#include "core/extent.h"
#include "core/settings.h"
#include "interop/frame.h"
#include "render/atmosphere_constants.h"
#include "render/ceiling_fit.h"
#include "render/terrain_fit.h"
#include "scene/view.h"

namespace alpenglow {

constexpr double NEAR_PLANE = 0.1; // [m]

/// The supersamples of one pixel: offsets in pixels from its centre; a single one is the centre itself. `count` is a
/// square number.
glm::dvec2 supersample_offset(int index, int count);

/// interop/display.h's constant for a tone curve's name in the settings.
int curve_index(std::string_view name);

/// Everything the shaders know of a frame.
shader::FrameConstants make_frame_constants(World const& world, Settings const& settings, Extent extent,
                                            ShadowFit const& shadow, CeilingFit const& ceiling,
                                            TerrainFit const& terrain, int sample_index);

/// The name under which `show` knows the picture of which cascade shades what.
inline constexpr char const* SHOW_CASCADES = "cascades";

} // namespace alpenglow
