#include "sandbox/shaft_error.h"

#include "core/error.h"
#include "core/files.h"
#include "image/compare.h"
#include "image/mask.h"
#include "image/metrics.h"

#include <algorithm>
#include <fmt/format.h>

namespace alpenglow {

namespace fs = std::filesystem;

namespace {

double mean_of_channels(FloatImage const& image) {
    double sum = 0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) sum += i % 4 == 3 ? 0 : double{image.rgba[i]};
    return sum / static_cast<double>(3 * image.extent.pixels());
}

} // namespace

ShaftLevel exact_shafts() { return {"exact", {{"shafts", "on"}, {"samples", "1024"}}}; }
ShaftLevel no_shafts() { return {"off", {{"shafts", "off"}, {"samples", "1024"}}}; }
ShaftLevel even_steps(int count) {
    return {fmt::format("{} steps", count), {{"shafts", "on"}, {"samples", std::to_string(2 * count)}}};
}
std::vector<ShaftLevel> shaft_levels() { return {no_shafts(), even_steps(20), even_steps(200)}; }

std::vector<fs::path> shaft_views() {
    fs::path const folder = assets_folder() / "views/shafts";
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_entry const& entry : fs::directory_iterator(folder, error)) {
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    }
    if (files.empty()) throw Error(ErrorKind::bad_input, "there are no views of shafts", folder.string(), "name views");
    std::ranges::sort(files);
    return files;
}

View at_level(View view, ShaftLevel const& level) {
    apply_overrides(view.settings, level.settings);
    return view;
}

FloatImage draw_shafts(Stage& stage, View const& view, Extent size) {
    stage.draw(view, stage.prepare(view), size);
    FloatImage picture = stage.renderer().radiance();
    if (std::size_t const count = count_non_finite(picture); count > 0) {
        throw Error(ErrorKind::device, fmt::format("{} rendered pixels are not finite", count), "view " + view.name,
                    "this is a fault of the renderer or its device: try another --device");
    }
    return picture;
}

ShaftCase make_shaft_case(Stage& stage, View view, Extent size) {
    view.settings.sun_disc = view.settings.stars = false;
    view.settings.aa = 1;
    ShaftCase made;
    made.view = view;
    made.size = size;
    made.off = draw_shafts(stage, at_level(view, no_shafts()), size);
    made.exact = draw_shafts(stage, at_level(view, exact_shafts()), size);
    made.mean_inscattered = mean_of_channels(made.exact);
    made.mask = where_apart(made.off, made.exact, SHAFT_MASK);
    return made;
}

ShaftError shaft_error(FloatImage const& picture, ShaftCase const& given) {
    ShaftError error;
    error.map = compute_hdr_flip(given.exact, picture);
    error.flip = error.map.mean;
    error.masked_flip = masked_mean(error.map.error, given.mask);
    Metrics const metrics = measure(picture, given.exact);
    error.rmse = metrics.rel_rmse.value();
    error.p999 = metrics.p999.value() / given.mean_inscattered;
    return error;
}

} // namespace alpenglow
