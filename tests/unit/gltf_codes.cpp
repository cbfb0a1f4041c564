#include "support/gltf_builder.h"

#include <gtest/gtest.h>

#include <functional>

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

Spoil set(char const* pointer, Json value) {
    return [pointer, value](GltfBuilder& b) { b.json[Json::json_pointer(pointer)] = value; };
}

/// Nothing is said of it: bounds, UVs, a material, a skin, a morph target, a camera, an animation.
GltfBuilder good_scene() {
    GltfBuilder b;
    int const position = b.add<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0}); // accessor 0
    b.json["accessors"][position].update({{"min", {0, 0, 0}}, {"max", {1, 1, 0}}});
    int const normal = b.add<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});             // 1
    int const tangent = b.add<float>("VEC4", {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, -1});  // 2
    int const uv = b.add<float>("VEC2", {0, 0, 1, 0, 0, 1});                          // 3
    int const color = b.add<float>("VEC4", std::vector<float>(12, 1));                // 4
    int const joints = b.add<std::uint8_t>("VEC4", std::vector<std::uint8_t>(12, 0)); // 5
    int const weights = b.add<float>("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});   // 6
    int const indices = b.add<std::uint16_t>("SCALAR", {0, 1, 2});                    // 7
    b.show({{"POSITION", position}, {"NORMAL", normal}, {"TANGENT", tangent}, {"TEXCOORD_0", uv}, {"COLOR_0", color},
            {"JOINTS_0", joints}, {"WEIGHTS_0", weights}},
           {{"indices", indices}, {"material", 0}, {"targets", {{{"POSITION", position}}}}});
    b.json["materials"] = {{{"normalTexture", {{"index", 0}}}}};
    b.json["textures"] = {{{"source", 0}}};
    b.json["images"] = {{{"uri", "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVQYV2P4z/AfAAQAAf+VHQdlAAAAAElFTkSuQmCC"}}};
    b.json["nodes"][0].update({{"skin", 0}, {"children", {1}}});
    b.json["nodes"].push_back({{"camera", 0}});
    b.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}, {"zfar", 9}}}}};
    std::vector<float> identity(16);
    for (std::size_t i = 0; i < 4; ++i) identity[5 * i] = 1;
    b.json["skins"] = {{{"joints", {1}}, {"inverseBindMatrices", b.add<float>("MAT4", identity)}}}; // 8
    int const times = b.add<float>("SCALAR", {0, 1});                                               // 9
    b.json["accessors"][times].update({{"min", {0}}, {"max", {1}}});
    int const rotations = b.add<float>("VEC4", {0, 0, 0, 1, 0, 0, 0, 1}); // 10
    b.json["animations"] = {{{"samplers", {{{"input", times}, {"output", rotations}}}},
                             {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}}}}}};
    return b;
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

char const* const attributes = "/meshes/0/primitives/0/attributes";
std::string const of_attributes = attributes;

} // namespace

TEST(GltfCodes, say_nothing_of_a_good_file) { expect_rows({{"", [](GltfBuilder&) {}}}); }

TEST(GltfCodes, of_any_value) {
    expect_rows({
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
    });
}

TEST(GltfCodes, of_extensions) {
    expect_rows({
        {"UNSUPPORTED_EXTENSION", set("/extensionsUsed", Json::array({"EXT_unknown"}))},
        {"DUPLICATE_ELEMENTS, UNSUPPORTED_EXTENSION", set("/extensionsUsed", Json::array({"EXT_unknown", "EXT_unknown"}))},
        {"UNDECLARED_EXTENSION", set("/nodes/0/extensions", {{"EXT_unknown", Json::object()}})},
        {"UNDECLARED_EXTENSION, UNEXPECTED_EXTENSION_OBJECT", set("/nodes/0/extensions", {{"KHR_materials_sheen", Json::object()}})},
        {"refused TYPE_MISMATCH", set("/nodes/0/extensions", {{"EXT_unknown", 1}})},
        {"UNSATISFIED_DEPENDENCY, UNUSED_EXTENSION_REQUIRED, refused UNSUPPORTED_EXTENSION",
         set("/extensionsRequired", Json::array({"EXT_unknown"}))},
        {"NON_REQUIRED_EXTENSION", set("/extensionsUsed", Json::array({"KHR_mesh_quantization"}))},
    });
}

TEST(GltfCodes, of_buffers_views_and_accessors) {
    expect_rows({
        {"refused BUFFER_VIEW_TOO_LONG", set("/bufferViews/0/byteLength", 100000)},
        {"refused ACCESSOR_TOO_LONG", set("/accessors/8/count", 2)},
        {"refused ACCESSOR_TOTAL_OFFSET_ALIGNMENT", [](GltfBuilder& b) {
             b.json["accessors"][b.add_accessor(0, 5126, 1, "VEC3")]["byteOffset"] = 2;
         }},
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
    });
}

TEST(GltfCodes, of_pictures) {
    expect_rows({
        {"refused ONE_OF_MISMATCH", set("/images/0", Json::object())},
        {"IMAGE_MIME_TYPE_INVALID", set("/images/0/mimeType", "image/jpeg")},
        {"IMAGE_UNRECOGNIZED_FORMAT, refused IMAGE_DATA_INVALID", set("/images/0/uri", "data:image/png;base64,AAAA")},
        {"IMAGE_UNEXPECTED_EOS", [](GltfBuilder& b) { b.json["images"].push_back({{"uri", "data:image/png;base64,iVBORw0KGgo="}}); }},
        {"IO_ERROR", [](GltfBuilder& b) { b.json["images"].push_back({{"uri", "missing.png"}}); }},
        {"IMAGE_NON_ENABLED_MIME_TYPE", [](GltfBuilder& b) {
             b.json["images"].push_back({{"uri", "data:image/webp;base64,UklGRgAAAABXRUJQ"}});
         }},
    });
}

