#pragma once

#include "scene/gltf_document.h"
#include "scene/gltf_report.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace alpenglow::gltf {

/// Checks every buffer view against its buffer. Throws Error(bad_input).
void check_views(Document const& document, Report const& report);

/// Checks every accessor against its views (ranges, strides, alignment, sparse
/// indices), in 64-bit arithmetic that can't overflow. Throws Error(bad_input).
void check_accessors(Document const& document, Report const& report);

std::size_t component_size(Component type);         ///< [bytes]
std::size_t element_size(Accessor const& accessor); ///< [bytes]

/// Elements as they lie in memory, after check_accessors has passed them.
struct Elements {
    std::byte const* first = nullptr; ///< nullptr: all zero
    std::size_t stride = 0;           ///< [bytes]
};
Elements elements_of(Document const& document, Accessor const& accessor);
Elements sparse_values_of(Document const& document, Accessor const& accessor);
/// Strictly increasing, each below the accessor's count.
std::vector<std::uint32_t> sparse_indices_of(Document const& document, Accessor const& accessor);

/// A component as a float, by the format's rule for normalized integers (glTF 2.0, section 3.11).
template <class T> float float_from(T value, bool normalized) {
    auto const number = static_cast<float>(value);
    if constexpr (std::is_integral_v<T>) {
        if (normalized) return std::max(number / static_cast<float>(std::numeric_limits<T>::max()), -1.0f);
    }
    return number;
}

/// Calls `store(i, value)` with `N` floats for each element of a vector accessor, or one of matrices without padding,
/// that has N components or fewer; what is missing is 1. Throws Error(bad_input) on a number that is not finite.
template <int N, class T, class Store>
void read_vectors_as(Document const& document, Accessor const& accessor, std::string const& pointer,
                     Report const& report, Store const& store) {
    auto const rows = static_cast<std::size_t>(accessor.rows * accessor.columns);
    auto const read = [&](std::byte const* bytes, std::size_t index) {
        T raw[N] = {};
        if (bytes) std::memcpy(raw, bytes, rows * sizeof(T));
        float value[N];
        for (std::size_t c = 0; c < N; ++c) value[c] = c < rows ? float_from(raw[c], accessor.normalized) : 1.0f;
        if constexpr (std::is_floating_point_v<T>) {
            for (float const v : value) {
                if (!std::isfinite(v))
                    report.refuse("ACCESSOR_INVALID_FLOAT", pointer,
                                  "element " + std::to_string(index) + " is not finite");
            }
        }
        store(index, value);
    };
    Elements const elements = elements_of(document, accessor);
    for (std::size_t i = 0; i < accessor.count; ++i)
        read(elements.first ? elements.first + i * elements.stride : nullptr, i);
    if (!accessor.sparse) return;
    Elements const values = sparse_values_of(document, accessor);
    std::size_t next = 0;
    for (std::uint32_t const index : sparse_indices_of(document, accessor))
        read(values.first + values.stride * next++, index);
}

template <int N, class Store>
void read_vectors(Document const& document, int index, Report const& report, Store const& store) {
    Accessor const& accessor = document.accessors[static_cast<std::size_t>(index)];
    std::string const pointer = "/accessors/" + std::to_string(index);
    switch (accessor.type) {
    case Component::int8:
        return read_vectors_as<N, std::int8_t>(document, accessor, pointer, report, store);
    case Component::uint8:
        return read_vectors_as<N, std::uint8_t>(document, accessor, pointer, report, store);
    case Component::int16:
        return read_vectors_as<N, std::int16_t>(document, accessor, pointer, report, store);
    case Component::uint16:
        return read_vectors_as<N, std::uint16_t>(document, accessor, pointer, report, store);
    case Component::uint32:
        return read_vectors_as<N, std::uint32_t>(document, accessor, pointer, report, store);
    case Component::float32:
        return read_vectors_as<N, float>(document, accessor, pointer, report, store);
    }
}

/// Vertex indices: 8, 16 or 32 bits, each below `vertices`, none the restart value. Throws Error(bad_input).
std::vector<std::uint32_t> read_indices(Document const& document, int index, std::size_t vertices,
                                        Report const& report);

} // namespace alpenglow::gltf
