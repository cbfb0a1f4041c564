#include "terrain/terrain.h"
#include "core/error.h"
#include "core/files.h"
#include "terrain/erosion.h"
#include "terrain/gltf_writer.h"
#include "terrain/sites.h"
#include "terrain/tiles.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <tuple>
#include <unistd.h>

using namespace alpenglow;

namespace {

constexpr double RADIUS = 6'360'000;
constexpr double SIDE = 12'000;

TerrainOptions small_options(int threads) {
    TerrainOptions options;
    options.side_km = SIDE / 1000;
    options.resolution = 128;
    options.map_size = 256;
    options.fine = {{500, -800, 150}};
    options.threads = threads;
    return options;
}

/// A folder that goes away with the test.
struct Folder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("alpenglow_terrain_" + std::to_string(::getpid()));
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
};

/// One small terrain for all tests that only look at it.
struct Small {
    HeightField field = make_eroded_field({1, SIDE, 64, 1, 0}, [](int, int) {});
    Fineness fineness{small_options(0).fine};
    Relief relief{field, fineness, 1, RADIUS};
    std::vector<Tile> tiles = make_tiles(relief, 1, 0, [](int, int) {});
};

Small const& small() {
    static Small const terrain;
    return terrain;
}

using Lattice = std::tuple<long long, long long, long long>; // [1/1024 m] scene frame

Lattice lattice(Tile const& tile, std::uint16_t index) {
    glm::dvec3 const p = (tile.origin + glm::dvec3(tile.vertices[index].position)) * 1024.0;
    EXPECT_EQ(p, glm::round(p)); // exact, not near
    return {std::llround(p.x), std::llround(p.y), std::llround(p.z)};
}

double distance_from_sea_level(glm::dvec3 const& p) { return glm::length(p + glm::dvec3(0, RADIUS, 0)) - RADIUS; }

} // namespace

TEST(Terrain, is_watertight_to_the_bit) {
    std::map<std::pair<Lattice, Lattice>, int> directed;
    int levels[32] = {};
    for (Tile const& tile : small().tiles) {
        ++levels[tile.key.level];
        std::vector<std::uint16_t> const indices = tile_indices(tile.coarser);
        for (std::size_t k = 0; k < indices.size(); ++k) {
            std::size_t const next = k % 3 == 2 ? k - 2 : k + 1;
            ++directed[{lattice(tile, indices[k]), lattice(tile, indices[next])}];
        }
    }
    EXPECT_GE(std::count_if(std::begin(levels), std::end(levels), [](int n) { return n > 0; }),
              4); // there are seams to test
    std::size_t border = 0;
    for (auto const& [edge, count] : directed) {
        ASSERT_EQ(count, 1);
        if (directed.contains({edge.second, edge.first})) continue;
        ++border;
        auto const [x, y, z] = edge.first;
        // The rim's vertices are 6 km east or north of the middle by arc length: 2 m less in the scene's plane at most.
        ASSERT_GT(std::max(std::llabs(x), std::llabs(z)), static_cast<long long>((0.5 * SIDE - 2) * 1024));
    }
    EXPECT_GT(border, 4u * Tile::CELLS);
}

TEST(Terrain, tiles_are_small_near_fine_places_only) {
    double finest = 1e9;
    for (Tile const& tile : small().tiles) {
        double const spacing = SIDE / (1 << tile.key.level) / Tile::CELLS;
        glm::dvec2 const from(tile.origin.x - 500, -tile.origin.z + 800);
        if (glm::length(from) < 100) finest = std::min(finest, spacing);
    }
    EXPECT_GT(finest, 4);
    EXPECT_LT(finest, 9);
}

