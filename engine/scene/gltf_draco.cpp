#include "scene/gltf_draco.h"

#include "scene/gltf_accessor.h"
#include "scene/gltf_draco_header.h"

#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>

#include <fmt/format.h>
#include <memory>

namespace alpenglow::gltf {

namespace {

/// Vertices, or triangles, for each byte. Flat grids come near 100; what claims more is made to take memory.
constexpr std::uint64_t most_growth = 1000;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

std::span<char const> bytes_of(Document const& document, int index) {
    BufferView const& view = document.views[at(index)];
    auto const* const first = reinterpret_cast<char const*>(document.buffers[at(view.buffer)].data());
    return {first + view.offset, view.length};
}

template <class T> bool write_values(draco::Mesh const& mesh, draco::PointAttribute const& from, std::byte* to) {
    T values[4] = {};
    auto const rows = static_cast<std::int8_t>(from.num_components());
    for (std::uint32_t i = 0; i < mesh.num_points(); ++i, to += sizeof(T) * static_cast<std::size_t>(rows)) {
        if (!from.ConvertValue<T>(from.mapped_index(draco::PointIndex(i)), rows, values)) return false;
        std::memcpy(to, values, sizeof(T) * static_cast<std::size_t>(rows));
    }
    return true;
}

bool write_values(draco::Mesh const& mesh, draco::PointAttribute const& from, Component type, std::byte* to) {
    switch (type) {
    case Component::int8:
        return write_values<std::int8_t>(mesh, from, to);
    case Component::uint8:
        return write_values<std::uint8_t>(mesh, from, to);
    case Component::int16:
        return write_values<std::int16_t>(mesh, from, to);
    case Component::uint16:
        return write_values<std::uint16_t>(mesh, from, to);
    case Component::uint32:
        return write_values<std::uint32_t>(mesh, from, to);
    case Component::float32:
        break;
    }
    return write_values<float>(mesh, from, to);
}

std::vector<std::byte> triangle_bytes(draco::Mesh const& mesh) {
    std::vector<std::byte> bytes(std::size_t{mesh.num_faces()} * 3 * sizeof(std::uint32_t));
    std::byte* to = bytes.data();
    for (std::uint32_t i = 0; i < mesh.num_faces(); ++i) {
        for (draco::PointIndex const& corner : mesh.face(draco::FaceIndex(i))) {
            std::uint32_t const index = corner.value();
            std::memcpy(to, &index, sizeof index);
            to += sizeof index;
        }
    }
    return bytes;
}

/// A decoder of Draco's that makes no more attributes than glTF has a use for: a few bytes suffice to announce one, and
/// each takes memory for every vertex.
template <class Decoder> class BoundedDecoder : public Decoder {
public:
    draco::Status decode(draco::DecoderBuffer& buffer, draco::Mesh& mesh) {
        return this->Decode(draco::DecoderOptions(), &buffer, &mesh);
    }

private:
    bool DecodeAllAttributes() override {
        constexpr int most_components = 64;
        int components = 0;
        for (int i = 0; i < this->mesh()->num_attributes(); ++i)
            components += this->mesh()->attribute(i)->num_components();
        return components <= most_components && Decoder::DecodeAllAttributes();
    }
};

/// The decoded primitives of one document. Two primitives that name one accessor for different bytes get one each.
class Decompressor {
public:
    Decompressor(Document& document, Report const& report)
        : document_(document), report_(report), taken_(document.accessors.size()) {}

    void decompress(Primitive& primitive, std::string const& pointer) {
        std::unique_ptr<draco::Mesh> const mesh = decode(primitive, pointer);
        for (auto const& [name, id] : primitive.draco->attributes) {
            auto const own = primitive.attributes.find(name);
            if (own == primitive.attributes.end())
                report_.fail(pointer + "/attributes/" + printable(name), "is not an attribute of the primitive");
            take_attribute(*mesh, id, own->second, pointer + "/attributes/" + printable(name));
        }
        Accessor triangles;
        triangles.type = Component::uint32;
        triangles.count = std::uint64_t{mesh->num_faces()} * 3;
        if (triangles.count == 0) report_.fail(pointer, "holds no triangle");
        triangles.view = add_view(triangle_bytes(*mesh));
        document_.accessors.push_back(triangles);
        primitive.indices = static_cast<int>(document_.accessors.size()) - 1;
        primitive.mode = 4;
    }

private:
    std::unique_ptr<draco::Mesh> decode(Primitive const& primitive, std::string const& pointer) {
        std::span<char const> const bytes = bytes_of(document_, primitive.draco->view);
        bool const edgebreaker = check_counts(bytes, primitive, pointer).edgebreaker;
        draco::DecoderBuffer buffer;
        buffer.Init(bytes.data(), bytes.size());
        auto mesh = std::make_unique<draco::Mesh>();
        draco::Status const status = edgebreaker
                                         ? BoundedDecoder<draco::MeshEdgebreakerDecoder>().decode(buffer, *mesh)
                                         : BoundedDecoder<draco::MeshSequentialDecoder>().decode(buffer, *mesh);
        if (!status.ok())
            report_.fail(pointer, "its bytes can't be decompressed: " + printable(status.error_msg_string()));
        return mesh;
    }

