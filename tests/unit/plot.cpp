#include "sandbox/plot.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <regex>

using namespace alpenglow;

namespace {

std::vector<PlotPanel> panels() {
    return {{"near", {{"a", {{10, 0.1, "4"}, {100, 0.01, "8"}}}, {"b", {{20, 0.05}}}}}, {"far", {{"a", {{1000, 0.02}}}}}};
}

/// Places of the circles of a colour.
std::vector<std::array<double, 2>> circles(std::string const& svg, std::string const& color) {
    std::regex const pattern("<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\" r=\"3.5\" fill=\"" + color + "\"/>");
    std::vector<std::array<double, 2>> found;
    for (std::sregex_iterator i(svg.begin(), svg.end(), pattern), end; i != end; ++i)
        found.push_back({std::stod((*i)[1]), std::stod((*i)[2])});
    return found;
}

} // namespace

TEST(Plot, has_every_point_in_its_series_color) {
    std::string const svg = svg_plot(panels(), "cost", "error");
    EXPECT_EQ(circles(svg, "#c0392b").size(), 3u); // series a, in both panels
    EXPECT_EQ(circles(svg, "#2471a3").size(), 1u);
    for (char const* const words : {"near", "far", "cost", "error", ">4</text>", ">a</text>"})
        EXPECT_NE(svg.find(words), std::string::npos) << words;
    EXPECT_TRUE(svg.starts_with("<svg") && svg.ends_with("</svg>\n"));
}

TEST(Plot, axes_are_logarithmic_and_shared) {
    std::string const svg = svg_plot(panels(), "cost", "error");
    auto const a = circles(svg, "#c0392b"), b = circles(svg, "#2471a3");
    // 10 to 100 and 100 to 1000 are one step each; the second panel starts a panel and a gap further on.
    EXPECT_NEAR(a[1][0] - a[0][0], a[2][0] - 322 - a[1][0], 0.2);
    EXPECT_NEAR((b[0][0] - a[0][0]) / (a[1][0] - a[0][0]), std::log10(2), 1e-2);
    // Less error is lower down the picture.
    EXPECT_GT(a[1][1], a[0][1]);
    EXPECT_NEAR((a[2][1] - a[0][1]) / (a[1][1] - a[0][1]), std::log10(5), 1e-2);
}
