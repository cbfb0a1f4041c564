#include "scene/gltf.h"
#include "support/gltf_builder.h"
#include "support/mutator.h"

#include "scene/view.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <functional>
#include <sys/resource.h>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

/// A few thousand in `./test --long`.
int mutation_count() { return std::getenv("ALPENGLOW_LONG_TESTS") ? 10'000 : 1'000; }

/// [MiB] the process has had at most.
long peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

#if defined(__SANITIZE_ADDRESS__)
constexpr double slower = 20; // shadow memory and checks
constexpr long more_memory = 4096;
#else
constexpr double slower = 1;
constexpr long more_memory = 0;
#endif

/// Every damaged file is read or refused by an Error of bad input, in 2 s and 512 MiB.
void expect_survived(std::string const& name, std::string const& text,
                     std::function<void(std::filesystem::path const&)> const& read) {
    static TemporaryFolder const folder;
    std::filesystem::path const file = folder.write(name, text);
    long const memory_before = peak_memory();
    auto const start = std::chrono::steady_clock::now();
    try {
        read(file);
    } catch (Error const& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input) << error.what();
        EXPECT_LT(std::string(error.what()).size(), 1200u) << error.what();
    } catch (std::exception const& other) {
        ADD_FAILURE() << "not an Error: " << other.what();
    }
    std::chrono::duration<double> const took = std::chrono::steady_clock::now() - start;
    EXPECT_LT(took.count(), 2 * slower);
    EXPECT_LT(peak_memory() - memory_before, 512 + more_memory);
}

void load(std::filesystem::path const& file) { load_gltf(file); }

/// Everything that the importer reads, small: indices, attributes of every kind, sparse and interleaved accessors, a
/// picture, a hierarchy, a skin, a morph target, a camera, an animation.
GltfBuilder rich_scene() {
    GltfBuilder b;
    int const position = b.add<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
    int const normal = b.add<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    int const uv = b.add<std::uint16_t>("VEC2", {0, 0, 65535, 0, 0, 65535, 65535, 65535}, true);
    int const color = b.add<std::uint8_t>("VEC4", std::vector<std::uint8_t>(16, 200), true);
    int const joints = b.add<std::uint8_t>("VEC4", std::vector<std::uint8_t>(16, 0));
    int const weights = b.add<float>("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    int const indices = b.add<std::uint16_t>("SCALAR", {0, 1, 2, 2, 1, 3});
    int const moved = b.add<float>("VEC3", std::vector<float>(12, 0.5f));
    int const places = b.add_view(std::vector<std::uint16_t>{1, 3}), values = b.add_view(std::vector<float>(6, 0.25f));
    b.json["accessors"][moved]["sparse"] = {
        {"count", 2}, {"indices", {{"bufferView", places}, {"componentType", 5123}}}, {"values", {{"bufferView", values}}}};
    b.show({{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}, {"COLOR_0", color}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}},
           {{"indices", indices}, {"material", 0}, {"targets", {{{"POSITION", moved}}}}});
    b.show({{"POSITION", position}}, {{"mode", 5}});
    b.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}, {"normalTexture", {{"index", 0}}}}};
    b.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    b.json["samplers"] = {{{"magFilter", 9728}}};
    b.json["images"] = {{{"uri", "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVQYV2P4z/AfAAQAAf+VHQdlAAAAAElFTkSuQmCC"}}};
    b.json["nodes"][0].update({{"skin", 0}, {"children", {1}}, {"rotation", {0, 0, 0, 1}}, {"translation", {1, 2, 3}}});
    b.json["nodes"].push_back({{"camera", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}});
    b.json["scenes"][0]["nodes"] = {0, 2};
    b.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    std::vector<float> identity(16);
    for (std::size_t i = 0; i < 4; ++i) identity[5 * i] = 1;
    b.json["skins"] = {{{"joints", {2}}, {"inverseBindMatrices", b.add<float>("MAT4", identity)}}};
    int const times = b.add<float>("SCALAR", {0, 1});
    int const rotations = b.add<float>("VEC4", {0, 0, 0, 1, 0, 0, 0, 1});
    b.json["animations"] = {{{"samplers", {{{"input", times}, {"output", rotations}}}},
                             {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}}}}}};
    return b;
}

void try_mutations(std::string const& name, std::function<std::string(Mutator&)> const& mutate,
                   std::function<void(std::filesystem::path const&)> const& read, int count) {
    for (int i = 0; i < count; ++i) {
        Mutator mutator(static_cast<std::uint32_t>(i));
        std::string const text = mutate(mutator);
        SCOPED_TRACE("mutation " + std::to_string(i) + " of " + name);
        expect_survived(name, text, read);
        if (testing::Test::HasFailure()) return;
    }
}

std::vector<std::filesystem::path> files_in(char const* folder) {
    std::vector<std::filesystem::path> files;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(assets() / folder)) {
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
}

/// Damages our own kind of file as bytes and as JSON.
void try_own_files(char const* folder, std::function<void(std::filesystem::path const&)> const& read) {
    std::vector<std::filesystem::path> const files = files_in(folder);
    ASSERT_FALSE(files.empty());
    auto const mutate = [&](Mutator& mutator) {
        std::string const good = read_text_file(files[mutator.below(files.size())]);
        return mutator.below(2) == 0 ? mutator.bytes(good) : mutator.json(good);
    };
    try_mutations("file.json", mutate, read, mutation_count() / 2);
}

} // namespace

class Mutations : public testing::Test {
protected:
    // Thousands of damaged files say thousands of warnings.
    void SetUp() override { testing::internal::CaptureStderr(); }
    void TearDown() override { testing::internal::GetCapturedStderr(); }
};

TEST_F(Mutations, of_nothing_load) {
    std::string const gltf = rich_scene().gltf(), glb = rich_scene().glb();
    EXPECT_EQ(error_of(gltf), "");
    EXPECT_EQ(error_of(glb), "");
}

TEST_F(Mutations, of_gltf_values_give_a_scene_or_an_error) {
    std::string const good = rich_scene().gltf();
    try_mutations("scene.gltf", [&](Mutator& m) { return m.json(good); }, load, mutation_count() / 2);
}

TEST_F(Mutations, of_glb_chunks_give_a_scene_or_an_error) {
    std::string const good = rich_scene().glb();
    try_mutations("scene.glb", [&](Mutator& m) { return m.glb(good); }, load, mutation_count() / 4);
}

TEST_F(Mutations, of_bytes_give_a_scene_or_an_error) {
    std::string const gltf = rich_scene().gltf(), glb = rich_scene().glb();
    try_mutations("scene.any", [&](Mutator& m) { return m.bytes(m.below(2) == 0 ? gltf : glb); }, load, mutation_count() / 4);
}

TEST_F(Mutations, of_views_give_a_view_or_an_error) {
    try_own_files("views", [](std::filesystem::path const& file) { load_view(file); });
}

TEST_F(Mutations, of_flights_give_a_flight_or_an_error) {
    try_own_files("flights", [](std::filesystem::path const& file) { load_flight(file); });
}

TEST_F(Mutations, of_planets_give_a_planet_or_an_error) {
    try_own_files("planets", [](std::filesystem::path const& file) { load_planet(file); });
}

TEST(Mutator, makes_the_same_damage_from_the_same_seed) {
    std::string const good = rich_scene().gltf();
    EXPECT_EQ(Mutator(7).json(good), Mutator(7).json(good));
    EXPECT_NE(Mutator(7).json(good), Mutator(8).json(good));
    EXPECT_NE(Mutator(7).bytes(good), good);
}
