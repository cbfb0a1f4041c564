#include "gpu/pipeline_cache.h"

#include "core/error.h"
#include "support/gpu_test.h"

#include <latch>

using namespace alpenglow;

namespace {

PipelineRecipe recipe(char const* shader) { return {ComputeState{{shader, {}}, {}}, {}}; }

/// Pipelines that are nothing but noted; the first is made when `go` is called.
class PipelineCaching : public test::GpuTest {
protected:
    std::unique_ptr<Pipeline> make(PipelineRecipe const& recipe) {
        std::string const name = std::get<ComputeState>(recipe.state).shader.name;
        if (name == "slow") begun_.count_down(), go_.wait();
        if (name == "bad") throw Error(ErrorKind::device, "no memory for " + name);
        std::lock_guard const lock(mutex_);
        made_.push_back(name);
        return std::make_unique<Pipeline>(device(), VK_NULL_HANDLE, VK_NULL_HANDLE, VK_NULL_HANDLE);
    }
    PipelineCache::Make maker() {
        return [this](PipelineRecipe const& recipe) { return make(recipe); };
    }
    std::vector<std::string> made() {
        std::lock_guard const lock(mutex_);
        return made_;
    }
    /// Until the cache's thread has made it.
    static void wait_for(PipelineCache& cache, char const* shader) {
        while (!cache.prepare(recipe(shader), Need::likely)) std::this_thread::yield();
    }

    std::latch begun_{1}, go_{1};
    std::mutex mutex_;
    std::vector<std::string> made_;
};

} // namespace

TEST_F(PipelineCaching, makes_a_pipeline_once_and_counts_who_had_to_wait) {
    PipelineCache cache(maker());
    Pipeline const& first = cache.get(recipe("plain"));
    EXPECT_EQ(&cache.get(recipe("plain")), &first);
    EXPECT_EQ(cache.misses(), 1u);
    EXPECT_FALSE(cache.prepare(recipe("ahead"), Need::likely));
    wait_for(cache, "ahead");
    cache.get(recipe("ahead"));
    EXPECT_EQ(cache.misses(), 1u);
    EXPECT_EQ(made(), (std::vector<std::string>{"plain", "ahead"}));
}

TEST_F(PipelineCaching, makes_what_is_wanted_beside_what_is_likely_and_once) {
    PipelineCache cache(maker());
    cache.prepare(recipe("slow"), Need::likely);
    begun_.wait();
    for (char const* const shader : {"a", "b", "c"}) cache.prepare(recipe(shader), Need::likely);
    EXPECT_FALSE(cache.prepare(recipe("b"), Need::wanted));
    EXPECT_FALSE(cache.prepare(recipe("new"), Need::wanted));
    wait_for(cache, "new");
    EXPECT_FALSE(cache.idle());
    go_.count_down();
    wait_for(cache, "c");
    EXPECT_EQ(made(), (std::vector<std::string>{"b", "new", "slow", "a", "c"}));
}

TEST_F(PipelineCaching, waits_for_a_pipeline_that_is_being_made) {
    PipelineCache cache(maker());
    cache.prepare(recipe("slow"), Need::likely);
    begun_.wait();
    std::jthread const release([&] { go_.count_down(); });
    cache.get(recipe("slow"));
    EXPECT_EQ(cache.misses(), 1u);
    EXPECT_EQ(made().size(), 1u);
}

TEST_F(PipelineCaching, a_failure_ahead_is_thrown_by_the_next_call_and_only_there) {
    PipelineCache cache(maker());
    cache.prepare(recipe("bad"), Need::wanted);
    EXPECT_THROW(wait_for(cache, "bad"), Error);
    cache.get(recipe("plain"));
    EXPECT_THROW(cache.get(recipe("bad")), Error);
    EXPECT_THROW(cache.get(recipe("bad")), Error);
}

TEST_F(PipelineCaching, stops_and_goes_behind_the_pipeline_that_is_being_made) {
    {
        PipelineCache cache(maker());
        cache.prepare(recipe("slow"), Need::likely);
        begun_.wait();
        for (char const* const shader : {"a", "b", "c"}) cache.prepare(recipe(shader), Need::likely);
        std::jthread const release([&] { go_.count_down(); });
        cache.stop_preparing();
        EXPECT_EQ(made(), std::vector<std::string>{"slow"});
        cache.prepare(recipe("d"), Need::likely);
    }
    EXPECT_LE(made().size(), 2u);
}