TEST(GltfCodes, of_meshes) {
    expect_rows({
        {"MESH_PRIMITIVE_INVALID_ATTRIBUTE", set((of_attributes + "/UNKNOWN").c_str(), 0)},
        {"MESH_PRIMITIVE_INVALID_ATTRIBUTE", set((of_attributes + "/TEXCOORD_00").c_str(), 3)},
        {"refused MESH_PRIMITIVE_UNEQUAL_ACCESSOR_COUNT", set((of_attributes + "/COLOR_0").c_str(), 10)},
        {"refused MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_INVALID_FORMAT", set((of_attributes + "/POSITION").c_str(), 2)},
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
    });
}

TEST(GltfCodes, of_nodes_cameras_and_skins) {
    expect_rows({
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
    });
}

TEST(GltfCodes, of_animations) {
    char const* const sampler = "/animations/0/samplers/0";
    expect_rows({
        {"ACCESSOR_ANIMATION_INPUT_NON_INCREASING, ACCESSOR_MAX_MISMATCH", with_float(9, 1, 0)},
        {"ACCESSOR_ANIMATION_INPUT_NEGATIVE, ACCESSOR_MIN_MISMATCH", with_float(9, 0, -1)},
        {"ACCESSOR_ANIMATION_SAMPLER_OUTPUT_NON_NORMALIZED_QUATERNION", with_float(10, 0, 1)},
        {"refused UNRESOLVED_REFERENCE", set("/animations/0/channels/0/sampler", 1)},
        {"ANIMATION_SAMPLER_INPUT_ACCESSOR_WITHOUT_BOUNDS", [](GltfBuilder& b) { b.json["accessors"][9].erase("max"); }},
        {"ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_FORMAT", set("/animations/0/channels/0/target/path", "scale")},
        {"refused ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_COUNT", set((std::string(sampler) + "/output").c_str(), 2)},
        {"ANIMATION_CHANNEL_TARGET_NODE_MATRIX", set("/nodes/0/matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1})},
        {"ANIMATION_DUPLICATE_TARGETS", [](GltfBuilder& b) {
             Json const channel = b.json["animations"][0]["channels"][0];
             b.json["animations"][0]["channels"].push_back(channel);
         }},
    });
}

TEST(GltfCodes, limits_name_the_setting) {
    GltfLimits few;
    few.most_vertices = 2;
    EXPECT_EQ(codes_without_usual(codes_of(good_scene().gltf(), {.limits = few})), "refused LIMIT_EXCEEDED");
    few = {};
    few.most_json_values = 10;
    try {
        load_text(good_scene().gltf(), {.limits = few});
        FAIL();
    } catch (GltfError const& error) {
        EXPECT_EQ(error.diagnostic().code, "LIMIT_EXCEEDED");
        EXPECT_NE(std::string(error.what()).find("more than the limit of 10 [LIMIT_EXCEEDED] (where the file is to be "
                                                 "trusted, raise it with --set most_json_values=NUMBER)"),
                  std::string::npos)
            << error.what();
    }
}

TEST(GltfCodes, of_containers) {
    std::string const good = good_scene().glb();
    auto const with_word = [&](std::size_t offset, std::uint32_t word) {
        std::string bad = good;
        std::memcpy(bad.data() + offset, &word, 4);
        return codes_without_usual(codes_of(bad));
    };
    EXPECT_EQ(codes_without_usual(codes_of(good)), "");
    GltfBuilder without_bytes;
    without_bytes.json["buffers"] = {{{"byteLength", 4}}};
    EXPECT_EQ(codes_of(without_bytes.glb()), "refused BUFFER_MISSING_GLB_DATA");
    EXPECT_EQ(codes_of(good.substr(0, 8)), "refused GLB_UNEXPECTED_END_OF_HEADER");
    EXPECT_EQ(with_word(4, 1), "refused GLB_INVALID_VERSION");
    EXPECT_EQ(with_word(8, 12), "refused GLB_LENGTH_TOO_SMALL");
    EXPECT_EQ(with_word(12, 0xfffffff0), "refused GLB_CHUNK_TOO_BIG");
    EXPECT_EQ(with_word(16, 0), "refused GLB_UNEXPECTED_FIRST_CHUNK");
    EXPECT_EQ(codes_of(good.substr(0, good.size() - 4)), "refused GLB_UNEXPECTED_END_OF_CHUNK_DATA");
    EXPECT_EQ(with_word(8, static_cast<std::uint32_t>(good.size()) + 1), "refused GLB_LENGTH_MISMATCH");
    EXPECT_EQ(codes_without_usual(codes_of(good + "more")), "GLB_EXTRA_DATA");
    EXPECT_EQ(codes_of("{"), "refused INVALID_JSON");
    EXPECT_EQ(codes_of("[]"), "refused TYPE_MISMATCH");
    EXPECT_EQ(codes_of("{\"a\": 1e999}"), "refused VALUE_NOT_IN_RANGE");
    EXPECT_EQ(codes_without_usual(codes_of("\xEF\xBB\xBF" + good_scene().gltf())), "INVALID_JSON");
}
