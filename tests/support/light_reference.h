#pragma once

#include "support/air_reference.h"
#include "support/render_test.h"

/// In-scattered light with the shadows of triangles, by brute force in double precision and world space.
namespace alpenglow::test::reference {

/// The triangles of a scene, in world space.
class Occluders {
public:
    Occluders(Scene const& scene, Stand const& stand) {
        for (Instance const& instance : scene.instances) {
            glm::dmat4 const world_from_mesh = stand.world_from_scene() * instance.scene_from_mesh;
            Mesh const& mesh = scene.meshes[instance.mesh];
            for (std::uint32_t index : mesh.indices) corners_.push_back(dvec3(world_from_mesh * glm::dvec4(mesh.vertices[index].position, 1)));
        }
    }
    /// Whether any of them is hit by a ray (Möller and Trumbore 1997).
    bool hide(dvec3 const& origin, dvec3 const& direction) const {
        for (std::size_t i = 0; i < corners_.size(); i += 3) {
            dvec3 const e1 = corners_[i + 1] - corners_[i], e2 = corners_[i + 2] - corners_[i];
            dvec3 const p = glm::cross(direction, e2), s = origin - corners_[i], q = glm::cross(s, e1);
            double const scale = 1 / glm::dot(e1, p), u = glm::dot(s, p) * scale, v = glm::dot(direction, q) * scale;
            if (u >= 0 && v >= 0 && u + v <= 1 && glm::dot(e2, q) * scale > 0) return true;
        }
        return false;
    }

private:
    std::vector<dvec3> corners_;
};

struct LightPath {
    dvec3 origin, direction; ///< world, direction a unit vector
    double length;           ///< [m]
    dvec3 to_sun;
};

/// Sunlight scattered once, by the midpoint rule in `n` steps; without `occluders` (nullptr) the planet alone shades. The sun's
/// transmittance, smooth along the path, is a straight line between 201 places.
inline dvec3 sunlit_air(Air const& air, Occluders const* occluders, LightPath const& path, int n = 20000) {
    constexpr int NODES = 200;
    auto const at = [&](double t) { return path.origin + t * path.direction; };
    std::vector<dvec3> sun;
    for (int i = 0; i <= NODES; ++i) {
        dvec3 const p = at(path.length * i / NODES);
        sun.push_back(sun_transmittance(air, glm::length(p) - air.radius(), glm::dot(glm::normalize(p), path.to_sun)));
    }
    double const nu = glm::dot(path.direction, path.to_sun), step = path.length / n;
    dvec3 sum(0), depth(0);
    for (int i = 0; i < n; ++i) {
        dvec3 const p = at((i + 0.5) * step);
        double const h = glm::length(p) - air.radius(), place = (i + 0.5) / n * NODES;
        dvec3 const extinction = air.extinction(h);
        depth += 0.5 * step * extinction;
        if (!occluders || !occluders->hide(p, path.to_sun)) {
            auto const node = static_cast<std::size_t>(place);
            sum += step * air.scattered(h, nu) * glm::mix(sun[node], sun[node + 1], place - static_cast<double>(node)) * glm::exp(-depth);
        }
        depth += 0.5 * step * extinction;
    }
    return sum;
}

/// The length of a path from inside the air to its top [m].
inline double to_top(Air const& air, dvec3 const& origin, dvec3 const& direction) {
    double const along = glm::dot(origin, direction), top = air.radius() + air.top();
    return -along + std::sqrt(along * along - glm::dot(origin, origin) + top * top);
}

} // namespace alpenglow::test::reference
