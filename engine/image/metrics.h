#pragma once

#include "image/image.h"

#include <array>
#include <optional>

namespace alpenglow {

/// How far a picture is from its reference, over the colour channels of linear Rec.709. Values are in the unit of the
/// pictures unless said otherwise. Pixels with a colour that is not finite in either picture are left out of all but
/// `non_finite`. What is not defined is empty.
struct Metrics {
    std::optional<double> mse;  ///< mean square error [unit squared]; like the next ones empty without finite pixels
    std::optional<double> rmse; ///< its root
    std::optional<double> rel_rmse; ///< rmse over the mean of the reference's channels; empty for a black reference
    /// Peak signal-to-noise ratio, 10 log10(peak² / mse) [dB]; infinite for equal pictures, empty for a peak of 0.
    std::optional<double> psnr;
    /// For red, green, blue: mean(test - reference) / mean(reference). 0.01 is 1 % too bright; empty where the
    /// reference's channel has the mean 0.
    std::array<std::optional<double>, 3> bias;
    /// 99.9th percentile of the absolute errors of all pixels' channels: the smallest error that at least 99.9 % of
    /// them do not exceed.
    std::optional<double> p999;
    double non_finite = 0; ///< share of pixels, 0..1
};

/// `peak` is that of psnr, the reference's largest channel unless given. Throws Error(bad_input) where the extents
/// differ or there are no pixels.
Metrics measure(FloatImage const& test, FloatImage const& reference, std::optional<double> peak = {});

} // namespace alpenglow