TEST(Terrain, vertices_stand_where_the_planets_curvature_puts_them) {
    glm::dvec3 const p = small().relief.position(48'000, 0, 0);
    EXPECT_NEAR(p.x, RADIUS * std::sin(48'000 / RADIUS), 1e-6);
    EXPECT_NEAR(p.y, RADIUS * std::cos(48'000 / RADIUS) - RADIUS, 1e-6); // 181 m down
    EXPECT_NEAR(p.y, -181.1, 0.1);
    EXPECT_DOUBLE_EQ(p.z, 0);
    glm::dvec3 const high = small().relief.position(-3000, 4000, 2500);
    EXPECT_NEAR(distance_from_sea_level(high), 2500, 1e-6);
    EXPECT_LT(high.x, 0);
    EXPECT_LT(high.z, 0); // north is -Z
    EXPECT_NEAR(glm::length(small().relief.up(-3000, 4000)), 1, 1e-12);
}

TEST(Terrain, the_rim_lies_under_the_sea_and_the_middle_over_it) {
    for (int k = 0; k <= 400; ++k) {
        double const t = SIDE * (k / 400.0 - 0.5), rim = 0.5 * SIDE;
        for (auto const& [e, n] : {std::pair{t, rim}, {t, -rim}, {rim, t}, {-rim, t}}) {
            ASSERT_LT(small().relief.altitude(e, n), -55) << e << " " << n;
        }
    }
    EXPECT_GT(small().relief.altitude(2000, 0), 20);
}

TEST(Terrain, altitude_has_no_steps) {
    for (double n = -5950; n < 6000; n += 613) {
        double before = small().relief.altitude(-6000, n);
        for (double e = -5999.5; e < 6000; e += 0.5) {
            double const now = small().relief.altitude(e, n);
            ASSERT_LT(std::abs(now - before), 3) << e << " " << n; // over half a metre: no slope is steeper than 6
            before = now;
        }
    }
}

TEST(Terrain, little_ground_lies_so_near_the_sea_that_depths_fight) {
    int near = 0, all = 0;
    for (double e = -5900; e < 6000; e += 37) {
        for (double n = -5900; n < 6000; n += 37, ++all) near += std::abs(small().relief.altitude(e, n)) < 1;
    }
    EXPECT_LT(near, 0.01 * all);
}

TEST(Terrain, vertices_are_finite_and_their_normals_point_up) {
    for (Tile const& tile : small().tiles) {
        for (TileVertex const& v : tile.vertices) {
            for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(v.position[c]) && std::isfinite(v.normal[c]));
            ASSERT_TRUE(std::isfinite(v.uv.x) && std::isfinite(v.uv.y));
            ASSERT_NEAR(glm::length(v.normal), 1, 1e-5);
            ASSERT_GT(v.normal.y, 0);
            ASSERT_LT(glm::length(v.position), 16'000); // float holds 1/1024 m
            ASSERT_GT(v.color[1], 0);
        }
    }
}

TEST(Terrain, the_default_size_keeps_its_budget_of_triangles) {
    HeightField field(256, 96'000);
    Island const island(1, 96'000);
    for (int j = 0; j < field.nodes(); ++j) {
        for (int i = 0; i < field.nodes(); ++i)
            field.at(i, j) = island.inland(field.position(i), field.position(j)) > 0 ? 500 : -50;
    }
    Fineness const fineness({{2000, 11'000, 550}, {15'000, 6000, 550}, {4000, 3000, 400}});
    std::size_t const triangles =
        plan_tiles(Relief(field, fineness, 1, RADIUS)).leaves().size() * 2 * Tile::CELLS * Tile::CELLS;
    EXPECT_GT(triangles, 400'000u);
    EXPECT_LT(triangles, 650'000u);
}

TEST(Terrain, is_one_valid_glb_and_the_same_for_any_number_of_threads) {
    Folder const folder;
    std::vector<TerrainSite> const sites = write_terrain(small_options(1), folder.path / "one.glb");
    write_terrain(small_options(2), folder.path / "two.glb");
    std::vector<std::byte> const bytes = read_file(folder.path / "one.glb");
    EXPECT_GT(bytes.size(), 1'000'000u);
    EXPECT_TRUE(bytes == read_file(folder.path / "two.glb"));

    std::uint32_t words[5];
    std::memcpy(words, bytes.data(), sizeof words);
    EXPECT_EQ(words[0], 0x46546C67u);
    EXPECT_EQ(words[2], bytes.size());
    char const* const text = reinterpret_cast<char const*>(bytes.data()) + 20;
    auto const json = nlohmann::json::parse(text, text + words[3]);
    std::size_t const binary = 28 + words[3];
    EXPECT_EQ(binary + json["buffers"][0]["byteLength"].get<std::size_t>(), bytes.size());
    EXPECT_EQ(json["scenes"][0]["extras"]["sites"].size(), sites.size());
    std::map<int, std::size_t> const component{{5123, 2}, {5126, 4}};
    std::map<std::string, std::size_t> const count{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
    for (auto const& a : json["accessors"]) {
        auto const& view = json["bufferViews"][a["bufferView"].get<std::size_t>()];
        std::size_t const element = component.at(a["componentType"]) * count.at(a["type"]);
        std::size_t const stride = view.value("byteStride", element), offset = a.value("byteOffset", std::size_t{0});
        ASSERT_LE(offset + stride * (a["count"].get<std::size_t>() - 1) + element,
                  view["byteLength"].get<std::size_t>());
        ASSERT_EQ((view["byteOffset"].get<std::size_t>() + offset) % 4, 0u);
        if (!a.contains("min")) continue;
        for (std::size_t k = 0; k < a["count"]; ++k) {
            float p[3];
            std::memcpy(p, &bytes[binary + view["byteOffset"].get<std::size_t>() + offset + stride * k], sizeof p);
            for (std::size_t c = 0; c < 3; ++c)
                ASSERT_TRUE(p[c] >= a["min"][c].get<float>() && p[c] <= a["max"][c].get<float>());
        }
    }
}

TEST(Terrain, a_gltf_has_its_buffer_and_pictures_beside_it) {
    Folder const folder;
    GltfWriter writer;
    std::array<std::byte, 5> const bytes{};
    writer.add_view(bytes);
    EXPECT_EQ(writer.add_view(bytes), 1);
    writer.add_picture("grain", "png", std::vector<std::byte>(7));
    writer.write(folder.path / "small.gltf");
    auto const json = nlohmann::json::parse(read_text_file(folder.path / "small.gltf"));
    EXPECT_EQ(json["bufferViews"][1]["byteOffset"], 8); // aligned to 4
    EXPECT_EQ(read_file(folder.path / json["buffers"][0]["uri"].get<std::string>()).size(),
              json["buffers"][0]["byteLength"]);
    EXPECT_EQ(read_file(folder.path / json["images"][0]["uri"].get<std::string>()).size(), 7u);
}

TEST(Terrain, options_out_of_range_are_refused) {
    Folder const folder;
    for (double const side : {0.0, -3.0, 1e9, std::nan("")}) {
        TerrainOptions options;
        options.side_km = side;
        EXPECT_THROW(write_terrain(options, folder.path / "x.glb"), Error);
    }
    TerrainOptions far = small_options(0);
    far.fine = {{1e6, 0, 600}};
    EXPECT_THROW(write_terrain(far, folder.path / "x.glb"), Error);
    EXPECT_THROW(write_terrain(small_options(0), folder.path / "x.obj"), Error);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path));
}

TEST(Terrain, a_skyline_of_a_step_is_where_trigonometry_puts_it) {
    HeightField field(100, 10'000);
    for (int j = 0; j < field.nodes(); ++j) {
        for (int i = 0; i < field.nodes(); ++i) field.at(i, j) = field.position(i) > 2950 ? 1000 : 0;
    }
    double const east = skyline_elevation(field, 0, 0, 0, 0.5 * 3.14159265358979, RADIUS);
    EXPECT_NEAR(east, std::atan2(1000, 3000), 0.006); // the ray's steps are 30 m
    EXPECT_LT(skyline_elevation(field, 0, 0, 2, 1.5 * 3.14159265358979, RADIUS), 0);
}

TEST(Terrain, the_highest_ground_nearby_is_found) {
    double east = 130, north = -70;
    auto const ground = [](double e, double n) { return 100 - std::hypot(e - 20, n - 10); };
    move_to_highest(ground, 150, 5, east, north);
    EXPECT_DOUBLE_EQ(east, 20);
    EXPECT_DOUBLE_EQ(north, 10);
}
