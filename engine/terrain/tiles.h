#pragma once

#include "terrain/quadtree.h"
#include "terrain/relief.h"

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace alpenglow {

/// As it stands in the file, 40 bytes.
struct TileVertex {
    glm::vec3 position; ///< [m] from the tile's origin
    glm::vec3 normal;
    glm::vec2 uv;                       ///< in periods of the detail pictures, or on the tile's far map
    std::array<std::uint16_t, 4> color; ///< linear, 65535 is 1
};
static_assert(sizeof(TileVertex) == 40);

/// A square of 16 x 16 cells. Its vertices, (17 y + x), all lie on a lattice of 1/1024 m in the scene frame, and its
/// origin on one of 1 m, so that origin + position is exact and two tiles that share a vertex agree on it to the bit.
struct Tile {
    static constexpr int CELLS = 16, NODES = CELLS + 1, NO_MAP = -1;

    TileKey key;
    unsigned coarser = 0; ///< TileSide bits: which triangles it has (tile_indices)
    int map = NO_MAP;     ///< the far map that clads it; none: the detail pictures
    glm::dvec3 origin{0}; ///< [m] scene frame
    std::vector<TileVertex> vertices;
};

/// Metres on the ground for one period of the detail pictures.
inline constexpr double DETAIL_PERIOD = 11;
/// Mean linear value of the detail picture, by which the vertices' colours are divided.
inline constexpr double DETAIL_MEAN = 0.8;

/// Triangles, counter-clockwise from above, of a tile with these coarser neighbours: along such a side every second
/// vertex is unused.
std::vector<std::uint16_t> tile_indices(unsigned coarser);

/// Which tiles cover the field's square.
Quadtree plan_tiles(Relief const& relief);

/// The tiles of plan_tiles, made. `tile_done(done, all)` is called from any thread, one call at a time.
std::vector<Tile> make_tiles(Relief const& relief, std::uint32_t seed, int threads,
                             std::function<void(int, int)> const& tile_done);

} // namespace alpenglow