    /// The decoder allocates by what the stream says: that must be what the accessors say, and within the limits.
    DracoCounts check_counts(std::span<char const> bytes, Primitive const& primitive, std::string const& pointer) {
        std::optional<DracoCounts> const counts = read_draco_counts(bytes);
        if (!counts) report_.fail(pointer + "/bufferView", "is not a Draco 2.2 mesh");
        auto const position = primitive.attributes.find("POSITION");
        std::uint64_t const points =
            position == primitive.attributes.end() ? 0 : document_.accessors[at(position->second)].count;
        std::uint64_t const corners =
            primitive.indices == no_index ? 0 : document_.accessors[at(primitive.indices)].count;
        bool const list = primitive.mode == 4;
        if (counts->vertices > points || (list ? counts->faces * 3 != corners : counts->faces > corners)) {
            report_.fail(pointer,
                         fmt::format("holds {} vertices and {} triangles, the primitive's accessors say {} and {}",
                                     counts->vertices, counts->faces, points, corners / 3));
        }
        if (points / most_growth > bytes.size() || counts->faces / most_growth > bytes.size())
            report_.fail(pointer, fmt::format("says {} vertices and {} triangles, more than {} bytes can hold", points,
                                              counts->faces, bytes.size()));
        check_total(points, counts->faces * 3 * (1 + counts->seams), pointer);
        return *counts;
    }

    void check_total(std::uint64_t vertices, std::uint64_t indices, std::string const& pointer) {
        vertices_ += vertices;
        indices_ += indices;
        GltfLimits const& limits = report_.limits();
        if (vertices_ > static_cast<std::uint64_t>(limits.most_vertices))
            report_.refuse_beyond("most_vertices", limits.most_vertices, pointer,
                                  fmt::format("unpacks {} vertices in all", vertices_));
        if (indices_ > static_cast<std::uint64_t>(limits.most_indices))
            report_.refuse_beyond("most_indices", limits.most_indices, pointer,
                                  fmt::format("unpacks {} indices in all", indices_));
    }

    void take_attribute(draco::Mesh const& mesh, int id, int& index, std::string const& pointer) {
        draco::PointAttribute const* const from = mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
        if (!from) report_.fail(pointer, fmt::format("there is no Draco attribute {}", id));
        Accessor accessor = document_.accessors[at(index)];
        if (accessor.columns != 1 || accessor.rows != from->num_components() || accessor.count != mesh.num_points())
            report_.fail(pointer,
                         fmt::format("its accessor says {} elements of {}, the Draco mesh {} of {}", accessor.count,
                                     accessor.rows, mesh.num_points(), from->num_components()));
        std::vector<std::byte> bytes(accessor.count * element_size(accessor));
        if (!write_values(mesh, *from, accessor.type, bytes.data()))
            report_.fail(pointer, "its values don't fit the accessor's components");
        accessor.view = add_view(std::move(bytes));
        accessor.offset = 0;
        if (taken_[at(index)]) {
            document_.accessors.push_back(accessor);
            index = static_cast<int>(document_.accessors.size()) - 1;
        } else {
            taken_[at(index)] = true;
            document_.accessors[at(index)] = accessor;
        }
    }

    int add_view(std::vector<std::byte> bytes) {
        document_.views.push_back({static_cast<int>(document_.buffers.size()), 0, bytes.size(), 0});
        document_.buffers.push_back(std::move(bytes));
        return static_cast<int>(document_.views.size()) - 1;
    }

    Document& document_;
    Report const& report_;
    std::vector<bool> taken_;
    std::uint64_t vertices_ = 0, indices_ = 0; ///< of all meshes so far
};

} // namespace

void decompress_primitives(Document& document, Report const& report) {
    Decompressor decompressor(document, report);
    for (std::size_t m = 0; m < document.meshes.size(); ++m) {
        std::vector<Primitive>& primitives = document.meshes[m].primitives;
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            if (!primitives[p].draco) continue;
            decompressor.decompress(
                primitives[p], fmt::format("/meshes/{}/primitives/{}/extensions/KHR_draco_mesh_compression", m, p));
        }
    }
}

} // namespace alpenglow::gltf
