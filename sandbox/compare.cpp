#include "core/error.h"
#include "core/files.h"
#include "image/codec.h"
#include "image/color.h"
#include "image/exr.h"
#include "image/flip.h"
#include "image/heat_map.h"
#include "image/metrics.h"
#include "sandbox/commands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alpenglow {

namespace {

struct LoadedPicture {
    FloatImage linear;
    bool is_radiance = false; ///< of an EXR; else what a screen shows
};

struct Comparison {
    std::optional<HdrFlipResult> flip; ///< of radiance
    FlipResult flip_ldr;
    Metrics metrics;
};

bool is_exr(std::span<std::byte const> bytes) {
    constexpr std::array magic{std::byte{0x76}, std::byte{0x2f}, std::byte{0x31}, std::byte{0x01}};
    return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

LoadedPicture load(std::filesystem::path const& path) {
    std::vector<std::byte> const bytes = read_file(path);
    if (is_exr(bytes)) return {read_exr(path), true};
    try {
        return {linear_from_srgb(decode_picture(bytes)), false};
    } catch (Error const& error) {
        throw Error(error.kind(), error.what(), path.string(), "give a whole PNG or EXR file");
    }
}

void require_same_kind(LoadedPicture const& test, LoadedPicture const& reference, CompareOptions const& options) {
    if (test.is_radiance != reference.is_radiance) {
        throw Error(ErrorKind::bad_input, "radiance can't be compared with a displayed picture",
                    options.test.string() + " and " + options.reference.string(), "give two EXR or two PNG files");
    }
    if (options.exposure && !test.is_radiance) {
        throw Error(ErrorKind::wrong_use, "--exposure is of no use to PNG files, which are displayed already", {},
                    "leave it out, or give EXR files");
    }
}

Comparison compare_radiance(FloatImage const& test, FloatImage const& reference, double exposure) {
    Metrics const metrics = measure(test, reference);
    return {compute_hdr_flip(reference, test),
            compute_flip(exponential_display(reference, exposure), exponential_display(test, exposure)), metrics};
}

Comparison compare_displayed(FloatImage const& test, FloatImage const& reference) {
    constexpr double white = 1;
    Metrics const metrics = measure(test, reference, white);
    return {{}, compute_flip(reference, test), metrics};
}

/// JSON has no number for what is not defined or infinite.
nlohmann::ordered_json number(std::optional<double> value) {
    return value && std::isfinite(*value) ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

void print_json(Comparison const& c) {
    Metrics const& m = c.metrics;
    nlohmann::ordered_json const json{{"flip", number(c.flip ? std::optional(c.flip->mean) : std::nullopt)},
                                      {"flip_ldr", number(c.flip_ldr.mean)},
                                      {"mse", number(m.mse)},
                                      {"rmse", number(m.rmse)},
                                      {"rel_rmse", number(m.rel_rmse)},
                                      {"psnr", number(m.psnr)},
                                      {"bias", {number(m.bias[0]), number(m.bias[1]), number(m.bias[2])}},
                                      {"p999", number(m.p999)},
                                      {"non_finite", m.non_finite}};
    fmt::print("{}\n", json.dump());
}

std::string text(std::optional<double> value, char const* format = "{:.6g}") {
    return value ? fmt::format(fmt::runtime(format), *value) : "undefined";
}

void print_row(std::string_view name, std::string const& value, std::string_view meaning) {
    fmt::print("{:<12}{:<26}{}\n", name, value, meaning);
}

std::string exposures_text(ExposureRange const& range) {
    return fmt::format("HDR FLIP, mean; {} exposures from {:.2f} to {:.2f} stops", range.count, range.start,
                       range.stop);
}

void print_table(Comparison const& c, double exposure) {
    Metrics const& m = c.metrics;
    print_row("flip", c.flip ? fmt::format("{:.6f}", c.flip->mean) : "undefined",
              c.flip ? exposures_text(c.flip->exposures) : "HDR FLIP needs radiance, of EXR files");
    print_row("flip_ldr", fmt::format("{:.6f}", c.flip_ldr.mean),
              c.flip ? fmt::format("LDR FLIP, mean; displayed with exposure {:g}", exposure) : "LDR FLIP, mean");
    print_row("mse", text(m.mse), "mean square error, linear RGB");
    print_row("rmse", text(m.rmse), "its root");
    print_row("rel_rmse", text(m.rel_rmse), "rmse over the reference's mean");
    print_row("psnr", text(m.psnr, "{:.2f} dB"), c.flip ? "peak: the reference's largest" : "peak: white");
    print_row(
        "bias",
        fmt::format("{} {} {}", text(m.bias[0], "{:+.4f}"), text(m.bias[1], "{:+.4f}"), text(m.bias[2], "{:+.4f}")),
        "of red, green, blue; relative, + is too bright");
    print_row("p999", text(m.p999), "99.9 % of absolute errors are at most this");
    print_row("non_finite", text(m.non_finite), "share of pixels; error 1 in FLIP, left out of the rest");
}

} // namespace

int compare(CompareOptions const& options) {
    LoadedPicture const test = load(options.test), reference = load(options.reference);
    require_same_kind(test, reference, options);
    double const exposure = options.exposure.value_or(0);
    Comparison const comparison = reference.is_radiance ? compare_radiance(test.linear, reference.linear, exposure)
                                                        : compare_displayed(test.linear, reference.linear);
    if (options.heatmap) {
        FlipResult const& flip = comparison.flip ? *comparison.flip : comparison.flip_ldr;
        write_png(*options.heatmap, heat_map(flip));
    }
    if (options.json)
        print_json(comparison);
    else
        print_table(comparison, exposure);
    return 0;
}

} // namespace alpenglow
