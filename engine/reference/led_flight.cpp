#include "reference/led_flight.h"

#include "reference/shell_walk.h"

#include <array>
#include <cmath>

namespace alpenglow {

namespace {

constexpr int SHELLS = 14;
constexpr int LONGEST_PIECES = 8;       ///< of a ray in a shell
constexpr double PIECE_LENGTH = 60'000; ///< [m] the sun's height changes by half a degree along it
constexpr double PIECE_DEPTH = 0.5;     ///< optical; a piece may be more where there are not enough of them
constexpr int MOST_PIECES = 2 * SHELLS * LONGEST_PIECES;
constexpr double PLAIN_SHARE = 0.2;     ///< of the choices, made without regard to brightness

struct Piece {
    double begin, end;
    double plain, bright; ///< light scattered in it, for light that is the same everywhere and as it is
};

} // namespace

LedFlight::LedFlight(Medium const& medium, LightGuide const& guide) : guide_(&guide) {
    for (int i = 1; i <= SHELLS; ++i) {
        // Thin shells near the ground, where the aerosol is.
        double const low = double(i - 1) / SHELLS, high = double(i) / SHELLS;
        double const bottom = medium.top * std::pow(low, 1.5), top = medium.top * std::pow(high, 1.5);
        Shell shell{glm::dvec3(0), glm::dvec3(0)};
        for (Component const& component : medium.components) {
            double const column = profile_column(component.profile, top) - profile_column(component.profile, bottom);
            double const there = column / (top - bottom);
            shell.scattering += component.scattering * there;
            shell.extinction += component.extinction * there;
        }
        top_radii_.push_back(medium.radius + top);
        shells_.push_back(shell);
    }
}

LedFlight::Choice LedFlight::choose(Ray const& ray, double from, double to, glm::dvec3 const& carried, double u) const {
    glm::dvec3 const share = carried / (carried.x + carried.y + carried.z);
    std::array<Piece, MOST_PIECES> pieces;
    std::size_t count = 0;
    double depth = 0, plain = 0, bright = 0;
    for (ShellWalk walk(top_radii_, ray, from, to); walk.next();) {
        Shell const& shell = shells_[walk.shell()];
        double const scattering = dot(share, shell.scattering), extinction = dot(share, shell.extinction);
        double const length = walk.end() - walk.begin();
        double const wanted = std::max(length / PIECE_LENGTH, extinction * length / PIECE_DEPTH);
        int const parts = 1 + static_cast<int>(std::min(wanted, LONGEST_PIECES - 1.0));
        for (int i = 0; i < parts && count < pieces.size(); ++i) {
            double const step = length / parts, begin = walk.begin() + i * step;
            if (!(begin + step > begin)) continue; // shorter than a rounding
            depth += extinction * step;
            Piece& piece = pieces[count++];
            double const seen = std::exp(0.5 * extinction * step - depth);
            piece = {begin, begin + step, scattering * step * seen + 1e-300 * step, 0};
            piece.bright = piece.plain * guide_->at(ray.at(begin + 0.5 * step)).all();
            plain += piece.plain;
            bright += piece.bright;
        }
    }
    std::size_t chosen = 0;
    double below = 0, here = 0;
    for (;; ++chosen) {
        here = PLAIN_SHARE * pieces[chosen].plain / plain + (1 - PLAIN_SHARE) * pieces[chosen].bright / bright;
        if (u < below + here || chosen + 1 == count) break;
        below += here;
    }
    Piece const& piece = pieces[chosen];
    double const width = piece.end - piece.begin;
    return {piece.begin + std::min((u - below) / here, 1.0) * width, here / width};
}

} // namespace alpenglow
