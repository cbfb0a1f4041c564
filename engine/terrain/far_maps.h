#pragma once

#include "image/image.h"
#include "terrain/relief.h"
#include "terrain/tiles.h"

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

namespace alpenglow {

/// A square of the terrain seen from above, in pictures: what tiles with few vertices are clad with. North is up.
struct FarMap {
    double west = 0, south = 0, side = 0; ///< [m]
    ByteImage color;                      ///< sRGB
    /// The relief's normals over the vertices' own: X along u, Y to decreasing v, as in glTF.
    ByteImage normal;

    double texel() const { return side / color.extent.width; }                       ///< [m]
    glm::dvec2 uv(double east, double north) const {
        return {(east - west) / side, 1 - (north - south) / side};
    }
};

/// Blank maps: the whole terrain and its half around the fine places, `size` texels along each; an eighth and a
/// 32nd of its side around each fine place, with a half and a quarter as many texels. Maps whose texels would be finer
/// than the vertices ever are get fewer texels, or are left out.
std::vector<FarMap> plan_far_maps(Relief const& relief, int size);

/// Draws each tile on the finest map that holds it, and lays those whose vertices stand farther apart than its texels
/// onto it (`Tile::map`, texture coordinates). `tile_done` as for make_tiles.
void clad_far_tiles(std::vector<Tile>& tiles, std::vector<FarMap>& maps, Relief const& relief, std::uint32_t seed,
                    int threads, std::function<void(int, int)> const& tile_done);

} // namespace alpenglow
