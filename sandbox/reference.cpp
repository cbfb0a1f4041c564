#include "core/error.h"
#include "core/files.h"
#include "core/progress.h"
#include "image/exr.h"
#include "reference/picture.h"
#include "sandbox/commands.h"
#include "sandbox/traced_view.h"

#include <atomic>
#include <csignal>
#include <fmt/format.h>
#include <mutex>

namespace alpenglow {

namespace {

std::atomic<bool> interrupted = false;

FloatImage to_image(TracedPicture const& picture, auto const& value_at) {
    FloatImage image(picture.size());
    for (std::size_t i = 0; i < picture.size().pixels(); ++i) {
        glm::vec3 const value(value_at(i));
        std::copy_n(&value.x, 3, &image.rgba[i * 4]);
        image.rgba[i * 4 + 3] = 1;
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
    return {compute_hdr_flip(a, b).mean, compare_radiance(b, a).rmse};
}

} // namespace

} // namespace alpenglow
