#pragma once

#include "scene/scene.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cmath>

/// Small scenes made of a few triangles, in the scene's frame: metres, +Y up, +X east, -Z north.
namespace alpenglow::test {

/// Diffuse and visible from both sides. `color` is linear.
inline Material matte(glm::vec3 const& color) {
    Material material;
    material.base_color = glm::vec4(color, 1);
    material.metallic = 0;
    material.double_sided = true;
    return material;
}

/// Sends nothing back of the sky's light, and of the sun's where it faces away from it. Needs picture 0 to be black.
inline Material black() {
    Material material = matte(glm::vec3(0));
    material.metallic = 1;
    material.occlusion_texture.picture = 0;
    return material;
}

inline Picture one_texel(std::array<std::uint8_t, 4> const& rgba) { return {"texel", 1, 1, {rgba.begin(), rgba.end()}}; }

/// A scene with its materials and, as picture 0, a black texel.
inline Scene scene_of(std::vector<Material> materials) {
    Scene scene;
    scene.pictures.push_back(one_texel({0, 0, 0, 255}));
    scene.materials = std::move(materials);
    return scene;
}

/// Adds triangles with flat normals; their origin is `origin`, corners are relative to it, three for each triangle.
inline void add_triangles(Scene& scene, glm::dvec3 const& origin, std::vector<glm::dvec3> const& corners, std::uint32_t material = 0) {
    Mesh mesh;
    MeshPart part{0, static_cast<std::uint32_t>(corners.size()), material, {}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        std::size_t const first = i - i % 3;
        Vertex vertex;
        vertex.position = glm::vec3(corners[i]);
        vertex.normal = glm::vec3(glm::normalize(glm::cross(corners[first + 1] - corners[first], corners[first + 2] - corners[first])));
        part.bounds.include(glm::dvec3(vertex.position));
        mesh.vertices.push_back(vertex);
        mesh.indices.push_back(static_cast<std::uint32_t>(i));
    }
    mesh.parts.push_back(part);
    scene.instances.push_back({static_cast<std::uint32_t>(scene.meshes.size()), glm::translate(glm::dmat4(1), origin)});
    scene.meshes.push_back(std::move(mesh));
    scene.bounds = scene_bounds(scene);
}

/// A parallelogram whose front looks along cross(u, v); u and v are half edges.
inline void add_quad(Scene& scene, glm::dvec3 const& centre, glm::dvec3 const& u, glm::dvec3 const& v, std::uint32_t material = 0) {
    add_triangles(scene, centre, {-u - v, u - v, u + v, -u - v, u + v, -u + v}, material);
}

/// Level ground around (0, height, 0).
inline void add_plane(Scene& scene, double half_width, double height = 0, std::uint32_t material = 0) {
    add_quad(scene, {0, height, 0}, {half_width, 0, 0}, {0, 0, -half_width}, material);
}

inline void add_box(Scene& scene, glm::dvec3 const& centre, glm::dvec3 const& half, std::uint32_t material = 0) {
    for (int axis = 0; axis < 3; ++axis) {
        for (double const side : {-1.0, 1.0}) {
            glm::dvec3 out(0), u(0), v(0);
            out[axis] = side * half[axis];
            u[(axis + 1) % 3] = side * half[(axis + 1) % 3];
            v[(axis + 2) % 3] = half[(axis + 2) % 3];
            add_quad(scene, centre + out, u, v, material);
        }
    }
}

/// A roof of two slopes along the level line from `a` to `b`, its ridge `height` above them.
inline void add_ridge(Scene& scene, glm::dvec3 const& a, glm::dvec3 const& b, double half_width, double height, std::uint32_t material = 0) {
    glm::dvec3 const across = half_width * glm::normalize(glm::cross(b - a, glm::dvec3(0, 1, 0)));
    glm::dvec3 const top(0, height, 0), along = b - a;
    for (double const side : {-1.0, 1.0}) {
        glm::dvec3 const foot = side * across;
        add_triangles(scene, a, {foot, foot + along, along + top, foot, along + top, top}, material);
    }
}

} // namespace alpenglow::test
