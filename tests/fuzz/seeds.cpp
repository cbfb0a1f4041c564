#include "core/error.h"
#include "image/codec.h"
#include "support/gltf_packed.h"
#include "support/gltf_samples.h"

#include <webp/encode.h>

#include <cstdio>

// Writes the files that the fuzz target begins with: small good ones of every kind that the importer reads.

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

ByteImage small_picture() {
    ByteImage image({8, 8});
    for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = static_cast<std::uint8_t>(37 * i);
    return image;
}

std::vector<std::byte> webp_of(ByteImage const& image) {
    std::uint8_t* encoded = nullptr;
    int const width = static_cast<int>(image.extent.width);
    std::size_t const size = WebPEncodeLosslessRGBA(image.rgba.data(), width, static_cast<int>(image.extent.height), 4 * width, &encoded);
    auto const* const first = reinterpret_cast<std::byte const*>(encoded);
    std::vector<std::byte> bytes(first, first + size);
    WebPFree(encoded);
    return bytes;
}

/// A triangle with a picture that lies in the buffer.
GltfBuilder with_picture(std::vector<std::byte> const& bytes, char const* type) {
    GltfBuilder builder = one_triangle();
    builder.json["images"] = {{{"bufferView", builder.add_view(bytes)}, {"mimeType", type}}};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    if (std::string(type) == "image/webp") {
        builder.json["textures"] = {{{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}}};
        builder.json["extensionsUsed"] = {"EXT_texture_webp"};
    }
    return builder;
}

/// Materials, lights, variants and quantized vertices: the extensions that are read from JSON.
GltfBuilder with_extensions() {
    GltfBuilder builder = good_scene();
    nlohmann::json const transform = {{"KHR_texture_transform", {{"offset", {0.5, 0}}, {"rotation", 1}, {"scale", {2, 2}}, {"texCoord", 0}}}};
    builder.json["materials"][0]["normalTexture"]["extensions"] = transform;
    builder.json["materials"][0]["extensions"] = {{"KHR_materials_emissive_strength", {{"emissiveStrength", 5}}},
                                                  {"KHR_materials_ior", {{"ior", 1.4}}},
                                                  {"KHR_materials_specular", {{"specularFactor", 0.5}, {"specularColorFactor", {1, 1, 0.5}}}},
                                                  {"KHR_materials_unlit", nlohmann::json::object()}};
    builder.json["extensions"] = {{"KHR_lights_punctual", {{"lights", {{{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}}}}}}}},
                                  {"KHR_materials_variants", {{"variants", {{{"name", "red"}}}}}}};
    builder.json["nodes"][1]["extensions"] = {{"KHR_lights_punctual", {{"light", 0}}}};
    builder.json["meshes"][0]["primitives"][0]["extensions"] = {{"KHR_materials_variants", {{"mappings", {{{"material", 0}, {"variants", {0}}}}}}}};
    int const places = builder.add<std::int16_t>("VEC3", {0, 0, 0, 0, 100, 0, 0, 0, 0, 100, 0, 0});
    builder.json["accessors"][places]["count"] = 3;
    builder.json["bufferViews"].back()["byteStride"] = 8;
    builder.show({{"POSITION", places}});
    builder.json["extensionsUsed"] = {"KHR_texture_transform", "KHR_materials_emissive_strength", "KHR_materials_ior", "KHR_materials_specular",
                                      "KHR_materials_unlit", "KHR_lights_punctual", "KHR_materials_variants", "KHR_mesh_quantization"};
    builder.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    return builder;
}

void write_seeds(std::filesystem::path const& folder) {
    write_text_file(folder / "good.gltf", good_scene().gltf());
    write_text_file(folder / "rich.gltf", rich_scene().gltf());
    write_text_file(folder / "rich.glb", rich_scene().glb());
    write_text_file(folder / "extensions.glb", with_extensions().glb());
    write_text_file(folder / "meshopt.gltf", packed_by_meshopt().gltf());
    write_text_file(folder / "draco.glb", packed_by_draco().glb());
    write_text_file(folder / "png.glb", with_picture(encode_png(small_picture()), "image/png").glb());
    write_text_file(folder / "jpeg.glb", with_picture(encode_jpeg(small_picture(), 80), "image/jpeg").glb());
    write_text_file(folder / "webp.glb", with_picture(webp_of(small_picture()), "image/webp").glb());
}

} // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::fputs("use: fuzz_seeds FOLDER\n", stderr);
        return 2;
    }
    try {
        write_seeds(arguments[1]);
    } catch (std::exception const& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}
