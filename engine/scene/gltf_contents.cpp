#include "scene/gltf_contents.h"

#include "scene/gltf_elements.h"
#include "scene/gltf_structure.h"

namespace alpenglow::gltf {

namespace {

using Json = nlohmann::json;

/// Interleaved and shared views are read a few times over; a file that has the same bytes read again and again wants
/// time, not triangles.
void check_work(Document const& document, Report const& report) {
    constexpr std::uint64_t most_times = 16, free_bytes = 1 << 20;
    std::uint64_t buffers = 0, accessors = 0;
    for (auto const& buffer : document.buffers) buffers += buffer.size();
    for (Accessor const& accessor : document.accessors) {
        std::uint64_t const stored = accessor.view != no_index ? accessor.count : 0;
        accessors += element_size(accessor) * (stored + (accessor.sparse ? accessor.sparse->count : 0));
        if (accessors > most_times * buffers + free_bytes)
            report.refuse("ACCESSORS_OVERLAP", "/accessors",
                          fmt::format("read the buffers' {} bytes more than {} times over", buffers, most_times));
    }
}

/// Compares what an accessor says of its least or greatest component with what it holds. Floats are compared as such:
/// the JSON may have fewer digits, or more.
bool is_bound(Json const& bound, double actual, bool is_float) {
    double const stated = bound.get<double>();
    return is_float ? static_cast<float>(stated) == static_cast<float>(actual) : stated == actual;
}

struct Range {
    ElementValues least, greatest;
};

void check_bounds(Json const& accessor, Range const& range, std::size_t components, std::string const& pointer,
                  Report& report) {
    bool const is_float = accessor["componentType"] == 5126;
    for (auto const& [key, actual] : {std::pair("min", &range.least), {"max", &range.greatest}}) {
        Json const& stated = member(accessor, key);
        if (stated.is_null()) continue;
        if (stated.size() != components)
            report.refuse("ARRAY_LENGTH_NOT_IN_LIST", pointer + "/" + key,
                          fmt::format("must be an array of {} numbers", components));
        for (std::size_t c = 0; c < components; ++c) {
            if (is_bound(stated[c], (*actual)[c], is_float)) continue;
            report.say(key == std::string_view("min") ? Code("ACCESSOR_MIN_MISMATCH") : "ACCESSOR_MAX_MISMATCH",
                       fmt::format("{}/{}/{}", pointer, key, c),
                       fmt::format("is {}, but the numbers say {}", stated[c].get<double>(), (*actual)[c]));
        }
    }
}

void check_accessor_values(Json const& json, Document const& document, std::size_t index, Report& report) {
    Accessor const& accessor = document.accessors[index];
    auto const components = static_cast<std::size_t>(accessor.columns * accessor.rows);
    std::string const pointer = fmt::format("/accessors/{}", index);
    Range range;
    range.least.fill(std::numeric_limits<double>::infinity());
    range.greatest.fill(-std::numeric_limits<double>::infinity());
    visit_elements(document, index, [&](std::size_t i, ElementValues const& values) {
        for (std::size_t c = 0; c < components; ++c) {
            if (!std::isfinite(values[c]))
                report.refuse("ACCESSOR_INVALID_FLOAT", pointer, fmt::format("element {} is not finite", i));
            range.least[c] = std::min(range.least[c], values[c]);
            range.greatest[c] = std::max(range.greatest[c], values[c]);
        }
    });
    // What a compressed mesh unpacks to is rounded, and may stand in accessors of its own.
    if (index >= json["accessors"].size()) return;
    Json const& stated = json["accessors"][index];
    if (stated.contains("bufferView") || stated.contains("sparse"))
        check_bounds(stated, range, components, pointer, report);
}

} // namespace

void check_values(Json const& json, Document const& document, Report& report) {
    for (std::size_t i = 0; i < document.accessors.size(); ++i) check_accessor_values(json, document, i, report);
}

void check_contents(Json const& json, Document const& document, Report& report) {
    check_work(document, report);
    check_values(json, document, report);
    check_attribute_values(json, document, report);
    check_motion_values(json, document, report);
    check_images(json, document, report);
}

} // namespace alpenglow::gltf
