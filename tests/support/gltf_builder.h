#pragma once

#include "core/error.h"
#include "core/files.h"
#include "scene/gltf.h"
#include "scene/gltf_report.h"
#include "support/files.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace alpenglow::test {

/// A small glTF in the making: one buffer, a view and an accessor for each array that is added.
struct GltfBuilder {
    nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
    std::vector<std::byte> buffer;

    template <class T> int add_view(std::vector<T> const& values, int stride = 0) {
        return add_bytes(std::as_bytes(std::span(values)), stride);
    }
    /// Returns the accessor's index. `type` is "SCALAR", "VEC3", …
    template <class T> int add(std::string const& type, std::vector<T> const& values, bool normalized = false) {
        return add_accessor(add_view(values), component_type<T>(), values.size() / components(type), type, normalized);
    }
    int add_accessor(int view, int component, std::size_t count, std::string const& type, bool normalized = false);
    /// A mesh of one primitive, and a node of the scene that shows it.
    void show(nlohmann::json const& attributes, nlohmann::json const& rest = nlohmann::json::object());

    /// The buffer as a data URI.
    std::string gltf() const;
    std::string glb() const;
    Scene load(GltfOptions const& options = {}) const;

    template <class T> static int component_type() {
        if constexpr (std::is_same_v<T, float>) return 5126;
        else return 5120 + (std::is_unsigned_v<T> ? 1 : 0) + (sizeof(T) == 2 ? 2 : sizeof(T) == 4 ? 4 : 0);
    }
    static std::size_t components(std::string const& type);

private:
    int add_bytes(std::span<std::byte const> bytes, int stride);
};

/// One triangle: (0,0,0), (1,0,0), (0,1,0), no normals.
GltfBuilder one_triangle();

/// Loads text as a .gltf of its own folder.
Scene load_text(std::string const& text, GltfOptions const& options = {}, GltfSummary* summary = nullptr);
/// The message of the error that loading gives, without the file's name, the code and the usual advice; "" where it
/// loads.
std::string error_of(std::string const& text);
/// What loading says, "refused CODE" at the end of it, each once: "EMPTY_ENTITY, refused TYPE_MISMATCH".
std::string codes_of(std::string const& text, GltfOptions const& options = {});
std::string without_usual_advice(std::string line);

std::string base64(std::span<std::byte const> bytes);

inline std::size_t GltfBuilder::components(std::string const& type) {
    if (type == "SCALAR") return 1;
    auto const rows = static_cast<std::size_t>(type.back() - '0');
    return type.starts_with("MAT") ? rows * rows : rows;
}

inline int GltfBuilder::add_bytes(std::span<std::byte const> bytes, int stride) {
    buffer.resize((buffer.size() + 3) / 4 * 4);
    nlohmann::json view = {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}};
    if (stride != 0) view["byteStride"] = stride;
    buffer.insert(buffer.end(), bytes.begin(), bytes.end());
    json["bufferViews"].push_back(view);
    return static_cast<int>(json["bufferViews"].size()) - 1;
}

inline int GltfBuilder::add_accessor(int view, int component, std::size_t count, std::string const& type, bool normalized) {
    nlohmann::json accessor = {{"componentType", component}, {"count", count}, {"type", type}};
    if (view >= 0) accessor["bufferView"] = view;
    if (normalized) accessor["normalized"] = true;
    json["accessors"].push_back(accessor);
    return static_cast<int>(json["accessors"].size()) - 1;
}

inline void GltfBuilder::show(nlohmann::json const& attributes, nlohmann::json const& rest) {
    nlohmann::json primitive = {{"attributes", attributes}};
    primitive.update(rest);
    json["meshes"].push_back({{"primitives", {primitive}}});
    json["nodes"].push_back({{"mesh", json["meshes"].size() - 1}});
    if (!json.contains("scenes")) json["scenes"] = nlohmann::json::array({nlohmann::json::object()});
    json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
}

inline std::string GltfBuilder::gltf() const {
    nlohmann::json copy = json;
    if (!buffer.empty() && !copy.contains("buffers")) {
        copy["buffers"] = {{{"byteLength", buffer.size()}, {"uri", "data:application/octet-stream;base64," + base64(buffer)}}};
    }
    return copy.dump();
}

inline std::string GltfBuilder::glb() const {
    nlohmann::json copy = json;
    if (!copy.contains("buffers")) copy["buffers"] = {{{"byteLength", buffer.size()}}};
    std::string text = copy.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string chunk(reinterpret_cast<char const*>(buffer.data()), buffer.size());
    chunk.resize((chunk.size() + 3) / 4 * 4, '\0');
    auto const word = [](std::uint32_t value) { return std::string(reinterpret_cast<char const*>(&value), 4); };
    auto const size = [](std::string const& bytes) { return static_cast<std::uint32_t>(bytes.size()); };
    return "glTF" + word(2) + word(12 + 8 + size(text) + 8 + size(chunk)) + word(size(text)) + "JSON" + text +
           word(size(chunk)) + std::string("BIN\0", 4) + chunk;
}

inline Scene GltfBuilder::load(GltfOptions const& options) const { return load_text(gltf(), options); }

inline GltfBuilder one_triangle() {
    GltfBuilder builder;
    builder.show({{"POSITION", builder.add<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})}});
    return builder;
}

inline Scene load_text(std::string const& text, GltfOptions const& options, GltfSummary* summary) {
    TemporaryFolder const folder;
    write_text_file(folder.path() / "scene.gltf", text);
    return load_gltf(folder.path() / "scene.gltf", options, summary);
}

inline std::string without_usual_advice(std::string line) {
    std::string const advice = std::string(" (") + gltf::EXPORT_AGAIN + ")";
    if (line.ends_with(advice)) line.resize(line.size() - advice.size());
    for (gltf::CodeInfo const& info : gltf::CODES) {
        std::string const code = " [" + std::string(info.name) + "]";
        if (std::size_t const at = line.find(code); at != std::string::npos) line.erase(at, code.size());
    }
    return line;
}

inline std::string error_of(std::string const& text) {
    try {
        load_text(text);
    } catch (Error const& error) {
        std::string const line = without_usual_advice(error.what());
        std::string const end_of_name = "scene.gltf: ";
        return line.substr(line.find(end_of_name) + end_of_name.size());
    }
    return "";
}

inline std::string codes_of(std::string const& text, GltfOptions const& options) {
    GltfSummary summary;
    std::string refusal;
    try {
        load_text(text, options, &summary);
    } catch (GltfError const& error) {
        refusal = "refused " + error.diagnostic().code;
    }
    std::set<std::string> codes;
    for (GltfDiagnostic const& diagnostic : summary.warnings) codes.insert(diagnostic.code);
    std::string line;
    for (std::string const& code : codes) line += (line.empty() ? "" : ", ") + code;
    return refusal.empty() ? line : line + (line.empty() ? "" : ", ") + refusal;
}

inline std::string base64(std::span<std::byte const> bytes) {
    char const* const alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? static_cast<std::uint32_t>(bytes[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? alphabet[bits >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

} // namespace alpenglow::test
