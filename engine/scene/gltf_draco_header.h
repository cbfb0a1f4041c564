#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace alpenglow::gltf {

/// What the front of a Draco stream announces.
struct DracoCounts {
    std::uint64_t faces = 0;
    std::uint64_t vertices = 0; ///< before those at seams are doubled
    bool edgebreaker = false;   ///< else one face after the other
    std::uint64_t seams = 0;    ///< tables of all corners that edgebreaker makes beside its own
};

/// Nothing where `bytes` are not a triangle mesh in Draco's bitstream 2.2, the one that glTF names (Draco bitstream
/// specification, sections 3.1 and 4).
std::optional<DracoCounts> read_draco_counts(std::span<char const> bytes);

} // namespace alpenglow::gltf
