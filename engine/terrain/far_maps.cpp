#include "terrain/far_maps.h"

#include "image/color.h"
#include "terrain/ground.h"
#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <mutex>

namespace alpenglow {

namespace {

constexpr double FINEST_TEXEL = 5; ///< [m]

FarMap make_map(double west, double south, double side, int size) {
    Extent const extent{static_cast<std::uint32_t>(size), static_cast<std::uint32_t>(size)};
    return {west, south, side, ByteImage(extent), ByteImage(extent)};
}

/// A map around a place, moved onto the lattice of the tiles that are a quarter as large, and into the terrain.
FarMap map_around(Relief const& relief, glm::dvec2 place, double side, int size) {
    double const quarter = side / 4, half = 0.5 * relief.field().side();
    auto const corner = [&](double x) {
        return std::clamp(std::round((x - 0.5 * side + half) / quarter) * quarter - half, -half, half - side);
    };
    return make_map(corner(place.x), corner(place.y), side, size);
}

bool holds(FarMap const& map, glm::dvec2 corner, double size) {
    constexpr double rounding = 1e-3; // [m]
    return corner.x > map.west - rounding && corner.y > map.south - rounding &&
           corner.x + size < map.west + map.side + rounding && corner.y + size < map.south + map.side + rounding;
}

/// The tile's own normal, as the renderer interpolates it, at a place of it from 0 to 1.
glm::dvec3 vertex_normal(Tile const& tile, double u, double v) {
    double const x = u * Tile::CELLS, y = v * Tile::CELLS;
    int const i = std::min(static_cast<int>(x), Tile::CELLS - 1), j = std::min(static_cast<int>(y), Tile::CELLS - 1);
    auto const at = [&](int a, int b) {
        return glm::dvec3(tile.vertices[static_cast<std::size_t>((j + b) * Tile::NODES + i + a)].normal);
    };
    return glm::normalize(glm::mix(glm::mix(at(0, 0), at(1, 0), x - i), glm::mix(at(0, 1), at(1, 1), x - i), y - j));
}

/// The texel that turns the vertex normal `n` (east, north, up) into the normal of ground with this slope. The
/// renderer's tangents are the directions east and north less their part along n, over the longer one's length.
glm::dvec3 normal_texel(glm::dvec3 n, glm::dvec2 slope) {
    n.z = std::max(n.z, 0.1);
    glm::dvec2 const steeper(slope.x + n.x / n.z, slope.y + n.y / n.z);
    double const length = std::sqrt(std::max(1 - std::min(n.x * n.x, n.y * n.y), 1e-3));
    double const along = 1 / n.z - steeper.x * n.x - steeper.y * n.y;
    return glm::normalize(glm::dvec3(-steeper.x * length, -steeper.y * length, std::max(along, 0.05)));
}

class Painter {
public:
    Painter(Relief const& relief, std::uint32_t seed, FarMap& map, Tile const& tile, glm::dvec2 corner, double size)
        : relief_(relief), seed_(seed), map_(map), tile_(tile), corner_(corner),
          count_(static_cast<int>(std::lround(size / map.texel()))) {}

    void paint() {
        std::vector<ReliefSample> lattice;
        lattice.reserve(std::size_t(count_ + 1) * (count_ + 1));
        for (int j = 0; j <= count_; ++j) {
            for (int i = 0; i <= count_; ++i) {
                glm::dvec2 const p = corner_ + glm::dvec2(i, j) * map_.texel();
                lattice.push_back(relief_.sample(p.x, p.y, map_.texel()));
            }
        }
        for (int j = 0; j < count_; ++j) {
            for (int i = 0; i < count_; ++i) {
                ReliefSample const* const row = &lattice[std::size_t(j) * (count_ + 1) + i];
                paint_texel(i, j, {row[0], row[1], row[count_ + 1], row[count_ + 2]});
            }
        }
    }

private:
    /// From the ground at the texel's corners: south-west, south-east, north-west, north-east.
    void paint_texel(int i, int j, std::array<ReliefSample, 4> const& at) {
        double const twice = 2 * map_.texel();
        glm::dvec2 const slope((at[1].altitude + at[3].altitude - at[0].altitude - at[2].altitude) / twice,
                               (at[2].altitude + at[3].altitude - at[0].altitude - at[1].altitude) / twice);
        glm::dvec2 const p = corner_ + (glm::dvec2(i, j) + 0.5) * map_.texel();
        double const altitude = 0.25 * (at[0].altitude + at[1].altitude + at[2].altitude + at[3].altitude);
        double const steepness = glm::length(slope), level = 1 / std::sqrt(1 + steepness * steepness);
        double const gully = 0.25 * (at[0].gully + at[1].gully + at[2].gully + at[3].gully);
        glm::dvec3 const albedo = ground_albedo(seed_, {p.x, p.y, altitude, steepness, -slope.y * level, gully});

        glm::dvec3 const up = relief_.up(p.x, p.y), east = glm::normalize(glm::dvec3(up.y, -up.x, 0));
        glm::dvec3 const n = vertex_normal(tile_, (i + 0.5) / count_, (j + 0.5) / count_);
        glm::dvec3 const texel =
            normal_texel({glm::dot(n, east), glm::dot(n, glm::cross(up, east)), glm::dot(n, up)}, slope);

        glm::dvec2 const uv = map_.uv(p.x, p.y) * double(map_.color.extent.width);
        auto const column = static_cast<std::uint32_t>(uv.x), line = static_cast<std::uint32_t>(uv.y);
        std::uint8_t *const color = map_.color.at(column, line), *const normal = map_.normal.at(column, line);
        for (int c = 0; c < 3; ++c) {
            color[c] = srgb_byte_from_linear(static_cast<float>(albedo[c]));
            normal[c] = static_cast<std::uint8_t>(std::lround(127.5 + 127.5 * texel[c]));
        }
        color[3] = normal[3] = 255;
    }

