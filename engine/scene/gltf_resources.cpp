#include "scene/gltf_resources.h"

#include "scene/gltf_meshopt.h"
#include "scene/gltf_structure.h"
#include "scene/gltf_uri.h"

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

/// Which buffers have views.
std::vector<bool> find_viewed(nlohmann::json const& json) {
    std::vector<bool> viewed(member(json, "buffers").size());
    for (nlohmann::json const& view : member(json, "bufferViews")) viewed[view["buffer"].get<std::size_t>()] = true;
    return viewed;
}

std::vector<std::byte> read_buffer(Source& source, std::size_t index, bool viewed, Report& report) {
    nlohmann::json const& json = source.json["buffers"][index];
    std::string const pointer = "/buffers/" + std::to_string(index);
    auto const length = json.at("byteLength").get<std::uint64_t>();
    auto const uri = json.find("uri");
    bool const in_chunk = uri == json.end();
    if (in_chunk && is_meshopt_fallback(json)) return {};
    if (in_chunk && !(source.binary && index == 0)) {
        if (viewed) report.fail(pointer, "has no uri, and is not the binary chunk of a .glb");
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
    std::vector<bool> const viewed = find_viewed(source.json);
    buffers.reserve(viewed.size());
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < viewed.size(); ++i) {
        buffers.push_back(read_buffer(source, i, viewed[i], report));
        bytes += buffers.back().size();
        check_file_bytes(bytes, "/buffers/" + std::to_string(i), report);
    }
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
