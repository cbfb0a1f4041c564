#pragma once

#include "support/gltf_builder.h"

#include <algorithm>
#include <cmath>

namespace alpenglow::test {

/// 8 km of ridges, 2 x 64 x 64 triangles, as the text of a .gltf: something to fly over that is made at once.
inline std::string hills_gltf() {
    constexpr int SIDE = 65;
    constexpr float STEP = 125; // [m]
    std::vector<float> places;
    std::vector<std::uint16_t> indices;
    float lowest = 1e9f, highest = -1e9f; // [m]
    for (int row = 0; row < SIDE; ++row) {
        for (int column = 0; column < SIDE; ++column) {
            float const x = STEP * float(column - SIDE / 2), z = STEP * float(row - SIDE / 2);
            float const y = 300 + 250 * std::sin(x / 400) * std::cos(z / 700);
            places.insert(places.end(), {x, y, z});
            lowest = std::min(lowest, y);
            highest = std::max(highest, y);
            if (row + 1 == SIDE || column + 1 == SIDE) continue;
            auto const at = static_cast<std::uint16_t>(row * SIDE + column);
            auto const below = static_cast<std::uint16_t>(at + SIDE);
            std::uint16_t const next = at + 1, across = below + 1;
            indices.insert(indices.end(), {at, below, next, next, below, across});
        }
    }
    GltfBuilder builder;
    int const position = builder.add<float>("VEC3", places);
    builder.json["accessors"][position].update({{"min", {-4000, lowest, -4000}}, {"max", {4000, highest, 4000}}});
    builder.show({{"POSITION", position}}, {{"indices", builder.add<std::uint16_t>("SCALAR", indices)}});
    return builder.gltf();
}

} // namespace alpenglow::test
