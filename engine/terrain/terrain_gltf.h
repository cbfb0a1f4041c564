#pragma once

#include "terrain/detail_pictures.h"
#include "terrain/far_maps.h"
#include "terrain/gltf_writer.h"
#include "terrain/terrain.h"
#include "terrain/tiles.h"

#include <vector>

namespace alpenglow {

/// One node and one mesh for each tile; one material for near ground and one for each far map; the sites in the scene's
/// extras.
GltfWriter terrain_gltf(std::vector<Tile> const& tiles, std::vector<FarMap> const& maps, DetailPictures const& pictures,
                        std::vector<TerrainSite> const& sites, int threads);

} // namespace alpenglow
