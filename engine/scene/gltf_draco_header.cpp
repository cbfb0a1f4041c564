#include "scene/gltf_draco_header.h"

#include <draco/core/decoder_buffer.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/geometry_metadata.h>
#include <draco/metadata/metadata_decoder.h>

#include <cstring>

namespace alpenglow::gltf {

namespace {

constexpr std::uint16_t bitstream_2_2 = 0x0202;
constexpr std::uint16_t has_metadata = 0x8000;

struct Header {
    char magic[5];
    std::uint8_t major, minor;
    std::uint8_t geometry; ///< 1: triangle mesh
    std::uint8_t method;   ///< 0: one after the other, 1: edgebreaker
};
static_assert(sizeof(Header) == 9);

} // namespace

std::optional<DracoCounts> read_draco_counts(std::span<char const> bytes) {
    draco::DecoderBuffer buffer;
    buffer.Init(bytes.data(), bytes.size(), bitstream_2_2);
    Header header{};
    std::uint16_t flags = 0;
    if (!buffer.Decode(&header) || !buffer.Decode(&flags)) return {};
    if (std::memcmp(header.magic, "DRACO", 5) != 0 || header.major != 2 || header.minor != 2 || header.geometry != 1 ||
        header.method > 1)
        return {};
    if ((flags & has_metadata) != 0) {
        draco::GeometryMetadata metadata;
        if (!draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata)) return {};
    }
    bool const edgebreaker = header.method == 1;
    std::uint8_t traversal = 0;
    if (edgebreaker && !buffer.Decode(&traversal)) return {};
    std::uint32_t first = 0, second = 0;
    if (!draco::DecodeVarint(&first, &buffer) || !draco::DecodeVarint(&second, &buffer)) return {};
    if (!edgebreaker) return DracoCounts{first, second};
    std::uint8_t seams = 0;
    if (!buffer.Decode(&seams)) return {};
    return DracoCounts{second, first, true, seams};
}

} // namespace alpenglow::gltf
