#pragma once

#include "scene/view.h"

#include <glm/gtc/quaternion.hpp>

#include <vector>

namespace alpenglow {

/// The smooth curve through a flight's keys, with a continuous velocity everywhere. Each quantity moves in the space
/// where its steps look even: height above the flight's ground as a logarithm, ground point and sun on great circles,
/// the camera's rotation as a quaternion in the local frame.
class FlightPath {
public:
    explicit FlightPath(Flight const& flight);
    View at(double time) const;

private:
    /// How fast [1/s] a segment's parameter runs, 0 to 1, at its two ends.
    struct Pace {
        double start, end;
    };

    template <typename Point>
    auto key_rate(std::vector<Point> const& points, std::vector<Pace> const& paces, std::size_t key) const;
    template <typename Point>
    Point on_curve(std::vector<Point> const& points, std::vector<Pace> const& paces, std::size_t segment,
                   double u) const;

    double log_height(std::size_t segment, double u) const;
    double height_integral(std::size_t segment, double end) const;
    Pace ground_pace(std::size_t segment) const;
    glm::dmat3 world_from_local(glm::dvec3 const& up) const;

    Flight const& flight_;
    glm::dvec3 pole_;                ///< of the local frames: far from the path, so that they turn smoothly along it
    std::vector<Pace> time_paces_;   ///< constant along each segment
    std::vector<Pace> ground_paces_; ///< in proportion to the height
    std::vector<double> log_heights_, fovs_, exposures_;
    std::vector<glm::dvec3> ups_;       ///< over the ground point
    std::vector<glm::dvec3> suns_;      ///< world
    std::vector<glm::dquat> rotations_; ///< local from camera
};

} // namespace alpenglow
