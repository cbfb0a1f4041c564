#include "sandbox/bench_scene.h"

#include "core/error.h"
#include "core/parallel.h"
#include "image/codec.h"
#include "terrain/gltf_writer.h"

#include <cstdlib>
#include <fmt/format.h>
#include <span>
#include <string>
#include <vector>

namespace alpenglow {

namespace {

using Json = nlohmann::ordered_json;

constexpr int STRIPS = 4, COLUMNS = 500, ROWS = 125; // cells of two triangles; rows of one strip
constexpr float CELL = 10, HEIGHT = 30;              // [m]
constexpr int UNSIGNED_INT = 5125, FLOAT = 5126;     // as glTF numbers them

/// Gradients under four bits of noise: it packs about as badly as a photograph.
ByteImage picture(int number) {
    ByteImage image({2048, 2048});
    auto noise = static_cast<std::uint32_t>(number);
    for (std::uint32_t y = 0; y < image.extent.height; ++y) {
        for (std::uint32_t x = 0; x < image.extent.width; ++x) {
            noise = noise * 1664525u + 1013904223u;
            std::uint32_t const base[3] = {x >> 4, y >> 4, 96 + 8 * static_cast<std::uint32_t>(number)};
            for (int c = 0; c < 3; ++c)
                image.at(x, y)[c] = static_cast<std::uint8_t>(64 + base[c] + (noise >> (20 + 4 * c)) % 16);
            image.at(x, y)[3] = 255;
        }
    }
    return image;
}

int add_accessor(GltfWriter& gltf, auto const& values, int component, char const* type, std::size_t width) {
    int const view = gltf.add_view(std::as_bytes(std::span(values)));
    Json& accessors = gltf.json["accessors"];
    accessors.push_back(
        {{"bufferView", view}, {"componentType", component}, {"count", values.size() / width}, {"type", type}});
    return static_cast<int>(accessors.size()) - 1;
}

/// A strip of ridges, with vertices of its own.
Json add_strip(GltfWriter& gltf, int strip) {
    std::vector<float> places, normals, uvs;
    std::vector<std::uint32_t> indices;
    for (int row = 0; row <= ROWS; ++row) {
        for (int column = 0; column <= COLUMNS; ++column) {
            places.insert(places.end(), {CELL * static_cast<float>(column), HEIGHT * static_cast<float>(column % 2),
                                         CELL * static_cast<float>(strip * ROWS + row)});
            normals.insert(normals.end(), {0, 1, 0});
            uvs.insert(uvs.end(), {static_cast<float>(column) / COLUMNS, static_cast<float>(row) / ROWS});
            if (row == ROWS || column == COLUMNS) continue;
            auto const at = static_cast<std::uint32_t>(row * (COLUMNS + 1) + column), below = at + COLUMNS + 1;
            indices.insert(indices.end(), {at, below, at + 1, at + 1, below, below + 1});
        }
    }
    int const position = add_accessor(gltf, places, FLOAT, "VEC3", 3);
    Json& accessor = gltf.json["accessors"].back();
    accessor["min"] = {0, 0, CELL * static_cast<float>(strip * ROWS)};
    accessor["max"] = {CELL * COLUMNS, HEIGHT, CELL * static_cast<float>((strip + 1) * ROWS)};
    return {{"attributes",
             {{"POSITION", position},
              {"NORMAL", add_accessor(gltf, normals, FLOAT, "VEC3", 3)},
              {"TEXCOORD_0", add_accessor(gltf, uvs, FLOAT, "VEC2", 2)}}},
            {"indices", add_accessor(gltf, indices, UNSIGNED_INT, "SCALAR", 1)},
            {"material", strip}};
}

GltfWriter make_scene() {
    GltfWriter gltf;
    std::vector<std::vector<std::byte>> files(2 * STRIPS);
    parallel_for(2 * STRIPS, 0, [&](int i) { files[static_cast<std::size_t>(i)] = encode_png(picture(i)); });
    for (int i = 0; i < 2 * STRIPS; ++i) {
        int const source = gltf.add_picture(fmt::format("{}", i), "png", std::move(files[static_cast<std::size_t>(i)]));
        gltf.json["textures"].push_back({{"source", source}});
    }
    Json primitives = Json::array();
    for (int strip = 0; strip < STRIPS; ++strip) {
        primitives.push_back(add_strip(gltf, strip));
        gltf.json["materials"].push_back({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 2 * strip}}}}},
                                          {"normalTexture", {{"index", 2 * strip + 1}}}});
    }
    gltf.json["meshes"] = {{{"primitives", std::move(primitives)}}};
    gltf.json["nodes"] = {{{"mesh", 0}}};
    gltf.json["scenes"] = {{{"nodes", {0}}}};
    gltf.json["scene"] = 0;
    return gltf;
}

std::filesystem::path make_folder() {
    std::string name = (std::filesystem::temp_directory_path() / "alpenglow_XXXXXX").string();
    if (!::mkdtemp(name.data())) {
        throw Error(ErrorKind::bad_input, "no temporary folder can be made", name, "set TMPDIR to a folder with space");
    }
    return name;
}

} // namespace

// The folder is this object's before anything is written, and goes away where that fails.
BenchScene::BenchScene() : BenchScene(make_folder()) { make_scene().write(file()); }

BenchScene::~BenchScene() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

} // namespace alpenglow
