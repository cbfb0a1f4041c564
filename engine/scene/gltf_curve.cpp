#include "core/error.h"
#include "scene/gltf.h"

#include <cmath>
#include <numbers>

namespace alpenglow {

namespace {

/// The bend at one point of the flat plane: its place on the planet, and how directions turn there. In the scene frame.
class Bend {
public:
    /// `flat` and `radius` in the same unit.
    Bend(glm::dvec3 const& flat, double radius) : place_(flat) {
        double const distance = std::hypot(flat.x, flat.z);
        double const angle = distance / radius;
        if (angle > std::numbers::pi || flat.y <= -radius) {
            throw Error(ErrorKind::bad_input, "the scene is larger than the planet that it is bent to", "curve",
                        "check its scale");
        }
        outwards_ = distance > 0 ? glm::dvec3(flat.x / distance, 0, flat.z / distance) : glm::dvec3(1, 0, 0);
        sine_ = std::sin(angle);
        double const half = std::sin(angle / 2);
        one_minus_cosine_ = 2 * half * half; // 1 - cos(angle) would cancel near the origin
        double const horizontal = (radius + flat.y) * sine_;
        place_ = {outwards_.x * horizontal, flat.y - (radius + flat.y) * one_minus_cosine_, outwards_.z * horizontal};
    }

    glm::dvec3 const& place() const { return place_; }
    /// By the rotation that takes the plane's up to the local up.
    glm::dvec3 turn(glm::dvec3 const& v) const {
        double const out = glm::dot(v, outwards_);
        return v + (v.y * sine_ - out * one_minus_cosine_) * outwards_ -
               glm::dvec3(0, out * sine_ + v.y * one_minus_cosine_, 0);
    }

private:
    glm::dvec3 place_, outwards_;
    double sine_, one_minus_cosine_;
};

glm::dvec3 unit_or(glm::dvec3 const& v, glm::dvec3 const& otherwise) {
    double const length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : otherwise;
}

/// The mesh of one instance, bent; the instance's transform becomes a translation.
Mesh bend_instance(Mesh const& flat, Instance& instance, double radius) {
    glm::dmat3 const linear(instance.scene_from_mesh);
    bool const mirrored = glm::determinant(linear) < 0;
    glm::dmat3 const normals = glm::transpose(glm::inverse(linear));
    std::vector<glm::dvec3> places(flat.vertices.size());
    Mesh mesh = flat;
    Box box;
    for (std::size_t i = 0; i < places.size(); ++i) {
        Vertex& vertex = mesh.vertices[i];
        Bend const bend(glm::dvec3(instance.scene_from_mesh * glm::dvec4(vertex.position, 1)), radius);
        places[i] = bend.place();
        box.include(places[i]);
        vertex.normal = bend.turn(unit_or(normals * glm::dvec3(vertex.normal), {0, 1, 0}));
        if (vertex.tangent.w == 0) continue;
        glm::dvec3 const tangent = bend.turn(unit_or(linear * glm::dvec3(vertex.tangent), {1, 0, 0}));
        vertex.tangent = {tangent, mirrored ? -vertex.tangent.w : vertex.tangent.w};
    }
    glm::dvec3 const origin = box.empty() ? glm::dvec3(0) : box.centre();
    for (std::size_t i = 0; i < places.size(); ++i) mesh.vertices[i].position = places[i] - origin;
    for (std::size_t i = 0; mirrored && i + 2 < mesh.indices.size(); i += 3)
        std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    for (MeshPart& part : mesh.parts) {
        part.bounds = {};
        for (std::uint32_t i = part.first_index; i < part.first_index + part.index_count; ++i) {
            part.bounds.include(glm::dvec3(mesh.vertices[mesh.indices[i]].position));
        }
    }
    instance.scene_from_mesh = glm::dmat4(1);
    instance.scene_from_mesh[3] = glm::dvec4(origin, 1);
    return mesh;
}

void check_bent_size(Scene const& scene, int most) {
    std::size_t vertices = 0;
    for (Instance const& instance : scene.instances) vertices += scene.meshes[instance.mesh].vertices.size();
    if (vertices <= static_cast<std::size_t>(most)) return;
    throw Error(ErrorKind::bad_input,
                "each instance is bent by itself: " + std::to_string(vertices) +
                    " vertices in all, more than the limit of " + std::to_string(most),
                "curve", "raise it with --set most_vertices=NUMBER, or place the scene without curve");
}

} // namespace

void curve_to_planet(Scene& scene, double planet_radius, double scale, int most_vertices) {
    check_bent_size(scene, most_vertices);
    std::vector<Mesh> meshes;
    meshes.reserve(scene.instances.size());
    for (Instance& instance : scene.instances) {
        // In the scene's own unit the planet's radius is planet_radius / scale: nothing else depends on the scale.
        Mesh mesh = bend_instance(scene.meshes[instance.mesh], instance, planet_radius / scale);
        instance.mesh = static_cast<std::uint32_t>(meshes.size());
        meshes.push_back(std::move(mesh));
    }
    scene.meshes = std::move(meshes);
    for (SceneCamera& camera : scene.cameras) {
        Bend const bend(glm::dvec3(camera.scene_from_camera[3]), planet_radius / scale);
        for (int i = 0; i < 3; ++i)
            camera.scene_from_camera[i] = glm::dvec4(bend.turn(glm::dvec3(camera.scene_from_camera[i])), 0);
        camera.scene_from_camera[3] = glm::dvec4(bend.place(), 1);
    }
    scene.bounds = scene_bounds(scene);
}

} // namespace alpenglow
