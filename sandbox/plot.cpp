#include "sandbox/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace alpenglow {

namespace {

constexpr double PANEL = 300, HEIGHT = 260, LEFT = 80, TOP = 34, GAP = 22, BOTTOM = 74; // [px]
constexpr std::array COLORS{"#c0392b", "#2471a3", "#7d8a2e", "#8e44ad", "#d68910", "#148f77"};

/// A logarithmic axis from `least` to `most`, on `length` pixels.
struct Axis {
    double least = std::numeric_limits<double>::infinity(), most = 0;

    void include(double value) { least = std::min(least, value), most = std::max(most, value); }
    /// Room around the points.
    void widen() { least *= 0.8, most *= 1.25; }
    double place(double value, double length) const {
        return length * std::log(value / least) / std::log(most / least);
    }
    /// 1, 2 and 5 in each power of ten.
    std::vector<double> ticks() const {
        std::vector<double> result;
        for (double decade = std::pow(10, std::floor(std::log10(least))); decade <= most; decade *= 10) {
            for (double const step : {1.0, 2.0, 5.0}) {
                if (decade * step >= least && decade * step <= most) result.push_back(decade * step);
            }
        }
        return result;
    }
};

struct Axes {
    Axis x, y;
};

Axes axes_of(std::span<PlotPanel const> panels) {
    Axes axes;
    for (PlotPanel const& panel : panels) {
        for (PlotSeries const& series : panel.series) {
            for (PlotPoint const& point : series.points) axes.x.include(point.x), axes.y.include(point.y);
        }
    }
    axes.x.widen(), axes.y.widen();
    return axes;
}

std::vector<std::string> names_of(std::span<PlotPanel const> panels) {
    std::vector<std::string> names;
    for (PlotPanel const& panel : panels) {
        for (PlotSeries const& series : panel.series) {
            if (std::ranges::find(names, series.name) == names.end()) names.push_back(series.name);
        }
    }
    return names;
}

char const* color_of(std::string const& name, std::vector<std::string> const& names) {
    return COLORS[static_cast<std::size_t>(std::ranges::find(names, name) - names.begin()) % COLORS.size()];
}

std::string text(double x, double y, char const* anchor, std::string const& words) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, words);
}

std::string grid(Axes const& axes, double left, bool first) {
    std::string svg =
        fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#888\"/>\n", left, TOP,
                    PANEL, HEIGHT);
    for (double const tick : axes.x.ticks()) {
        double const x = left + axes.x.place(tick, PANEL);
        svg += fmt::format("<path d=\"M{:.1f} {}v{}\" stroke=\"#ddd\"/>\n", x, TOP, HEIGHT);
        svg += text(x, TOP + HEIGHT + 16, "middle", fmt::format("{:g}", tick));
    }
    for (double const tick : axes.y.ticks()) {
        double const y = TOP + HEIGHT - axes.y.place(tick, HEIGHT);
        svg += fmt::format("<path d=\"M{} {:.1f}h{}\" stroke=\"#ddd\"/>\n", left, y, PANEL);
        if (first) svg += text(left - 6, y + 4, "end", fmt::format("{:g}", tick));
    }
    return svg;
}

std::string curve(PlotSeries const& series, Axes const& axes, double left, char const* color) {
    std::string path, marks;
    for (PlotPoint const& point : series.points) {
        double const x = left + axes.x.place(point.x, PANEL), y = TOP + HEIGHT - axes.y.place(point.y, HEIGHT);
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x, y);
        marks += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\"/>\n", x, y, color);
        if (!point.label.empty()) marks += text(x + 5, y - 5, "start", point.label);
    }
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", path, color) + marks;
}

} // namespace

std::string svg_plot(std::span<PlotPanel const> panels, std::string const& x_label, std::string const& y_label) {
    Axes const axes = axes_of(panels);
    std::vector<std::string> const names = names_of(panels);
    double const width = LEFT + static_cast<double>(panels.size()) * (PANEL + GAP), height = TOP + HEIGHT + BOTTOM;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
        width, height);
    for (std::size_t i = 0; i < panels.size(); ++i) {
        double const left = LEFT + static_cast<double>(i) * (PANEL + GAP);
        svg += grid(axes, left, i == 0) + text(left + PANEL / 2, TOP - 10, "middle", panels[i].title);
        for (PlotSeries const& series : panels[i].series)
            svg += curve(series, axes, left, color_of(series.name, names));
    }
    svg += text(width / 2, TOP + HEIGHT + 38, "middle", x_label);
    svg += fmt::format("<text transform=\"translate(16 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                       TOP + HEIGHT / 2, y_label);
    for (std::size_t i = 0; i < names.size(); ++i) {
        double const x = LEFT + 110.0 * static_cast<double>(i), y = height - 14;
        svg += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"4\" fill=\"{}\"/>\n", x, y - 4, color_of(names[i], names));
        svg += text(x + 9, y, "start", names[i]);
    }
    return svg + "</svg>\n";
}

} // namespace alpenglow
