#pragma once

#include "support/scenes.h"

#include <cmath>

namespace alpenglow::test {

/// Sharp ridges and valleys, 24 x 24 km, up to 3 km high, bent to a planet of `radius` [m]: 2 x 160 x 160 triangles.
inline Scene mountains(double radius) {
    constexpr int SIDE = 161;
    constexpr double STEP = 150; // [m]
    auto const height = [](double x, double z) {
        double const a = std::abs(std::sin(x / 2300 + 0.4 * std::sin(z / 3100))), b = std::abs(std::sin((0.6 * x + 0.8 * z) / 1700));
        double const rough = std::sin(x / 410 + z / 630) * std::cos(z / 370 - x / 900);
        return 1900 * (1 - a) * (0.4 + 0.6 * b) + 900 * (1 - b) + 110 * rough + 150;
    };
    Scene scene = scene_of({matte({0.4f, 0.4f, 0.4f})});
    Mesh mesh;
    for (int row = 0; row < SIDE; ++row) {
        for (int column = 0; column < SIDE; ++column) {
            double const x = STEP * (column - SIDE / 2), z = STEP * (row - SIDE / 2);
            bool const border = row % (SIDE - 1) == 0 || column % (SIDE - 1) == 0; // hangs down, so that nothing looks in below
            Vertex vertex;
            vertex.position = glm::vec3(x, (border ? -2000 : height(x, z)) - (x * x + z * z) / (2 * radius), z);
            mesh.vertices.push_back(vertex);
            if (row + 1 == SIDE || column + 1 == SIDE) continue;
            auto const at = static_cast<std::uint32_t>(row * SIDE + column);
            for (std::uint32_t i : {at, at + SIDE, at + 1, at + 1, at + SIDE, at + SIDE + 1}) mesh.indices.push_back(i);
        }
    }
    MeshPart part{0, static_cast<std::uint32_t>(mesh.indices.size()), 0, {}};
    for (Vertex const& vertex : mesh.vertices) part.bounds.include(glm::dvec3(vertex.position));
    mesh.parts.push_back(part);
    scene.instances.push_back({0, glm::dmat4(1)});
    scene.meshes.push_back(std::move(mesh));
    scene.bounds = scene_bounds(scene);
    return scene;
}

} // namespace alpenglow::test
