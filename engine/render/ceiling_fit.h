#pragma once

#include "interop/frame.h"
#include "render/cascades.h"
#include "scene/planet.h"

namespace alpenglow {

/// Where the map of the shadow ceiling lies (shaders/interop/shadow_ceiling.h): over the scene's footprint, turned to
/// the sun. It knows nothing of the camera, so that equal fits give equal maps.
struct CeilingFit {
    int size = 0;                     ///< [texels] along a side; 0: no map, nothing is shaded by it
    glm::dvec3 origin{0};             ///< the scene's, world [m]
    glm::dmat3 axes{1};               ///< columns: across, up, level towards the sun; unit, world
    glm::dvec2 sun{1, 0};             ///< cosine and sine of its elevation at the origin
    glm::dvec2 lowest{0}, highest{0}; ///< (across, towards the sun) of the map [m]
    double bottom = 0, top = 0;       ///< heights above the origin [m]
    double over = 0;                  ///< the ceiling is nowhere higher [m]
    double shaded_altitude = 0;       ///< no mesh shades the air above this altitude [m]
    double planet_radius = 0;         ///< [m]
    double sun_angular_radius = 0;    ///< [rad]

    bool operator==(CeilingFit const&) const = default;
    glm::dvec2 texel() const { return (highest - lowest) / static_cast<double>(size); } ///< [m]
};

/// `size`: texels along a side; 0 and what has no use for a map give a fit without one: no scene, one that spans more
/// than a quarter of the planet's radius, or a sun so low that the planet shades all air over the scene.
/// `highest` [m]: the highest place of any mesh above the planet's radius.
CeilingFit fit_ceiling(ShadowScene const& scene, double highest, Planet const& planet, glm::dvec3 const& to_sun,
                       int size);

/// The matrix that draws the scene from above into the map, for vertices relative to the fit's origin in world axes.
glm::mat4 ceiling_clip(CeilingFit const& fit);

/// What the pass needs to sweep the map.
shader::ShadowCeilingPush ceiling_push(CeilingFit const& fit);

/// What shaders need to look into the map from a camera at `camera`, world [m].
shader::ShadowCeiling ceiling_constants(CeilingFit const& fit, glm::dmat3 const& light_from_world,
                                        glm::dvec3 const& camera);

/// Where, relative to the camera in the sun's frame, meshes can shade the air: shader::FrameConstants::shaded_slabs.
/// Without a map the last cascade's square.
void set_shaded_slabs(shader::FrameConstants& frame, CeilingFit const& fit);

} // namespace alpenglow
