#include "scene/gltf_source.h"

#include "core/files.h"

#include <cstring>
#include <optional>
#include <span>

namespace alpenglow::gltf {

namespace {

using Bytes = std::span<std::byte const>;

constexpr std::uint64_t largest_file = std::uint64_t{4} << 30; // a .glb's length field has 32 bits
constexpr int deepest_json = 100;
constexpr std::size_t most_json_values = 8'000'000; // about 0.5 GiB once parsed

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

/// Takes the next chunk off the front of `rest`; nothing where less than a chunk's header is left.
std::optional<Chunk> take_chunk(Bytes& rest, Report const& report) {
    if (rest.empty()) return {};
    if (rest.size() < 8) report.fail("", "GLB ends in the middle of a chunk's header");
    std::uint32_t const length = word_at(rest, 0);
    if (length > rest.size() - 8) {
        report.fail("", "GLB chunk of " + std::to_string(length) + " bytes, but only " +
                            std::to_string(rest.size() - 8) + " are left");
    }
    Chunk const chunk{word_at(rest, 4), rest.subspan(8, length)};
    rest = rest.subspan(8 + length);
    return chunk;
}

struct Parts {
    Bytes json, chunk;
};

Parts split_glb(Bytes file, Report const& report) {
    if (file.size() < 12) report.fail("", "GLB shorter than its header");
    if (std::uint32_t const version = word_at(file, 4); version != 2) {
        report.fail("", "GLB version " + std::to_string(version) + " is not supported", "only version 2 is");
    }
    std::uint32_t const length = word_at(file, 8);
    if (length < 12 || length > file.size()) {
        report.fail("", "GLB header says " + std::to_string(length) + " bytes, the file has " +
                            std::to_string(file.size()));
    }
    Bytes rest = file.subspan(12, length - 12);
    std::optional<Chunk> const first = take_chunk(rest, report);
    if (!first || first->type != json_chunk) report.fail("", "GLB does not begin with a JSON chunk");
    Parts parts{first->bytes, {}};
    bool second = true;
    while (std::optional<Chunk> const chunk = take_chunk(rest, report)) {
        if (second && chunk->type == binary_chunk) parts.chunk = chunk->bytes;
        second = false;
    }
    return parts;
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
            if (++depth > deepest_json)
                report.fail("", "JSON is nested deeper than " + std::to_string(deepest_json) + " levels");
        }
    }
    if (values > most_json_values)
        report.fail("", "JSON holds more than " + std::to_string(most_json_values) + " values");
}

nlohmann::json parse_json(Bytes bytes, Report const& report) {
    std::string_view const text(reinterpret_cast<char const*>(bytes.data()), bytes.size());
    check_json_shape(text, report);
    nlohmann::json json;
    try {
        json = nlohmann::json::parse(text);
    } catch (nlohmann::json::exception const& error) {
        std::string_view const reason = error.what();
        report.fail("", "is not glTF: " + printable(reason.substr(std::min(reason.find(']') + 2, reason.size()))));
    }
    if (!json.is_object()) report.fail("", "is not glTF: its JSON is not an object");
    return json;
}

} // namespace

Source read_source(Report const& report) {
    std::vector<std::byte> const file = read_file(report.file(), largest_file);
    Source source;
    source.binary = file.size() >= 4 && word_at(file, 0) == glb_magic;
    Parts const parts = source.binary ? split_glb(file, report) : Parts{file, {}};
    source.json = parse_json(parts.json, report);
    source.chunk.assign(parts.chunk.begin(), parts.chunk.end());
    return source;
}

} // namespace alpenglow::gltf
