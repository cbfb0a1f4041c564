#include "terrain/terrain_gltf.h"

#include "image/codec.h"
#include "core/parallel.h"

#include <array>
#include <cstddef>
#include <fmt/format.h>

namespace alpenglow {

namespace {

using Json = nlohmann::ordered_json;

// Numbers of the glTF 2.0 specification.
constexpr int UNSIGNED_SHORT = 5123, FLOAT = 5126, ARRAY_BUFFER = 34962, ELEMENT_ARRAY_BUFFER = 34963, REPEAT = 10497,
              CLAMP_TO_EDGE = 33071, LINEAR = 9729, LINEAR_MIPMAP_LINEAR = 9987;

int add_accessor(GltfWriter& gltf, Json accessor) {
    gltf.json["accessors"].push_back(std::move(accessor));
    return static_cast<int>(gltf.json["accessors"].size()) - 1;
}

/// One accessor for each of the 16 sets of coarser neighbours; tiles share them.
std::array<int, 16> add_indices(GltfWriter& gltf) {
    std::array<int, 16> accessors{};
    for (unsigned coarser = 0; coarser < 16; ++coarser) {
        std::vector<std::uint16_t> const indices = tile_indices(coarser);
        int const view = gltf.add_view(std::as_bytes(std::span(indices)), 0, ELEMENT_ARRAY_BUFFER);
        accessors[coarser] = add_accessor(
            gltf,
            {{"bufferView", view}, {"componentType", UNSIGNED_SHORT}, {"count", indices.size()}, {"type", "SCALAR"}});
    }
    return accessors;
}

Json position_accessor(Json accessor, Tile const& tile) {
    glm::vec3 lowest = tile.vertices.front().position, highest = lowest;
    for (TileVertex const& v : tile.vertices)
        lowest = glm::min(lowest, v.position), highest = glm::max(highest, v.position);
    accessor["min"] = {lowest.x, lowest.y, lowest.z};
    accessor["max"] = {highest.x, highest.y, highest.z};
    return accessor;
}

Json add_attributes(GltfWriter& gltf, Tile const& tile) {
    int const view = gltf.add_view(std::as_bytes(std::span(tile.vertices)), sizeof(TileVertex), ARRAY_BUFFER);
    auto const accessor = [&](std::size_t offset, int component, char const* type) {
        return Json{{"bufferView", view},
                    {"byteOffset", offset},
                    {"componentType", component},
                    {"count", tile.vertices.size()},
                    {"type", type}};
    };
    Json color = accessor(offsetof(TileVertex, color), UNSIGNED_SHORT, "VEC4");
    color["normalized"] = true;
    return {{"POSITION",
             add_accessor(gltf, position_accessor(accessor(offsetof(TileVertex, position), FLOAT, "VEC3"), tile))},
            {"NORMAL", add_accessor(gltf, accessor(offsetof(TileVertex, normal), FLOAT, "VEC3"))},
            {"TEXCOORD_0", add_accessor(gltf, accessor(offsetof(TileVertex, uv), FLOAT, "VEC2"))},
            {"COLOR_0", add_accessor(gltf, std::move(color))}};
}

int add_texture(GltfWriter& gltf, int sampler, int source) {
    gltf.json["textures"].push_back({{"sampler", sampler}, {"source", source}});
    return static_cast<int>(gltf.json["textures"].size()) - 1;
}

void add_material(GltfWriter& gltf, std::string const& name, int color, int normal) {
    gltf.json["materials"].push_back(
        {{"name", name},
         {"pbrMetallicRoughness",
          {{"baseColorTexture", {{"index", color}}}, {"metallicFactor", 0}, {"roughnessFactor", 0.9}}},
         {"normalTexture", {{"index", normal}}}});
}

/// Material 0 is the near ground's, 1 + k that of far map k.
void add_materials(GltfWriter& gltf, std::vector<FarMap> const& maps, DetailPictures const& pictures, int threads) {
    auto const sampler = [](int wrap) {
        return Json{{"magFilter", LINEAR}, {"minFilter", LINEAR_MIPMAP_LINEAR}, {"wrapS", wrap}, {"wrapT", wrap}};
    };
    gltf.json["samplers"] = {sampler(REPEAT), sampler(CLAMP_TO_EDGE)};
    int const color = gltf.add_picture("grain_color", "png", encode_png(pictures.color));
    int const normal = gltf.add_picture("grain_normal", "png", encode_png(pictures.normal));
    add_material(gltf, "ground", add_texture(gltf, 0, color), add_texture(gltf, 0, normal));

    constexpr int quality = 93;
    std::vector<std::array<std::vector<std::byte>, 2>> encoded(maps.size());
    parallel_for(static_cast<int>(2 * maps.size()), threads, [&](int k) {
        FarMap const& map = maps[std::size_t(k) / 2];
        encoded[std::size_t(k) / 2][std::size_t(k) % 2] =
            k % 2 ? encode_png(map.normal) : encode_jpeg(map.color, quality);
    });
    for (std::size_t k = 0; k < maps.size(); ++k) {
        int const far_color = gltf.add_picture(fmt::format("far_color_{}", k), "jpeg", std::move(encoded[k][0]));
        int const far_normal = gltf.add_picture(fmt::format("far_normal_{}", k), "png", std::move(encoded[k][1]));
        add_material(gltf, fmt::format("far_{}", k), add_texture(gltf, 1, far_color), add_texture(gltf, 1, far_normal));
    }
}

} // namespace

GltfWriter terrain_gltf(std::vector<Tile> const& tiles, std::vector<FarMap> const& maps, DetailPictures const& pictures,
                        std::vector<TerrainSite> const& sites, int threads) {
    GltfWriter gltf;
    Json children = Json::array(), places = Json::array();
    for (std::size_t k = 0; k < tiles.size(); ++k) children.push_back(k);
    for (TerrainSite const& s : sites) {
        places.push_back(
            {{"name", s.name}, {"east", s.east}, {"north", s.north}, {"altitude", s.altitude}, {"heading", s.heading}});
    }
    gltf.json["scene"] = 0;
    gltf.json["scenes"] = {
        {{"name", "terrain"}, {"nodes", std::move(children)}, {"extras", {{"sites", std::move(places)}}}}};
    std::array<int, 16> const indices = add_indices(gltf);
    for (std::size_t k = 0; k < tiles.size(); ++k) {
        Tile const& tile = tiles[k];
        std::string const name = fmt::format("tile_{}_{}_{}", tile.key.level, tile.key.x, tile.key.y);
        gltf.json["nodes"].push_back(
            {{"name", name}, {"mesh", k}, {"translation", {tile.origin.x, tile.origin.y, tile.origin.z}}});
        gltf.json["meshes"].push_back({{"name", name},
                                       {"primitives",
                                        {{{"attributes", add_attributes(gltf, tile)},
                                          {"indices", indices[tile.coarser]},
                                          {"material", 1 + tile.map}}}}});
    }
    add_materials(gltf, maps, pictures, threads);
    return gltf;
}

} // namespace alpenglow
