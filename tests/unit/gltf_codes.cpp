#include "support/gltf_samples.h"
#include "support/mutator.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <sstream>

using namespace alpenglow;
using namespace alpenglow::test;
using Json = nlohmann::json;

// Each row damages a good file in one way and names what has to be said; the rows need no files but their own.

namespace {

using Spoil = std::function<void(GltfBuilder&)>;

struct Row {
    std::string codes;
    Spoil spoil;
};

Spoil set(std::string const& pointer, Json value) {
    return [pointer, value](GltfBuilder& b) { b.json[Json::json_pointer(pointer)] = value; };
}

/// What is said of the good scene: of what is left out.
std::string codes_without_usual(std::string codes) {
    for (std::string const usual : {"SIMPLIFIED, ", ", SIMPLIFIED", "SIMPLIFIED"}) {
        if (std::size_t const at = codes.find(usual); at != std::string::npos) codes.erase(at, usual.size());
    }
    return codes;
}

void expect_rows(std::vector<Row> const& rows) {
    for (Row const& row : rows) {
        GltfBuilder builder = good_scene();
        row.spoil(builder);
        EXPECT_EQ(codes_without_usual(codes_of(builder.gltf())), row.codes) << builder.json.dump().substr(0, 3000);
    }
}

/// Overwrites float `number` of an accessor of the good scene.
Spoil with_float(int accessor, std::size_t number, float value) {
    return [=](GltfBuilder& b) {
        std::size_t const view = b.json["accessors"][accessor]["bufferView"];
        std::size_t const offset = b.json["bufferViews"][view]["byteOffset"];
        std::memcpy(b.buffer.data() + offset + 4 * number, &value, 4);
    };
}

Spoil with_stride(int accessor, int stride) {
    return [=](GltfBuilder& b) {
        std::size_t const view = b.json["accessors"][accessor]["bufferView"];
        b.json["bufferViews"][view]["byteStride"] = stride;
    };
}

Spoil with_sparse(std::vector<std::uint16_t> places) {
    return [places](GltfBuilder& b) {
        int const view = b.add_view(places), values = b.add_view(std::vector<float>(places.size() * 3));
        b.json["accessors"][0]["sparse"] = {{"count", places.size()},
                                            {"indices", {{"bufferView", view}, {"componentType", 5123}}},
                                            {"values", {{"bufferView", values}}}};
    };
}

Spoil with_animation_pointer(Json target) {
    target["extensions"] = {{"KHR_animation_pointer", {{"pointer", "/nodes/0/scale"}}}};
    return [target](GltfBuilder& b) {
        b.json["animations"][0]["channels"][0]["target"] = target;
        b.json["extensionsUsed"] = {"KHR_animation_pointer"};
    };
}

std::string const of_attributes = "/meshes/0/primitives/0/attributes";

std::vector<Row> rows_of_any_value() {
    return {
        {"refused TYPE_MISMATCH", set("/nodes/0/mesh", "0")},
        {"refused TYPE_MISMATCH", set("/samplers", Json::object())},
        {"refused UNDEFINED_PROPERTY", [](GltfBuilder& b) { b.json["accessors"][0].erase("count"); }},
        {"refused UNDEFINED_PROPERTY", [](GltfBuilder& b) { b.json.erase("asset"); }},
        {"refused UNRESOLVED_REFERENCE", set("/nodes/0/mesh", 9)},
        {"refused VALUE_NOT_IN_LIST", set("/accessors/0/componentType", 5124)},
        {"refused VALUE_NOT_IN_RANGE", set("/bufferViews/0/byteLength", 0)},
        {"refused VALUE_MULTIPLE_OF", set("/bufferViews/0/byteStride", 14)},
        {"refused ARRAY_LENGTH_NOT_IN_LIST", set("/nodes/0/scale", Json::array({1, 2}))},
        {"refused ARRAY_LENGTH_NOT_IN_LIST", set("/accessors/0/min", Json::array({0}))},
        {"EMPTY_ENTITY", set("/samplers", Json::array())},
        {"refused PATTERN_MISMATCH", set("/asset/version", "two")},
        {"refused UNKNOWN_ASSET_MAJOR_VERSION", set("/asset/version", "1.0")},
        {"refused ASSET_MIN_VERSION_GREATER_THAN_VERSION", set("/asset/minVersion", "2.1")},
        {"refused UNSUPPORTED_VERSION", set("/asset", {{"version", "2.1"}, {"minVersion", "2.1"}})},
    };
}

std::vector<Row> rows_of_extensions() {
    return {
        {"UNSUPPORTED_EXTENSION", set("/extensionsUsed", Json::array({"EXT_unknown"}))},
        {"DUPLICATE_ELEMENTS, UNSUPPORTED_EXTENSION", set("/extensionsUsed", Json::array({"EXT_unknown", "EXT_unknown"}))},
        {"UNDECLARED_EXTENSION", set("/nodes/0/extensions", {{"EXT_unknown", Json::object()}})},
        {"UNDECLARED_EXTENSION, UNEXPECTED_EXTENSION_OBJECT", set("/nodes/0/extensions", {{"KHR_materials_sheen", Json::object()}})},
        {"refused TYPE_MISMATCH", set("/nodes/0/extensions", {{"EXT_unknown", 1}})},
        {"UNSATISFIED_DEPENDENCY, UNUSED_EXTENSION_REQUIRED, refused UNSUPPORTED_EXTENSION",
         set("/extensionsRequired", Json::array({"EXT_unknown"}))},
        {"NON_REQUIRED_EXTENSION", set("/extensionsUsed", Json::array({"KHR_mesh_quantization"}))},
        {"refused KHR_LIGHTS_PUNCTUAL_LIGHT_SPOT_ANGLES", [](GltfBuilder& b) {
             Json const spot = {{"innerConeAngle", 0.5}, {"outerConeAngle", 0.4}};
             b.json["extensions"] = {{"KHR_lights_punctual", {{"lights", {{{"type", "spot"}, {"spot", spot}}}}}}};
             b.json["extensionsUsed"] = {"KHR_lights_punctual"};
         }},
        {"KHR_MATERIALS_VARIANTS_NON_UNIQUE_VARIANT, UNSUPPORTED_EXTENSION", [](GltfBuilder& b) {
             Json const mapping = {{"material", 0}, {"variants", {0}}};
             b.json["extensions"] = {{"KHR_materials_variants", {{"variants", {{{"name", "red"}}}}}}};
             b.json["extensionsUsed"] = {"KHR_materials_variants"};
             b.json["meshes"][0]["primitives"][0]["extensions"] = {{"KHR_materials_variants", {{"mappings", {mapping, mapping}}}}};
         }},
        {"KHR_ANIMATION_POINTER_ANIMATION_CHANNEL_TARGET_NODE, UNSUPPORTED_EXTENSION",
         with_animation_pointer({{"node", 0}, {"path", "pointer"}})},
        {"KHR_ANIMATION_POINTER_ANIMATION_CHANNEL_TARGET_PATH, UNSUPPORTED_EXTENSION",
         with_animation_pointer({{"path", "rotation"}})},
    };
}

std::vector<Row> rows_of_buffers_views_and_accessors() {
    return {
        {"refused BUFFER_VIEW_TOO_LONG", set("/bufferViews/0/byteLength", 100000)},
        {"refused ACCESSOR_TOO_LONG", set("/accessors/8/count", 2)},
        {"refused ACCESSOR_TOTAL_OFFSET_ALIGNMENT", set("/bufferViews/0/byteOffset", 2)},
        {"refused ACCESSOR_SMALL_BYTESTRIDE", with_stride(0, 4)},
        {"refused ACCESSOR_NORMALIZED_INVALID", set("/accessors/1/normalized", true)},
        {"refused ACCESSOR_INVALID_FLOAT", with_float(6, 3, INFINITY)},
        {"ACCESSOR_MIN_MISMATCH", set("/accessors/0/min/0", -1)},
        {"ACCESSOR_MAX_MISMATCH", set("/accessors/0/max/1", 3)},
        {"UNSATISFIED_DEPENDENCY", [](GltfBuilder& b) {
             b.json["accessors"].push_back({{"componentType", 5126}, {"count", 1}, {"type", "VEC3"}, {"byteOffset", 4}});
         }},
        {"BUFFER_VIEW_TARGET_OVERRIDE", set("/bufferViews/7/target", 34962)},
        {"refused NOT_LOADABLE", set("/buffers", Json::array({{{"byteLength", 36}}}))},
        {"refused BUFFER_BYTE_LENGTH_MISMATCH", set("/buffers", Json::array({{{"byteLength", 36}, {"uri", "data:application/octet-stream;base64,AAAA"}}}))},
        {"refused INVALID_URI", set("/buffers", Json::array({{{"byteLength", 36}, {"uri", "data:application/octet-stream;;base64,AAAA"}}}))},
        {"refused IO_ERROR", set("/buffers", Json::array({{{"byteLength", 36}, {"uri", "missing.bin"}}}))},
        {"refused URI_NOT_ALLOWED", set("/buffers", Json::array({{{"byteLength", 36}, {"uri", "../up.bin"}}}))},
        {"refused ACCESSORS_OVERLAP", [](GltfBuilder& b) {
             int const view = b.add_view(std::vector<float>(30000));
             for (int i = 0; i < 30; ++i) b.add_accessor(view, 5126, 30000, "SCALAR");
         }},
        {"refused ACCESSOR_OFFSET_ALIGNMENT", [](GltfBuilder& b) {
             b.json["accessors"][b.add_accessor(0, 5126, 1, "VEC3")]["byteOffset"] = 2;
         }},
        {"refused ACCESSOR_MATRIX_ALIGNMENT", [](GltfBuilder& b) {
             b.json["accessors"][b.add_accessor(0, 5121, 1, "MAT2")]["byteOffset"] = 2;
         }},
        {"refused ACCESSOR_SPARSE_COUNT_OUT_OF_RANGE", with_sparse({0, 1, 2, 3})},
        {"refused ACCESSOR_SPARSE_INDEX_OOB", with_sparse({1, 3})},
        {"refused ACCESSOR_SPARSE_INDICES_NON_INCREASING", with_sparse({1, 1})},
        {"BUFFER_DATA_URI_MIME_TYPE_INVALID", [](GltfBuilder& b) {
             b.json["buffers"] = {{{"byteLength", b.buffer.size()}, {"uri", "data:text/plain;base64," + base64(b.buffer)}}};
         }},
        {"BUFFER_VIEW_INVALID_BYTE_STRIDE", [](GltfBuilder& b) {
             b.json["bufferViews"].push_back({{"buffer", 0}, {"byteLength", 8}, {"byteStride", 4}, {"target", 34963}});
         }},
        {"BUFFER_VIEW_TOO_BIG_BYTE_STRIDE", [](GltfBuilder& b) {
             b.json["bufferViews"].push_back({{"buffer", 0}, {"byteLength", 8}, {"byteStride", 12}});
         }},
    };
}

std::vector<Row> rows_of_pictures() {
    return {
        {"refused ONE_OF_MISMATCH", set("/images/0", Json::object())},
        {"IMAGE_MIME_TYPE_INVALID", set("/images/0/mimeType", "image/jpeg")},
        {"IMAGE_UNRECOGNIZED_FORMAT, refused IMAGE_DATA_INVALID", set("/images/0/uri", "data:image/png;base64,AAAA")},
        {"IMAGE_UNEXPECTED_EOS", [](GltfBuilder& b) { b.json["images"].push_back({{"uri", "data:image/png;base64,iVBORw0KGgo="}}); }},
        {"IO_ERROR", [](GltfBuilder& b) { b.json["images"].push_back({{"uri", "missing.png"}}); }},
        {"IMAGE_NON_ENABLED_MIME_TYPE", [](GltfBuilder& b) {
             b.json["images"].push_back({{"uri", "data:image/webp;base64,UklGRgAAAABXRUJQ"}});
         }},
        {"IMAGE_BUFFER_VIEW_WITH_BYTESTRIDE, IMAGE_UNRECOGNIZED_FORMAT", [](GltfBuilder& b) {
             b.json["bufferViews"].push_back({{"buffer", 0}, {"byteLength", 8}, {"byteStride", 4}});
             b.json["images"].push_back({{"bufferView", b.json["bufferViews"].size() - 1}, {"mimeType", "image/png"}});
         }},
        {"IMAGE_NON_ENABLED_MIME_TYPE, TEXTURE_INVALID_IMAGE_MIME_TYPE", [](GltfBuilder& b) {
             b.json["images"].push_back({{"uri", "data:image/webp;base64,UklGRgAAAABXRUJQ"}});
             b.json["textures"].push_back({{"source", 1}});
         }},
    };
}

std::vector<Row> rows_of_meshes() {
    return {
        {"MESH_PRIMITIVE_INVALID_ATTRIBUTE", set(of_attributes + "/UNKNOWN", 0)},
        {"MESH_PRIMITIVE_INVALID_ATTRIBUTE", set(of_attributes + "/TEXCOORD_00", 3)},
        {"refused MESH_PRIMITIVE_UNEQUAL_ACCESSOR_COUNT", set(of_attributes + "/COLOR_0", 10)},
        {"refused MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_INVALID_FORMAT", set(of_attributes + "/POSITION", 2)},
        {"MESH_PRIMITIVE_POSITION_ACCESSOR_WITHOUT_BOUNDS", [](GltfBuilder& b) { b.json["accessors"][0].erase("min"); }},
        {"refused MESH_PRIMITIVE_INDICES_ACCESSOR_INVALID_FORMAT", set("/meshes/0/primitives/0/indices", 9)},
        {"MESH_PRIMITIVE_JOINTS_WEIGHTS_MISMATCH", [](GltfBuilder& b) { b.json["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0"); }},
        {"MESH_PRIMITIVE_TOO_FEW_TEXCOORDS", set("/materials/0/normalTexture/texCoord", 1)},
        {"MESH_PRIMITIVE_MORPH_TARGET_NO_BASE_ACCESSOR", set("/meshes/0/primitives/0/targets/0/TEXCOORD_1", 3)},
        {"refused MESH_PRIMITIVE_MORPH_TARGET_INVALID_ATTRIBUTE_COUNT", set("/meshes/0/primitives/0/targets/0/NORMAL", 9)},
        {"refused MESH_INVALID_WEIGHTS_COUNT", set("/meshes/0/weights", Json::array({1, 0}))},
        {"ACCESSOR_VECTOR3_NON_UNIT", with_float(1, 2, 3)},
        {"ACCESSOR_INVALID_SIGN", with_float(2, 3, 0)},
        {"ACCESSOR_NON_CLAMPED", with_float(4, 3, 1.5f)},
        {"ACCESSOR_WEIGHTS_NEGATIVE", with_float(6, 1, -1)},
        {"refused ACCESSOR_INDEX_OOB", [](GltfBuilder& b) { b.json["meshes"][0]["primitives"][0]["indices"] = b.add<std::uint16_t>("SCALAR", {0, 1, 3}); }},
        {"refused ACCESSOR_INDEX_PRIMITIVE_RESTART", [](GltfBuilder& b) { b.json["meshes"][0]["primitives"][0]["indices"] = b.add<std::uint8_t>("SCALAR", {0, 1, 255}); }},
        {"refused ACCESSOR_JOINTS_INDEX_OOB", [](GltfBuilder& b) {
             b.json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] = b.add<std::uint8_t>("VEC4", std::vector<std::uint8_t>(12, 1));
         }},
        {"refused MESH_PRIMITIVES_UNEQUAL_TARGETS_COUNT", [](GltfBuilder& b) {
             b.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}});
         }},
        {"MESH_PRIMITIVE_ACCESSOR_UNALIGNED", [](GltfBuilder& b) {
             int const joints = b.add_accessor(b.add_view(std::vector<std::uint8_t>(16)), 5121, 3, "VEC4");
             b.json["accessors"][joints]["byteOffset"] = 2;
             b.json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] = joints;
         }},
        {"MESH_PRIMITIVE_ACCESSOR_WITHOUT_BYTESTRIDE", [](GltfBuilder& b) {
             b.json["meshes"][0]["primitives"][0]["attributes"]["_OWN"] = b.add_accessor(1, 5126, 3, "VEC3");
         }},
        {"MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_UNSIGNED_INT", [](GltfBuilder& b) {
             b.json["meshes"][0]["primitives"][0]["attributes"]["_OWN"] = b.add<std::uint32_t>("SCALAR", {1, 2, 3});
         }},
        {"MESH_PRIMITIVE_INDICES_ACCESSOR_WITH_BYTESTRIDE", [](GltfBuilder& b) {
             int const view = b.add_view(std::vector<std::uint16_t>{0, 0, 1, 0, 2, 0}, 4);
             b.json["meshes"][0]["primitives"][0]["indices"] = b.add_accessor(view, 5123, 3, "SCALAR");
         }},
    };
}

