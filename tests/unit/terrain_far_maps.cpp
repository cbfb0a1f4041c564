#include "terrain/far_maps.h"
#include "image/color.h"
#include "terrain/erosion.h"
#include "terrain/ground.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>

using namespace alpenglow;

namespace {

constexpr double RADIUS = 6'360'000, SIDE = 12'000;

struct Clad {
    HeightField field = make_eroded_field({1, SIDE, 64, 1, 0}, [](int, int) {});
    Fineness fineness{{{500, -800, 150}}};
    Relief relief{field, fineness, 1, RADIUS};
    std::vector<Tile> tiles = make_tiles(relief, 1, 0, [](int, int) {});
    std::vector<FarMap> maps = plan_far_maps(relief, 256);

    Clad() { clad_far_tiles(tiles, maps, relief, 1, 0, [](int, int) {}); }
};

Clad const& clad() {
    static Clad const terrain;
    return terrain;
}

glm::dvec3 vertex_normal(Tile const& tile, int x, int y) { return tile.vertices[std::size_t(y * Tile::NODES + x)].normal; }

/// What shaders/passes/gbuffer.frag makes of a texel over the vertex normal `n`; u goes east, v south.
glm::dvec3 mapped(glm::dvec3 n, std::uint8_t const* texel) {
    glm::dvec3 const east(1, 0, 0), north(0, 0, -1);
    glm::dvec3 const t = east - n * dot(n, east), b = north - n * dot(n, north);
    double const scale = 1 / std::max(length(t), length(b));
    glm::dvec3 const m = glm::dvec3(texel[0], texel[1], texel[2]) / 127.5 - 1.0;
    return normalize(t * scale * m.x + b * scale * m.y + n * m.z);
}

} // namespace

TEST(FarMaps, lie_around_the_fine_place_with_finer_texels_each) {
    ASSERT_EQ(clad().maps.size(), 4u);
    EXPECT_DOUBLE_EQ(clad().maps[0].side, SIDE);
    EXPECT_DOUBLE_EQ(clad().maps[1].side, SIDE / 2);
    EXPECT_DOUBLE_EQ(clad().maps[2].side, SIDE / 8);
    EXPECT_DOUBLE_EQ(clad().maps[3].side, SIDE / 32);
    for (std::size_t k = 1; k < 4; ++k) {
        EXPECT_LT(clad().maps[k].texel(), clad().maps[k - 1].texel());
        glm::dvec2 const place = clad().maps[k].uv(500, -800);
        for (int c = 0; c < 2; ++c) EXPECT_TRUE(place[c] > 0.25 && place[c] < 0.75);
    }
}

TEST(FarMaps, have_no_blank_texel) {
    for (FarMap const& map : clad().maps) {
        for (std::size_t i = 3; i < map.color.rgba.size(); i += 4) ASSERT_EQ(map.color.rgba[i], 255) << i;
    }
}

TEST(FarMaps, clad_the_tiles_whose_vertices_stand_far_apart) {
    int near = 0, far = 0;
    for (Tile const& tile : clad().tiles) {
        double const spacing = SIDE / (1 << tile.key.level) / Tile::CELLS;
        if (tile.map == Tile::NO_MAP) {
            ++near;
            EXPECT_LT(spacing, 1.5 * clad().maps[0].texel());
            continue;
        }
        ++far;
        EXPECT_GT(spacing, clad().maps[std::size_t(tile.map)].texel());
        for (TileVertex const& v : tile.vertices) {
            for (int c = 0; c < 2; ++c) ASSERT_TRUE(v.uv[c] > -1e-6 && v.uv[c] < 1 + 1e-6);
        }
    }
    EXPECT_GT(near, 10);
    EXPECT_GT(far, 10);
}

TEST(FarMaps, give_the_ground_its_own_normal_and_color_whatever_the_vertices_say) {
    int seen = 0;
    for (Tile const& tile : clad().tiles) {
        if (tile.map == Tile::NO_MAP) continue;
        FarMap const& map = clad().maps[std::size_t(tile.map)];
        double const size = SIDE / (1 << tile.key.level), step = map.texel();
        // The texel north-east of the tile's middle; its south-west corner is the middle vertex.
        double const east = tile.key.x * size - 0.5 * SIDE + 0.5 * size, north = tile.key.y * size - 0.5 * SIDE + 0.5 * size;
        auto const h = [&](double x, double y) { return clad().relief.sample(east + x * step, north + y * step, step).altitude; };
        double const sw = h(0, 0), se = h(1, 0), nw = h(0, 1), ne = h(1, 1);
        glm::dvec2 const slope((se + ne - sw - nw) / (2 * step), (nw + ne - sw - se) / (2 * step));
        if (glm::length(slope) > 1.5) continue; // the texel's z may be clamped there
        double const t = 0.5 * step / (size / Tile::CELLS);
        glm::dvec3 const n = normalize(mix(mix(vertex_normal(tile, 8, 8), vertex_normal(tile, 9, 8), t),
                                           mix(vertex_normal(tile, 8, 9), vertex_normal(tile, 9, 9), t), t));
        glm::dvec2 const uv = map.uv(east + 0.5 * step, north + 0.5 * step) * double(map.normal.extent.width);
        auto const x = static_cast<std::uint32_t>(uv.x), y = static_cast<std::uint32_t>(uv.y);
        glm::dvec3 const expected = normalize(glm::dvec3(-slope.x, 1, slope.y));
        // 8 bits turn a normal by 0.01 at most, stretched here by slopes; the planet's curvature tilts it by 0.001.
        ASSERT_LT(glm::distance(mapped(n, map.normal.at(x, y)), expected), 0.03) << east << " " << north;
        if (sw < -20) {
            glm::dvec3 const sand = ground_albedo(1, {east, north, sw});
            ASSERT_NEAR(linear_from_srgb_byte(map.color.at(x, y)[0]), sand.r, 0.01);
        }
        ++seen;
    }
    EXPECT_GT(seen, 20);
}
