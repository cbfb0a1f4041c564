#include "scene/gltf_accessor.h"

#include <algorithm>
#include <fmt/format.h>

namespace alpenglow::gltf {

namespace {

/// What an accessor without a view may claim whatever the file's size.
constexpr std::uint64_t most_zero_elements = 65536;

std::string pointer_to(char const* array, std::size_t index) { return fmt::format("/{}/{}", array, index); }

std::string bytes_text(std::uint64_t bytes) { return std::to_string(bytes) + " bytes"; }

void check_view(Document const& document, std::size_t index, Report const& report) {
    BufferView const& view = document.views[index];
    std::uint64_t const size = document.buffers[static_cast<std::size_t>(view.buffer)].size();
    if (view.offset > size || view.length > size - view.offset) {
        report.refuse("BUFFER_VIEW_TOO_LONG", pointer_to("bufferViews", index),
                      bytes_text(view.length) + " from " + std::to_string(view.offset) +
                          " reach beyond its buffer of " + bytes_text(size));
    }
}

/// `count` elements of `size` bytes at `offset` in a view, `stride` apart.
struct Span {
    int view;
    std::uint64_t offset, count, size, stride, component;
};

void check_span(Document const& document, Span const& span, std::string const& pointer, Report const& report) {
    BufferView const& view = document.views[static_cast<std::size_t>(span.view)];
    if (span.stride < span.size) {
        report.refuse("ACCESSOR_SMALL_BYTESTRIDE", pointer,
                      "elements of " + bytes_text(span.size) + " don't fit its view's stride of " +
                          bytes_text(span.stride));
    }
    if ((view.offset + span.offset) % span.component != 0 || span.stride % span.component != 0) {
        report.refuse("ACCESSOR_TOTAL_OFFSET_ALIGNMENT", pointer,
                      "is not aligned to its components of " + bytes_text(span.component));
    }
    bool const fits = span.offset <= view.length && span.size <= view.length - span.offset &&
                      span.count - 1 <= (view.length - span.offset - span.size) / span.stride;
    if (!fits) {
        report.refuse("ACCESSOR_TOO_LONG", pointer,
                      std::to_string(span.count) + " elements from byte " + std::to_string(span.offset) +
                          " reach beyond its view of " + bytes_text(view.length));
    }
}

void check_sparse(Document const& document, Accessor const& accessor, std::string const& pointer,
                  Report const& report) {
    Accessor::Sparse const& sparse = *accessor.sparse;
    if (sparse.count > accessor.count)
        report.refuse("ACCESSOR_SPARSE_COUNT_OUT_OF_RANGE", pointer + "/sparse/count", "is above the accessor's count");
    std::size_t const index_size = component_size(sparse.index_type), size = element_size(accessor);
    check_span(document, {sparse.index_view, sparse.index_offset, sparse.count, index_size, index_size, index_size},
               pointer + "/sparse/indices", report);
    check_span(document,
               {sparse.value_view, sparse.value_offset, sparse.count, size, size, component_size(accessor.type)},
               pointer + "/sparse/values", report);
    std::vector<std::uint32_t> const indices = sparse_indices_of(document, accessor);
    if (std::ranges::adjacent_find(indices, std::greater_equal<>()) != indices.end()) {
        report.refuse("ACCESSOR_SPARSE_INDICES_NON_INCREASING", pointer + "/sparse/indices", "must increase strictly");
    }
    if (indices.back() >= accessor.count)
        report.refuse("ACCESSOR_SPARSE_INDEX_OOB", pointer + "/sparse/indices",
                      "holds an index beyond the accessor's count");
}

/// [bytes] of an element without the padding behind its last column, which the last one may lack.
std::size_t unpadded_size(Accessor const& accessor) {
    std::size_t const column = component_size(accessor.type) * static_cast<std::size_t>(accessor.rows);
    return element_size(accessor) - element_size(accessor) / static_cast<std::size_t>(accessor.columns) + column;
}

void check_accessor(Document const& document, std::size_t index, std::uint64_t all_bytes, Report const& report) {
    Accessor const& accessor = document.accessors[index];
    std::string const pointer = pointer_to("accessors", index);
    if (accessor.normalized && (accessor.type == Component::float32 || accessor.type == Component::uint32)) {
        report.refuse("ACCESSOR_NORMALIZED_INVALID", pointer + "/normalized",
                      "is true, but its components are not 8 or 16 bits");
    }
    if (accessor.view != no_index) {
        std::size_t const size = element_size(accessor);
        std::uint64_t const stride = document.views[static_cast<std::size_t>(accessor.view)].stride;
        check_span(document,
                   {accessor.view, accessor.offset, accessor.count, unpadded_size(accessor), stride ? stride : size,
                    component_size(accessor.type)},
                   pointer, report);
    } else if (accessor.count > std::max(all_bytes, most_zero_elements)) {
        report.refuse("ACCESSOR_TOO_LONG", pointer + "/count",
                      "is " + std::to_string(accessor.count) + ", more than all buffers have bytes");
    }
    if (accessor.sparse) check_sparse(document, accessor, pointer, report);
}

template <class T> std::vector<std::uint32_t> integers(Elements const& elements, std::size_t count) {
    std::vector<std::uint32_t> result(count);
    for (std::size_t i = 0; elements.first && i < count; ++i) {
        T value;
        std::memcpy(&value, elements.first + i * elements.stride, sizeof value);
        result[i] = value;
    }
    return result;
}

std::vector<std::uint32_t> integers(Elements const& elements, std::size_t count, Component type) {
    if (type == Component::uint8) return integers<std::uint8_t>(elements, count);
    if (type == Component::uint16) return integers<std::uint16_t>(elements, count);
    return integers<std::uint32_t>(elements, count);
}

Elements elements_in(Document const& document, int view, std::uint64_t offset, std::size_t size) {
    BufferView const& source = document.views[static_cast<std::size_t>(view)];
    std::byte const* const first = document.buffers[static_cast<std::size_t>(source.buffer)].data();
    return {first + source.offset + offset, source.stride ? source.stride : size};
}

} // namespace

std::size_t component_size(Component type) {
    switch (type) {
    case Component::int8:
    case Component::uint8:
        return 1;
    case Component::int16:
    case Component::uint16:
        return 2;
    case Component::uint32:
    case Component::float32:
        break;
    }
    return 4;
}

std::size_t element_size(Accessor const& accessor) {
    std::size_t const column = component_size(accessor.type) * static_cast<std::size_t>(accessor.rows);
    if (accessor.columns == 1) return column;
    // The columns of matrices begin at multiples of four bytes (glTF 2.0, section 3.6.2.4).
    return (column + 3) / 4 * 4 * static_cast<std::size_t>(accessor.columns);
}

void check_views(Document const& document, Report const& report) {
    for (std::size_t i = 0; i < document.views.size(); ++i) check_view(document, i, report);
}

void check_accessors(Document const& document, Report const& report) {
    std::uint64_t all_bytes = 0;
    for (auto const& buffer : document.buffers) all_bytes += buffer.size();
    for (std::size_t i = 0; i < document.accessors.size(); ++i) check_accessor(document, i, all_bytes, report);
}

Elements elements_of(Document const& document, Accessor const& accessor) {
    if (accessor.view == no_index) return {};
    return elements_in(document, accessor.view, accessor.offset, element_size(accessor));
}

Elements sparse_values_of(Document const& document, Accessor const& accessor) {
    std::size_t const size = element_size(accessor);
    return {elements_in(document, accessor.sparse->value_view, accessor.sparse->value_offset, size).first, size};
}

std::vector<std::uint32_t> sparse_indices_of(Document const& document, Accessor const& accessor) {
    Accessor::Sparse const& sparse = *accessor.sparse;
    std::size_t const size = component_size(sparse.index_type);
    return integers({elements_in(document, sparse.index_view, sparse.index_offset, size).first, size}, sparse.count,
                    sparse.index_type);
}

std::vector<std::uint32_t> read_indices(Document const& document, int index, std::size_t vertices,
                                        Report const& report) {
    Accessor const& accessor = document.accessors[static_cast<std::size_t>(index)];
    std::string const pointer = pointer_to("accessors", static_cast<std::size_t>(index));
    bool const suitable =
        accessor.type == Component::uint8 || accessor.type == Component::uint16 || accessor.type == Component::uint32;
    if (!suitable || accessor.rows != 1 || accessor.columns != 1 || accessor.normalized) {
        report.refuse("MESH_PRIMITIVE_INDICES_ACCESSOR_INVALID_FORMAT", pointer,
                      "can't be indices: these are unsigned scalars, not normalized");
    }
    std::vector<std::uint32_t> indices = integers(elements_of(document, accessor), accessor.count, accessor.type);
    if (accessor.sparse) {
        std::vector<std::uint32_t> const places = sparse_indices_of(document, accessor);
        std::vector<std::uint32_t> const values =
            integers(sparse_values_of(document, accessor), places.size(), accessor.type);
        for (std::size_t i = 0; i < places.size(); ++i) indices[places[i]] = values[i];
    }
    std::uint64_t const restart = (std::uint64_t{1} << 8 * component_size(accessor.type)) - 1;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] == restart) {
            report.refuse("ACCESSOR_INDEX_PRIMITIVE_RESTART", pointer,
                          "index " + std::to_string(i) + " is the restart value " + std::to_string(restart));
        }
        if (indices[i] >= vertices) {
            report.refuse("ACCESSOR_INDEX_OOB", pointer,
                          "index " + std::to_string(i) + " is " + std::to_string(indices[i]) + ", but there are " +
                              std::to_string(vertices) + " vertices");
        }
    }
    return indices;
}

} // namespace alpenglow::gltf
