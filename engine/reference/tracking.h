#pragma once

#include "reference/medium.h"
#include "reference/random.h"
#include "reference/ray.h"

#include <optional>

namespace alpenglow {

/// Free flights through a medium by delta tracking (Woodcock 1965): tentative collisions in a majorant, which is
/// constant in each of a few shells of altitude, are real with the probability extinction / majorant.
class Tracking {
public:
    explicit Tracking(Medium const& medium);

    /// The distance [m] of the first collision in a colour channel (0..2) along the ray, between `from` and `to`;
    /// nothing where the light gets through. The stretch must be inside the medium and outside the planet.
    std::optional<double> fly(Ray const& ray, double from, double to, int channel, PathNumbers& numbers) const;

private:
    Medium medium_;
    std::vector<double> top_radii_;     ///< of the shells, from the ground up
    std::vector<glm::dvec3> majorants_; ///< [1/m]
};

} // namespace alpenglow
