#pragma once

#include "interop/terrain_light.h"
#include "render/cascades.h"
#include "scene/planet.h"

namespace alpenglow {

/// Where the map of the light on a scene's terrain lies (shaders/interop/terrain_light.h): a square over the scene, seen
/// from above. It knows neither camera nor sun.
struct TerrainFit {
    int size = 0;             ///< [texels] along a side; 0: no map
    glm::dvec3 origin{0};     ///< the scene's, world [m]
    glm::dmat3 axes{1};       ///< columns: level, level, up; unit, world
    glm::dvec2 lowest{0};     ///< (x, y) of the map's corner [m]
    double texel = 0;         ///< [m]
    double bottom = 0, top = 0; ///< heights above the origin [m]
    double planet_radius = 0; ///< [m]

    bool operator==(TerrainFit const&) const = default;
};

/// Half way up in the middle of the map, world [m].
glm::dvec3 middle(TerrainFit const& fit);

/// `size`: texels along a side; 0 and a scene that spans more than a quarter of the planet's radius give a fit without a
/// map.
TerrainFit fit_terrain(ShadowScene const& scene, Planet const& planet, int size);

/// The matrix that draws the scene from above into the map, for vertices relative to the fit's origin in world axes.
glm::mat4 terrain_clip(TerrainFit const& fit);

/// What shaders need from a camera at `camera`, world [m].
shader::TerrainMap terrain_constants(TerrainFit const& fit, glm::dvec3 const& camera);

} // namespace alpenglow
