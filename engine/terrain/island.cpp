#include "terrain/island.h"

#include "terrain/noise.h"

#include <algorithm>
#include <cmath>

namespace alpenglow {

double Island::inland(double east, double north) const {
    double const x = 2 * east / side_, y = 2 * north / side_;
    double const bay_x = x + 0.30 * fractal_noise(seed_ + 11, 2.3 * x, 2.3 * y, 8);
    double const bay_y = y + 0.30 * fractal_noise(seed_ + 23, 2.3 * x, 2.3 * y, 8);
    // A superellipse fills the square better than a circle and shows no corners.
    double const reach = std::pow(std::pow(std::abs(bay_x), 2.4) + std::pow(std::abs(bay_y), 2.4), 1 / 2.4);
    double const rim = 0.95 - std::max(std::abs(x), std::abs(y));
    return 0.5 * side_ * std::min(0.83 - reach, rim);
}

double Island::valley_distance(double east, double north) const {
    constexpr double pi = 3.14159265358979324;
    double const head = 0.26 * side_;
    double const along = std::min(north, head) / side_;
    double const bends =
        0.045 * std::sin(2 * pi * 1.3 * along + 0.6) + 0.09 * fractal_noise(seed_ + 31, 6 * along, 0.5, 3);
    return std::hypot(east - side_ * (bends - 0.02), north - std::min(north, head));
}

double Island::uplift(double east, double north) const {
    double const x = east / side_, y = north / side_;
    double const massif = 0.75 + 0.55 * fractal_noise(seed_ + 47, 7 * x, 7 * y, 4);
    double const coast = 0.15 + 0.85 * smooth_step(0, 0.09 * side_, inland(east, north));
    double const ragged = 1 + 0.9 * fractal_noise(seed_ + 53, 14 * x, 14 * y, 4);
    double const main_valley =
        std::lerp(0.10, 1.0, smooth_step(0.003 * side_, 0.042 * side_, ragged * valley_distance(east, north)));
    // Where this noise crosses zero, lines of softer uplift become the valleys that cross the range.
    double const line = std::abs(fractal_noise(seed_ + 61, 8 * x + 0.7, 8 * y, 3));
    double const cross_valley = std::lerp(0.4, 1.0, smooth_step(0.02, 0.2, line));
    return coast * main_valley * cross_valley * std::clamp(massif, 0.3, 1.2);
}

double Island::seabed(double inland) const { return -80 * (1 - std::exp(inland / (0.0065 * side_))); }

double Island::raw_altitude(double east, double north) const {
    double const shore = std::max(inland(east, north), 0.0);
    double const x = east / side_, y = north / side_;
    double const crests = ridged_noise(seed_ + 59, 9 * x, 9 * y, 6);
    // 3200 m for the default side of 96 km.
    return 0.033 * side_ * uplift(east, north) * smooth_step(0, 0.2 * side_, shore) * (0.2 + 1.1 * crests) +
           0.01 * shore;
}

} // namespace alpenglow
