#pragma once

#include "terrain/detail_pictures.h"
#include "terrain/gltf_writer.h"
#include "terrain/terrain.h"
#include "terrain/tiles.h"

#include <vector>

namespace alpenglow {

/// One node and one mesh for each tile, under one material; the sites in the scene's extras.
GltfWriter terrain_gltf(std::vector<Tile> const& tiles, DetailPictures const& pictures,
                        std::vector<TerrainSite> const& sites);

} // namespace alpenglow
