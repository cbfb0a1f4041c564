#include "render/rehearsal.h"

#include "render/executor.h"
#include "support/gpu_test.h"
#include "support/temporary_folder.h"

#include <cstdlib>
#include <test_shaders.h>

using namespace alpenglow;

namespace {

/// Mesa's cache is a folder of this test.
class Rehearsing : public test::GpuTest {
protected:
    void SetUp() override {
        GpuTest::SetUp();
        if (!device().is_software()) GTEST_SKIP() << "this device compiles nothing late";
        setenv("MESA_SHADER_CACHE_DIR", folder_.path().c_str(), 1);
        unsetenv("MESA_SHADER_CACHE_DISABLE");
    }
    void TearDown() override {
        unsetenv("MESA_SHADER_CACHE_DIR");
        GpuTest::TearDown();
    }
    /// Calls `use` with a device and a graph of one pass on images of that size, and gives how many files the cache has
    /// when the device is gone.
    std::size_t files_after(Extent extent, std::function<void(Device const&, FrameGraph const&)> const& use) const {
        {
            Device const own;
            auto const from = test::make_float_image(own, std::vector<glm::vec4>(extent.pixels()), extent);
            auto const to = test::make_float_image(own, std::vector<glm::vec4>(extent.pixels()), extent);
            FrameGraph graph;
            ImageId const read = graph.import(*from, "input", ShowScale::unit, true);
            ImageId const written = graph.import(*to, "output", ShowScale::unit, false);
            graph.add(ComputePass{"test", shaders::encoding_round_trip_comp,
                                  {sampled(0, read, NEAREST_CLAMP), stored(1, written)}, extent});
            use(own, graph);
        }
        std::size_t files = 0;
        for (auto const& entry : std::filesystem::recursive_directory_iterator(folder_.path()))
            files += entry.is_regular_file() && entry.path().filename() != "index";
        return files;
    }
    static void run(Device const& device, FrameGraph const& graph) {
        Executor executor(device);
        executor.submit(graph);
        executor.wait();
    }

    test::TemporaryFolder const folder_;
};

} // namespace

TEST_F(Rehearsing, leaves_nothing_to_compile_for_images_of_the_same_kinds) {
    std::size_t const rehearsed = files_after({100, 60}, [](Device const& device, FrameGraph const& graph) {
        Rehearsal rehearsal(device);
        rehearsal.add(graph);
        while (!rehearsal.idle()) std::this_thread::yield();
    });
    EXPECT_GT(rehearsed, 0u);
    EXPECT_EQ(files_after({70, 40}, run), rehearsed);
    EXPECT_GT(files_after({64, 40}, run), rehearsed) << "a side that is a power of two is of another kind";
}

TEST_F(Rehearsing, leaves_out_what_has_run) {
    std::size_t const files = files_after({100, 60}, [](Device const& device, FrameGraph const& graph) {
        Rehearsal rehearsal(device);
        rehearsal.skip(graph);
        rehearsal.add(graph);
        while (!rehearsal.idle()) std::this_thread::yield();
    });
    EXPECT_EQ(files, 0u);
}
