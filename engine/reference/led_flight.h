#pragma once

#include "reference/light_guide.h"
#include "reference/medium.h"
#include "reference/ray.h"

namespace alpenglow {

/// Collisions that are forced, however thin the air, and led to where it is bright: the choice is even in each piece of
/// a ray through shells of altitude, with a share that is roughly the light which comes from it.
class LedFlight {
public:
    struct Choice {
        double distance; ///< [m]
        double density;  ///< of the choice [1/m]
    };

    LedFlight(Medium const& medium, LightGuide const& guide);

    /// Between two distances in the medium; `carried` is what each channel carries, `u` is in (0, 1).
    Choice choose(Ray const& ray, double from, double to, glm::dvec3 const& carried, double u) const;

private:
    LightGuide const* guide_;
    std::vector<double> top_radii_;
    struct Shell {
        glm::dvec3 scattering, extinction; ///< [1/m] the shell's mean
    };
    std::vector<Shell> shells_;
};

} // namespace alpenglow
