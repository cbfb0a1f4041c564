#include "terrain/relief.h"

#include "terrain/gullies.h"
#include "terrain/noise.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace alpenglow {

namespace {

/// How much of a wave of length `wave` vertices `spacing` apart can show.
double shown(double wave, double spacing) { return smooth_step(1.8 * spacing, 3.6 * spacing, wave); }

/// Ribs and gullies down the slope; each octave follows the slope that the ones before it made.
ReliefSample gullies(std::uint32_t seed, glm::dvec2 place, glm::dvec2 slope, double spacing) {
    ReliefSample sum;
    double wave = 420, aspect = 0.075;
    for (std::uint32_t octave = 0; octave < 6; ++octave, wave *= 0.53, aspect *= 0.85) {
        double const share = shown(wave, spacing), steepness = glm::length(slope);
        if (share <= 0) break;
        double const height = share * aspect * wave * smooth_step(0.12, 0.75, steepness);
        if (height <= 0) break;
        Gully const gully = gully_noise(seed + octave, place / wave, -slope / steepness);
        sum.altitude += height * gully.height;
        // The two broadest are what one sees from afar.
        if (octave < 2) sum.gully += 0.5 * gully.height * smooth_step(0.12, 0.5, steepness);
        slope += height / wave * gully.slope;
    }
    return sum;
}

/// [m] Towers and clefts of bare rock.
double crags(std::uint32_t seed, glm::dvec2 place, double spacing) {
    double sum = 0, wave = 150;
    for (std::uint32_t octave = 0; octave < 6; ++octave, wave *= 0.5) {
        double const share = shown(wave, spacing);
        if (share <= 0) break;
        sum += share * 0.13 * wave *
               (0.5 - std::abs(gradient_noise(seed + octave, place.x / wave + octave * 0.37, place.y / wave)));
    }
    return sum;
}

/// [m] The unevenness of earth and gravel.
double hummocks(std::uint32_t seed, glm::dvec2 place, double spacing) {
    double sum = 0, wave = 320;
    for (std::uint32_t octave = 0; octave < 6; ++octave, wave *= 0.45) {
        double const share = shown(wave, spacing);
        if (share <= 0) break;
        sum += share * 0.012 * wave * gradient_noise(seed + octave, place.x / wave + octave * 0.61, place.y / wave);
    }
    return sum;
}

} // namespace

double Relief::altitude(double east, double north) const {
    return sample(east, north, fineness_.spacing(east, north)).altitude;
}

ReliefSample Relief::sample(double east, double north, double spacing) const {
    HeightSample const base = field_.sample(east, north);
    // Detail is weak at the water's edge, so that the shore stays one clear line.
    double const land = smooth_step(-10, 60, base.altitude);
    double h = base.altitude, gully = 0;
    if (land > 0) {
        glm::dvec2 const place(east, north), slope(base.east, base.north);
        double const steepness = glm::length(slope);
        ReliefSample const ribs = gullies(seed_ + 201, place, slope, spacing);
        h += land * ribs.altitude;
        gully = land * ribs.gully;
        h += land * hummocks(seed_ + 221, place, spacing) * smooth_step(0.0, 0.25, steepness + 0.06);
        double const rock = smooth_step(0.45, 0.9, steepness) * smooth_step(700, 2200, base.altitude);
        if (rock > 0) h += land * rock * crags(seed_ + 241, place, spacing);
    }
    // A step at the water's edge: little ground lies so near sea level that sea and land would fight for the depth.
    return {h + 3 * std::tanh(h / 2), gully};
}

glm::dvec3 Relief::up(double east, double north) const {
    double const distance = std::hypot(east, north), angle = distance / radius_;
    double const across = distance > 0 ? std::sin(angle) / distance : 0;
    return {east * across, std::cos(angle), -north * across};
}

glm::dvec3 Relief::position(double east, double north, double altitude) const {
    double const distance = std::hypot(east, north), angle = distance / radius_, half = std::sin(0.5 * angle);
    double const across = distance > 0 ? (radius_ + altitude) * std::sin(angle) / distance : 0;
    return {east * across, altitude * std::cos(angle) - 2 * radius_ * half * half, -north * across};
}

glm::dvec3 Relief::normal(double east, double north) const {
    double const step = 0.4 * fineness_.spacing(east, north);
    glm::dvec3 const along_east = position(east + step, north) - position(east - step, north);
    glm::dvec3 const along_north = position(east, north + step) - position(east, north - step);
    return glm::normalize(glm::cross(along_east, along_north));
}

} // namespace alpenglow
