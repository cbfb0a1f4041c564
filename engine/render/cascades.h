#pragma once

#include "render/gpu_scene.h"
#include "scene/camera.h"

#include <vector>

namespace alpenglow {

/// The sun's frame: x and y across its rays, z away from the sun. A world vector times this matrix. `axes`: unit
/// vectors at right angles; the frame turns with them, so that a scene's shadows have the same texels wherever it
/// stands.
glm::dmat3 light_from_world(glm::dvec3 const& to_sun, glm::dmat3 const& axes);

/// A square across the sun's rays, its centre on a grid of its own texels that is fixed to the scene's origin.
struct CascadeFit {
    glm::dvec2 centre{0};  ///< light frame, from the planet's centre [m]
    double half_width = 0; ///< [m]
    double texel = 0;      ///< [m]
};

struct ShadowFit {
    glm::dmat3 light_from_world{1};
    double nearest = 0, farthest = 0; ///< light z of the scene, from the planet's centre [m]
    std::vector<CascadeFit> cascades; ///< nested, from fine to coarse; empty where there is nothing to shade
};

/// What the cascades are fitted to.
struct ShadowScene {
    Box bounds; ///< scene frame
    glm::dmat4 world_from_scene{1};

    /// One of the bounds' eight, from the scene's origin, world axes [m].
    glm::dvec3 corner(int i) const;
};

struct ShadowSettings {
    int cascades = 4;
    int size = 2048;    ///< texels along a side
    double reach = 1e5; ///< [m] in front of the camera
};

/// Squares that grow by one factor from the finest to the coarsest, around the place of the scene that is nearest to
/// the camera, half their width ahead of it. Their sizes depend on the scene, the reach and the camera's distance from
/// the scene, never on the camera's direction, and their centres are snapped: the grid of texels stays where it is when
/// the camera turns or moves.
ShadowFit fit_cascades(ShadowScene const& scene, Camera const& camera, glm::dvec3 const& to_sun,
                       ShadowSettings const& settings);

/// Whether a sphere can throw a shadow into the cascade: everything in its square, however far towards the sun.
bool touches(CascadeFit const& cascade, glm::dmat3 const& light_from_world, Sphere const& sphere);

/// Whether a sphere may be seen: a test against the four sides of the view.
bool in_view(Camera const& camera, double aspect, Sphere const& sphere);

} // namespace alpenglow
