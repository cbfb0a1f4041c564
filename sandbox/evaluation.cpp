#include "sandbox/evaluation.h"

#include "core/error.h"
#include "core/files.h"
#include "image/compare.h"
#include "image/exr.h"
#include "image/metrics.h"
#include "sandbox/published_figures.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <tuple>

namespace alpenglow {

namespace fs = std::filesystem;

namespace {

/// How to make a reference (again).
std::string making(fs::path const& folder, fs::path const& view_file) {
    return fmt::format("make it: alpenglow reference {} --size 320x180 --out {}", view_file.string(), folder.string());
}

double number_attribute(RadianceRecord const& record, std::string const& name, fs::path const& file,
                        std::string const& advice) {
    double value = NAN;
    if (auto const found = record.attributes.find(name); found != record.attributes.end()) {
        std::string const& text = found->second;
        std::from_chars(text.data(), text.data() + text.size(), value);
    }
    if (!(value >= 0)) throw Error(ErrorKind::bad_input, "has no " + name, file.string(), advice);
    return value;
}

/// Over the colour channels of all pixels.
double sum_of_channels(FloatImage const& image) {
    double sum = 0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) sum += i % 4 == 3 ? 0 : static_cast<double>(image.rgba[i]);
    return sum;
}

std::ptrdiff_t published_place(std::string const& view) {
    return std::ranges::find(PUBLISHED_FIGURES, view, &PublishedFigures::view) - PUBLISHED_FIGURES.begin();
}

} // namespace

std::vector<fs::path> comparison_views() {
    fs::path const folder = assets_folder() / "views/comparison";
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_entry const& entry : fs::directory_iterator(folder, error)) {
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    }
    if (files.empty())
        throw Error(ErrorKind::bad_input, "there are no comparison views", folder.string(), "give --views");
    std::ranges::sort(files, {}, [](fs::path const& file) {
        std::string const name = file.stem().string();
        return std::tuple(published_place(name), name);
    });
    return files;
}

ViewReference load_reference(fs::path const& folder, fs::path const& view_file) {
    std::string const name = view_file.stem().string(), advice = making(folder, view_file);
    fs::path const file = folder / (name + ".exr");
    std::error_code error;
    if (!fs::exists(file, error))
        throw Error(ErrorKind::bad_input, "the view " + name + " has no reference", file.string(), advice);
    RadianceRecord record = read_record(file);
    if (count_non_finite(record.radiance) > 0)
        throw Error(ErrorKind::bad_input, "has pixels that are not finite", file.string(), advice);
    if (!(sum_of_channels(record.radiance) > 0)) throw Error(ErrorKind::bad_input, "is black", file.string(), advice);
    double const flip = number_attribute(record, "noise_flip", file, advice);
    return {std::move(record.radiance), flip, number_attribute(record, "noise_rmse", file, advice)};
}

ViewError measure_error(Stage& stage, View const& view, ViewReference const& reference) {
    World const world = stage.prepare(view);
    stage.draw(view, world, reference.radiance.extent);
    FloatImage picture = stage.renderer().radiance();
    if (std::size_t const count = count_non_finite(picture); count > 0) {
        throw Error(ErrorKind::device, fmt::format("{} rendered pixels are not finite", count), "view " + view.name,
                    "this is a fault of the renderer or its device: try another --device");
    }
    FlipResult flip = compute_hdr_flip(reference.radiance, picture);
    double const rmse = measure(picture, reference.radiance).rmse.value();
    double const bias = sum_of_channels(picture) / sum_of_channels(reference.radiance) - 1;
    return {flip.mean, rmse, bias, std::move(flip), std::move(picture)};
}

} // namespace alpenglow
