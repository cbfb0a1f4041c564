#include "core/settings.h"
#include "image/codec.h"
#include "scene/gltf_limits.h"
#include "support/gltf_packed.h"
#include "support/gltf_samples.h"

#include <gtest/gtest.h>

#include <set>

using namespace alpenglow;
using namespace alpenglow::test;
using Json = nlohmann::json;

// Every limit is met by a file of our own, and its error names limit, value and setting.

namespace {

struct LimitRow {
    std::string setting;
    int GltfLimits::*limit;
    int value;            ///< just below what the file asks for
    std::string message;  ///< the error's beginning, after the file's name
    std::string text;     ///< the file
};

std::string with_picture(std::uint32_t width, std::uint32_t height, int copies = 1) {
    GltfBuilder builder = one_triangle();
    std::string const uri = "data:image/png;base64," + base64(encode_png(ByteImage({width, height})));
    for (int i = 0; i < copies; ++i) {
        builder.json["images"].push_back({{"uri", uri}});
        builder.json["textures"].push_back({{"source", i}});
        builder.json["materials"].push_back({{"normalTexture", {{"index", i}}}});
    }
    return builder.gltf();
}

std::string with_children() {
    GltfBuilder builder = one_triangle();
    builder.json["nodes"] = {{{"children", {1}}}, {{"children", {2}}}, {{"mesh", 0}}};
    return builder.gltf();
}

std::string with_instances(int count) {
    GltfBuilder builder = one_triangle();
    for (int i = 1; i < count; ++i) {
        builder.json["nodes"].push_back({{"mesh", 0}});
        builder.json["scenes"][0]["nodes"].push_back(i);
    }
    return builder.gltf();
}

std::string with_materials(int count) {
    GltfBuilder builder = one_triangle();
    builder.json["materials"] = Json::array_t(static_cast<std::size_t>(count), Json::object());
    return builder.gltf();
}

/// 1.5 MiB of bytes, 2 MiB as base64.
std::string with_large_buffer() {
    GltfBuilder builder = one_triangle();
    builder.buffer.resize(std::size_t{3} << 19);
    return builder.gltf();
}

std::vector<LimitRow> limit_rows() {
    return {
        {"largest_scene_file", &GltfLimits::largest_scene_file, 1, "comes to 2 MiB", with_large_buffer()},
        {"most_json_values", &GltfLimits::most_json_values, 10, "JSON holds ", one_triangle().gltf()},
        {"most_entries", &GltfLimits::most_entries, 2, "/nodes: holds 3 entries", with_children()},
        {"most_materials", &GltfLimits::most_materials, 4, "/materials: holds 5 materials", with_materials(5)},
        {"deepest_json", &GltfLimits::deepest_json, 4, "JSON is nested deeply", one_triangle().gltf()},
        {"deepest_node", &GltfLimits::deepest_node, 2, "/nodes/2: stands 3 nodes deep", with_children()},
        {"most_instances", &GltfLimits::most_instances, 1, "/nodes: places 2 meshes", with_instances(2)},
        {"most_vertices", &GltfLimits::most_vertices, 2, "/meshes/0: makes 3 vertices in all", one_triangle().gltf()},
        {"most_indices", &GltfLimits::most_indices, 2, "/meshes/0: makes 3 indices in all", one_triangle().gltf()},
        {"most_triangles", &GltfLimits::most_triangles, 2, "/nodes: show 3 triangles in all", with_instances(3)},
        {"largest_picture", &GltfLimits::largest_picture, 15, "/images/0: is a picture of 16 x 2 texels", with_picture(16, 2)},
        {"most_pixels", &GltfLimits::most_pixels, 1, "/images/0: is a picture of 1025 x 1024, 1.0 Mi texels", with_picture(1025, 1024)},
        {"most_picture_memory", &GltfLimits::most_picture_memory, 4, "/images: take 6 MiB or more once decoded", with_picture(1024, 768, 2)},
    };
}

} // namespace

TEST(GltfLimits, each_is_named_with_its_value_and_its_setting) {
    for (LimitRow const& row : limit_rows()) {
        EXPECT_EQ(error_of(row.text), "") << row.setting;
        GltfOptions options;
        options.limits.*row.limit = row.value;
        try {
            load_text(row.text, options);
            ADD_FAILURE() << row.setting << " limits nothing";
        } catch (GltfError const& error) {
            EXPECT_EQ(error.diagnostic().code, "LIMIT_EXCEEDED");
            std::string const line = error.what();
            EXPECT_NE(line.find("scene.gltf: " + row.message), std::string::npos) << line;
            std::string const end = ", more than the limit of " + std::to_string(row.value) +
                                    " [LIMIT_EXCEEDED] (where the file is to be trusted, raise it with --set " + row.setting + "=NUMBER)";
            EXPECT_TRUE(line.ends_with(end)) << line;
        }
    }
}

TEST(GltfLimits, are_all_settings_of_their_names) {
    std::vector<LimitRow> const rows = limit_rows();
    EXPECT_EQ(rows.size() * sizeof(int), sizeof(GltfLimits)) << "a limit has no row";
    Settings settings;
    for (LimitRow const& row : rows) {
        EXPECT_EQ(GltfLimits{}.*row.limit, gltf_limits(Settings{}).*row.limit) << row.setting << ": another default";
        set_setting(settings, row.setting, "1000");
        EXPECT_EQ(gltf_limits(settings).*row.limit, 1000) << row.setting;
    }
}
