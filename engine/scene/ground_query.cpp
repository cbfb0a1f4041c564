#include "scene/ground_query.h"

#include <algorithm>
#include <cmath>

namespace alpenglow {

namespace {

constexpr double LEAST_COSINE = 0.17; // about 80 degrees from the anchor: the map's edge runs away to infinity
constexpr int LARGEST_SIDE = 512;

/// How far along the unit direction from the planet's centre the triangle lies [m], from either side. From differences
/// of its corners: products of whole positions would leave a few metres of a triangle of a few metres.
std::optional<double> distance_to(glm::dvec3 const& direction, glm::dvec3 const& a, glm::dvec3 const& b,
                                  glm::dvec3 const& c) {
    constexpr double SLACK = 1e-6; // a place on an edge is in one of its triangles at least
    glm::dvec3 const ab = b - a, ac = c - a, normal = glm::cross(ab, ac);
    double const facing = glm::dot(direction, normal);
    if (facing == 0) return {};
    double const distance = glm::dot(a, normal) / facing;
    glm::dvec3 const along = distance * direction - a;
    double const area = glm::dot(normal, normal);
    double const v = glm::dot(glm::cross(along, ac), normal) / area, w = glm::dot(glm::cross(ab, along), normal) / area;
    if (v < -SLACK || w < -SLACK || v + w > 1 + SLACK) return {};
    return distance;
}

} // namespace

GroundQuery::GroundQuery(Scene const& scene, Placement const& placement, double planet_radius)
    : radius_(planet_radius), anchor_from_world_(glm::transpose(
                                  world_from_east_north_up(placement.anchor.latitude, placement.anchor.longitude))) {
    add_vertices(scene, world_from_scene(placement, planet_radius));
    fill_grid();
}

void GroundQuery::add_vertices(Scene const& scene, glm::dmat4 const& world_from_scene) {
    for (Instance const& instance : scene.instances) {
        Mesh const& mesh = scene.meshes[instance.mesh];
        glm::dmat4 const world_from_mesh = world_from_scene * instance.scene_from_mesh;
        auto const base = static_cast<std::uint32_t>(vertices_.size());
        for (Vertex const& vertex : mesh.vertices)
            vertices_.emplace_back(world_from_mesh * glm::dvec4(vertex.position, 1));
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            triangles_.push_back({base + mesh.indices[i], base + mesh.indices[i + 1], base + mesh.indices[i + 2]});
        }
    }
}

/// Central projection to the plane that touches the planet at the anchor, in radii.
std::optional<glm::dvec2> GroundQuery::on_map(glm::dvec3 const& world) const {
    glm::dvec3 const at = anchor_from_world_ * world;
    if (!(at.z > LEAST_COSINE * glm::length(at))) return {};
    return glm::dvec2(at.x, at.y) / at.z;
}

glm::ivec2 GroundQuery::cell_at(glm::dvec2 const& on_map) const {
    return glm::ivec2(glm::clamp((on_map - lowest_) / cell_size_, glm::dvec2(0), glm::dvec2(side_ - 1)));
}

std::optional<GroundQuery::Cells> GroundQuery::cells_of(Triangle const& triangle) const {
    Cells cells{glm::ivec2(side_), glm::ivec2(-1)};
    for (std::uint32_t vertex : triangle) {
        auto const at = on_map(vertices_[vertex]);
        if (!at) return {};
        cells.first = glm::min(cells.first, cell_at(*at));
        cells.last = glm::max(cells.last, cell_at(*at));
    }
    return cells;
}

void GroundQuery::fill_grid() {
    glm::dvec2 highest(-std::numeric_limits<double>::infinity());
    lowest_ = -highest;
    for (glm::dvec3 const& vertex : vertices_) {
        if (auto const at = on_map(vertex)) lowest_ = glm::min(lowest_, *at), highest = glm::max(highest, *at);
    }
    if (lowest_.x > highest.x) triangles_.clear();
    // About one triangle in a cell.
    side_ = std::clamp(static_cast<int>(std::sqrt(triangles_.size())), 1, LARGEST_SIDE);
    cell_size_ = glm::max((highest - lowest_) / double(side_), glm::dvec2(1e-12));

    // Counts first, then places: the triangles of a cell lie together.
    auto const each_cell = [this](auto const& visit) {
        for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
            auto const cells = cells_of(triangles_[i]);
            if (!cells) continue;
            for (int y = cells->first.y; y <= cells->last.y; ++y) {
                for (int x = cells->first.x; x <= cells->last.x; ++x) visit(static_cast<std::size_t>(y * side_ + x), i);
            }
        }
    };
    starts_.assign(static_cast<std::size_t>(side_ * side_) + 1, 0);
    each_cell([this](std::size_t cell, std::uint32_t) { ++starts_[cell + 1]; });
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    cell_triangles_.resize(starts_.back());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    each_cell([&](std::size_t cell, std::uint32_t triangle) { cell_triangles_[next[cell]++] = triangle; });
}

std::optional<double> GroundQuery::altitude(glm::dvec3 const& world) const {
    auto const at = on_map(world);
    if (!at || triangles_.empty()) return {};
    glm::dvec3 const direction = glm::normalize(world);
    glm::ivec2 const cell = cell_at(*at);
    auto const index = static_cast<std::size_t>(cell.y * side_ + cell.x);
    std::optional<double> highest;
    for (std::uint32_t i = starts_[index]; i < starts_[index + 1]; ++i) {
        Triangle const& t = triangles_[cell_triangles_[i]];
        auto const distance = distance_to(direction, vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]);
        if (distance) highest = std::max(highest.value_or(*distance), *distance);
    }
    if (!highest) return {};
    return *highest - radius_;
}

} // namespace alpenglow
