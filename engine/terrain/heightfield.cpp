#include "terrain/heightfield.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alpenglow {

namespace {

struct Weights {
    std::array<double, 4> value, slope;
};

Weights catmull_rom(double t) {
    double const t2 = t * t, t3 = t2 * t;
    return {
        {0.5 * (-t3 + 2 * t2 - t), 0.5 * (3 * t3 - 5 * t2 + 2), 0.5 * (-3 * t3 + 4 * t2 + t), 0.5 * (t3 - t2)},
        {0.5 * (-3 * t2 + 4 * t - 1), 0.5 * (9 * t2 - 10 * t), 0.5 * (-9 * t2 + 8 * t + 1), 0.5 * (3 * t2 - 2 * t)}};
}

} // namespace

HeightSample HeightField::sample(double east, double north) const {
    double const x = std::clamp((east / side_ + 0.5) * (nodes_ - 1), 0.0, nodes_ - 1.0);
    double const y = std::clamp((north / side_ + 0.5) * (nodes_ - 1), 0.0, nodes_ - 1.0);
    int const i = std::min(static_cast<int>(x), nodes_ - 2), j = std::min(static_cast<int>(y), nodes_ - 2);
    Weights const wx = catmull_rom(x - i), wy = catmull_rom(y - j);
    HeightSample result;
    for (int b = 0; b < 4; ++b) {
        int const row = std::clamp(j + b - 1, 0, nodes_ - 1);
        double value = 0, slope = 0;
        for (int a = 0; a < 4; ++a) {
            double const h = at(std::clamp(i + a - 1, 0, nodes_ - 1), row);
            value += wx.value[a] * h;
            slope += wx.slope[a] * h;
        }
        result.altitude += wy.value[b] * value;
        result.east += wy.value[b] * slope;
        result.north += wy.slope[b] * value;
    }
    result.east /= cell();
    result.north /= cell();
    return result;
}

double HeightField::rough_altitude(double east, double north) const {
    double const x = std::clamp((east / side_ + 0.5) * (nodes_ - 1), 0.0, nodes_ - 1.0);
    double const y = std::clamp((north / side_ + 0.5) * (nodes_ - 1), 0.0, nodes_ - 1.0);
    int const i = std::min(static_cast<int>(x), nodes_ - 2), j = std::min(static_cast<int>(y), nodes_ - 2);
    double const south_side = std::lerp(double(at(i, j)), double(at(i + 1, j)), x - i);
    double const north_side = std::lerp(double(at(i, j + 1)), double(at(i + 1, j + 1)), x - i);
    return std::lerp(south_side, north_side, y - j);
}

} // namespace alpenglow
