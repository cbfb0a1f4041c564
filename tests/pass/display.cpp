#include "render/passes/display.h"

#include "encoding/color.glsl"
#include "gpu/transfer.h"
#include "interop/display.h"
#include "render/executor.h"
#include "render/passes/accumulate.h"
#include "render/passes/exposure.h"
#include "render/passes/post_aa.h"
#include "support/gpu_test.h"

#include <algorithm>
#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{512, 64};

class DisplayPass : public GpuTest {
protected:
    /// The pass on synthetic radiance, grey as `value(x, y)` says; the first channel.
    template <typename Value>
    std::vector<int> displayed(Settings const& settings, Value const& value) {
        std::vector<glm::vec4> texels;
        for (std::uint32_t i = 0; i < EXTENT.pixels(); ++i) texels.push_back(glm::vec4(glm::vec3(static_cast<float>(value(i % EXTENT.width, i / EXTENT.width))), 1));
        auto const input = make_float_image(device(), texels, EXTENT);
        constexpr VkImageUsageFlags usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
        GpuImage picture(device(), {VK_FORMAT_R8G8B8A8_UNORM, EXTENT}, usage, "picture");
        FrameGraph graph;
        ImageId const read = graph.import(*input, "radiance", ShowScale::radiance, true);
        ImageId const written = graph.import(picture, "picture", ShowScale::encoded, false);
        ImageId const exposure = graph.add_image("exposure", {VK_FORMAT_R32G32B32A32_SFLOAT, {1, 1}}, ShowScale::number);
        ImageId const mean = graph.add_image("mean", {VK_FORMAT_R32G32B32A32_SFLOAT, EXTENT}, ShowScale::radiance);
        add_exposure(graph, read, exposure, settings, ADAPTED_AT_ONCE);
        ImageId const toned = add_accumulate(graph, read, mean, exposure, settings, 0);
        if (settings.post_aa == "fxaa") {
            add_post_aa(graph, add_display(graph, toned, settings), written);
        } else {
            add_display_to(graph, toned, settings, written);
        }
        Executor executor(device());
        executor.submit(graph);
        executor.wait();
        auto const bytes = values_of<std::uint8_t>(read_back(device(), picture));
        std::vector<int> first;
        for (std::size_t i = 0; i < bytes.size(); i += 4) first.push_back(bytes[i]);
        return first;
    }
    Settings settings(char const* curve, bool dither) const {
        Settings result;
        result.curve = curve;
        result.dither = dither;
        return result;
    }
};

constexpr char const* CURVES[] = {"filmic", "exponential", "reinhard", "aces", "lottes", "uchimura", "agx", "linear"};

/// The most columns in a row whose most frequent value is the same, in one row of the picture.
int longest_run(std::vector<int> const& picture, std::uint32_t row) {
    int longest = 0, run = 0;
    for (std::uint32_t x = 1; x < EXTENT.width; ++x) {
        run = picture[row * EXTENT.width + x] == picture[row * EXTENT.width + x - 1] ? run + 1 : 0;
        longest = std::max(longest, run + 1);
    }
    return longest;
}

/// A dusk sky: five steps of 8 bits from side to side.
double gentle(std::uint32_t x, std::uint32_t) { return 0.05 + 0.004 * x / EXTENT.width; }

} // namespace

TEST_F(DisplayPass, curves_rise_from_black_and_stay_below_white) {
    for (char const* const curve : CURVES) {
        // From 2^-20 to 2^12.
        auto const seen = displayed(settings(curve, false), [](std::uint32_t x, std::uint32_t) { return std::exp2(-20.0 + x / 16.0); });
        EXPECT_LE(seen.front(), 1);
        EXPECT_EQ(seen[EXTENT.width - 1], 255);
        for (std::uint32_t x = 1; x < EXTENT.width; ++x) ASSERT_GE(seen[x], seen[x - 1]) << curve << ' ' << x;
    }
}

TEST_F(DisplayPass, exposure_is_in_stops) {
    for (char const* const curve : CURVES) {
        Settings brighter = settings(curve, false);
        brighter.exposure = 3;
        EXPECT_EQ(displayed(brighter, [](std::uint32_t x, std::uint32_t) { return x * 1e-4; }),
                  displayed(settings(curve, false), [](std::uint32_t x, std::uint32_t) { return x * 8e-4; }));
    }
}

TEST_F(DisplayPass, the_exponential_curve_is_the_documents) {
    auto const seen = displayed(settings("exponential", false), [](std::uint32_t x, std::uint32_t) { return x * 0.01; });
    for (std::uint32_t x = 0; x < EXTENT.width; ++x) {
        double const linear = 1 - std::exp(-0.01 * x), encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
        ASSERT_NEAR(seen[x], 255 * encoded, 0.51) << x; // half a step, and the driver's pow
    }
}

TEST_F(DisplayPass, dither_leaves_the_mean_as_it_is) {
    for (double const grey : {0.01, 0.05, 0.2, 0.6}) {
        auto const flat = displayed(settings("exponential", true), [&](std::uint32_t, std::uint32_t) { return grey; });
        double mean = 0;
        for (int const value : flat) mean += value;
        double const exact = 255 * shader::srgb_from_linear(1.0f - std::exp(-static_cast<float>(grey)));
        // 32 768 pixels of a noise of half a step would leave 0.003 by chance.
        EXPECT_NEAR(mean / static_cast<double>(flat.size()), exact, 0.02) << grey;
    }
}

TEST_F(DisplayPass, dither_leaves_no_band) {
    auto const plain = displayed(settings("filmic", false), gentle), dithered = displayed(settings("filmic", true), gentle);
    int widest = 0;
    for (std::uint32_t y = 0; y < EXTENT.height; ++y) {
        widest = std::max(widest, longest_run(dithered, y));
        EXPECT_GT(longest_run(plain, y), 60); // the bands that are there without it
    }
    EXPECT_LT(widest, 24); // [pixel]; a triangular noise of two steps repeats a value more often than not nowhere
}

TEST_F(DisplayPass, no_radiance_is_too_large_to_show) {
    for (char const* const curve : CURVES) {
        for (double const value : {1e6, 1e20, 3e38}) {
            auto const seen = displayed(settings(curve, true), [&](std::uint32_t, std::uint32_t) { return value; });
            EXPECT_GE(*std::ranges::min_element(seen), 254) << curve << ' ' << value;
        }
    }
}

TEST_F(DisplayPass, fxaa_leaves_flat_areas_and_smooths_steps) {
    Settings smooth = settings("exponential", false);
    auto const stairs = [](std::uint32_t x, std::uint32_t y) { return x > 200 + 4 * y ? 2.0 : 0.1; };
    auto const before = displayed(smooth, stairs);
    smooth.post_aa = "fxaa";
    auto const after = displayed(smooth, stairs);
    int smoothed = 0;
    for (std::uint32_t i = 0; i < EXTENT.pixels(); ++i) {
        int const from_edge = static_cast<int>(i % EXTENT.width) - static_cast<int>(200 + 4 * (i / EXTENT.width));
        if (from_edge < -16 || from_edge > 16) {
            ASSERT_EQ(after[i], before[i]) << "at " << i % EXTENT.width << ", " << i / EXTENT.width;
        }
        smoothed += after[i] != before[i];
    }
    EXPECT_GT(smoothed, 64); // at least one pixel a row
}
