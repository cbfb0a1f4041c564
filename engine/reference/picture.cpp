#include "reference/picture.h"

#include "core/error.h"
#include "core/parallel.h"

#include <array>
#include <cmath>
#include <cstring>
#include <numeric>

namespace alpenglow {

namespace {

/// Paths that share a camera's ray and its own work: fewer where a pixel holds much detail.
constexpr std::uint32_t PATHS_OF_SKY_RAY = 16, PATHS_OF_GROUND_RAY = 8;
constexpr std::size_t HEADER_BYTES = 4 * sizeof(std::int64_t);

glm::dvec3 ray_direction(Camera const& camera, Extent size, double x, double y) {
    double const half = std::tan(0.5 * camera.vertical_fov), aspect = double(size.width) / size.height;
    glm::dvec3 const in_camera((2 * x / size.width - 1) * half * aspect, (1 - 2 * y / size.height) * half, -1);
    return normalize(camera.world_from_camera * in_camera);
}

/// The place of a pixel on a curve through the picture that fills each square of 2^n pixels before the next (Morton).
std::uint64_t curve_place(std::uint32_t x, std::uint32_t y) {
    std::uint64_t place = 0;
    for (int bit = 0; bit < 16; ++bit) {
        place |= std::uint64_t{(x >> bit) & 1} << (2 * bit) | std::uint64_t{(y >> bit) & 1} << (2 * bit + 1);
    }
    return place;
}

} // namespace

PathTracer::Estimate trace_pixel(PathTracer const& tracer, Camera const& camera, Extent size, std::uint32_t x,
                                 std::uint32_t y, std::uint64_t seed, int pass) {
    double const pixel_angle = 2 * std::tan(0.5 * camera.vertical_fov) / size.height;
    std::uint64_t const first_path = curve_place(x, y) * PASS_PATHS;
    std::uint64_t const key = hash(hash(seed, static_cast<std::uint64_t>(pass)), first_path >> 32);
    auto const first = static_cast<std::uint32_t>(first_path);
    bool const ground = tracer.meets_ground(camera.position, ray_direction(camera, size, x + 0.5, y + 0.5));
    std::uint32_t const together = ground ? PATHS_OF_GROUND_RAY : PATHS_OF_SKY_RAY;
    PathTracer::Estimate mean;
    for (std::uint32_t i = 0; i < PASS_PATHS; i += together) {
        PathNumbers numbers(hash(key, 0), (first + i) / together);
        double const u = numbers.next(), v = numbers.next();
        glm::dvec3 const direction = ray_direction(camera, size, x + u, y + v);
        PathTracer::Estimate const ray =
            tracer.trace(camera.position, direction, pixel_angle, key, first + i, static_cast<int>(together));
        mean.radiance += ray.radiance * (double(together) / PASS_PATHS);
        mean.events += ray.events;
    }
    return mean;
}

bool TracedPicture::add_pass(PathTracer const& tracer, Camera const& camera, std::uint64_t seed, int threads,
                             std::function<void()> const& row_done, std::atomic<bool> const* stop) {
    std::vector<glm::dvec3> traced(size_.pixels());
    std::vector<long> events(size_.height);
    parallel_for(static_cast<int>(size_.height), threads, [&](int row) {
        for (std::uint32_t x = 0; x < size_.width; ++x) {
            if (stop && *stop) return;
            auto const y = static_cast<std::uint32_t>(row);
            PathTracer::Estimate const pixel = trace_pixel(tracer, camera, size_, x, y, seed, passes_);
            traced[std::size_t{y} * size_.width + x] = pixel.radiance;
            events[y] += pixel.events;
        }
        if (row_done) row_done();
    });
    if (stop && *stop) return false;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        (passes_ % 2 == 0 ? pixels_[i].even : pixels_[i].odd) += traced[i];
        pixels_[i].squares += traced[i] * traced[i];
    }
    ++passes_;
    events_ = std::accumulate(events.begin(), events.end(), events_);
    return true;
}

glm::dvec3 TracedPicture::mean(std::size_t pixel) const {
    return (pixels_[pixel].even + pixels_[pixel].odd) / double(passes_);
}

glm::dvec3 TracedPicture::variance(std::size_t pixel) const {
    glm::dvec3 const m = mean(pixel);
    glm::dvec3 const of_pass = max(glm::dvec3(0), pixels_[pixel].squares / double(passes_) - m * m);
    return of_pass / double(passes_ - 1);
}

glm::dvec3 TracedPicture::half(std::size_t pixel, int which) const {
    int const even = (passes_ + 1) / 2;
    return which == 0 ? pixels_[pixel].even / double(even) : pixels_[pixel].odd / double(passes_ - even);
}

std::vector<std::byte> TracedPicture::state() const {
    std::array<std::int64_t, 4> const header{size_.width, size_.height, passes_, events_};
    std::vector<std::byte> bytes(HEADER_BYTES + pixels_.size() * sizeof(Pixel));
    std::memcpy(bytes.data(), header.data(), HEADER_BYTES);
    std::memcpy(bytes.data() + HEADER_BYTES, pixels_.data(), pixels_.size() * sizeof(Pixel));
    return bytes;
}

void TracedPicture::restore(std::span<std::byte const> state) {
    std::array<std::int64_t, 4> header{};
    if (state.size() == HEADER_BYTES + pixels_.size() * sizeof(Pixel)) {
        std::memcpy(header.data(), state.data(), HEADER_BYTES);
    }
    if (header[0] != size_.width || header[1] != size_.height || header[2] < 1 || header[2] > (1 << 30)) {
        throw Error(ErrorKind::bad_input, "is not the state of a picture of this size");
    }
    passes_ = static_cast<int>(header[2]);
    events_ = header[3];
    std::memcpy(pixels_.data(), state.data() + HEADER_BYTES, pixels_.size() * sizeof(Pixel));
}

} // namespace alpenglow
