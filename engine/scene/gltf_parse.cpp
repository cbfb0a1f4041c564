#include "scene/gltf_parse.h"

#include "scene/gltf_nodes.h"

#include <algorithm>
#include <fmt/format.h>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wextra"
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
            bool const draco = primitive.contains("/extensions/KHR_draco_mesh_compression"_json_pointer);
            report.fail(fmt::format("/meshes/{}/primitives/{}/indices", m, p),
                        draco ? "is compressed by KHR_draco_mesh_compression, which is not supported"
                              : "has no bufferView");
        }
    }
}

tinygltf::Model parse_model(nlohmann::json json, Report const& report) {
    check_index_views(json, report);
    // Read by us (buffers, images) or not at all: the less reaches the parser, the less can go wrong in it.
    for (char const* const key : {"buffers", "images", "animations", "skins", "cameras", "extensions", "extras"})
        json.erase(key);
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

/// `Info` is one of tinygltf's three kinds of texture reference.
template <class Info> Texture convert_texture(Info const& info, tinygltf::Model const& model, Report& report) {
    Texture texture;
    if (info.index < 0) return texture;
    tinygltf::Texture const& source = model.textures[at(info.index)];
    if (source.source < 0) {
        report.warn("/textures/" + std::to_string(info.index) + " has no PNG or JPEG picture: left out");
        return texture;
    }
    if (info.texCoord > 1) {
        report.warn("texture coordinates beyond the second set are not supported: such textures are left out");
        return texture;
    }
    texture.picture = static_cast<std::uint32_t>(source.source);
    texture.uv_set = static_cast<std::uint8_t>(info.texCoord);
    if (source.sampler >= 0) apply_sampler(texture, model.samplers[at(source.sampler)]);
    return texture;
}

Material convert(tinygltf::Material const& source, tinygltf::Model const& model, Report& report) {
    tinygltf::PbrMetallicRoughness const& pbr = source.pbrMetallicRoughness;
    Material material;
    material.name = source.name;
    for (int i = 0; i < 4; ++i) material.base_color[i] = static_cast<float>(pbr.baseColorFactor[at(i)]);
    material.metallic = static_cast<float>(pbr.metallicFactor);
    material.roughness = static_cast<float>(pbr.roughnessFactor);
    for (int i = 0; i < 3; ++i) material.emission[i] = static_cast<float>(source.emissiveFactor[at(i)]);
    material.normal_scale = static_cast<float>(source.normalTexture.scale);
    material.occlusion_strength = static_cast<float>(source.occlusionTexture.strength);
    material.base_color_texture = convert_texture(pbr.baseColorTexture, model, report);
    material.metallic_roughness_texture = convert_texture(pbr.metallicRoughnessTexture, model, report);
    material.normal_texture = convert_texture(source.normalTexture, model, report);
    material.occlusion_texture = convert_texture(source.occlusionTexture, model, report);
    material.emission_texture = convert_texture(source.emissiveTexture, model, report);
    bool const blended = source.alphaMode == "BLEND";
    if (blended) report.warn("blended materials are drawn as masked ones");
    material.alpha_mask = blended || source.alphaMode == "MASK";
    material.alpha_cutoff = blended ? 0.5f : static_cast<float>(source.alphaCutoff);
    material.double_sided = source.doubleSided;
    return material;
}

MeshSource convert(tinygltf::Mesh const& source, Report& report) {
    MeshSource mesh{source.name, {}};
    for (tinygltf::Primitive const& primitive : source.primitives) {
        if (!primitive.targets.empty()) report.warn("morph targets are ignored");
        mesh.primitives.push_back({primitive.attributes, primitive.indices, primitive.material, primitive.mode});
    }
    return mesh;
}

Node convert(tinygltf::Node const& source, std::size_t index, Report& report) {
    Node node{source.name, source.children, source.mesh, {}};
    if (source.skin >= 0) report.warn("skins are ignored: such meshes stand in their bind pose");
    node.parent_from_node =
        node_matrix({source.matrix, source.translation, source.rotation, source.scale}, index, report);
    return node;
}

std::vector<int> shown_roots(tinygltf::Model const& model) {
    if (!model.scenes.empty()) return model.scenes[at(std::max(model.defaultScene, 0))].nodes;
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

Document parse_document(nlohmann::json const& json, Report& report) {
    tinygltf::Model const model = parse_model(json, report);
    Document document;
    for (tinygltf::BufferView const& view : model.bufferViews) document.views.push_back(convert(view));
    for (tinygltf::Accessor const& accessor : model.accessors) document.accessors.push_back(convert(accessor));
    for (tinygltf::Material const& material : model.materials)
        document.materials.push_back(convert(material, model, report));
    for (tinygltf::Mesh const& mesh : model.meshes) document.meshes.push_back(convert(mesh, report));
    for (tinygltf::Node const& node : model.nodes)
        document.nodes.push_back(convert(node, document.nodes.size(), report));
    document.images = convert_images(json, report);
    document.roots = shown_roots(model);
    document.quantized = std::ranges::find(model.extensionsUsed, "KHR_mesh_quantization") != model.extensionsUsed.end();
    if (json.contains("animations")) report.warn("animations are ignored");
    return document;
}

} // namespace alpenglow::gltf
