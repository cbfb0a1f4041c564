#include "terrain/gltf_writer.h"

#include "core/error.h"
#include "core/files.h"

#include <bit>
#include <cstdint>
#include <cstring>

namespace alpenglow {

namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

void append(std::vector<std::byte>& to, std::span<std::byte const> bytes) {
    to.insert(to.end(), bytes.begin(), bytes.end());
}

void append_word(std::vector<std::byte>& to, std::size_t word) {
    auto const value = static_cast<std::uint32_t>(word);
    append(to, std::as_bytes(std::span(&value, 1)));
}

void align(std::vector<std::byte>& bytes, char padding) {
    bytes.resize((bytes.size() + 3) / 4 * 4, static_cast<std::byte>(padding));
}

} // namespace

int GltfWriter::add_view(std::span<std::byte const> bytes, int stride, int target) {
    align(binary_, 0);
    nlohmann::ordered_json view{{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}};
    if (stride) view["byteStride"] = stride;
    if (target) view["target"] = target;
    append(binary_, bytes);
    json["bufferViews"].push_back(std::move(view));
    return static_cast<int>(json["bufferViews"].size()) - 1;
}

int GltfWriter::add_picture(std::string const& name, std::string const& kind, std::vector<std::byte> bytes) {
    pictures_.push_back({name, kind, std::move(bytes)});
    return static_cast<int>(pictures_.size()) - 1;
}

void GltfWriter::require_known_ending(std::filesystem::path const& file) {
    if (file.extension() == ".glb" || file.extension() == ".gltf") return;
    throw Error(ErrorKind::wrong_use, "is neither .glb nor .gltf", file.string(), "give the file one of these endings");
}

void GltfWriter::write(std::filesystem::path const& file) {
    require_known_ending(file);
    if (file.extension() == ".glb")
        write_glb(file);
    else
        write_gltf(file);
}

void GltfWriter::write_glb(std::filesystem::path const& file) {
    for (Picture const& p : pictures_) {
        json["images"].push_back(
            {{"name", p.name}, {"mimeType", "image/" + p.kind}, {"bufferView", add_view(p.bytes)}});
    }
    align(binary_, 0);
    json["buffers"] = {{{"byteLength", binary_.size()}}};

    std::string const text = json.dump();
    std::vector<std::byte> head(std::as_bytes(std::span(text)).begin(), std::as_bytes(std::span(text)).end());
    align(head, ' ');
    std::vector<std::byte> glb;
    glb.reserve(28 + head.size() + binary_.size());
    append_word(glb, 0x46546C67); // "glTF"
    append_word(glb, 2);
    append_word(glb, 28 + head.size() + binary_.size());
    append_word(glb, head.size());
    append_word(glb, 0x4E4F534A); // "JSON"
    append(glb, head);
    append_word(glb, binary_.size());
    append_word(glb, 0x004E4942); // "BIN"
    append(glb, binary_);
    write_file(file, glb);
}

void GltfWriter::write_gltf(std::filesystem::path const& file) {
    std::string const stem = file.stem().string();
    std::filesystem::path const folder = file.parent_path();
    std::vector<std::filesystem::path> written;
    auto const write = [&](std::string const& name, std::span<std::byte const> bytes) {
        write_file(folder / name, bytes);
        written.push_back(folder / name);
    };
    try {
        for (Picture const& picture : pictures_) {
            std::string const name = stem + "_" + picture.name + "." + picture.kind;
            write(name, picture.bytes);
            json["images"].push_back({{"name", picture.name}, {"uri", name}});
        }
        write(stem + ".bin", binary_);
        json["buffers"] = {{{"byteLength", binary_.size()}, {"uri", stem + ".bin"}}};
        write_text_file(file, json.dump(1));
    } catch (...) {
        std::error_code ignored;
        for (std::filesystem::path const& part : written) std::filesystem::remove(part, ignored);
        throw;
    }
}

} // namespace alpenglow
