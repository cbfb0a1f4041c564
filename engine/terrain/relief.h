#pragma once

#include "terrain/fineness.h"
#include "terrain/heightfield.h"

#include <cstdint>
#include <glm/vec3.hpp>

namespace alpenglow {

struct ReliefSample {
    double altitude = 0; ///< [m]
    double gully = 0;    ///< about -1 at the bottom of a gully to 1 on a rib; 0 where there is neither
};

/// The ground as a function of the place: the eroded field, with gullies, crags and hummocks down to what is asked for,
/// or to what the vertices show there.
class Relief {
public:
    Relief(HeightField const& field, Fineness const& fineness, std::uint32_t seed, double planet_radius)
        : field_(field), fineness_(fineness), seed_(seed), radius_(planet_radius) {}

    /// With all that samples `spacing` [m] apart can show.
    ReliefSample sample(double east, double north, double spacing) const;
    double altitude(double east, double north) const; ///< [m]
    /// Scene frame [m]: the map point at horizontal distance d goes to arc length d on the sphere, altitude along its
    /// normal.
    glm::dvec3 position(double east, double north) const { return position(east, north, altitude(east, north)); }
    glm::dvec3 position(double east, double north, double altitude) const;
    /// Unit, scene frame, of the curved ground.
    glm::dvec3 normal(double east, double north) const;
    /// Unit, scene frame, away from the planet's centre.
    glm::dvec3 up(double east, double north) const;

    Fineness const& fineness() const { return fineness_; }
    HeightField const& field() const { return field_; }
    double planet_radius() const { return radius_; }

private:
    HeightField const& field_;
    Fineness const& fineness_;
    std::uint32_t seed_;
    double radius_;
};

} // namespace alpenglow
