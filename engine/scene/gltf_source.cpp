#include "scene/gltf_source.h"

#include "core/error.h"
#include "core/files.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <optional>
#include <span>

namespace alpenglow::gltf {

namespace {

using Bytes = std::span<std::byte const>;

constexpr std::uint32_t glb_magic = 0x46546C67;    // "glTF"
constexpr std::uint32_t json_chunk = 0x4E4F534A;   // "JSON"
constexpr std::uint32_t binary_chunk = 0x004E4942; // "BIN"

std::uint32_t word_at(Bytes bytes, std::size_t offset) {
    std::uint32_t word;
    std::memcpy(&word, bytes.data() + offset, sizeof word);
    return word;
}

struct Chunk {
    std::uint32_t type;
    Bytes bytes;
};

/// Takes the next chunk off the front of `rest`; nothing where it is empty. `declared` bytes were to follow.
std::optional<Chunk> take_chunk(Bytes& rest, std::size_t declared, Report const& report) {
    if (rest.empty()) return {};
    if (rest.size() < 8)
        report.refuse("GLB_UNEXPECTED_END_OF_CHUNK_HEADER", "", "GLB ends in the middle of a chunk's header");
    std::uint32_t const length = word_at(rest, 0);
    if (length > rest.size() - 8) {
        bool const cut = length + std::uint64_t{8} <= declared;
        report.refuse(cut ? Code("GLB_UNEXPECTED_END_OF_CHUNK_DATA") : "GLB_CHUNK_TOO_BIG", "",
                      "GLB chunk of " + std::to_string(length) + " bytes, but only " + std::to_string(rest.size() - 8) +
                          " are left");
    }
    Chunk const chunk{word_at(rest, 4), rest.subspan(8, length)};
    rest = rest.subspan(8 + length);
    return chunk;
}

struct Parts {
    Bytes json, chunk;
};

void check_glb_header(Bytes file, Report& report) {
    if (file.size() < 12) report.refuse("GLB_UNEXPECTED_END_OF_HEADER", "", "GLB shorter than its header");
    if (word_at(file, 0) != glb_magic) report.refuse("GLB_INVALID_MAGIC", "", "is neither GLB nor JSON");
    if (std::uint32_t const version = word_at(file, 4); version != 2) {
        report.refuse("GLB_INVALID_VERSION", "", "GLB version " + std::to_string(version) + " is not supported",
                      "only version 2 is");
    }
    std::uint32_t const length = word_at(file, 8);
    std::string const says = "GLB header says " + std::to_string(length) + " bytes";
    if (length <= 12) report.refuse("GLB_LENGTH_TOO_SMALL", "", says + ", no more than its header");
    if (length < file.size()) report.warn("GLB_EXTRA_DATA", "", says + ", the file has " + std::to_string(file.size()));
}

/// The binary chunk, which stands second or not at all.
Bytes take_binary_chunk(Bytes rest, std::size_t declared, Report& report) {
    Bytes binary;
    for (int number = 1; std::optional<Chunk> const chunk = take_chunk(rest, declared, report); ++number) {
        if (chunk->bytes.size() % 4 != 0)
            report.warn("GLB_CHUNK_LENGTH_UNALIGNED", "", "a GLB chunk's length is no multiple of 4");
        bool const again = chunk->type == json_chunk || (chunk->type == binary_chunk && binary.data());
        if (again)
            report.warn("GLB_DUPLICATE_CHUNK", "", "a kind of GLB chunk stands twice: the first one counts");
        else if (chunk->type == binary_chunk && number > 1)
            report.warn("GLB_UNEXPECTED_BIN_CHUNK", "", "a binary chunk that is not the second is left out");
        else if (chunk->type == binary_chunk)
            binary = chunk->bytes;
    }
    return binary;
}

Parts split_glb(Bytes file, Report& report) {
    check_glb_header(file, report);
    std::size_t const declared = word_at(file, 8) - 12;
    Bytes rest = file.subspan(12, std::min(declared, file.size() - 12));
    std::optional<Chunk> const first = take_chunk(rest, declared, report);
    if (!first || first->type != json_chunk)
        report.refuse("GLB_UNEXPECTED_FIRST_CHUNK", "", "GLB does not begin with a JSON chunk");
    if (first->bytes.empty()) report.refuse("GLB_EMPTY_CHUNK", "", "GLB has an empty JSON chunk");
    if (first->bytes.size() % 4 != 0)
        report.warn("GLB_CHUNK_LENGTH_UNALIGNED", "", "the JSON chunk's length is no multiple of 4");
    Bytes const binary = take_binary_chunk(rest, declared, report);
    if (declared > file.size() - 12) {
        report.refuse("GLB_LENGTH_MISMATCH", "",
                      "GLB header says " + std::to_string(declared + 12) + " bytes, the file has " +
                          std::to_string(file.size()));
    }
    return {first->bytes, binary};
}

/// By content; a name that ends in .glb decides only where the content is neither.
bool is_binary(Bytes file, std::filesystem::path const& name) {
    if (file.size() >= 4 && word_at(file, 0) == glb_magic) return true;
    auto const is_space = [](std::byte b) { return std::isspace(static_cast<unsigned char>(b)) != 0; };
    auto const first = std::ranges::find_if_not(file, is_space);
    return name.extension() == ".glb" && (first == file.end() || *first != std::byte{'{'});
}

/// The parser's memory and stack depend on the number of values and on their depth; both are known before it runs.
void check_json_shape(std::string_view text, Report const& report) {
    int depth = 0;
    std::size_t values = 1;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        char const c = text[i];
        if (in_string) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                in_string = false;
            continue;
        }
        if (c == '"')
            in_string = true;
        else if (c == ',' || c == ':')
            ++values;
        else if (c == ']' || c == '}')
            --depth;
        else if (c == '[' || c == '{') {
            ++values;
            if (++depth > report.limits().deepest_json)
                report.refuse_beyond("deepest_json", report.limits().deepest_json, "", "JSON is nested deeply");
        }
    }
    if (int const most = report.limits().most_json_values; values > static_cast<std::size_t>(most))
        report.refuse_beyond("most_json_values", most, "", "JSON holds " + std::to_string(values) + " values");
}

