#include "support/gltf_builder.h"
#include "support/refusal.h"

#include "image/codec.h"

using namespace alpenglow;
using Json = nlohmann::json;

namespace {

/// One triangle with one picture.
std::string textured_triangle() {
    test::GltfBuilder builder;
    int const position = builder.add<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
    builder.json["accessors"][position].update({{"min", {0, 0, 0}}, {"max", {1, 1, 0}}});
    builder.show({{"POSITION", position}, {"TEXCOORD_0", builder.add<float>("VEC2", {0, 0, 1, 0, 0, 1})}}, {{"material", 0}});
    builder.json["images"] = {{{"uri", "picture.png"}}};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    return builder.gltf();
}

test::ProcessResult bench_load(test::TemporaryFolder const& folder, std::vector<std::string> const& more) {
    folder.write("scene.gltf", textured_triangle());
    write_png(folder.path() / "picture.png", ByteImage({16, 16}));
    std::vector<std::string> arguments{"bench", "--load", "scene.gltf", "--frames", "2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run({.program = ALPENGLOW_PROGRAM, .arguments = arguments, .folder = folder.path()});
}

} // namespace

TEST(BenchLoad, prints_times_of_three_steps_and_their_ratios_to_the_first) {
    test::ProcessResult const result = bench_load(test::TemporaryFolder(), {"--json"});
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    Json const json = Json::parse(result.output);
    EXPECT_EQ(json["scene"], "scene.gltf");
    EXPECT_EQ(json["triangles"], 1);
    EXPECT_EQ(json["pictures"], 1);
    EXPECT_EQ(json["rounds"], 2);
    double const first = json["read_and_decode"]["wall_ms"], first_cpu = json["read_and_decode"]["cpu_ms"];
    for (char const* const step : {"read_and_decode", "load", "load_and_upload"}) {
        EXPECT_GT(json[step]["wall_ms"], 0) << step;
        // Both sides come from the same two doubles, and JSON keeps every digit.
        EXPECT_DOUBLE_EQ(json[step]["wall_ratio"], json[step]["wall_ms"].get<double>() / first) << step;
        EXPECT_DOUBLE_EQ(json[step]["cpu_ratio"], json[step]["cpu_ms"].get<double>() / first_cpu) << step;
    }
}

TEST(BenchLoad, prints_a_table_with_a_line_for_each_step) {
    test::ProcessResult const result = bench_load(test::TemporaryFolder(), {});
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    std::vector<std::string> const lines = test::lines_of(result.output);
    ASSERT_EQ(lines.size(), 4u) << result.output;
    EXPECT_NE(lines[0].find("scene.gltf: 1 triangles, 1 pictures"), std::string::npos) << lines[0];
    EXPECT_NE(lines[1].find("reading and decoding alone"), std::string::npos) << lines[1];
    EXPECT_NE(lines[1].find("1.00 and 1.00 times"), std::string::npos) << lines[1];
    EXPECT_NE(lines[2].find("loading "), std::string::npos) << lines[2];
    EXPECT_NE(lines[3].find("loading and upload"), std::string::npos) << lines[3];
}
