#pragma once

#include "scene/scene.h"

#include <optional>

namespace alpenglow {

/// How high the triangles of a scene stand over any place. Seen from the planet's centre, verticals are points and
/// triangles stay triangles, so that a grid of that picture (a gnomonic map around the scene) finds those over a place
/// at once.
class GroundQuery {
public:
    /// Copies what it needs. Triangles more than about 80 degrees around the planet from the scene's anchor are left
    /// out.
    GroundQuery(Scene const& scene, Placement const& placement, double planet_radius);

    /// Altitude [m] above the planet's radius of the highest triangle over or under `world`; nothing where there is
    /// none.
    std::optional<double> altitude(glm::dvec3 const& world) const;

private:
    using Triangle = std::array<std::uint32_t, 3>;
    struct Cells {
        glm::ivec2 first, last;
    };
    void add_vertices(Scene const& scene, glm::dmat4 const& world_from_scene);
    void fill_grid();
    std::optional<glm::dvec2> on_map(glm::dvec3 const& world) const;
    std::optional<Cells> cells_of(Triangle const& triangle) const;
    glm::ivec2 cell_at(glm::dvec2 const& on_map) const;

    double radius_;
    glm::dmat3 anchor_from_world_;     ///< rows east, north, up
    std::vector<glm::dvec3> vertices_; ///< world [m]
    std::vector<Triangle> triangles_;
    glm::dvec2 lowest_{0}, cell_size_{1}; ///< of the map
    int side_ = 1;                        ///< cells along a side
    std::vector<std::uint32_t> starts_;   ///< for each cell, into `cell_triangles_`
    std::vector<std::uint32_t> cell_triangles_;
};

} // namespace alpenglow
