#pragma once

#include "reference/ground_point.h"
#include "scene/planet.h"
#include "scene/scene.h"

#include <limits>
#include <memory>
#include <optional>

namespace alpenglow {

class TerrainMesh;

/// The solid things of a world: the planet's body and, where there is a scene, its triangles. Queries may come from
/// any number of threads.
///
/// Sides of triangles are as in the renderer: a camera looks through the backs of single-sided materials; light is
/// stopped by both sides. What an alpha mask cuts out lets everything through.
class Ground {
public:
    /// `scene` may be null; it is not copied and must outlive this. Throws Error(bad_input) where the scene is too
    /// large for the memory.
    Ground(Planet const& planet, Scene const* scene, Placement const& placement);
    ~Ground();
    Ground(Ground&&) noexcept;

    /// The nearest place before `longest` [m] along the unit `direction` from `origin` (world [m]). A ray that starts
    /// at or under the planet's surface meets it at distance 0 if it goes down, and not at all if it goes up.
    /// `pixel_angle` [rad]: how wide a camera's pixel is; 0 for light that is on its way after its first event, which
    /// sees the planet's body as Lambertian with the mean `ground_albedo`; a uniform ground is that to everyone.
    std::optional<GroundPoint> first_hit(glm::dvec3 const& origin, glm::dvec3 const& direction,
                                         double longest = std::numeric_limits<double>::infinity(),
                                         double pixel_angle = 0) const;

    /// No planet and no triangle stands along the whole ray.
    bool sees_out(glm::dvec3 const& origin, glm::dvec3 const& direction) const;

private:
    std::optional<double> distance_to_planet(glm::dvec3 const& origin, glm::dvec3 const& direction) const;
    GroundPoint planet_point(glm::dvec3 const& origin, glm::dvec3 const& direction, double distance,
                             double pixel_angle) const;

    Planet planet_;
    std::unique_ptr<TerrainMesh> terrain_;
};

} // namespace alpenglow
