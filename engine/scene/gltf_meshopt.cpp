#include "scene/gltf_meshopt.h"

#include "scene/gltf_json.h"
#include "scene/gltf_source.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <fmt/format.h>

namespace alpenglow::gltf {

namespace {

constexpr char const* extension = "EXT_meshopt_compression";
/// An attribute stream spends at least two bits on each byte of sixteen elements, an index stream a byte on three
/// indices: no stream grows more.
constexpr std::uint64_t most_growth = 64;

enum class Mode { attributes, triangles, indices };
enum class Filter { none, octahedral, quaternion, exponential };

struct Stream {
    unsigned char const* bytes;
    std::uint64_t length, count, stride;
    Mode mode;
    Filter filter;
};

template <class Choice>
Choice choice(JsonObject const& json, std::string const& name, std::vector<std::string> const& names,
              std::string const& fallback) {
    std::string const text = json.text(name, fallback);
    auto const found = std::ranges::find(names, text);
    if (found == names.end()) json.fail(name, "\"" + printable(text) + "\" is not known");
    return static_cast<Choice>(found - names.begin());
}

void check_stride(Stream const& stream, JsonObject const& json) {
    bool const whole =
        stream.mode == Mode::attributes ? stream.stride % 4 == 0 : stream.stride == 2 || stream.stride == 4;
    bool const filtered = stream.filter == Filter::none || stream.mode == Mode::attributes;
    bool const suits = (stream.filter != Filter::octahedral || stream.stride == 4 || stream.stride == 8) &&
                       (stream.filter != Filter::quaternion || stream.stride == 8);
    if (!whole || !suits)
        json.fail("byteStride", fmt::format("is {}, which its mode and filter can't have", stream.stride));
    if (!filtered) json.fail("filter", "only attributes are filtered");
    if (stream.mode == Mode::triangles && stream.count % 3 != 0) json.fail("count", "is no multiple of three");
}

Stream read_stream(JsonObject const& json, BufferView const& view, Document const& document) {
    for (char const* const name : {"buffer", "byteLength", "byteStride", "count", "mode"}) json.require(name);
    constexpr std::uint64_t largest = std::uint64_t{1} << 40;
    auto const& buffer = document.buffers[static_cast<std::size_t>(json.index("buffer", document.buffers.size()))];
    std::uint64_t const offset = json.whole("byteOffset", 0, 0, largest);
    Stream stream{};
    stream.length = json.whole("byteLength", 1, 1, largest);
    stream.stride = json.whole("byteStride", 1, 1, 256);
    stream.count = json.whole("count", 1, 1, largest);
    stream.mode = choice<Mode>(json, "mode", {"ATTRIBUTES", "TRIANGLES", "INDICES"}, "");
    stream.filter = choice<Filter>(json, "filter", {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"}, "NONE");
    if (offset > buffer.size() || stream.length > buffer.size() - offset)
        json.fail("byteLength",
                  fmt::format("{} bytes from {} reach beyond its buffer of {}", stream.length, offset, buffer.size()));
    stream.bytes = reinterpret_cast<unsigned char const*>(buffer.data()) + offset;
    check_stride(stream, json);
    if (stream.count * stream.stride != view.length)
        json.fail("count", fmt::format("{} elements of {} bytes don't fill its view of {}", stream.count, stream.stride,
                                       view.length));
    if (view.length / most_growth > stream.length)
        json.fail("count", fmt::format("is {}, more than {} bytes can hold", stream.count, stream.length));
    return stream;
}

bool decode(Stream const& stream, std::byte* to) {
    switch (stream.mode) {
    case Mode::attributes:
        return meshopt_decodeVertexBuffer(to, stream.count, stream.stride, stream.bytes, stream.length) == 0;
    case Mode::triangles:
        return meshopt_decodeIndexBuffer(to, stream.count, stream.stride, stream.bytes, stream.length) == 0;
    case Mode::indices:
        break;
    }
    return meshopt_decodeIndexSequence(to, stream.count, stream.stride, stream.bytes, stream.length) == 0;
}

void undo_filter(Stream const& stream, std::byte* bytes) {
    if (stream.filter == Filter::octahedral) meshopt_decodeFilterOct(bytes, stream.count, stream.stride);
    if (stream.filter == Filter::quaternion) meshopt_decodeFilterQuat(bytes, stream.count, stream.stride);
    if (stream.filter == Filter::exponential) meshopt_decodeFilterExp(bytes, stream.count, stream.stride);
}

} // namespace

bool is_meshopt_fallback(nlohmann::json const& buffer) {
    auto const extensions = buffer.find("extensions");
    if (extensions == buffer.end() || !extensions->is_object()) return false;
    auto const found = extensions->find(extension);
    return found != extensions->end() && found->is_object() && found->value("fallback", nlohmann::json()) == true;
}

void decompress_views(Document& document, nlohmann::json const& json, Report const& report) {
    std::vector<JsonObject> const views = JsonObject(json, "", report).objects("bufferViews");
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        auto const compressed = views[i].extension(extension);
        if (!compressed) continue;
        BufferView& view = document.views[i];
        Stream const stream = read_stream(*compressed, view, document);
        total += view.length;
        check_file_bytes(total, compressed->pointer(), report);
        std::vector<std::byte> bytes(view.length);
        if (!decode(stream, bytes.data())) report.fail(compressed->pointer(), "its bytes can't be decompressed");
        undo_filter(stream, bytes.data());
        view.buffer = static_cast<int>(document.buffers.size());
        view.offset = 0;
        document.buffers.push_back(std::move(bytes));
    }
}

} // namespace alpenglow::gltf
