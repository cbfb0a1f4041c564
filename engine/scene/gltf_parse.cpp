#include "scene/gltf_parse.h"

#include "scene/gltf_json.h"
#include "scene/gltf_material_extensions.h"
#include "scene/gltf_nodes.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wextra"
// Debian's libdraco has another version of tinygltf inside, under the same names: ours is compiled here, under its own.
#define tinygltf alpenglow_tinygltf
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_INCLUDE_JSON
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>
#pragma GCC diagnostic pop

namespace alpenglow::gltf {

namespace {

using namespace nlohmann::literals;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// tinygltf refuses indices without bytes of their own; this says why they have none.
void check_index_views(nlohmann::json const& json, Report const& report) {
    nlohmann::json const none = nlohmann::json::array();
    nlohmann::json const& meshes = json.contains("meshes") ? json["meshes"] : none;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        nlohmann::json const& primitives = meshes[m]["primitives"];
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            nlohmann::json const& primitive = primitives[p];
            if (!primitive.contains("indices")) continue;
            if (json["accessors"][primitive["indices"].get<std::size_t>()].contains("bufferView")) continue;
            report.fail(fmt::format("/meshes/{}/primitives/{}/indices", m, p), "has no bufferView");
        }
    }
}

/// The indices of compressed primitives have no bytes of their own; they are made when these are decompressed.
void drop_compressed_indices(nlohmann::json& json) {
    if (!json.contains("meshes")) return;
    for (nlohmann::json& mesh : json["meshes"]) {
        for (nlohmann::json& primitive : mesh["primitives"])
            if (primitive.contains("/extensions/KHR_draco_mesh_compression"_json_pointer)) primitive.erase("indices");
    }
}

/// Extensions are read by us.
void drop_extensions(nlohmann::json& value) {
    if (value.is_object()) value.erase("extensions"), value.erase("extras");
    for (nlohmann::json& member : value)
        if (member.is_structured()) drop_extensions(member);
}

tinygltf::Model parse_model(nlohmann::json json, Report const& report) {
    drop_compressed_indices(json);
    check_index_views(json, report);
    // Read by us (buffers, images) or not at all: the less reaches the parser, the less can go wrong in it.
    for (char const* const key : {"buffers", "images", "animations", "skins", "cameras"}) json.erase(key);
    drop_extensions(json);
    std::string const text = json.dump();
    tinygltf::TinyGLTF parser;
    parser.RemoveImageLoader();
    parser.SetFsCallbacks({});
    tinygltf::Model model;
    std::string error, warning;
    bool good = false;
    try {
        good =
            parser.LoadASCIIFromString(&model, &error, &warning, text.data(), static_cast<unsigned>(text.size()), "");
    } catch (std::exception const& exception) {
        error = exception.what();
    }
    if (!good) report.fail("", "is not glTF: " + printable(error));
    return model;
}

BufferView convert(tinygltf::BufferView const& view) {
    return {view.buffer, view.byteOffset, view.byteLength, view.byteStride};
}

Accessor convert(tinygltf::Accessor const& source) {
    Accessor accessor;
    accessor.view = source.bufferView;
    accessor.offset = source.byteOffset;
    accessor.type = static_cast<Component>(source.componentType);
    accessor.rows = source.type == TINYGLTF_TYPE_SCALAR ? 1 : source.type & 7; // VEC3 is 3, MAT3 is 32 + 3
    accessor.columns = source.type > 32 && source.type < 64 ? accessor.rows : 1;
    accessor.normalized = source.normalized;
    accessor.count = source.count;
    if (source.sparse.isSparse) {
        accessor.sparse = {static_cast<std::uint64_t>(source.sparse.count),
                           source.sparse.indices.bufferView,
                           source.sparse.values.bufferView,
                           static_cast<std::uint64_t>(source.sparse.indices.byteOffset),
                           static_cast<std::uint64_t>(source.sparse.values.byteOffset),
                           static_cast<Component>(source.sparse.indices.componentType)};
    }
    return accessor;
}

