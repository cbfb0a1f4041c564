#include "terrain/shaft_scenes.h"

#include "terrain/block_mesh.h"
#include "terrain/noise.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alpenglow {

namespace {

constexpr float BELOW = -2; // [m] where things on the ground begin
constexpr glm::vec3 STONE(0.3f, 0.27f, 0.24f), ROCK(0.22f, 0.21f, 0.2f), WOOD(0.2f, 0.15f, 0.1f);

/// From `low` to `high`, in steps of a sixteenth, so that every machine writes the same bytes.
float some(float low, float high, std::uint32_t seed, int x, int y = 0) {
    double const share = lattice_unit(seed, x, y);
    return static_cast<float>(std::floor(16 * (low + (high - low) * share)) / 16);
}

/// A saw-toothed ridge from south to north, 3 km in the east.
GltfWriter valley() {
    constexpr int POINTS = 81;
    constexpr float STEP = 110, MIDDLE = 3000; // [m]
    std::array<std::vector<glm::vec3>, POINTS> rows;
    for (int i = 0; i < POINTS; ++i) {
        float const north = STEP * float(i - POINTS / 2) + some(-24, 24, 1, i);
        float const shoulder = 420 - some(0, 120, 2, i / 4) + some(-20, 20, 3, i);
        float const crest = shoulder + (i % 2 ? some(10, 60, 4, i) : some(160, 380, 5, i));
        float const place = MIDDLE + some(-60, 60, 6, i), foot = some(-120, 120, 7, i);
        rows[i] = {{place - 1300 + foot, BELOW, -north},
                   {place - 600 + some(-80, 80, 8, i), some(120, 220, 9, i), -north},
                   {place - 180 + some(-40, 40, 10, i), shoulder - some(20, 100, 11, i), -north},
                   {place, crest, -north},
                   {place + 240 + some(-60, 60, 12, i), shoulder - some(40, 140, 13, i), -north},
                   {place + 1300 - foot, BELOW, -north}};
    }
    BlockMesh mesh;
    mesh.add_sheet(rows);
    return mesh.gltf("valley", ROCK);
}

/// Columns of six sides, 90 to 220 m high, with an aisle between them.
GltfWriter pillars() {
    BlockMesh mesh;
    for (int row = 0; row < 28; ++row) {
        for (int column = -6; column <= 6; ++column) {
            float const x = 120 + 55 * float(row) + some(-25, 25, 21, row, column);
            float const z = 50 * float(column) + some(-22, 22, 22, row, column);
            float const radius = some(3, 8, 23, row, column), half = radius / 2;
            if (std::abs(z) < 12 + 0.02f * x) continue;
            float const top = some(90, 220, 24, row, column);
            std::array<glm::vec2, 6> const corners{{{x - radius, z},
                                                    {x - half, z + radius},
                                                    {x + half, z + radius},
                                                    {x + radius, z},
                                                    {x + half, z - radius},
                                                    {x - half, z - radius}}};
            mesh.add_column(corners, BELOW, top);
        }
    }
    return mesh.gltf("pillars", STONE);
}

/// A wall across the view, between `slits` of `open` metres every `step` metres.
void add_slit_wall(BlockMesh& mesh, float east, float height, float half_width, float step, float open) {
    constexpr float THICK = 2;
    for (float z = -half_width; z < half_width; z += step)
        mesh.add_box({east, BELOW, z}, {east + THICK, height, z + step - open});
}

/// Two thin walls with slits, a low one before a high one.
GltfWriter walls() {
    BlockMesh mesh;
    add_slit_wall(mesh, 260, 75, 700, 42, 11);
    add_slit_wall(mesh, 760, 240, 1100, 61, 19);
    return mesh.gltf("walls", STONE);
}

/// Hundreds of thin masts.
GltfWriter masts() {
    BlockMesh mesh;
    for (int row = 0; row < 22; ++row) {
        for (int column = -10; column <= 10; ++column) {
            float const x = 60 + 45 * float(row) + some(-20, 20, 31, row, column);
            float const z = 36 * float(column) + some(-17, 17, 32, row, column);
            float const half = some(0.75f, 1.25f, 33, row, column), top = some(70, 130, 34, row, column);
            std::array<glm::vec2, 3> const corners{{{x - half, z + half}, {x + half, z + half}, {x, z - half}}};
            mesh.add_column(corners, BELOW, top);
        }
    }
    return mesh.gltf("masts", WOOD);
}

/// A wall across the view with high windows.
GltfWriter gates() {
    constexpr float EAST = 240, THICK = 6, SILL = 30, LINTEL = 110, TOP = 150, STEP = 24, OPEN = 8, HALF = 1200;
    BlockMesh mesh;
    mesh.add_slab({EAST, BELOW, -HALF}, {EAST + THICK, SILL, HALF});
    mesh.add_slab({EAST, LINTEL, -HALF}, {EAST + THICK, TOP, HALF});
    for (float z = -HALF + OPEN / 2; z < HALF; z += STEP)
        mesh.add_box({EAST, SILL, z}, {EAST + THICK, LINTEL, z + STEP - OPEN});
    return mesh.gltf("gates", STONE);
}

/// A hall, 960 m wide and open in the west, whose roof has holes of many sizes.
GltfWriter roof() {
    constexpr float BOTTOM = 130, TOP = 133, HALF = 480, ROW = 40;
    BlockMesh mesh;
    int hole = 0;
    for (float x = -HALF; x < HALF; x += ROW) {
        float const depth = some(8, 16, 41, ++hole);
        mesh.add_slab({x, BOTTOM, -HALF}, {x + ROW - depth, TOP, HALF});
        for (float z = -HALF; z < HALF;) {
            float const end = std::min(z + some(12, 60, 42, ++hole), HALF);
            mesh.add_slab({x + ROW - depth, BOTTOM, z}, {x + ROW, TOP, end});
            z = end + some(8, 24, 43, hole);
        }
    }
    constexpr float WALL = 4;
    mesh.add_box({HALF, BELOW, -HALF}, {HALF + WALL, TOP, HALF});
    mesh.add_box({-HALF, BELOW, HALF}, {HALF, TOP, HALF + WALL});
    mesh.add_box({-HALF, BELOW, -HALF - WALL}, {HALF, TOP, -HALF});
    return mesh.gltf("roof", STONE);
}

/// Rows of plates high above the camera, beyond what it sees, and a small plate close to it.
GltfWriter louvre() {
    constexpr float BOTTOM = 600, TOP = 603, HALF = 500, ROW = 60;
    BlockMesh mesh;
    int plate = 0;
    for (float x = -200; x < 1240; x += ROW) {
        float const width = ROW - some(12, 28, 51, ++plate);
        for (float z = -HALF + some(0, 60, 52, plate); z < HALF;) {
            float const end = std::min(z + some(60, 200, 53, ++plate), HALF);
            mesh.add_slab({x, BOTTOM, z}, {x + width, TOP, end});
            z = end + some(15, 40, 54, plate);
        }
    }
    mesh.add_slab({4, 12, -3}, {16, 12.25f, 3});
    return mesh.gltf("louvre", WOOD);
}

constexpr ShaftScene SCENES[] = {{"valley", valley}, {"pillars", pillars}, {"walls", walls},  {"masts", masts},
                                 {"gates", gates},   {"roof", roof},       {"louvre", louvre}};

} // namespace

std::span<ShaftScene const> shaft_scenes() { return SCENES; }

} // namespace alpenglow
