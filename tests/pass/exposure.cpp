#include "render/passes/exposure.h"

#include "encoding/metering.glsl"
#include "gpu/transfer.h"
#include "render/executor.h"
#include "support/gpu_test.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{203, 117}; // no multiple of a tile

class ExposurePass : public GpuTest {
protected:
    void SetUp() override {
        GpuTest::SetUp();
        settings_.auto_exposure = true;
        state_ = make_float_image(device(), {glm::vec4(1, 0, 0, 0)}, {1, 1});
    }
    /// Exposes for a grey picture whose log2 of luminance is `stops(i)`; -100 is black.
    template <typename Stops> shader::ExposureState expose(Stops const& stops, double seconds = ADAPTED_AT_ONCE) {
        std::vector<glm::vec4> texels;
        for (std::uint32_t i = 0; i < EXTENT.pixels(); ++i) {
            double const s = stops(i);
            texels.push_back(glm::vec4(glm::vec3(s < -99 ? 0.0f : static_cast<float>(std::exp2(s))), 1));
        }
        auto const picture = make_float_image(device(), texels, EXTENT);
        FrameGraph graph;
        ImageId const lit = graph.import(*picture, "lit", ShowScale::radiance, true);
        ImageId const state = graph.import(*state_, "exposure", ShowScale::number, true);
        add_exposure(graph, lit, state, settings_, seconds);
        Executor executor(device());
        executor.submit(graph);
        executor.wait();
        return values_of<shader::ExposureState>(read_back(device(), *state_)).front();
    }
    Settings settings_;
    std::unique_ptr<GpuImage> state_;
};

/// What the picture is metered as, by sorting instead of counting.
double metered_by_sorting(std::vector<double> stops) {
    std::erase_if(stops, [](double s) { return s < -30; });
    std::ranges::sort(stops);
    auto const at = [&](double share) { return static_cast<std::ptrdiff_t>(share * static_cast<double>(stops.size())); };
    auto const from = stops.begin() + at(0.40), to = stops.begin() + at(0.95);
    double const mean = std::accumulate(from, to, 0.0) / static_cast<double>(to - from);
    return std::max(mean, stops[static_cast<std::size_t>(at(0.99))] - 3.5);
}

/// A spread-out picture: a repeatable shuffle of an even ramp.
double ramp(std::uint32_t i, double low, double high) {
    return low + (high - low) * static_cast<double>((i * 7919u) % EXTENT.pixels()) / static_cast<double>(EXTENT.pixels());
}

} // namespace

TEST_F(ExposurePass, meters_what_sorting_the_pixels_finds) {
    std::vector<std::function<double(std::uint32_t)>> const pictures{
        [](std::uint32_t i) { return ramp(i, -9, -1); },
        [](std::uint32_t i) { return ramp(i, -25, 3); },
        [](std::uint32_t i) { return i % 3 ? -100.0 : ramp(i, -8, -6); },           // two thirds of black space
        [](std::uint32_t i) { return i % 50 ? ramp(i, -22, -18) : -3.0; },           // a bright limb over night
        [](std::uint32_t i) { return i % 500 ? ramp(i, -5, -4) : 13.0; },            // the sun's disc in a day's sky
    };
    for (std::size_t p = 0; p < pictures.size(); ++p) {
        std::vector<double> all;
        for (std::uint32_t i = 0; i < EXTENT.pixels(); ++i) all.push_back(pictures[p](i));
        // A step of the histogram is 0.18: half of it for where a pixel lies in its bin, and as much for the highlight.
        EXPECT_NEAR(expose(pictures[p]).metered, metered_by_sorting(all), 0.18) << p;
    }
}

TEST_F(ExposurePass, shows_the_mean_at_a_fifth) {
    shader::ExposureState const state = expose([](std::uint32_t i) { return ramp(i, -4, -3); });
    EXPECT_NEAR(double(state.factor) * std::exp2(double(state.metered)), 0.19, 0.01);
    EXPECT_FLOAT_EQ(state.factor, std::exp2(state.stops));
    EXPECT_EQ(state.stops, state.target);
}

TEST_F(ExposurePass, is_shifted_and_bounded_by_the_settings) {
    auto const grey = [](std::uint32_t i) { return ramp(i, -5, -4); };
    double const found = expose(grey).stops;
    settings_.exposure_compensation = 1.5;
    EXPECT_NEAR(expose(grey).stops, found + 1.5, 1e-5);
    settings_.exposure_most = found;
    EXPECT_NEAR(expose(grey).stops, found, 1e-5);
    settings_.exposure_compensation = -9;
    settings_.exposure_least = 0;
    EXPECT_EQ(expose(grey).stops, 0);
    settings_ = Settings{};
    settings_.exposure = 3;
    EXPECT_EQ(expose(grey).factor, 8); // fixed
}

TEST_F(ExposurePass, dusk_is_shown_darker_than_day_and_black_as_far_as_the_bound) {
    auto const shown = [&](double luminance) {
        shader::ExposureState const state = expose([&](std::uint32_t) { return luminance; });
        return state.stops + luminance;
    };
    EXPECT_NEAR(shown(-5), shown(-2), 0.19);
    EXPECT_LT(shown(-12), shown(-5) - 0.5);
    EXPECT_LT(shown(-17), shown(-12) - 0.5);
    EXPECT_EQ(expose([](std::uint32_t) { return -100.0; }).stops, static_cast<float>(settings_.exposure_most));
}

TEST_F(ExposurePass, follows_in_time_faster_into_light_than_into_the_dark) {
    auto const bright = [](std::uint32_t) { return -1.0; };
    auto const dim = [](std::uint32_t) { return -7.0; };
    double const start = expose(bright).stops, end = expose(dim, 0).target;
    ASSERT_NEAR(end - start, 6, 0.3);
    EXPECT_NEAR(expose(dim, 0).stops, start, 1e-6); // no time, no way
    EXPECT_NEAR(expose(dim, 1).stops, start + settings_.dark_adaptation, 1e-3); // far from the end: full speed
    double before = start;
    for (int i = 0; i < 12; ++i) {
        double const now = expose(dim, 1).stops;
        EXPECT_GE(now, before);
        EXPECT_LE(now, end + 1e-6); // never beyond
        before = now;
    }
    EXPECT_NEAR(before, end, 0.01);
    EXPECT_NEAR(expose(bright, 1).stops, end - settings_.light_adaptation, 1e-2);
}

TEST_F(ExposurePass, small_steps_of_time_lead_where_large_ones_do) {
    auto const bright = [](std::uint32_t) { return -1.0; };
    auto const dim = [](std::uint32_t) { return -4.0; };
    expose(bright);
    for (int i = 0; i < 10; ++i) expose(dim, 0.1);
    double const fine = expose(dim, 0).stops;
    expose(bright);
    for (int i = 0; i < 2; ++i) expose(dim, 0.5);
    EXPECT_NEAR(expose(dim, 0).stops, fine, 0.1); // [stops]
}