TextureWrap wrap_from_gltf(int wrap) {
    if (wrap == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return TextureWrap::clamp;
    return wrap == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? TextureWrap::mirror : TextureWrap::repeat;
}

void apply_sampler(Texture& texture, tinygltf::Sampler const& sampler) {
    texture.wrap_u = wrap_from_gltf(sampler.wrapS);
    texture.wrap_v = wrap_from_gltf(sampler.wrapT);
    int const smaller = sampler.minFilter;
    bool const nearest = smaller == TINYGLTF_TEXTURE_FILTER_NEAREST ||
                         smaller == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST ||
                         smaller == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR;
    texture.minify = nearest ? TextureFilter::nearest : TextureFilter::linear;
    texture.magnify =
        sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST ? TextureFilter::nearest : TextureFilter::linear;
    texture.mipmaps = smaller != TINYGLTF_TEXTURE_FILTER_NEAREST && smaller != TINYGLTF_TEXTURE_FILTER_LINEAR;
}

/// What texture references point into.
struct Textures {
    tinygltf::Model const& model;
    std::vector<JsonObject> json;
    std::size_t images;
    Report& report;
};

/// `Info` is one of tinygltf's three kinds of texture reference, `json` the same in the file.
template <class Info>
Texture convert_texture(Info const& info, std::optional<JsonObject> const& json, Textures& textures) {
    Texture texture;
    if (info.index < 0 || !json) return texture;
    int const image = image_of_texture(textures.json[at(info.index)], textures.images, textures.report);
    if (image == no_index) return texture;
    int const uv_set = apply_texture_transform(texture, *json, info.texCoord);
    if (uv_set > 1) {
        textures.report.warn("texture coordinates beyond the second set are not supported: such textures are left out");
        return texture;
    }
    texture.picture = static_cast<std::uint32_t>(image);
    texture.uv_set = static_cast<std::uint8_t>(uv_set);
    int const sampler = textures.model.textures[at(info.index)].sampler;
    if (sampler >= 0) apply_sampler(texture, textures.model.samplers[at(sampler)]);
    return texture;
}

Material convert(tinygltf::Material const& source, JsonObject const& json, Textures& textures) {
    tinygltf::PbrMetallicRoughness const& pbr = source.pbrMetallicRoughness;
    Material material;
    material.name = source.name;
    for (int i = 0; i < 4; ++i) material.base_color[i] = static_cast<float>(pbr.baseColorFactor[at(i)]);
    material.metallic = static_cast<float>(pbr.metallicFactor);
    material.roughness = static_cast<float>(pbr.roughnessFactor);
    for (int i = 0; i < 3; ++i) material.emission[i] = static_cast<float>(source.emissiveFactor[at(i)]);
    material.normal_scale = static_cast<float>(source.normalTexture.scale);
    material.occlusion_strength = static_cast<float>(source.occlusionTexture.strength);
    if (auto const core = json.find("pbrMetallicRoughness")) {
        material.base_color_texture = convert_texture(pbr.baseColorTexture, core->find("baseColorTexture"), textures);
        material.metallic_roughness_texture =
            convert_texture(pbr.metallicRoughnessTexture, core->find("metallicRoughnessTexture"), textures);
    }
    material.normal_texture = convert_texture(source.normalTexture, json.find("normalTexture"), textures);
    material.occlusion_texture = convert_texture(source.occlusionTexture, json.find("occlusionTexture"), textures);
    material.emission_texture = convert_texture(source.emissiveTexture, json.find("emissiveTexture"), textures);
    apply_material_extensions(material, json, textures.report);
    bool const blended = source.alphaMode == "BLEND";
    if (blended) textures.report.warn("blended materials are drawn as masked ones");
    material.alpha_mask = blended || source.alphaMode == "MASK";
    material.alpha_cutoff = blended ? 0.5f : static_cast<float>(source.alphaCutoff);
    material.double_sided = source.doubleSided;
    return material;
}

std::optional<DracoSource> read_draco(JsonObject const& primitive, std::size_t views) {
    auto const json = primitive.extension("KHR_draco_mesh_compression");
    if (!json) return {};
    json->require("bufferView");
    json->require("attributes");
    DracoSource source{json->index("bufferView", views), {}};
    JsonObject const attributes = *json->find("attributes");
    for (std::string const& name : attributes.names())
        source.attributes[name] = static_cast<int>(attributes.whole(name, 0, 0, std::numeric_limits<int>::max()));
    return source;
}

MeshSource convert(tinygltf::Mesh const& source, JsonObject const& json, std::size_t views, std::size_t accessors) {
    MeshSource mesh{source.name, {}, json.numbers("weights", {})};
    std::vector<JsonObject> const primitives = json.objects("primitives");
    for (std::size_t i = 0; i < source.primitives.size(); ++i) {
        tinygltf::Primitive const& from = source.primitives[i];
        Primitive primitive{from.attributes, from.indices, from.material,
                            from.mode,       from.targets, read_draco(primitives[i], views)};
        if (primitive.draco) primitive.indices = primitives[i].index("indices", accessors);
        mesh.primitives.push_back(std::move(primitive));
    }
    return mesh;
}

Node convert(tinygltf::Node const& source, JsonObject const& json, std::size_t index, Report const& report) {
    Node node{source.name, source.children, source.mesh, {}};
    node.skin = source.skin;
    node.camera = source.camera;
    node.weights = json.numbers("weights", {});
    node.parent_from_node =
        node_matrix({source.matrix, source.translation, source.rotation, source.scale}, index, report);
    return node;
}

Skin read_skin(JsonObject const& json, Document const& document) {
    return {json.indices("joints", document.nodes.size()),
            json.index("inverseBindMatrices", document.accessors.size())};
}

CameraSource read_camera(JsonObject const& json) {
    CameraSource camera{json.text("name", ""), 1, json.text("type", "perspective") == "perspective"};
    auto const perspective = json.find("perspective");
    if (camera.perspective && !perspective) json.fail("perspective", "is missing");
    if (perspective) camera.vertical_fov = perspective->number("yfov", 1, 0);
    return camera;
}

/// Of scene `chosen`, or of the file's default where none is chosen.
std::vector<int> shown_roots(tinygltf::Model const& model, std::optional<int> chosen, Report const& report) {
    int const scene = chosen.value_or(std::max(model.defaultScene, 0));
    if (chosen && at(scene) >= model.scenes.size())
        report.fail("/scenes", fmt::format("there is no scene {}: the file has {}", scene, model.scenes.size()),
                    "give another --scene-index");
    if (!model.scenes.empty()) return model.scenes[at(scene)].nodes;
    std::vector<bool> is_child(model.nodes.size());
    for (tinygltf::Node const& node : model.nodes) {
        for (int const child : node.children) is_child[at(child)] = true;
    }
    std::vector<int> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i) {
        if (!is_child[i]) roots.push_back(static_cast<int>(i));
    }
    return roots;
}

