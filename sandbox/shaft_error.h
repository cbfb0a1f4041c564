#pragma once

#include "image/flip.h"
#include "image/image.h"
#include "sandbox/stage.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alpenglow {

/// A way to draw shafts: settings laid over the view's.
struct ShaftLevel {
    std::string name;
    std::vector<Override> settings;
};

/// What every level is measured against, and no shafts at all.
ShaftLevel exact_shafts();
ShaftLevel no_shafts();
/// Brute force: `count` even samples where meshes can shade the air.
ShaftLevel even_steps(int count);
/// The levels that have errors: no_shafts, brute force with 20 steps, and those of the setting.
std::vector<ShaftLevel> shaft_levels();

/// Pixels whose luminance the shafts change by more than this share are those of the masked mean.
inline constexpr double SHAFT_MASK = 0.02;

/// How far a picture is from that with exact shafts.
struct ShaftError {
    double flip = 0;                   ///< mean HDR FLIP, 0 to 1
    std::optional<double> masked_flip; ///< over the pixels that shafts change; empty where there are none
    double rmse = 0; ///< over all pixels and channels, over the mean of the exact picture
    double p999 = 0; ///< 99.9th percentile of the channels' absolute errors, over the mean in-scattered radiance
    FlipResult map;
};

/// The linear radiance of a view at one level, and what it cost.
struct ShaftPicture {
    FloatImage radiance;
    double mean_inscattered = 0; ///< of all pixels and channels [radiance]
    double ms = 0;               ///< of its passes, without those that draw surfaces and the display's
};

/// A view with what its levels are measured against. Without the sun's disc and the stars, which no shaft changes.
struct ShaftCase {
    View view;
    Extent size;
    ShaftPicture exact;
    std::vector<bool> mask; ///< pixels that shafts change
};

/// The views of assets/views/shafts by name. Throws Error(bad_input) where there are none.
std::vector<std::filesystem::path> shaft_views();

/// Draws the view at the level, then `timed` frames for the time, which is that of the first without them. Throws Error;
/// Error(device) where a pixel is not finite.
ShaftPicture draw_shafts(Stage& stage, View view, ShaftLevel const& level, Extent size, int timed);

ShaftCase make_shaft_case(Stage& stage, View view, Extent size);
ShaftError shaft_error(FloatImage const& picture, ShaftCase const& given);

} // namespace alpenglow
