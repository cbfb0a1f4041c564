#include "encoding/tone_curves.glsl"

#include "core/settings.h"
#include "render/frame_constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

using namespace alpenglow;

namespace {

std::vector<std::string> names() {
    std::vector<std::string> result;
    std::string_view left = find_setting("curve")->choices;
    while (!left.empty()) {
        std::size_t const bar = std::min(left.find('|'), left.size());
        result.emplace_back(left.substr(0, bar));
        left.remove_prefix(std::min(bar + 1, left.size()));
    }
    return result;
}

glm::vec3 shown(std::string const& curve, glm::vec3 const& exposed) {
    return shader::tone_curve(curve_index(curve), exposed);
}

double grey(std::string const& curve, double exposed) { return double(shown(curve, glm::vec3(float(exposed))).y); }

} // namespace

TEST(ToneCurves, each_name_has_a_curve_of_its_own) {
    std::set<int> indices;
    for (std::string const& name : names()) {
        EXPECT_LT(curve_index(name), CURVE_COUNT) << name;
        EXPECT_TRUE(indices.insert(curve_index(name)).second) << name;
    }
    EXPECT_EQ(indices.size(), std::size_t(CURVE_COUNT));
}

TEST(ToneCurves, start_at_black_never_fall_and_end_at_white) {
    for (std::string const& name : names()) {
        EXPECT_NEAR(grey(name, 0), 0, 1e-6) << name;
        double before = 0;
        for (double stops = -20; stops <= 20; stops += 1.0 / 16) {
            double const now = grey(name, std::exp2(stops));
            EXPECT_GE(now, before - 1e-6) << name << " at 2^" << stops; // 1e-6: rounding of float powers
            before = now;
        }
        EXPECT_NEAR(before, 1, 2e-6) << name; // Reinhard's approach to 1 is 2^-20 short
        EXPECT_EQ(grey(name, 3e38), grey(name, 1e6)) << name;
    }
}

TEST(ToneCurves, greys_stay_grey) {
    for (std::string const& name : names()) {
        for (float const value : {0.001f, 0.18f, 1.0f, 30.0f}) {
            glm::vec3 const c = shown(name, glm::vec3(value));
            EXPECT_NEAR(c.x, c.y, 2e-6f) << name << ' ' << value;
            EXPECT_NEAR(c.z, c.y, 2e-6f) << name << ' ' << value;
        }
    }
}

// Values by hand from the equations as their authors print them.
TEST(ToneCurves, have_their_authors_values) {
    EXPECT_NEAR(grey("exponential", 1), 1 - std::exp(-1), 1e-6);
    EXPECT_NEAR(grey("reinhard", 1), 0.5, 1e-6);
    EXPECT_NEAR(grey("reinhard", 3), 0.75, 1e-6);
    EXPECT_NEAR(grey("aces", 1), 2.54 / 3.16, 1e-6);
    EXPECT_NEAR(grey("aces", 0.18), 0.18 * (2.51 * 0.18 + 0.03) / (0.18 * (2.43 * 0.18 + 0.59) + 0.14), 1e-6);
    EXPECT_EQ(grey("aces", 7.3), 1);
    EXPECT_LT(grey("aces", 7.2), 1);
    // Lottes' anchors: middle grey and the largest value that is not white.
    EXPECT_NEAR(grey("lottes", 0.18), 0.267, 2e-6);
    EXPECT_NEAR(grey("lottes", 8), 1, 2e-6);
    EXPECT_LT(grey("lottes", 7.9), 1);
    // Uchimura: the identity from 0.22 to 0.532; the toe halfway, where its weight is a half; the shoulder's slope 1.
    for (double const x : {0.22, 0.3, 0.45, 0.532}) EXPECT_NEAR(grey("uchimura", x), x, 2e-6);
    EXPECT_NEAR(grey("uchimura", 0.11), 0.5 * (0.22 * std::pow(0.5, 1.33) + 0.11), 2e-6);
    EXPECT_NEAR(grey("uchimura", 1), 1 - 0.468 * std::exp(-1.0), 2e-6);
    // AgX: middle grey is the sigmoid's pivot, a half of the encoded display; 6.5 stops above it is white.
    EXPECT_NEAR(grey("agx", 0.18), std::pow(0.5, 2.2), 1e-4);
    EXPECT_NEAR(grey("agx", 0.18 * std::exp2(6.5)), 1, 1e-4);
    EXPECT_LT(grey("agx", 0.18 * std::exp2(6)), 0.995);
}

// What makes it worth its price: a bright saturated colour turns white, where curves of each channel end at a primary.
TEST(ToneCurves, agx_fades_bright_colours_to_white) {
    glm::vec3 const red(60, 2, 1);
    EXPECT_GT(shown("agx", red).z, 0.4f);
    EXPECT_GT(shown("agx", {20, 0.2f, 0.1f}).z, shown("agx", {2, 0.02f, 0.01f}).z);
    glm::vec3 const dim = shown("agx", {0.1f, 0.02f, 0.01f});
    EXPECT_GT(dim.x, 2 * dim.z); // and a dim one keeps its colour
}
