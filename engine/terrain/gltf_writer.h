#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace alpenglow {

/// A glTF 2.0 document in the making: the caller fills `json` (but for buffers and images) and adds bytes and pictures.
class GltfWriter {
public:
    nlohmann::ordered_json json{{"asset", {{"version", "2.0"}, {"generator", "Alpenglow"}}}};

    /// A buffer view of these bytes, aligned to 4; `stride` and `target` where they are not 0. Returns its index.
    int add_view(std::span<std::byte const> bytes, int stride = 0, int target = 0);
    /// An image of `kind` "png" or "jpeg". Returns its index.
    int add_picture(std::string const& name, std::string const& kind, std::vector<std::byte> bytes);

    /// Throws Error(wrong_use) where `file` ends neither with .glb nor with .gltf.
    static void require_known_ending(std::filesystem::path const& file);
    /// One .glb, or a .gltf with its .bin and pictures beside it, the .gltf last. Throws as above, and Error(bad_input)
    /// where a file can't be written.
    void write(std::filesystem::path const& file);

private:
    struct Picture {
        std::string name, kind;
        std::vector<std::byte> bytes;
    };

    void write_glb(std::filesystem::path const& file);
    void write_gltf(std::filesystem::path const& file);

    std::vector<std::byte> binary_;
    std::vector<Picture> pictures_;
};

} // namespace alpenglow
