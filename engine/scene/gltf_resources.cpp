#include "scene/gltf_resources.h"

#include "scene/gltf_meshopt.h"
#include "scene/gltf_uri.h"

#include <algorithm>

namespace alpenglow::gltf {

namespace {

std::vector<std::byte> read_uri(std::string const& uri, std::string const& pointer, Report const& report) {
    if (std::optional<DataUri> data = parse_data_uri(uri)) {
        if (!data->valid) report.refuse("INVALID_URI", pointer, "is not a valid data URI");
        return std::move(data->bytes);
    }
    FileUri const file = resolve_file_uri(uri, report.file().parent_path());
    if (!file.reason.empty())
        report.refuse(file.malformed ? Code("INVALID_URI") : "URI_NOT_ALLOWED", pointer,
                      "\"" + printable(uri) + "\" " + file.reason);
    return read_limited(file.path, pointer, report);
}

bool is_buffer_uri(std::string_view uri) {
    std::string_view const type = data_uri_type(uri);
    return !uri.starts_with("data:") || type == "application/octet-stream" || type == "application/gltf-buffer";
}

bool is_viewed(nlohmann::json const& json, std::size_t buffer) {
    return std::ranges::any_of(json.value("bufferViews", nlohmann::json::array()),
                               [&](nlohmann::json const& view) { return view["buffer"] == buffer; });
}

std::vector<std::byte> read_buffer(Source& source, std::size_t index, Report& report) {
    nlohmann::json const& json = source.json["buffers"][index];
    std::string const pointer = "/buffers/" + std::to_string(index);
    auto const length = json.at("byteLength").get<std::uint64_t>();
    auto const uri = json.find("uri");
    bool const in_chunk = uri == json.end();
    if (in_chunk && is_meshopt_fallback(json)) return {};
    if (in_chunk && !(source.binary && index == 0)) {
        if (is_viewed(source.json, index)) report.fail(pointer, "has no uri, and is not the binary chunk of a .glb");
        report.warn(pointer + " has no uri, and nothing reads it");
        return {};
    }
    if (in_chunk && source.chunk.empty())
        report.refuse("BUFFER_MISSING_GLB_DATA", pointer, "needs a binary chunk, which this .glb lacks");
    if (!in_chunk && !is_buffer_uri(uri->get_ref<std::string const&>()))
        report.warn("BUFFER_DATA_URI_MIME_TYPE_INVALID", pointer + "/uri", "has a media type that is no buffer's");
    std::vector<std::byte> bytes = in_chunk ? std::move(source.chunk) : read_uri(*uri, pointer + "/uri", report);
    if (bytes.size() < length) {
        report.refuse("BUFFER_BYTE_LENGTH_MISMATCH", pointer + "/byteLength",
                      "is " + std::to_string(length) + ", but there are " + std::to_string(bytes.size()) + " bytes");
    }
    bytes.resize(length);
    return bytes;
}

} // namespace

std::vector<std::vector<std::byte>> read_buffers(Source& source, Report& report) {
    std::vector<std::vector<std::byte>> buffers;
    std::size_t const count = source.json.contains("buffers") ? source.json["buffers"].size() : 0;
    buffers.reserve(count);
    for (std::size_t i = 0; i < count; ++i) buffers.push_back(read_buffer(source, i, report));
    return buffers;
}

std::vector<std::byte> read_image_bytes(Document const& document, std::size_t image, Report const& report) {
    Image const& source = document.images[image];
    std::string const pointer = "/images/" + std::to_string(image);
    if (source.view == no_index) return read_uri(source.uri, pointer + "/uri", report);
    BufferView const& view = document.views[static_cast<std::size_t>(source.view)];
    auto const first =
        document.buffers[static_cast<std::size_t>(view.buffer)].begin() + static_cast<std::ptrdiff_t>(view.offset);
    return {first, first + static_cast<std::ptrdiff_t>(view.length)};
}

} // namespace alpenglow::gltf
