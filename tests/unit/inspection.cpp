#include "sandbox/inspection.h"
#include "support/gltf_builder.h"

#include <gtest/gtest.h>

using namespace alpenglow;
using namespace alpenglow::test;
using Json = nlohmann::json;

namespace {

struct Loaded {
    Scene scene;
    GltfSummary summary;
};

/// The triangle twice, the second time moved and named by an extension that nobody knows.
Loaded two_triangles() {
    GltfBuilder builder = one_triangle();
    builder.json["nodes"].push_back({{"mesh", 0}, {"translation", {10, 0, 4}}});
    builder.json["scenes"][0]["nodes"].push_back(1);
    builder.json["extensionsUsed"] = {"ACME_glow"};
    TemporaryFolder const folder;
    write_text_file(folder.path() / "a.gltf", builder.gltf());
    Loaded loaded;
    loaded.scene = load_gltf(folder.path() / "a.gltf", {}, &loaded.summary);
    return loaded;
}

} // namespace

TEST(Inspection, says_what_a_scene_holds) {
    Loaded const loaded = two_triangles();
    EXPECT_EQ(inspection_text(loaded.scene, loaded.summary),
              "triangles   2 drawn by 2 instances of 1 meshes (1 stored, 3 vertices)\n"
              "extent      11 x 1 x 4 m (east, up, north), from 0, 0, -4\n"
              "materials   1, 0 textures\n"
              "memory      0.0 MiB geometry, 0.0 MiB textures\n"
              "extensions  ACME_glow\n"
              "warnings    /meshes/0/primitives/0/attributes/POSITION: has no min and max "
              "[MESH_PRIMITIVE_POSITION_ACCESSOR_WITHOUT_BOUNDS]\n"
              "            /extensionsUsed: loaded without ACME_glow, which is not supported [UNSUPPORTED_EXTENSION]\n");
}

TEST(Inspection, as_json_has_the_same) {
    Loaded const loaded = two_triangles();
    Json const json = Json::parse(inspection_json(loaded.scene, loaded.summary));
    EXPECT_EQ(json["triangles"], 2);
    EXPECT_EQ(json["mesh_triangles"], 1);
    EXPECT_EQ(json["geometry_bytes"], 3 * sizeof(Vertex) + 12);
    EXPECT_EQ(json["bounds"]["highest"], Json({11, 1, 4}));
    EXPECT_EQ(json["extensions"], Json({"ACME_glow"}));
    ASSERT_EQ(json["warnings"].size(), 2u);
    EXPECT_EQ(json["warnings"][1]["code"], "UNSUPPORTED_EXTENSION");
    EXPECT_EQ(json["warnings"][1]["pointer"], "/extensionsUsed");
}
