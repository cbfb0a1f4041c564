#include "image/mask.h"

#include "image/color.h"
#include "image/compare.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace alpenglow {

std::vector<bool> where_apart(FloatImage const& test, FloatImage const& reference, double share) {
    require_same_extent(test.extent, reference.extent);
    std::vector<bool> mask(reference.extent.pixels());
    for (std::size_t i = 0; i < mask.size(); ++i) {
        float const *const a = &test.rgba[4 * i], *const b = &reference.rgba[4 * i];
        double const wanted = double{luminance(b[0], b[1], b[2])};
        double const difference = std::abs(double{luminance(a[0], a[1], a[2])} - wanted);
        mask[i] = !is_finite_color(a) || !is_finite_color(b) || difference > share * wanted;
    }
    return mask;
}

double share_of(std::vector<bool> const& mask) {
    if (mask.empty()) return 0;
    return static_cast<double>(std::ranges::count(mask, true)) / static_cast<double>(mask.size());
}

std::optional<double> masked_mean(std::span<float const> values, std::vector<bool> const& mask) {
    assert(values.size() == mask.size());
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (!mask[i]) continue;
        sum += double{values[i]};
        ++count;
    }
    if (count == 0) return {};
    return sum / static_cast<double>(count);
}

} // namespace alpenglow
