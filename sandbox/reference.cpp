#include "core/error.h"
#include "core/files.h"
#include "core/progress.h"
#include "image/compare.h"
#include "image/exr.h"
#include "image/flip.h"
#include "reference/picture.h"
#include "sandbox/commands.h"
#include "sandbox/traced_view.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <mutex>
#include <set>

namespace alpenglow {

namespace {

std::atomic<bool> interrupted = false;

/// The bits of a mantissa that are stored: radiance to 8e-6 of itself, a variance, which is a rough figure, to 0.4 %.
/// The rest would be noise, which no compression makes smaller.
constexpr int RADIANCE_BITS = 16, VARIANCE_BITS = 7;

FloatImage to_image(TracedPicture const& picture, auto const& value_at) {
    FloatImage image(picture.size());
    for (std::size_t i = 0; i < picture.size().pixels(); ++i) {
        glm::vec3 const value(value_at(i));
        std::copy_n(&value.x, 3, &image.rgba[i * 4]);
        image.rgba[i * 4 + 3] = 1;
    }
    return image;
}

FloatImage with_mantissas_of(FloatImage image, int bits) {
    std::uint32_t const step = 1u << (23 - bits);
    for (float& value : image.rgba) {
        value = std::bit_cast<float>((std::bit_cast<std::uint32_t>(value) + step / 2) & ~(step - 1));
    }
    return image;
}

/// The difference of two halves of the passes.
struct Noise {
    double flip = 0, rmse = 0;
};

Noise measure_noise(TracedPicture const& picture) {
    FloatImage const a = to_image(picture, [&](std::size_t i) { return picture.half(i, 0); });
    FloatImage const b = to_image(picture, [&](std::size_t i) { return picture.half(i, 1); });
    return {compute_hdr_flip(a, b).mean, compare(a, b).rmse};
}

std::string orders_text(int orders) { return orders == 0 ? "all" : std::to_string(orders); }

/// What decides the picture: a state file of another recipe is of another picture.
std::string recipe(View view, ReferenceOptions const& options) {
    view.scene = std::filesystem::path(view.scene).filename().string(); // pictures are for other machines too
    return fmt::format("{}seed {}, orders {}, sun {}, {}x{}\n", view_text(view), options.seed,
                       orders_text(options.orders), options.point_sun ? "point" : "disc", options.size.width,
                       options.size.height);
}

/// A picture is named after its view's file.
void require_different_names(std::vector<View> const& views) {
    std::set<std::string> names;
    for (View const& view : views) {
        if (names.insert(view.name).second) continue;
        throw Error(ErrorKind::wrong_use, "two views are named " + view.name + ", and so would be their pictures", {},
                    "trace them into different folders");
    }
}

/// What would stop a later view is said before the first is traced.
void require_inputs(View const& view) {
    Planet const planet = load_planet(view.planet);
    if (view.scene_camera.empty()) make_world(view, planet); // the scene's own is known with the scene
    if (view.scene.empty() || view.scene == "default" || std::filesystem::exists(view.scene)) return;
    throw Error(ErrorKind::bad_input, "there is no such scene", view.scene, "correct the view " + view.name);
}

std::filesystem::path picture_file(View const& view, ReferenceOptions const& options) {
    return options.out / (view.name + ".exr");
}

std::filesystem::path state_file(View const& view, ReferenceOptions const& options) {
    return options.out / (view.name + ".state");
}

/// Whether an earlier run made the picture as well as it is asked for now.
bool is_finished(View const& view, ReferenceOptions const& options) {
    std::filesystem::path const file = picture_file(view, options);
    if (std::filesystem::exists(state_file(view, options)) || !std::filesystem::exists(file)) return false;
    std::map<std::string, std::string> attributes = read_record(file).attributes;
    if (attributes["recipe"] != recipe(view, options)) return false;
    double const samples = std::strtod(attributes["samples"].c_str(), nullptr);
    double const noise = std::strtod(attributes["noise_flip"].c_str(), nullptr);
    return samples >= options.samples || noise <= options.noise;
}

/// One view on its way to a picture, and the file that keeps what is done so far.
class Tracing {
public:
    Tracing(View const& view, ReferenceOptions const& options)
        : view_(view), options_(options), recipe_(recipe(view, options)),
          traced_(view, options.point_sun ? SunShape::point : SunShape::disc, options.orders),
          picture_(options.size) {
        if (options.resume && std::filesystem::exists(state_file(view_, options_))) restore();
    }

