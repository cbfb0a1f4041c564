#pragma once

#include "reference/ground.h"
#include "reference/optical_depth.h"

namespace alpenglow {

/// The sun above the air, and what comes from all other sides.
struct LightSource {
    glm::dvec3 to_sun{0, 0, 1};     ///< unit, world: the disc's centre
    double angular_radius = 0;      ///< [rad] of an even disc; 0: a point
    glm::dvec3 irradiance{1};       ///< across the direction to the sun, above the air
    glm::dvec3 background{0};       ///< radiance that enters the air from everywhere else, for tests
};

/// Irradiance across the direction to a point of the sun, through the air.
struct SunRay {
    glm::dvec3 direction; ///< unit, to that point
    glm::dvec3 irradiance{0};
};

/// The sun as a light path's event sees it.
class Sunlight {
public:
    /// The parts must outlive this.
    Sunlight(LightSource const& source, OpticalDepth const& depth, Ground const& ground, double top_radius);

    /// From a point of the disc, chosen evenly by numbers in [0, 1): u1 its distance from the centre, u2 the way round.
    /// Dark behind planet and scene.
    SunRay sample(glm::dvec3 const& place, double u1, double u2) const;
    /// From the disc's centre, as if no scene stood there.
    glm::dvec3 unshadowed(glm::dvec3 const& place) const;
    /// Whether the line from a place to the disc's centre passes the planet.
    bool misses_planet(glm::dvec3 const& place) const;
    LightSource const& source() const { return source_; }

private:
    glm::dvec3 through_air(glm::dvec3 const& place, glm::dvec3 const& direction) const;

    LightSource source_;
    OpticalDepth const* depth_;
    Ground const* ground_;
    double top_radius_;
    double disc_height_; ///< 1 - cos(angular radius)
};

} // namespace alpenglow