std::vector<Row> rows_of_nodes_cameras_and_skins() {
    return {
        {"refused NODE_LOOP", [](GltfBuilder& b) { b.json["nodes"].push_back({{"children", {2}}}); }},
        {"refused NODE_PARENT_OVERRIDE", [](GltfBuilder& b) { b.json["nodes"].push_back({{"children", {1}}}); }},
        {"refused SCENE_NON_ROOT_NODE", set("/scenes/0/nodes", Json::array({0, 1}))},
        {"NODE_MATRIX_TRS", set("/nodes/1", {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}, {"scale", {1, 1, 1}}})},
        {"NODE_MATRIX_NON_TRS", set("/nodes/1/matrix", {1, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1})},
        {"refused ROTATION_NON_UNIT", set("/nodes/0/rotation", {0, 0, 0, 0.5})},
        {"UNSATISFIED_DEPENDENCY", set("/nodes/1/skin", 0)},
        {"NODE_SKIN_WITH_NON_SKINNED_MESH", [](GltfBuilder& b) {
             for (char const* const name : {"JOINTS_0", "WEIGHTS_0"}) b.json["meshes"][0]["primitives"][0]["attributes"].erase(name);
         }},
        {"refused NODE_WEIGHTS_INVALID", set("/nodes/0/weights", Json::array({1, 0}))},
        {"refused CAMERA_ZFAR_LEQUAL_ZNEAR", set("/cameras/0/perspective/zfar", 0.05)},
        {"refused ONE_OF_MISMATCH", [](GltfBuilder& b) { b.json["cameras"][0].erase("perspective"); }},
        {"refused CAMERA_XMAG_YMAG_ZERO", set("/cameras/0", {{"type", "orthographic"}, {"orthographic", {{"xmag", 0}, {"ymag", 1}, {"zfar", 2}, {"znear", 1}}}})},
        {"SKIN_NO_COMMON_ROOT", [](GltfBuilder& b) { b.json["nodes"].push_back(Json::object()), b.json["skins"][0]["joints"] = {1, 2}; b.json["skins"][0].erase("inverseBindMatrices"); }},
        {"SKIN_SKELETON_INVALID", [](GltfBuilder& b) { b.json["nodes"].push_back(Json::object()), b.json["skins"][0]["skeleton"] = 2; }},
        {"refused SKIN_IBM_INVALID_FORMAT", set("/skins/0/inverseBindMatrices", 10)},
        {"refused INVALID_IBM_ACCESSOR_COUNT", set("/skins/0/joints", Json::array({0, 1}))},
        {"ACCESSOR_INVALID_IBM", with_float(8, 15, 2)},
        {"NODE_SKIN_NO_SCENE", [](GltfBuilder& b) { b.json["nodes"].push_back(Json::object()), b.json["skins"][0]["joints"] = {2}; }},
        {"SKIN_IBM_ACCESSOR_WITH_BYTESTRIDE", with_stride(8, 64)},
    };
}

