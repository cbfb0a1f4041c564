#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace alpenglow {

/// The middle one of the values, or the mean of the middle two; 0 of none.
inline double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::ranges::sort(values);
    std::size_t const middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

} // namespace alpenglow
