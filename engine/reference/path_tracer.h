#pragma once

#include "reference/first_flight.h"
#include "reference/ground.h"
#include "reference/led_flight.h"
#include "reference/random.h"
#include "reference/sunlight.h"
#include "reference/tracking.h"

namespace alpenglow {

/// Radiance along rays by volumetric Monte Carlo without bias: paths start at the camera, take the sun's light at every
/// event in air and on ground, and end by leaving, by being absorbed, by Russian roulette, or at `orders` events.
///
/// All three channels go along one path. Through thick air a flight is tracked in a channel that is chosen by the light
/// the path carries, and weighted by all channels' probabilities of having made it (the balance heuristic of Veach and
/// Guibas 1995, as for wavelengths in Wilkie et al. 2014), so that the sum over channels never changes by the choice;
/// likewise the constituent of the air that turns it. A path's first few flights, where some light gets through,
/// collide where it is bright or pass.
class PathTracer {
public:
    struct Options {
        int orders = 0; ///< events in air or on ground between sun and camera at most; 0: any number
    };

    /// `ground` must outlive this. Throws Error(bad_input) for a medium with more than 16 components.
    PathTracer(Medium const& medium, Ground const& ground, LightSource const& light, Options const& options);
    PathTracer(PathTracer const&) = delete;
    PathTracer& operator=(PathTracer const&) = delete;

    struct Estimate {
        glm::dvec3 radiance{0};
        long events = 0; ///< collisions with air and ground that were simulated
    };

    /// The mean of `paths` paths along one ray from `origin`, numbered from `first_index` in the set `key`; the sets of
    /// other rays may continue it. `pixel_angle` [rad] says how wide the ray is where it meets procedural ground.
    Estimate trace(glm::dvec3 const& origin, glm::dvec3 const& direction, double pixel_angle, std::uint64_t key,
                   std::uint32_t first_index, int paths) const;

    /// Whether a ray ends on planet or scene.
    bool meets_ground(glm::dvec3 const& origin, glm::dvec3 const& direction) const {
        return !ground_->sees_out(origin, direction);
    }

private:
    struct Path;
    void walk_from_air(Path& path) const;
    void walk_from_ground(Path& path, GroundPoint const& point) const;
    bool scatter_in_air(Path& path) const;
    bool scatter_on_ground(Path& path, GroundPoint const& point) const;
    void walk(Path& path) const;
    bool fly(Path& path, Ray const& ray, std::optional<GroundPoint> const& ground) const;
    bool fly_tracked(Path& path, Ray const& ray, Span const& air, DepthAlong const& depth,
                     glm::dvec3 const& start) const;
    bool survives(Path& path, double light) const;

    Medium medium_;
    OpticalDepth depth_;
    Tracking tracking_;
    Ground const* ground_;
    Sunlight sun_;
    LightGuide guide_;
    LedFlight led_flight_;
    Options options_;
};

} // namespace alpenglow
