#include "terrain/terrain_gltf.h"

#include "image/codec.h"

#include <array>
#include <cstddef>
#include <fmt/format.h>

namespace alpenglow {

namespace {

using Json = nlohmann::ordered_json;

// Numbers of the glTF 2.0 specification.
constexpr int UNSIGNED_SHORT = 5123, FLOAT = 5126, ARRAY_BUFFER = 34962, ELEMENT_ARRAY_BUFFER = 34963, REPEAT = 10497,
              LINEAR = 9729, LINEAR_MIPMAP_LINEAR = 9987;

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

void add_material(GltfWriter& gltf, DetailPictures const& pictures) {
    int const color = gltf.add_png("grain_color", encode_png(pictures.color));
    int const normal = gltf.add_png("grain_normal", encode_png(pictures.normal));
    gltf.json["samplers"] = {
        {{"magFilter", LINEAR}, {"minFilter", LINEAR_MIPMAP_LINEAR}, {"wrapS", REPEAT}, {"wrapT", REPEAT}}};
    gltf.json["textures"] = {{{"sampler", 0}, {"source", color}}, {{"sampler", 0}, {"source", normal}}};
    gltf.json["materials"] = {
        {{"name", "ground"},
         {"pbrMetallicRoughness",
          {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}, {"roughnessFactor", 0.9}}},
         {"normalTexture", {{"index", 1}}}}};
}

} // namespace

GltfWriter terrain_gltf(std::vector<Tile> const& tiles, DetailPictures const& pictures,
                        std::vector<TerrainSite> const& sites) {
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
        gltf.json["meshes"].push_back(
            {{"name", name},
             {"primitives",
              {{{"attributes", add_attributes(gltf, tile)}, {"indices", indices[tile.coarser]}, {"material", 0}}}}});
    }
    add_material(gltf, pictures);
    return gltf;
}

} // namespace alpenglow