nlohmann::json parse_json(Bytes bytes, Report& report) {
    std::string_view const text(reinterpret_cast<char const*>(bytes.data()), bytes.size());
    check_json_shape(text, report);
    if (text.starts_with("\xEF\xBB\xBF")) report.warn("INVALID_JSON", "", "begins with a byte order mark");
    auto const reason = [](std::string_view what) {
        return printable(what.substr(std::min(what.find(']') + 2, what.size())));
    };
    nlohmann::json json;
    try {
        json = nlohmann::json::parse(text);
    } catch (nlohmann::json::out_of_range const& error) {
        report.refuse("VALUE_NOT_IN_RANGE", "", "is not glTF: " + reason(error.what()));
    } catch (nlohmann::json::exception const& error) {
        report.refuse("INVALID_JSON", "", "is not glTF: " + reason(error.what()));
    }
    if (!json.is_object()) report.refuse("TYPE_MISMATCH", "", "is not glTF: its JSON is not an object");
    return json;
}

} // namespace

std::vector<std::byte> read_limited(std::filesystem::path const& path, std::string const& pointer,
                                    Report const& report) {
    int const most = report.limits().largest_scene_file;
    std::error_code no_file;
    std::uint64_t const size = std::filesystem::file_size(path, no_file);
    if (!no_file && size > std::uint64_t(most) << 20)
        report.refuse_beyond("largest_scene_file", most, pointer, "has " + std::to_string(size >> 20) + " MiB");
    try {
        return read_file(path, std::uint64_t(most) << 20);
    } catch (Error const& error) {
        if (pointer.empty()) throw;
        report.refuse("IO_ERROR", pointer, error.what(), "");
    }
}

Source read_source(Report& report) {
    std::vector<std::byte> const file = read_limited(report.file(), "", report);
    Source source;
    source.binary = is_binary(file, report.file());
    Parts const parts = source.binary ? split_glb(file, report) : Parts{file, {}};
    source.json = parse_json(parts.json, report);
    source.chunk.assign(parts.chunk.begin(), parts.chunk.end());
    return source;
}

} // namespace alpenglow::gltf
