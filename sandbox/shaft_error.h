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
/// `count` even samples inside the span that can be shadowed.
ShaftLevel even_steps(int count);
/// The levels of a table, `no_shafts` first.
std::vector<ShaftLevel> shaft_levels();

/// Pixels whose luminance the shafts change by more than this share are those of the masked mean.
inline constexpr double SHAFT_MASK = 0.02;

/// How far a picture is from that with exact shafts.
struct ShaftError {
    double flip = 0;                   ///< mean HDR FLIP, 0 to 1
    std::optional<double> masked_flip; ///< over the pixels that shafts change; empty where there are none
    double rmse = 0;                   ///< over all pixels and channels, over the mean of the exact picture
    double p999 = 0; ///< 99.9th percentile of the absolute error, over the mean in-scattered radiance
    FlipResult map;
};

/// A view with all that its levels are measured with. Without the sun's disc and the stars.
struct ShaftCase {
    View view;
    Extent size;
    FloatImage exact, off;
    std::vector<bool> mask;      ///< pixels that shafts change
    double mean_inscattered = 0; ///< of all pixels and channels of the exact picture [radiance]
};

/// The views of assets/views/shafts by name. Throws Error(bad_input) where there are none.
std::vector<std::filesystem::path> shaft_views();

/// The view with the level's settings.
View at_level(View view, ShaftLevel const& level);
/// Its linear radiance. Throws Error; Error(device) where a pixel is not finite.
FloatImage draw_shafts(Stage& stage, View const& view, Extent size);

ShaftCase make_shaft_case(Stage& stage, View view, Extent size);
ShaftError shaft_error(FloatImage const& picture, ShaftCase const& given);

} // namespace alpenglow
