#pragma once

#include "scene/gltf_accessor.h"

#include <algorithm>
#include <array>

namespace alpenglow::gltf {

/// The components of one element as stored, before normalization; matrices by columns. 32 bits fit a double.
using ElementValues = std::array<double, 16>;

template <class T> ElementValues element_values(std::byte const* bytes, std::size_t columns, std::size_t rows) {
    ElementValues values{};
    // Columns begin at multiples of four bytes (glTF 2.0, section 3.6.2.4).
    std::size_t const column_size = columns == 1 ? rows * sizeof(T) : (rows * sizeof(T) + 3) / 4 * 4;
    for (std::size_t c = 0; c < columns; ++c) {
        for (std::size_t r = 0; r < rows; ++r) {
            T value;
            std::memcpy(&value, bytes + c * column_size + r * sizeof(T), sizeof(T));
            values[c * rows + r] = static_cast<double>(value);
        }
    }
    return values;
}

template <class T, class Visit>
void visit_elements_as(Document const& document, Accessor const& accessor, Visit const& visit) {
    auto const columns = static_cast<std::size_t>(accessor.columns), rows = static_cast<std::size_t>(accessor.rows);
    std::vector<std::uint32_t> const replaced =
        accessor.sparse ? sparse_indices_of(document, accessor) : std::vector<std::uint32_t>{};
    Elements const elements = elements_of(document, accessor);
    if (elements.first) {
        auto next = replaced.begin();
        for (std::size_t i = 0; i < accessor.count; ++i) {
            if (next != replaced.end() && *next == i)
                ++next;
            else
                visit(i, element_values<T>(elements.first + i * elements.stride, columns, rows));
        }
    } else if (replaced.size() < accessor.count) {
        std::size_t first_zero = 0;
        while (first_zero < replaced.size() && replaced[first_zero] == first_zero) ++first_zero;
        visit(first_zero, ElementValues{});
    }
    if (replaced.empty()) return;
    Elements const values = sparse_values_of(document, accessor);
    for (std::size_t i = 0; i < replaced.size(); ++i)
        visit(replaced[i], element_values<T>(values.first + i * values.stride, columns, rows));
}

/// Calls `visit(index, values)` for the elements of an accessor that check_accessors has passed: those replaced by a
/// sparse one come last, and one stands for all that are zero for want of a view.
template <class Visit> void visit_elements(Document const& document, std::size_t accessor_index, Visit const& visit) {
    Accessor const& accessor = document.accessors[accessor_index];
    switch (accessor.type) {
    case Component::int8:
        return visit_elements_as<std::int8_t>(document, accessor, visit);
    case Component::uint8:
        return visit_elements_as<std::uint8_t>(document, accessor, visit);
    case Component::int16:
        return visit_elements_as<std::int16_t>(document, accessor, visit);
    case Component::uint16:
        return visit_elements_as<std::uint16_t>(document, accessor, visit);
    case Component::uint32:
        return visit_elements_as<std::uint32_t>(document, accessor, visit);
    case Component::float32:
        return visit_elements_as<float>(document, accessor, visit);
    }
}

} // namespace alpenglow::gltf