std::vector<Row> rows_of_animations() {
    return {
        {"ACCESSOR_ANIMATION_INPUT_NON_INCREASING, ACCESSOR_MAX_MISMATCH", with_float(9, 1, 0)},
        {"ACCESSOR_ANIMATION_INPUT_NEGATIVE, ACCESSOR_MIN_MISMATCH", with_float(9, 0, -1)},
        {"ACCESSOR_ANIMATION_SAMPLER_OUTPUT_NON_NORMALIZED_QUATERNION", with_float(10, 0, 1)},
        {"refused UNRESOLVED_REFERENCE", set("/animations/0/channels/0/sampler", 1)},
        {"ANIMATION_SAMPLER_INPUT_ACCESSOR_WITHOUT_BOUNDS", [](GltfBuilder& b) { b.json["accessors"][9].erase("max"); }},
        {"ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_FORMAT", set("/animations/0/channels/0/target/path", "scale")},
        {"refused ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_COUNT", set("/animations/0/samplers/0/output", 2)},
        {"ANIMATION_CHANNEL_TARGET_NODE_MATRIX", set("/nodes/0/matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1})},
        {"ANIMATION_DUPLICATE_TARGETS", [](GltfBuilder& b) {
             Json const channel = b.json["animations"][0]["channels"][0];
             b.json["animations"][0]["channels"].push_back(channel);
         }},
        {"ANIMATION_CHANNEL_TARGET_NODE_WEIGHTS_NO_MORPHS", [](GltfBuilder& b) {
             b.json["animations"][0]["channels"][0]["target"] = {{"node", 1}, {"path", "weights"}};
             b.json["animations"][0]["samplers"][0]["output"] = 9;
         }},
        {"ANIMATION_SAMPLER_ACCESSOR_WITH_BYTESTRIDE", with_stride(9, 4)},
        {"ANIMATION_SAMPLER_INPUT_ACCESSOR_INVALID_FORMAT", [](GltfBuilder& b) {
             int const times = b.add<std::uint16_t>("SCALAR", {0, 1});
             b.json["accessors"][times].update({{"min", {0}}, {"max", {1}}});
             b.json["animations"][0]["samplers"][0]["input"] = times;
         }},
        {"refused ANIMATION_SAMPLER_INPUT_ACCESSOR_TOO_FEW_ELEMENTS", [](GltfBuilder& b) {
             int const times = b.add<float>("SCALAR", {0});
             b.json["accessors"][times].update({{"min", {0}}, {"max", {0}}});
             b.json["animations"][0]["samplers"][0].update({{"input", times}, {"interpolation", "CUBICSPLINE"}});
         }},
    };
}

/// A whole file.
struct FileRow {
    std::string codes, text;
    std::string name = "scene.gltf";
};

std::string word(std::size_t value) { return detail::word(static_cast<std::uint32_t>(value)); }
std::string chunk(std::string const& type, std::string const& bytes) { return word(bytes.size()) + type + bytes; }
std::string container(std::string const& chunks) { return "glTF" + word(2) + word(12 + chunks.size()) + chunks; }
std::string const BIN("BIN\0", 4);

std::vector<FileRow> rows_of_containers() {
    std::string const good = good_scene().glb();
    auto const with_word = [&](std::size_t offset, std::uint32_t value) { return std::string(good).replace(offset, 4, word(value)); };
    GltfBuilder without_bytes;
    without_bytes.json["buffers"] = {{{"byteLength", 4}}};
    std::string const json = chunk("JSON", R"({"asset":{"version":"2.0"}} )");
    std::string const odd = chunk("JSON", R"({"asset":{"version":"2.0"}})");
    return {
        {"", good},
        {"refused BUFFER_MISSING_GLB_DATA", without_bytes.glb()},
        {"refused GLB_UNEXPECTED_END_OF_HEADER", good.substr(0, 8)},
        {"refused GLB_INVALID_VERSION", with_word(4, 1)},
        {"refused GLB_LENGTH_TOO_SMALL", with_word(8, 12)},
        {"refused GLB_CHUNK_TOO_BIG", with_word(12, 0xfffffff0)},
        {"refused GLB_UNEXPECTED_FIRST_CHUNK", with_word(16, 0)},
        {"refused GLB_UNEXPECTED_END_OF_CHUNK_HEADER", container("1234")},
        {"refused GLB_UNEXPECTED_END_OF_CHUNK_DATA", good.substr(0, good.size() - 4)},
        {"refused GLB_LENGTH_MISMATCH", with_word(8, static_cast<std::uint32_t>(good.size()) + 1)},
        {"refused GLB_INVALID_MAGIC", "solid stl of some length", "scene.glb"},
        {"refused GLB_EMPTY_CHUNK", container(chunk("JSON", ""))},
        {"GLB_EXTRA_DATA", good + "more"},
        {"GLB_CHUNK_LENGTH_UNALIGNED", container(odd)},
        {"GLB_DUPLICATE_CHUNK", container(json + chunk(BIN, "1234") + chunk(BIN, "1234"))},
        {"GLB_UNEXPECTED_BIN_CHUNK", container(json + chunk("TEXT", "1234") + chunk(BIN, "1234"))},
        {"refused INVALID_JSON", "{"},
        {"refused TYPE_MISMATCH", "[]"},
        {"refused VALUE_NOT_IN_RANGE", "{\"a\": 1e999}"},
        {"INVALID_JSON", "\xEF\xBB\xBF" + good_scene().gltf()},
    };
}

} // namespace

TEST(GltfCodes, say_nothing_of_a_good_file) { expect_rows({{"", [](GltfBuilder&) {}}}); }
TEST(GltfCodes, of_any_value) { expect_rows(rows_of_any_value()); }
TEST(GltfCodes, of_extensions) { expect_rows(rows_of_extensions()); }
TEST(GltfCodes, of_buffers_views_and_accessors) { expect_rows(rows_of_buffers_views_and_accessors()); }
TEST(GltfCodes, of_pictures) { expect_rows(rows_of_pictures()); }
TEST(GltfCodes, of_meshes) { expect_rows(rows_of_meshes()); }
TEST(GltfCodes, of_nodes_cameras_and_skins) { expect_rows(rows_of_nodes_cameras_and_skins()); }
TEST(GltfCodes, of_animations) { expect_rows(rows_of_animations()); }

TEST(GltfCodes, of_containers) {
    for (FileRow const& row : rows_of_containers())
        EXPECT_EQ(codes_without_usual(codes_of(row.text, {}, row.name)), row.codes);
}

TEST(GltfCodes, are_each_said_of_a_file_of_our_own) {
    std::set<std::string> said;
    auto const add = [&](std::string const& codes) {
        std::istringstream words(codes);
        for (std::string code; words >> code;) said.insert(code.substr(0, code.find(',')));
    };
    for (std::vector<Row> const& rows :
         {rows_of_any_value(), rows_of_extensions(), rows_of_buffers_views_and_accessors(), rows_of_pictures(), rows_of_meshes(),
          rows_of_nodes_cameras_and_skins(), rows_of_animations()})
        for (Row const& row : rows) add(row.codes);
    for (FileRow const& row : rows_of_containers()) add(row.codes);
    add("SIMPLIFIED");     // of the good file's animation
    add("LIMIT_EXCEEDED"); // tests/unit/gltf_limits.cpp
    for (gltf::CodeInfo const& info : gltf::CODES)
        EXPECT_TRUE(said.contains(std::string(info.name))) << info.name << " is in the table, and no row provokes it";
}
