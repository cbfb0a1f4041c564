#pragma once

#include "reference/light_guide.h"
#include "reference/medium.h"
#include "reference/optical_depth.h"
#include "reference/sunlight.h"

#include <vector>

namespace alpenglow {

/// Where a camera's ray meets the air for the first time: always somewhere along it, however thin the air. The density
/// of the choice is constant in each of a few dozen cells: partly as the sunlight that is scattered once to the camera,
/// partly as what is scattered where the air is bright; the weight makes up for what it is not.
class FirstFlight {
public:
    struct Choice {
        double distance;   ///< [m]
        glm::dvec3 weight; ///< transmittance from the camera over the density of the choice [m]
    };

    /// Between two distances inside the medium, with no ground between. `ray` must outlive this.
    FirstFlight(Medium const& medium, OpticalDepth const& depth, Sunlight const& sun, LightGuide const& guide,
                Ray const& ray, double from, double to);

    /// For a number in (0, 1).
    Choice choose(double u) const;
    /// Of the whole stretch.
    glm::dvec3 transmittance() const;

private:
    void add_cells(double from, double to, double radius);
    std::vector<double> cell_light(Medium const& medium, Sunlight const& sun, LightGuide const& guide) const;

    Ray const& ray_;
    DepthAlong depth_;
    glm::dvec3 start_; ///< of depth_
    std::vector<double> edges_;      ///< distances [m], increasing
    std::vector<double> cumulative_; ///< share of the choices up to each edge: 0 … 1
};

} // namespace alpenglow
