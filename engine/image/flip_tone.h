#pragma once

#include "image/flip.h"

namespace alpenglow::flip {

/// 0..1 as the screen shows it, from exposed radiance: the fit to ACES by Narkowicz (2016), "ACES Filmic Tone Mapping
/// Curve", with its exposure of 0.6 taken back in, as HDR-FLIP has it. What is negative is black.
float aces_curve(float exposed);

/// The exposed luminance that `aces_curve` shows as `shown`, 0 < shown < 1.
double aces_curve_inverse(double shown);

/// 2^exposure of picture `i` of the range.
float exposure_gain(ExposureRange const& range, int i);

} // namespace alpenglow::flip
