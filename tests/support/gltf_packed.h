#pragma once

#include "support/gltf_builder.h"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include <stdexcept>

namespace alpenglow::test {

inline std::vector<float> const CORNERS = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 2};
inline std::vector<std::uint32_t> const INDICES = {0, 1, 2, 2, 1, 3};

inline std::string const MESHOPT = "EXT_meshopt_compression", DRACO = "KHR_draco_mesh_compression";

/// A view of `length` bytes in the fallback buffer whose compressed bytes are `bytes`.
inline int add_compressed(GltfBuilder& builder, std::vector<unsigned char> const& bytes, std::size_t count, std::size_t stride,
                   std::string const& mode) {
    int const view = builder.add_view(bytes);
    nlohmann::json& json = builder.json["bufferViews"][static_cast<std::size_t>(view)];
    nlohmann::json const extension = {{"buffer", 0},       {"byteOffset", json["byteOffset"]}, {"byteLength", bytes.size()},
                            {"byteStride", stride}, {"count", count},                {"mode", mode}};
    json = {{"buffer", 1}, {"byteLength", count * stride}, {"extensions", {{MESHOPT, extension}}}};
    return view;
}

/// Two triangles, as meshoptimizer packs them; the second buffer has no bytes.
inline GltfBuilder packed_by_meshopt() {
    GltfBuilder builder;
    std::vector<unsigned char> corners(meshopt_encodeVertexBufferBound(4, 12));
    corners.resize(meshopt_encodeVertexBuffer(corners.data(), corners.size(), CORNERS.data(), 4, 12));
    std::vector<unsigned char> triangles(meshopt_encodeIndexBufferBound(6, 4));
    triangles.resize(meshopt_encodeIndexBuffer(triangles.data(), triangles.size(), INDICES.data(), 6));
    int const positions = builder.add_accessor(add_compressed(builder, corners, 4, 12, "ATTRIBUTES"), 5126, 4, "VEC3");
    int const indices = builder.add_accessor(add_compressed(builder, triangles, 6, 4, "TRIANGLES"), 5125, 6, "SCALAR");
    builder.show({{"POSITION", positions}}, {{"indices", indices}});
    std::string const uri = "data:application/octet-stream;base64," + base64(builder.buffer);
    builder.json["buffers"] = {{{"byteLength", builder.buffer.size()}, {"uri", uri}},
                               {{"byteLength", 72}, {"extensions", {{MESHOPT, {{"fallback", true}}}}}}};
    builder.json["extensionsRequired"] = builder.json["extensionsUsed"] = {MESHOPT};
    return builder;
}

inline std::vector<char> draco_bytes(int& id) {
    draco::TriangleSoupMeshBuilder soup;
    soup.Start(2);
    id = soup.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    for (std::size_t t = 0; t < 2; ++t) {
        auto const corner = [&](std::size_t i) { return &CORNERS[3 * INDICES[3 * t + i]]; };
        soup.SetAttributeValuesForFace(id, draco::FaceIndex(static_cast<std::uint32_t>(t)), corner(0), corner(1), corner(2));
    }
    std::unique_ptr<draco::Mesh> const mesh = soup.Finalize();
    draco::EncoderBuffer buffer;
    if (!draco::Encoder().EncodeMeshToBuffer(*mesh, &buffer).ok()) throw std::runtime_error("Draco can't encode");
    return {buffer.data(), buffer.data() + buffer.size()};
}

inline GltfBuilder packed_by_draco() {
    GltfBuilder builder;
    int id = 0;
    int const view = builder.add_view(draco_bytes(id));
    nlohmann::json const extension = {{"bufferView", view}, {"attributes", {{"POSITION", id}}}};
    int const positions = builder.add_accessor(-1, 5126, 4, "VEC3");
    int const indices = builder.add_accessor(-1, 5123, 6, "SCALAR");
    builder.show({{"POSITION", positions}}, {{"indices", indices}, {"extensions", {{DRACO, extension}}}});
    builder.json["extensionsRequired"] = builder.json["extensionsUsed"] = {DRACO};
    return builder;
}

} // namespace alpenglow::test
