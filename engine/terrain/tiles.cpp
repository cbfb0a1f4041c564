#include "terrain/tiles.h"

#include "terrain/ground.h"
#include "terrain/noise.h"
#include "core/parallel.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace alpenglow {

namespace {

double tile_side(double side, int level) { return side / (1 << level); }

bool all_under_sea(HeightField const& field, double west, double south, double size) {
    auto const node = [&](double x) {
        return std::clamp(static_cast<int>((x / field.side() + 0.5) * (field.nodes() - 1)), 0, field.nodes() - 1);
    };
    for (int j = node(south); j <= std::min(node(south + size) + 1, field.nodes() - 1); ++j) {
        for (int i = node(west); i <= std::min(node(west + size) + 1, field.nodes() - 1); ++i) {
            if (field.at(i, j) > -15) return false;
        }
    }
    return true;
}

bool wants_split(Relief const& relief, TileKey const& key) {
    double const side = relief.field().side(), size = tile_side(side, key.level), spacing = size / Tile::CELLS;
    double const west = -0.5 * side + key.x * size, south = -0.5 * side + key.y * size;
    // Near the middle: a tile that a fine place's circle only touches stays coarse.
    double wanted = relief.fineness().spacing(west + 0.5 * size, south + 0.5 * size, 0.1 * size);
    if (all_under_sea(relief.field(), west, south, size)) wanted = 2 * Fineness::COARSEST;
    return spacing > 1.4 * wanted;
}

std::uint16_t unorm16(double x) { return static_cast<std::uint16_t>(std::lround(65535 * std::clamp(x, 0.0, 1.0))); }

/// Scene coordinates on the lattice that all tiles share.
glm::dvec3 snapped(glm::dvec3 const& p) { return glm::round(p * 1024.0) / 1024.0; }

/// [m] The detail pictures are stretched here and squeezed there, so that no rows of them show.
glm::dvec2 detail_shift(std::uint32_t seed, double east, double north) {
    constexpr double wave = 45, reach = 5;
    return reach * glm::dvec2(gradient_noise(seed + 361, east / wave, north / wave),
                              gradient_noise(seed + 362, east / wave, north / wave));
}

TileVertex make_vertex(Relief const& relief, std::uint32_t seed, Tile const& tile, glm::dvec2 const& uv_origin,
                       double east, double north) {
    auto const [altitude, gully] = relief.sample(east, north, relief.fineness().spacing(east, north));
    glm::dvec3 const normal = relief.normal(east, north), up = relief.up(east, north);
    double const level = std::max(glm::dot(normal, up), 0.02),
                 slope = std::sqrt(std::max(0.0, 1 - level * level)) / level;
    glm::dvec3 const albedo = ground_albedo(seed, {east, north, altitude, slope, -normal.z, gully}) / DETAIL_MEAN;
    return {glm::vec3(snapped(relief.position(east, north, altitude)) - tile.origin),
            glm::vec3(normal),
            glm::vec2((glm::dvec2(east, -north) + detail_shift(seed, east, north)) / DETAIL_PERIOD - uv_origin),
            {unorm16(albedo.r), unorm16(albedo.g), unorm16(albedo.b), 65535}};
}

void fill_tile(Relief const& relief, std::uint32_t seed, Tile& tile) {
    double const side = relief.field().side();
    // From whole numbers of the tile's level: a quotient of powers of two, so that tiles of all levels agree to the
    // bit.
    auto const coordinate = [&](int k) {
        return side * (static_cast<double>(k) / (Tile::CELLS << tile.key.level)) - 0.5 * side;
    };
    double const centre_east = coordinate(tile.key.x * Tile::CELLS + Tile::CELLS / 2);
    double const centre_north = coordinate(tile.key.y * Tile::CELLS + Tile::CELLS / 2);
    tile.origin = glm::round(relief.position(centre_east, centre_north));
    glm::dvec2 const uv_origin = glm::floor(glm::dvec2(centre_east, -centre_north) / DETAIL_PERIOD);
    tile.vertices.reserve(Tile::NODES * Tile::NODES);
    for (int y = 0; y < Tile::NODES; ++y) {
        for (int x = 0; x < Tile::NODES; ++x) {
            tile.vertices.push_back(make_vertex(relief, seed, tile, uv_origin, coordinate(tile.key.x * Tile::CELLS + x),
                                                coordinate(tile.key.y * Tile::CELLS + y)));
        }
    }
}

} // namespace

std::vector<std::uint16_t> tile_indices(unsigned coarser) {
    constexpr int ring[8][2] = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
    std::vector<std::uint16_t> indices;
    for (int y = 0; y < Tile::CELLS; y += 2) {
        for (int x = 0; x < Tile::CELLS; x += 2) {
            auto const index = [&](int a, int b) { return static_cast<std::uint16_t>((y + b) * Tile::NODES + x + a); };
            // A fan around the middle of 2 x 2 cells, without the midpoints that a coarser neighbour doesn't have.
            bool const absent[8] = {false, y == 0 && (coarser & SOUTH),
                                    false, x == Tile::CELLS - 2 && (coarser & EAST),
                                    false, y == Tile::CELLS - 2 && (coarser & NORTH),
                                    false, x == 0 && (coarser & WEST)};
            for (int k = 0; k < 8; ++k) {
                if (absent[k]) continue;
                int const next = absent[(k + 1) % 8] ? (k + 2) % 8 : (k + 1) % 8;
                indices.insert(indices.end(),
                               {index(1, 1), index(ring[k][0], ring[k][1]), index(ring[next][0], ring[next][1])});
            }
        }
    }
    return indices;
}

Quadtree plan_tiles(Relief const& relief) {
    return Quadtree([&](TileKey const& key) { return wants_split(relief, key); });
}

std::vector<Tile> make_tiles(Relief const& relief, std::uint32_t seed, int threads,
                             std::function<void(int, int)> const& tile_done) {
    Quadtree const tree = plan_tiles(relief);
    std::vector<TileKey> const keys = tree.leaves();
    int const count = static_cast<int>(keys.size());
    std::vector<Tile> tiles(keys.size());
    std::mutex mutex;
    int done = 0;
    parallel_for(count, threads, [&](int k) {
        tiles[k].key = keys[k];
        tiles[k].coarser = tree.coarser_sides(keys[k]);
        fill_tile(relief, seed, tiles[k]);
        std::lock_guard const lock(mutex);
        tile_done(++done, count);
    });
    return tiles;
}

} // namespace alpenglow
