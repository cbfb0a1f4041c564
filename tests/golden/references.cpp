#include "core/files.h"
#include "image/exr.h"
#include "reference/picture.h"
#include "sandbox/traced_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>

using namespace alpenglow;

namespace {

std::filesystem::path const SOURCE = ALPENGLOW_SOURCE;
constexpr std::uint64_t OTHER_SEED = 20261122;

std::vector<std::filesystem::path> view_files() {
    std::vector<std::filesystem::path> files;
    for (auto const& entry : std::filesystem::directory_iterator(SOURCE / "assets/views/comparison")) files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

std::filesystem::path reference_of(std::filesystem::path const& view_file) {
    return SOURCE / "assets/references" / (view_file.stem().string() + ".exr");
}

/// Mean of the variance over the pixels around one: few passes say little of a single pixel's.
glm::dvec3 variance_around(FloatImage const& variance, std::uint32_t x, std::uint32_t y) {
    constexpr std::uint32_t reach = 3;
    glm::dvec3 sum(0);
    int count = 0;
    for (std::uint32_t v = y - std::min(y, reach); v <= std::min(y + reach, variance.extent.height - 1); ++v) {
        for (std::uint32_t u = x - std::min(x, reach); u <= std::min(x + reach, variance.extent.width - 1); ++u, ++count) {
            for (int c = 0; c < 3; ++c) sum[c] += double(variance.at(u, v)[c]);
        }
    }
    return sum / double(count);
}

/// No pixel counts for more: at dawn one path in hundreds is worth twenty of the deviations that a few passes know of.
constexpr double MOST_DEVIATIONS = 6;

/// How far some pixels of a stored picture are from what another seed makes of them, in standard deviations.
struct Disagreement {
    double chi_squared = 0; ///< mean over pixels and channels of (difference / deviation)^2; 1 where both are right
    double bias = 0;        ///< largest over the channels of |sum of differences / deviation|
};

/// `pixels` of the record's pixels, traced with one pass. Its variance is that of one of the record's passes.
Disagreement disagreement(RadianceRecord const& record, TracedView const& view, int pixels) {
    int passes = 0;
    std::string const& text = record.attributes.at("passes");
    std::from_chars(text.data(), text.data() + text.size(), passes);
    Extent const size = record.radiance.extent;
    glm::dvec3 squares(0), differences(0);
    for (int i = 0; i < pixels; ++i) {
        std::uint64_t const random = hash(OTHER_SEED, static_cast<std::uint64_t>(i)) % size.pixels();
        auto const x = static_cast<std::uint32_t>(random % size.width), y = static_cast<std::uint32_t>(random / size.width);
        glm::dvec3 const traced = trace_pixel(view.tracer(), view.camera(), size, x, y, OTHER_SEED, 0).radiance;
        float const* const stored = record.radiance.at(x, y);
        glm::dvec3 const variance = variance_around(*record.variance, x, y) * (1.0 + passes) + 1e-30;
        glm::dvec3 const found = (traced - glm::dvec3(stored[0], stored[1], stored[2])) / sqrt(variance);
        glm::dvec3 const deviations = clamp(found, -MOST_DEVIATIONS, MOST_DEVIATIONS);
        squares += deviations * deviations;
        differences += deviations;
    }
    glm::dvec3 const bias = abs(differences) / std::sqrt(pixels);
    return {(squares.x + squares.y + squares.z) / (3 * pixels), std::max({bias.x, bias.y, bias.z})};
}

class References : public testing::TestWithParam<std::filesystem::path> {};

std::string test_name(testing::TestParamInfo<std::filesystem::path> const& info) {
    std::string name = info.param.stem().string();
    std::ranges::replace(name, '-', '_');
    return name;
}

} // namespace

/// Found: 0.3 (where most pixels are black) to 1.2, and 2.9 at most. The variance of a few passes is a rough figure.
TEST_P(References, agree_with_another_seed) {
    RadianceRecord const record = read_record(reference_of(GetParam()));
    ASSERT_TRUE(record.variance);
    Disagreement const found = disagreement(record, TracedView(load_view(GetParam())), 300);
    EXPECT_LT(found.chi_squared, 1.5);
    EXPECT_LT(found.bias, 4.5);
}

INSTANTIATE_TEST_SUITE_P(All, References, testing::ValuesIn(view_files()), test_name);

/// The check above would notice.
TEST(ReferencesCheck, finds_three_percent_more_rayleigh_and_a_sun_half_a_degree_off) {
    std::filesystem::path const file = SOURCE / "assets/views/comparison/ground-sunrise.json";
    RadianceRecord const record = read_record(reference_of(file));
    View const view = load_view(file);
    Planet planet = load_planet(view.planet);
    planet.air.at("rayleigh").scattering *= 1.03;
    EXPECT_GT(disagreement(record, TracedView(view, planet), 300).bias, 5);

    View moved = view;
    moved.sun.elevation += glm::radians(0.5);
    EXPECT_GT(disagreement(record, TracedView(moved), 300).bias, 5);
}