    Relief const& relief_;
    std::uint32_t seed_;
    FarMap& map_;
    Tile const& tile_;
    glm::dvec2 corner_;
    int count_; ///< texels along the tile
};

/// The whole terrain's, which comes first, holds every tile.
std::size_t finest_map(std::vector<FarMap> const& maps, glm::dvec2 corner, double size) {
    std::size_t best = 0;
    for (std::size_t m = 1; m < maps.size(); ++m) {
        if (holds(maps[m], corner, size) && maps[m].texel() < maps[best].texel()) best = m;
    }
    return best;
}

/// What a map leaves to others it takes from them, so that its smaller mips are right up to the edge of what it shows.
void fill_blanks(FarMap& map, std::vector<FarMap> const& maps, int threads) {
    auto const size = map.color.extent.width;
    parallel_for(static_cast<int>(size), threads, [&](int row) {
        auto const line = static_cast<std::uint32_t>(row);
        for (std::uint32_t column = 0; column < size; ++column) {
            if (map.color.at(column, line)[3]) continue;
            double const east = map.west + (column + 0.5) * map.texel();
            double const north = map.south + map.side - (line + 0.5) * map.texel();
            for (FarMap const& other : maps) {
                if (&other == &map || !holds(other, {east, north}, 0)) continue;
                glm::dvec2 const uv = other.uv(east, north) * double(other.color.extent.width);
                auto const x = static_cast<std::uint32_t>(uv.x), y = static_cast<std::uint32_t>(uv.y);
                if (!other.color.at(x, y)[3]) continue;
                std::copy_n(other.color.at(x, y), 4, map.color.at(column, line));
                std::copy_n(other.normal.at(x, y), 4, map.normal.at(column, line));
                break;
            }
        }
    });
}

void lay_on(FarMap const& map, Tile& tile, glm::dvec2 corner, double size) {
    for (int k = 0; k < Tile::NODES * Tile::NODES; ++k) {
        glm::dvec2 const p = corner + glm::dvec2(k % Tile::NODES, k / Tile::NODES) * (size / Tile::CELLS);
        tile.vertices[static_cast<std::size_t>(k)].uv = glm::vec2(map.uv(p.x, p.y));
        tile.vertices[static_cast<std::size_t>(k)].color = {65535, 65535, 65535, 65535};
    }
}

} // namespace

std::vector<FarMap> plan_far_maps(Relief const& relief, int size) {
    double const side = relief.field().side();
    std::vector<FinePlace> const& places = relief.fineness().places();
    glm::dvec2 middle(0);
    for (FinePlace const& p : places) middle += glm::dvec2(p.east, p.north) / double(places.size());

    int whole = size;
    while (whole > 64 && side / whole < FINEST_TEXEL) whole /= 2;
    std::vector<FarMap> maps{make_map(-0.5 * side, -0.5 * side, side, whole)};
    auto const add = [&](glm::dvec2 place, int part, int texels) {
        if (side / part / texels >= FINEST_TEXEL) maps.push_back(map_around(relief, place, side / part, texels));
    };
    add(middle, 2, size);
    for (FinePlace const& p : places) {
        add({p.east, p.north}, 8, size / 2);
        add({p.east, p.north}, 32, size / 4);
    }
    return maps;
}

void clad_far_tiles(std::vector<Tile>& tiles, std::vector<FarMap>& maps, Relief const& relief, std::uint32_t seed,
                    int threads, std::function<void(int, int)> const& tile_done) {
    std::mutex mutex;
    int done = 0;
    int const count = static_cast<int>(tiles.size());
    parallel_for(count, threads, [&](int k) {
        Tile& tile = tiles[static_cast<std::size_t>(k)];
        double const side = relief.field().side(), size = side / (1 << tile.key.level);
        glm::dvec2 const corner = glm::dvec2(tile.key.x, tile.key.y) * size - 0.5 * side;
        FarMap& map = maps[finest_map(maps, corner, size)];
        if (size >= map.texel()) Painter(relief, seed, map, tile, corner, size).paint();
        if (size / Tile::CELLS > 1.01 * map.texel())
            lay_on(map, tile, corner, size), tile.map = static_cast<int>(&map - maps.data());
        std::lock_guard const lock(mutex);
        tile_done(++done, count);
    });
    for (FarMap& map : maps) fill_blanks(map, maps, threads);
}

} // namespace alpenglow
