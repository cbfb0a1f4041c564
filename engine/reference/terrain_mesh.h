#pragma once

#include "reference/ground_point.h"
#include "scene/scene.h"

#include <memory>
#include <optional>

namespace alpenglow {

/// Which sides of triangles stop a ray.
enum class Sides {
    seen, ///< single-sided materials are seen from the front only
    both
};

/// The triangles of a scene for rays, in single precision around the middle of the scene's box, along its axes. Rays
/// come and hits leave in double precision; how far a triangle stands from its place is `position_error`. Queries may
/// come from any number of threads. The tree is built by one, so that the same scene gives the same
/// hits each time; another kind of processor may round differently.
class TerrainMesh {
public:
    /// `scene` is not copied and must outlive this. Throws Error(bad_input) where memory doesn't suffice.
    TerrainMesh(Scene const& scene, Placement const& placement, double planet_radius);
    ~TerrainMesh();

    bool empty() const; ///< no triangles

    /// The nearest place before `longest` [m]; `direction` is unit, both in world space [m].
    std::optional<GroundPoint> first_hit(glm::dvec3 const& origin, glm::dvec3 const& direction, double longest,
                                         Sides sides) const;
    /// A triangle stands somewhere along the whole ray; both sides count.
    bool occludes(glm::dvec3 const& origin, glm::dvec3 const& direction) const;

    /// A bound [m] on how far single precision moves a ray's start and a triangle apart. `reach` [m]: how far the
    /// triangle extends from the middle along an axis; `extent` [m]: its longest side along an axis. Small triangles 48
    /// km from the middle: 11 mm.
    static double position_error(double reach, double extent);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace alpenglow
