#pragma once

#include "support/gltf_builder.h"

namespace alpenglow::test {

/// Nothing is said of it: bounds, UVs, a material, a skin, a morph target, a camera, an animation.
inline GltfBuilder good_scene() {
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

/// Everything that the importer reads, small: indices, attributes of every kind, sparse and interleaved accessors, a
/// picture, a hierarchy, a skin, a morph target, a camera, an animation.
inline GltfBuilder rich_scene() {
    GltfBuilder b;
    int const position = b.add<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
    int const normal = b.add<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    int const uv = b.add<std::uint16_t>("VEC2", {0, 0, 65535, 0, 0, 65535, 65535, 65535}, true);
    int const color = b.add<std::uint8_t>("VEC4", std::vector<std::uint8_t>(16, 200), true);
    int const joints = b.add<std::uint8_t>("VEC4", std::vector<std::uint8_t>(16, 0));
    int const weights = b.add<float>("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    int const indices = b.add<std::uint16_t>("SCALAR", {0, 1, 2, 2, 1, 3});
    int const moved = b.add<float>("VEC3", std::vector<float>(12, 0.5f));
    int const places = b.add_view(std::vector<std::uint16_t>{1, 3}), values = b.add_view(std::vector<float>(6, 0.25f));
    b.json["accessors"][moved]["sparse"] = {
        {"count", 2}, {"indices", {{"bufferView", places}, {"componentType", 5123}}}, {"values", {{"bufferView", values}}}};
    b.show({{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}, {"COLOR_0", color}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}},
           {{"indices", indices}, {"material", 0}, {"targets", {{{"POSITION", moved}}}}});
    b.show({{"POSITION", position}}, {{"mode", 5}});
    b.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}, {"normalTexture", {{"index", 0}}}}};
    b.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    b.json["samplers"] = {{{"magFilter", 9728}}};
    b.json["images"] = {{{"uri", "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVQYV2P4z/AfAAQAAf+VHQdlAAAAAElFTkSuQmCC"}}};
    b.json["nodes"][0].update({{"skin", 0}, {"children", {1}}, {"rotation", {0, 0, 0, 1}}, {"translation", {1, 2, 3}}});
    b.json["nodes"].push_back({{"camera", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}});
    b.json["scenes"][0]["nodes"] = {0, 2};
    b.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    std::vector<float> identity(16);
    for (std::size_t i = 0; i < 4; ++i) identity[5 * i] = 1;
    b.json["skins"] = {{{"joints", {2}}, {"inverseBindMatrices", b.add<float>("MAT4", identity)}}};
    int const times = b.add<float>("SCALAR", {0, 1});
    int const rotations = b.add<float>("VEC4", {0, 0, 0, 1, 0, 0, 0, 1});
    b.json["animations"] = {{{"samplers", {{{"input", times}, {"output", rotations}}}},
                             {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}}}}}};
    return b;
}

} // namespace alpenglow::test
