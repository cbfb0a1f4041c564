#pragma once

#include <span>
#include <string>
#include <vector>

namespace alpenglow {

struct PlotPoint {
    double x = 0, y = 0; ///< both greater than 0
    std::string label{};
};

/// Points that belong together, joined in their order.
struct PlotSeries {
    std::string name;
    std::vector<PlotPoint> points;
};

struct PlotPanel {
    std::string title;
    std::vector<PlotSeries> series;
};

/// Panels beside each other as an SVG picture, both axes logarithmic and the same in all. Series of one name have one
/// colour. At least one point.
std::string svg_plot(std::span<PlotPanel const> panels, std::string const& x_label, std::string const& y_label);

} // namespace alpenglow
