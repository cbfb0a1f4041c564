#pragma once

#include "image/flip.h"
#include "image/image.h"
#include "sandbox/stage.h"

#include <filesystem>
#include <string>
#include <vector>

namespace alpenglow {

/// A converged picture of a view, and how far two independent halves of its samples are apart.
struct ViewReference {
    FloatImage radiance;
    double noise_flip = 0; ///< mean HDR FLIP
    double noise_rmse = 0; ///< [radiance]
};

/// How far a rendered view is from its reference.
struct ViewError {
    double flip = 0; ///< mean HDR FLIP, 0 to 1
    double rmse = 0; ///< over all pixels and channels [radiance]
    double bias = 0; ///< mean over pixels and channels, test minus reference, over the reference's
    FlipResult map;
    FloatImage picture; ///< what was rendered
};

/// A row of the table.
struct Evaluation {
    std::string view, model;
    double flip = 0, rmse = 0, bias = 0; ///< as in ViewError
    double frame_ms = 0;                 ///< as in FrameTimes, at the reference's size with one ray for each pixel
    double noise_flip = 0, noise_rmse = 0;
};

/// Rays for each pixel of the picture that is compared: both pictures hold means over a pixel's square.
inline constexpr int EVALUATION_AA = 16;

/// The views of assets/views/comparison: those with published figures in the order of their table, then the others by
/// name. Throws Error(bad_input) where the folder is missing.
std::vector<std::filesystem::path> comparison_views();

/// NAME.exr in `folder` for the view file NAME.json. Throws Error(bad_input) where it is missing (with the command that
/// makes it), holds no noise floor, is black, or has pixels that are not finite.
ViewReference load_reference(std::filesystem::path const& folder, std::filesystem::path const& view_file);

/// Renders the view, with `aa` rays for each pixel as it says, at the reference's size and compares. Throws Error;
/// Error(device) where a pixel is not finite.
ViewError measure_error(Stage& stage, View const& view, ViewReference const& reference);

} // namespace alpenglow
