#pragma once

#include "reference/path_tracer.h"
#include "support/statistics.h"

#include <cstdlib>
#include <string_view>

/// What the proofs of the path tracer share.
namespace alpenglow::test {

/// The long form of the proofs: many more paths, and so narrower bounds, which are multiples of the noise.
inline bool long_proofs() {
    char const* const value = std::getenv("ALPENGLOW_LONG_PROOFS");
    return value && std::string_view(value) == "1";
}

/// Batches of a measurement: 64, so that their own scatter tells the noise to a tenth; 25 times as many in the long
/// form.
inline int batches() { return long_proofs() ? 1600 : 64; }

/// Bound of a difference in standard deviations: of ten thousand right values one or two exceed it with the noise known
/// from 64 batches (Student's t), none of the few hundred that are tested should.
inline constexpr double BOUND = 4.5;

/// A tracer with all that it needs; stays where it is made.
struct TracedWorld {
    Ground ground;
    PathTracer tracer;

    TracedWorld(Planet const& planet, Medium const& medium, LightSource const& light, int orders,
                Scene const* scene = nullptr, Placement const& placement = {})
        : ground(planet, scene, placement), tracer(medium, ground, light, {.orders = orders}) {}
    TracedWorld(Planet const& planet, LightSource const& light, int orders, Scene const* scene = nullptr,
                Placement const& placement = {})
        : TracedWorld(planet, make_medium(planet), light, orders, scene, placement) {}
    TracedWorld(TracedWorld const&) = delete;
};

struct Measured {
    glm::dvec3 mean{0}, deviation{0}; ///< deviation of the mean
};

/// Radiance along a ray from batches that are independent of each other. The ray is a mathematical one: it sees the
/// planet's body as Lambertian.
inline Measured measure(PathTracer const& tracer, glm::dvec3 const& origin, glm::dvec3 const& direction, int paths,
                        std::uint64_t seed) {
    Tally tallies[3];
    for (int batch = 0; batch < batches(); ++batch) {
        std::uint64_t const key = hash(seed, static_cast<std::uint64_t>(batch));
        glm::dvec3 const radiance = tracer.trace(origin, direction, 0, key, 0, paths).radiance;
        for (int c = 0; c < 3; ++c) tallies[c].add(radiance[c]);
    }
    Measured measured;
    for (int c = 0; c < 3; ++c) measured.mean[c] = tallies[c].mean(), measured.deviation[c] = tallies[c].deviation();
    return measured;
}

} // namespace alpenglow::test
