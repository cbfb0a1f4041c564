#include "terrain/sites.h"

#include "terrain/parallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace alpenglow {

namespace {

constexpr double DEGREE = std::numbers::pi / 180;
constexpr double EYE = 2; // [m]

struct Candidate {
    double east, north, altitude;
    double score = -1e9;
};

struct Spread {
    double mean = 0, deviation = 0;
};

/// Of the skyline [degrees] from one azimuth to another.
Spread skyline_spread(HeightField const& field, Candidate const& c, double radius, double from, double to) {
    double sum = 0, squares = 0;
    int count = 0;
    for (double azimuth = from; azimuth <= to; azimuth += 2.5, ++count) {
        double const e = skyline_elevation(field, c.east, c.north, c.altitude + EYE, azimuth * DEGREE, radius) / DEGREE;
        sum += e, squares += e * e;
    }
    double const mean = sum / count;
    return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

/// Highest less lowest within a square of half side `reach` [m].
double roughness(HeightField const& field, Candidate const& c, double reach) {
    double lowest = 1e9, highest = -1e9;
    for (int b = -2; b <= 2; ++b) {
        for (int a = -2; a <= 2; ++a) {
            double const h = field.sample(c.east + 0.5 * a * reach, c.north + 0.5 * b * reach).altitude;
            lowest = std::min(lowest, h), highest = std::max(highest, h);
        }
    }
    return highest - lowest;
}

/// The candidate with the best score among nodes of a coarse lattice; the first of equals.
Candidate best_of(HeightField const& field, int threads, std::function<std::optional<double>(Candidate const&)> const& score) {
    int const count = 240;
    double const step = field.side() / count;
    std::vector<Candidate> best(count, Candidate{0, 0, 0});
    parallel_for(count, threads, [&](int j) {
        for (int i = 0; i < count; ++i) {
            Candidate c{(i + 0.5) * step - 0.5 * field.side(), (j + 0.5) * step - 0.5 * field.side(), 0};
            c.altitude = field.sample(c.east, c.north).altitude;
            if (c.altitude < 5) continue;
            c.score = score(c).value_or(-1e9);
            if (c.score > best[j].score) best[j] = c;
        }
    });
    Candidate const chosen = *std::max_element(best.begin(), best.end(), [](auto const& a, auto const& b) { return a.score < b.score; });
    return chosen.score > -1e9 ? chosen : Candidate{0, 0, field.sample(0, 0).altitude};
}

} // namespace

double skyline_elevation(HeightField const& field, double east, double north, double eye, double azimuth, double planet_radius) {
    double highest = -0.5 * std::numbers::pi;
    double const de = std::sin(azimuth), dn = std::cos(azimuth), border = 0.5 * field.side();
    for (double d = 40; d < 2 * field.side(); d += std::max(30.0, 0.01 * d)) {
        double const e = east + d * de, n = north + d * dn;
        if (std::max(std::abs(e), std::abs(n)) > border) break;
        double const angle = d / planet_radius, r = planet_radius + std::max(0.0, field.sample(e, n).altitude);
        highest = std::max(highest, std::atan2(r * std::cos(angle) - planet_radius - eye, r * std::sin(angle)));
    }
    return highest;
}

std::vector<TerrainSite> find_sites(HeightField const& field, double planet_radius, int threads) {
    float const highest = *std::max_element(field.altitudes().begin(), field.altitudes().end());
    Candidate const valley = best_of(field, threads, [&](Candidate const& c) -> std::optional<double> {
        if (c.altitude > 0.35 * highest || roughness(field, c, 700) > 45) return {};
        Spread const east = skyline_spread(field, c, planet_radius, 65, 115);
        Spread const along = skyline_spread(field, c, planet_radius, -30, 30);
        return 2 * east.deviation - std::abs(east.mean - 12) - 0.5 * std::max(0.0, along.mean - 6);
    });
    Candidate const ridge = best_of(field, threads, [&](Candidate const& c) -> std::optional<double> {
        if (c.altitude < 0.62 * highest || c.altitude > 0.85 * highest || c.east < -0.1 * field.side()) return {};
        Spread const west = skyline_spread(field, c, planet_radius, 235, 305);
        Spread const all = skyline_spread(field, c, planet_radius, 0, 359);
        return -2 * std::abs(west.mean - 1.2) - 0.5 * std::max(0.0, all.mean - 2) + west.deviation;
    });
    Candidate const noon = best_of(field, threads, [&](Candidate const& c) -> std::optional<double> {
        if (c.altitude < 1000 || c.altitude > 2000 || roughness(field, c, 150) > 90) return {};
        Spread const north = skyline_spread(field, c, planet_radius, -40, 40);
        double const below = field.sample(c.east, c.north + 1500).altitude;
        return north.deviation - std::abs(north.mean - 9) + std::min(0.01 * (c.altitude - below), 6.0);
    });
    return {{"valley", valley.east, valley.north, valley.altitude, 90},
            {"ridge", ridge.east, ridge.north, ridge.altitude, 270},
            {"noon", noon.east, noon.north, noon.altitude, 0}};
}

} // namespace alpenglow