std::vector<Image> convert_images(nlohmann::json const& json, Report const& report) {
    std::vector<Image> images;
    for (nlohmann::json const& source : json.value("images", nlohmann::json::array())) {
        if (source.contains("uri") == source.contains("bufferView")) {
            report.refuse("ONE_OF_MISMATCH", "/images/" + std::to_string(images.size()),
                          "must have either a uri or a bufferView");
        }
        images.push_back({source.value("name", ""), source.value("uri", ""), source.value("bufferView", no_index)});
    }
    return images;
}

} // namespace

Document parse_document(nlohmann::json const& json, std::optional<int> scene_index, Report& report) {
    tinygltf::Model const model = parse_model(json, report);
    JsonObject const root(json, "", report);
    Document document;
    for (tinygltf::BufferView const& view : model.bufferViews) document.views.push_back(convert(view));
    for (tinygltf::Accessor const& accessor : model.accessors) document.accessors.push_back(convert(accessor));
    document.images = convert_images(json, report);
    Textures textures{model, root.objects("textures"), document.images.size(), report};
    std::vector<JsonObject> const materials = root.objects("materials"), meshes = root.objects("meshes"),
                                  nodes = root.objects("nodes");
    for (std::size_t i = 0; i < model.materials.size(); ++i)
        document.materials.push_back(convert(model.materials[i], materials[i], textures));
    for (std::size_t i = 0; i < model.meshes.size(); ++i)
        document.meshes.push_back(
            convert(model.meshes[i], meshes[i], document.views.size(), document.accessors.size()));
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        document.nodes.push_back(convert(model.nodes[i], nodes[i], i, report));
    for (JsonObject const& skin : root.objects("skins")) document.skins.push_back(read_skin(skin, document));
    for (JsonObject const& camera : root.objects("cameras")) document.cameras.push_back(read_camera(camera));
    document.roots = shown_roots(model, scene_index, report);
    document.quantized = std::ranges::find(model.extensionsUsed, "KHR_mesh_quantization") != model.extensionsUsed.end();
    return document;
}

} // namespace alpenglow::gltf
