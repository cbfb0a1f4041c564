#pragma once

#include "reference/ray.h"

#include <algorithm>
#include <span>

namespace alpenglow {

/// Cuts a stretch of a ray where it passes from one shell around the planet to the next.
class ShellWalk {
public:
    /// `top_radii` [m] of the shells from the ground up, increasing; the last reaches over the whole stretch.
    ShellWalk(std::span<double const> top_radii, Ray const& ray, double from, double to)
        : tops_(top_radii), ray_(ray), to_(to), end_(from) {
        double const radius = ray.radius_at(from);
        next_ = static_cast<std::size_t>(std::upper_bound(tops_.begin(), tops_.end() - 1, radius) - tops_.begin());
    }

    /// Goes on to the next piece; false after the last.
    bool next() {
        if (!(end_ < to_)) return false;
        begin_ = end_;
        shell_ = next_;
        double const bottom = shell_ > 0 ? tops_[shell_ - 1] : 0, top = tops_[shell_];
        double leave = to_;
        if (ray_.along + begin_ < 0 && ray_.closest_squared < bottom * bottom) {
            leave = -ray_.along - std::sqrt(bottom * bottom - ray_.closest_squared);
            next_ = shell_ - 1;
        } else if (shell_ + 1 < tops_.size()) {
            leave = -ray_.along + std::sqrt(std::max(0.0, top * top - ray_.closest_squared));
            next_ = shell_ + 1;
        }
        end_ = std::clamp(leave, begin_, to_);
        return true;
    }

    double begin() const { return begin_; } ///< [m] along the ray
    double end() const { return end_; }
    std::size_t shell() const { return shell_; }

private:
    std::span<double const> tops_;
    Ray const& ray_;
    double to_, begin_ = 0, end_;
    std::size_t shell_ = 0, next_ = 0;
};

} // namespace alpenglow
