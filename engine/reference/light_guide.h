#pragma once

#include "reference/medium.h"
#include "reference/sunlight.h"

#include <vector>

namespace alpenglow {

/// Roughly how bright the air is in which place, and from which directions light arrives there: what light paths are
/// led by. Wrong values cost noise, never truth. Places are told apart by altitude and the sun's zenith angle,
/// directions by their angles with the zenith and, around it, with the sun; light is grey here, ground is black, and
/// what was scattered once is scattered evenly ever after.
class LightGuide {
public:
    /// Even light where there is no sun. Takes some tenths of a second.
    LightGuide(Medium const& medium, Sunlight const& sun);

    /// Sunlight and what is scattered, relative, each above 0.
    struct Light {
        double direct, diffuse;

        double all() const { return direct + diffuse; }
    };
    Light at(glm::dvec3 const& place) const;

    /// What is known of the directions at one place.
    class Directions {
    public:
        Directions(LightGuide const& guide, glm::dvec3 const& place);
        /// For numbers in (0, 1).
        glm::dvec3 sample(double u, double v) const;
        /// Of the choice of this unit vector [1/sr].
        double density(glm::dvec3 const& direction) const;

    private:
        float const* rows_;
        glm::dvec3 up_, ahead_, aside_; ///< ahead: the sun's side of the horizon
    };

private:
    static constexpr int ALTITUDES = 20, SUNS = 40, ROWS = 16, COLUMNS = 6;
    static constexpr int NODES = ALTITUDES * SUNS, BINS = ROWS * COLUMNS;
    /// Cumulative shares: of the rows, then of the columns of each row.
    static constexpr int NODE_SIZE = (ROWS + 1) + ROWS * (COLUMNS + 1);

    struct Grid {
        double row, column; ///< fractional places of altitude and sun
    };
    Grid grid_at(glm::dvec3 const& place) const;
    /// Of a node, in the plane of one great circle through the sun [m]; at the altitude `lowest` [m] at least.
    glm::dvec3 place_of(int node, double lowest) const;
    /// For each node and direction, the light that the air along it scatters: radiance times solid angle.
    void gather(Medium const& medium, std::vector<float>& bins) const;
    /// Radiance of the air along a ray that starts in it.
    double scattered_along(Medium const& medium, Ray const& ray) const;
    void set_shares(std::vector<float> const& bins);

    double radius_, top_;
    glm::dvec3 to_sun_;
    std::vector<Light> light_;  ///< for each node
    std::vector<float> shares_; ///< NODE_SIZE for each node
};

} // namespace alpenglow
