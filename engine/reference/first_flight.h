#pragma once

#include "reference/light_guide.h"
#include "reference/medium.h"
#include "reference/optical_depth.h"
#include "reference/sunlight.h"

#include <vector>

namespace alpenglow {

/// Where a camera's ray meets the air for the first time: always somewhere along it, however thin the air. The density
/// of the choice is constant in each of some dozens of cells: partly as the sunlight that is scattered once to the
/// camera, partly as what is scattered where the air is bright, with a little everywhere; the weight makes up for what
/// it is not. Cells end where the planet's shadow does, and are halved where the light in them is uneven: what is
/// chosen rarely must not be bright.
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
    /// Light per length of the ray, each up to a factor.
    struct Light {
        double once;   ///< scattered once
        double bright; ///< scattered, of the light that the guide knows
        double plain;  ///< scattered, of light that is the same everywhere
    };
    struct Cell {
        double from, to; ///< [m]
        Light start, middle, end;

        Light light() const;
        bool uneven() const;
    };
    struct Surroundings {
        Medium const& medium;
        Sunlight const& sun;
        LightGuide const& guide;
    };
    std::vector<double> first_edges(double from, double to, double radius) const;
    void cut_at_nodes(std::vector<double>& edges, Medium const& medium) const;
    void cut_at_shadow(std::vector<double>& edges, Sunlight const& sun) const;
    Light light_at(Surroundings const& around, double distance) const;
    std::vector<Cell> make_cells(Surroundings const& around, std::vector<double> const& edges) const;
    void halve_uneven(Surroundings const& around, std::vector<Cell>& cells) const;
    void set_shares(std::vector<Cell> const& cells);

    Ray const& ray_;
    DepthAlong depth_;
    glm::dvec3 start_;               ///< of depth_
    std::vector<double> edges_;      ///< distances [m], increasing
    std::vector<double> cumulative_; ///< share of the choices up to each edge: 0 … 1
};

} // namespace alpenglow
