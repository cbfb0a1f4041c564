#include "sandbox/shaft_error.h"

#include "core/error.h"
#include "core/files.h"
#include "image/compare.h"
#include "image/mask.h"
#include "image/metrics.h"
#include "sandbox/median.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <fmt/format.h>
#include <string_view>

namespace alpenglow {

namespace fs = std::filesystem;

namespace {

/// Passes that shafts have no part in.
constexpr std::array<std::string_view, 13> OTHER_PASSES{
    "ground_light", "sun_shadow", "gbuffer",    "pixel_work", "ambient_occlusion", "ambient_occlusion_smooth", "sky",
    "lighting",     "exposure",   "accumulate", "display",    "post_aa",           "show"};

double mean_of_channels(std::span<float const> rgba) {
    double sum = 0;
    for (std::size_t i = 0; i < rgba.size(); ++i) sum += i % 4 == 3 ? 0 : double{rgba[i]};
    return sum / (0.75 * static_cast<double>(rgba.size()));
}

double mean_inscattered(Renderer& renderer) {
    std::vector<std::byte> const bytes = renderer.image_bytes("air_inscattered");
    std::vector<float> values(bytes.size() / sizeof(float));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values.empty() ? 0 : mean_of_channels(values);
}

double shaft_ms(std::vector<PassTime> const& passes) {
    double sum = 0;
    for (PassTime const& pass : passes)
        sum += std::ranges::find(OTHER_PASSES, pass.name) == OTHER_PASSES.end() ? pass.gpu_ms : 0;
    return sum;
}

double timed_frame(Stage& stage, View const& view, World const& world, Extent size) {
    stage.draw(view, world, size);
    stage.renderer().wait();
    return shaft_ms(stage.renderer().timings());
}

} // namespace

ShaftLevel exact_shafts() { return {"exact", {{"shafts", "exact"}}}; }
ShaftLevel no_shafts() { return {"off", {{"shafts", "off"}}}; }
ShaftLevel even_steps(int count) {
    return {fmt::format("{} steps", count), {{"shafts", "exact"}, {"exact_steps", std::to_string(count)}}};
}
std::vector<ShaftLevel> shaft_levels() {
    return {no_shafts(), even_steps(20), {"fast", {{"shafts", "fast"}}}, {"default", {{"shafts", "default"}}}};
}

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

ShaftPicture draw_shafts(Stage& stage, View view, ShaftLevel const& level, Extent size, int timed) {
    apply_overrides(view.settings, level.settings);
    World const world = stage.prepare(view);
    ShaftPicture picture;
    picture.ms = timed_frame(stage, view, world, size);
    picture.radiance = stage.renderer().radiance();
    if (std::size_t const count = count_non_finite(picture.radiance); count > 0) {
        throw Error(ErrorKind::device, fmt::format("{} rendered pixels are not finite", count), "view " + view.name,
                    "this is a fault of the renderer or its device: try another --device");
    }
    picture.mean_inscattered = mean_inscattered(stage.renderer());
    std::vector<double> times;
    for (int i = 0; i < timed; ++i) times.push_back(timed_frame(stage, view, world, size));
    if (timed > 0) picture.ms = median(times);
    return picture;
}

ShaftCase make_shaft_case(Stage& stage, View view, Extent size) {
    view.settings.sun_disc = view.settings.stars = false;
    view.settings.aa = 1;
    ShaftCase made;
    made.size = size;
    FloatImage const off = draw_shafts(stage, view, no_shafts(), size, 0).radiance;
    made.exact = draw_shafts(stage, view, exact_shafts(), size, 0);
    made.mask = where_apart(off, made.exact.radiance, SHAFT_MASK);
    made.view = std::move(view);
    return made;
}

ShaftError shaft_error(FloatImage const& picture, ShaftCase const& given) {
    ShaftError error;
    error.map = compute_hdr_flip(given.exact.radiance, picture);
    error.flip = error.map.mean;
    error.masked_flip = masked_mean(error.map.error, given.mask);
    Metrics const metrics = measure(picture, given.exact.radiance);
    error.rmse = metrics.rel_rmse.value();
    error.p999 = metrics.p999.value() / given.exact.mean_inscattered;
    return error;
}

} // namespace alpenglow