    /// False where the user interrupted it.
    bool finish() {
        int const most = std::max(2, (options_.samples + PASS_PATHS - 1) / PASS_PATHS); // two halves
        std::atomic<std::size_t> rows = static_cast<std::size_t>(picture_.passes()) * options_.size.height;
        Progress progress("tracing " + view_.name, static_cast<std::size_t>(most) * options_.size.height, rows);
        std::mutex mutex;
        auto const row_done = [&] {
            std::size_t const done = ++rows;
            std::lock_guard const lock(mutex);
            progress.update(done, note_);
        };
        while (picture_.passes() < most && !quiet_enough()) {
            if (!picture_.add_pass(traced_.tracer(), traced_.camera(), options_.seed, options_.threads, row_done,
                                   &interrupted)) {
                return false;
            }
            save();
        }
        write();
        return true;
    }

private:
    void save() const {
        std::vector<std::byte> bytes(recipe_.size() + 1);
        std::memcpy(bytes.data(), recipe_.c_str(), bytes.size());
        std::vector<std::byte> const state = picture_.state();
        bytes.insert(bytes.end(), state.begin(), state.end());
        write_file(state_file(view_, options_), bytes);
    }

    void restore() {
        std::vector<std::byte> const bytes = read_file(state_file(view_, options_));
        auto const* const text = reinterpret_cast<char const*>(bytes.data());
        std::size_t const length = bytes.empty() ? 0 : strnlen(text, bytes.size());
        if (std::string_view(text, length) != recipe_) {
            throw Error(ErrorKind::bad_input, "was made for another view, size, seed, sun or number of orders",
                        state_file(view_, options_).string(), "leave --resume out to begin again");
        }
        try {
            picture_.restore(std::span(bytes).subspan(std::min(length + 1, bytes.size())));
        } catch (Error const& error) {
            throw Error(ErrorKind::bad_input, error.what(), state_file(view_, options_).string(), "delete it");
        }
    }

    /// Looked at after 4, 8, 12, … passes.
    bool quiet_enough() {
        if (options_.noise == 0 || picture_.passes() < 4 || picture_.passes() % 4 != 0) return false;
        Noise const noise = measure_noise(picture_);
        note_ = fmt::format("FLIP between halves {:.4f}", noise.flip);
        return noise.flip <= options_.noise;
    }

    void write() const {
        RadianceRecord record;
        auto const mean = [&](std::size_t i) { return picture_.mean(i); };
        auto const variance = [&](std::size_t i) { return picture_.variance(i); };
        record.radiance = with_mantissas_of(to_image(picture_, mean), RADIANCE_BITS);
        record.variance = with_mantissas_of(to_image(picture_, variance), VARIANCE_BITS);
        Noise const noise = measure_noise(picture_);
        int const samples = picture_.passes() * PASS_PATHS;
        record.attributes = {
            {"command", fmt::format("alpenglow reference {}.json --samples {} --orders {} --size {}x{} --seed {}{}",
                                    view_.name, samples, orders_text(options_.orders), options_.size.width,
                                    options_.size.height, options_.seed, options_.point_sun ? " --sun point" : "")},
            {"recipe", recipe_},
            {"seed", std::to_string(options_.seed)},
            {"samples", std::to_string(samples)},
            {"passes", std::to_string(picture_.passes())},
            {"noise_flip", fmt::format("{:.5g}", noise.flip)},
            {"noise_rmse", fmt::format("{:.5g}", noise.rmse)},
        };
        write_exr(picture_file(view_, options_), record);
        std::filesystem::remove(state_file(view_, options_));
        fmt::print("{}: {} samples, {:.1f} events each; between halves FLIP {:.4f}, RMSE {:.3g}\n", view_.name, samples,
                   double(picture_.events()) / (double(samples) * double(options_.size.pixels())), noise.flip,
                   noise.rmse);
        std::fflush(stdout);
    }

    View view_;
    ReferenceOptions options_;
    std::string recipe_;
    TracedView traced_;
    TracedPicture picture_;
    std::string note_;
};

} // namespace

int reference(ReferenceOptions const& options) {
    std::vector<View> views;
    for (std::filesystem::path const& file : options.views) views.push_back(load_view(file));
    require_different_names(views);
    for (View const& view : views) require_inputs(view);
    require_writable_folder(options.out);
    std::signal(SIGINT, [](int) { interrupted = true; });
    for (View const& view : views) {
        if (options.resume && is_finished(view, options)) continue;
        if (Tracing(view, options).finish()) continue;
        throw Error(ErrorKind::bad_input, "interrupted", view.name, "go on with --resume");
    }
    return 0;
}

} // namespace alpenglow
