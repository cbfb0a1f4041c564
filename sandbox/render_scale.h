#pragma once

#include "core/extent.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alpenglow {

/// What share of the window's width and height a picture is drawn with: all of it while it stands still; while it moves
/// as much as the device draws in time. Few steps, with a dead band between them, so that the size does not flicker.
class RenderScale {
public:
    static constexpr double BUDGET_MS = 100;

    /// `ms`: what the picture's pixels cost at the share that it was drawn with.
    void note(double ms, double share) { whole_ms_ = ms / (share * share); }

    double share(bool moving) {
        if (!moving) return 1;
        while (moving_ > 0 && cost(moving_ - 1) < 0.8 * BUDGET_MS) --moving_;
        while (moving_ + 1 < SHARES.size() && cost(moving_) > BUDGET_MS) ++moving_;
        return SHARES[moving_];
    }

private:
    static constexpr std::array SHARES = {1.0, 0.75, 0.5, 1.0 / 3};
    double cost(std::size_t step) const { return whole_ms_ * SHARES[step] * SHARES[step]; }

    double whole_ms_ = 0;
    std::size_t moving_ = 0; ///< step of the last moving picture
};

inline Extent scaled(Extent extent, double share) {
    auto const side = [share](std::uint32_t whole) {
        return std::max(1u, static_cast<std::uint32_t>(std::lround(whole * share)));
    };
    return {side(extent.width), side(extent.height)};
}

} // namespace alpenglow
