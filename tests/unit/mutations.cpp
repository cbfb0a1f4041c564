#include "scene/gltf.h"
#include "scene/view.h"
#include "support/cost.h"
#include "support/files.h"
#include "support/gltf_samples.h"
#include "support/mutator.h"
#include "support/sound_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <thread>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

int mutation_count() { return std::getenv("ALPENGLOW_LONG_TESTS") ? 10'000 : 1'000; }

using Read = std::function<void(std::filesystem::path const&)>;

/// A damaged file is read or refused by an Error of bad input, in bounded time and memory. Returns whether it was read.
bool survives(std::filesystem::path const& file, Read const& read, std::string const& what) {
    bool was_read = false;
    Cost const cost = cost_of([&] {
        try {
            read(file);
            was_read = true;
        } catch (Error const& error) {
            EXPECT_EQ(error.kind(), ErrorKind::bad_input) << error.what();
            EXPECT_LT(std::string(error.what()).size(), 1200u) << error.what();
        } catch (std::exception const& other) {
            ADD_FAILURE() << "not an Error: " << other.what();
        }
    });
    expect_cheap(cost, what);
    return was_read;
}

void load(std::filesystem::path const& file) { EXPECT_EQ(fault_of(load_gltf(file)), ""); }

/// Some of the damage must go unnoticed and some must be refused: else the files or the mutator are no good.
void try_mutations(std::string const& name, std::function<std::string(Mutator&)> const& mutate, Read const& read,
                   int count) {
    TemporaryFolder const folder;
    int read_count = 0;
    for (int i = 0; i < count; ++i) {
        Mutator mutator(static_cast<std::uint32_t>(i));
        std::filesystem::path const file = folder.write(name, mutate(mutator));
        std::string const what = "mutation " + std::to_string(i) + " of " + name;
        SCOPED_TRACE(what);
        read_count += survives(file, read, what);
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(read_count, count / 100);
    EXPECT_LT(read_count, count - count / 100);
}

std::vector<std::filesystem::path> files_in(char const* folder) {
    std::vector<std::filesystem::path> files;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(assets() / folder)) {
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
}

/// What the renderer needs of a view holds for one that was read; its camera may be refused.
void expect_drawable(View const& view) {
    static Planet const earth = load_planet(assets() / "planets/earth.json");
    World const world = make_world(view, earth);
    EXPECT_TRUE(std::isfinite(glm::length(world.camera.position)));
    EXPECT_NEAR(glm::length(world.to_sun), 1, 1e-9);
}

/// Damages our own kind of file as bytes and as JSON.
void try_own_files(char const* folder, Read const& read) {
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
    try_own_files("views", [](std::filesystem::path const& file) { expect_drawable(load_view(file)); });
}

TEST_F(Mutations, of_flights_give_a_flight_or_an_error) {
    try_own_files("flights", [](std::filesystem::path const& file) {
        Flight const flight = load_flight(file);
        for (double const share : {0.0, 0.3, 0.7, 1.0}) expect_drawable(flight.at(share * flight.duration()));
    });
}

TEST_F(Mutations, of_planets_give_a_planet_or_an_error) {
    try_own_files("planets", [](std::filesystem::path const& file) {
        Planet const planet = load_planet(file);
        EXPECT_TRUE(std::isfinite(planet.radius) && planet.radius > 0);
    });
}

TEST(Cost, tells_processor_time_and_memory_of_each_action) {
    Cost const idle = cost_of([] { std::this_thread::sleep_for(std::chrono::milliseconds(50)); });
    EXPECT_LT(idle.seconds, 0.04);
    EXPECT_GE(idle.wall, 0.05);
    EXPECT_LT(idle.mebibytes, 32);
    auto const take = [](std::size_t mebibytes) {
        std::vector<char> const bytes(mebibytes << 20, 'x');
        ASSERT_EQ(bytes[bytes.size() / 2], 'x');
    };
    Cost const large = cost_of([&] { take(600); });
    EXPECT_GT(large.mebibytes, 560);
    EXPECT_LT(cost_of([&] { take(64); }).mebibytes, 300) << "the largest size begins anew";
    Cost const busy = cost_of([] {
        for (std::clock_t const end = std::clock() + CLOCKS_PER_SEC / 20; std::clock() < end;) continue;
    });
    EXPECT_GE(busy.seconds, 0.04);
}

TEST(Mutator, makes_the_same_damage_from_the_same_seed) {
    std::string const good = rich_scene().gltf();
    EXPECT_EQ(Mutator(7).json(good), Mutator(7).json(good));
    EXPECT_NE(Mutator(7).json(good), Mutator(8).json(good));
    EXPECT_NE(Mutator(7).bytes(good), good);
}
