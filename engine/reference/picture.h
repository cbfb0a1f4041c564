#pragma once

#include "core/extent.h"
#include "reference/path_tracer.h"
#include "scene/camera.h"

#include <atomic>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace alpenglow {

/// Paths for each pixel in one pass: spread evenly together, and over squares of pixels too, so that neighbours' errors
/// cancel (Ahmed and Wonka 2020: a sequence in the order of a Morton curve). Passes are independent.
inline constexpr int PASS_PATHS = 256;

/// The mean over a pixel's square of one pass' paths. Depends on nothing but its arguments.
PathTracer::Estimate trace_pixel(PathTracer const& tracer, Camera const& camera, Extent size, std::uint32_t x,
                                 std::uint32_t y, std::uint64_t seed, int pass);

/// A picture that grows by passes, from which its noise is known: passes are independent, so that what they differ by
/// gives the variance of their mean, and two halves of them are two pictures.
class TracedPicture {
public:
    explicit TracedPicture(Extent size) : size_(size), pixels_(size.pixels()) {}

    Extent size() const { return size_; }
    int passes() const { return passes_; }
    long events() const { return events_; }

    /// Adds a pass on `threads` threads (0: one for each core), the same for any number of them. `row_done` is called
    /// from these threads after each row. Where `stop` becomes true, returns false soon, and the picture is as before.
    bool add_pass(PathTracer const& tracer, Camera const& camera, std::uint64_t seed, int threads,
                  std::function<void()> const& row_done = {}, std::atomic<bool> const* stop = nullptr);

    /// Pixels row by row from the top left. Needs one pass.
    glm::dvec3 mean(std::size_t pixel) const;
    /// Of the mean, by channel. Needs two passes.
    glm::dvec3 variance(std::size_t pixel) const;
    /// The mean of every other pass, from the first (0) or the second (1). Needs two passes.
    glm::dvec3 half(std::size_t pixel, int which) const;

    /// Everything, for `restore`.
    std::vector<std::byte> state() const;
    /// Throws Error(bad_input) where the bytes are not the state of a picture of this size.
    void restore(std::span<std::byte const> state);

private:
    struct Pixel {
        glm::dvec3 even{0}, odd{0}; ///< sums of the passes' means
        glm::dvec3 squares{0};
    };

    Extent size_;
    std::vector<Pixel> pixels_;
    int passes_ = 0;
    long events_ = 0;
};

} // namespace alpenglow
