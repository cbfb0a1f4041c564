#include "terrain/sites.h"

#include "core/parallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace alpenglow {

namespace {

constexpr double DEGREE = std::numbers::pi / 180;
constexpr double EYE = 2; // [m]
constexpr double NOWHERE = -1e9;

struct Candidate {
    double east, north, altitude;
    double score = NOWHERE;
};

/// Of the skyline [degrees] from one azimuth to another.
struct Skyline {
    double mean = 0, lowest = 90;
    double jags = 0; ///< mean bend from one step to the next
};

Skyline skyline(HeightField const& field, Candidate const& c, double radius, double from, double to,
                double step = 2.5) {
    std::vector<double> elevations;
    for (double azimuth = from; azimuth <= to; azimuth += step) {
        elevations.push_back(skyline_elevation(field, c.east, c.north, c.altitude + EYE, azimuth * DEGREE, radius) /
                             DEGREE);
    }
    Skyline line;
    for (std::size_t k = 0; k < elevations.size(); ++k) {
        line.mean += elevations[k] / static_cast<double>(elevations.size());
        line.lowest = std::min(line.lowest, elevations[k]);
        if (k < 2) continue;
        line.jags += std::abs(elevations[k] - 2 * elevations[k - 1] + elevations[k - 2]) /
                     static_cast<double>(elevations.size() - 2);
    }
    return line;
}

double altitude_at(HeightField const& field, Candidate const& c, double distance, double heading) {
    return field.rough_altitude(c.east + distance * std::sin(heading * DEGREE),
                                c.north + distance * std::cos(heading * DEGREE));
}

/// Highest less lowest within a square of half side `reach` [m].
double roughness(HeightField const& field, Candidate const& c, double reach) {
    double lowest = 1e9, highest = -1e9;
    for (int b = -2; b <= 2; ++b) {
        for (int a = -2; a <= 2; ++a) {
            double const h = field.rough_altitude(c.east + 0.5 * a * reach, c.north + 0.5 * b * reach);
            lowest = std::min(lowest, h), highest = std::max(highest, h);
        }
    }
    return highest - lowest;
}

/// The candidate with the best score among nodes of a coarse lattice; the first of equals. `score` may move its
/// candidate.
Candidate best_of(HeightField const& field, int threads,
                  std::function<std::optional<double>(Candidate&)> const& score) {
    int const count = std::min(200, field.nodes() - 1);
    double const step = field.side() / count;
    std::vector<Candidate> best(count, Candidate{0, 0, 0});
    parallel_for(count, threads, [&](int j) {
        for (int i = 0; i < count; ++i) {
            Candidate c{(i + 0.5) * step - 0.5 * field.side(), (j + 0.5) * step - 0.5 * field.side(), 0};
            c.altitude = field.rough_altitude(c.east, c.north);
            if (c.altitude < 5) continue;
            double const value = score(c).value_or(NOWHERE);
            c.score = value;
            if (c.score > best[j].score) best[j] = c;
        }
    });
    Candidate const chosen =
        *std::max_element(best.begin(), best.end(), [](auto const& a, auto const& b) { return a.score < b.score; });
    return chosen.score > NOWHERE ? chosen : Candidate{0, 0, field.rough_altitude(0, 0)};
}

} // namespace

double skyline_elevation(HeightField const& field, double east, double north, double eye, double azimuth,
                         double planet_radius) {
    double highest = -1e9;
    double const de = std::sin(azimuth), dn = std::cos(azimuth), border = 0.5 * field.side();
    for (double d = 0.5 * field.cell(); d < 2 * field.side(); d += std::max(0.5 * field.cell(), 0.015 * d)) {
        double const e = east + d * de, n = north + d * dn;
        if (std::max(std::abs(e), std::abs(n)) > border) break;
        // The planet falls away by d^2 / 2R; the next term is a millimetre at 100 km.
        double const above = std::max(0.0, field.rough_altitude(e, n)) - eye - 0.5 * d * d / planet_radius;
        highest = std::max(highest, above / d);
    }
    return std::atan(highest);
}

void move_to_highest(std::function<double(double, double)> const& ground, double reach, double step, double& east,
                     double& north) {
    int const most = static_cast<int>(reach / step);
    double const from_east = east, from_north = north;
    double best = ground(east, north);
    for (int j = -most; j <= most; ++j) {
        for (int i = -most; i <= most; ++i) {
            double const e = from_east + i * step, n = from_north + j * step;
            if (double const h = ground(e, n); h > best) best = h, east = e, north = n;
        }
    }
}

std::vector<TerrainSite> find_sites(HeightField const& field, double planet_radius, int threads) {
    double const highest = *std::max_element(field.altitudes().begin(), field.altitudes().end());
    double const inner = 0.27 * field.side(); // far enough inside that mountains stand on all sides
    auto const central = [&](Candidate const& c) { return std::max(std::abs(c.east), std::abs(c.north)) < inner; };

    Candidate const valley = best_of(field, threads, [&](Candidate& c) -> std::optional<double> {
        if (!central(c) || c.altitude > 0.35 * highest || roughness(field, c, 900) > 60) return {};
        Skyline const east = skyline(field, c, planet_radius, 60, 120);
        return 5 * east.jags - std::abs(east.mean - 10) - 2 * std::max(0.0, 5 - east.lowest);
    });
    Candidate const ridge = best_of(field, threads, [&](Candidate& c) -> std::optional<double> {
        if (!central(c) || c.altitude < 0.5 * highest) return {};
        move_to_highest([&](double e, double n) { return field.rough_altitude(e, n); }, 4 * field.cell(), field.cell(),
                        c.east, c.north);
        c.altitude = field.rough_altitude(c.east, c.north);
        if (c.altitude > 0.85 * highest || c.altitude - altitude_at(field, c, 700, 270) < 0.05 * highest) return {};
        Skyline const west = skyline(field, c, planet_radius, 235, 305),
                      all = skyline(field, c, planet_radius, 0, 345, 15);
        return 6 * west.jags - 3 * std::abs(west.mean - 0.5) - std::max(0.0, all.mean - 1);
    });
    double heading = 0;
    Candidate noon{0, 0, 0};
    for (double towards : {315.0, 0.0, 45.0}) { // away from the sun at noon
        Candidate const found = best_of(field, threads, [&](Candidate& c) -> std::optional<double> {
            if (!central(c) || c.altitude < 0.3 * highest || c.altitude > 0.5 * highest ||
                roughness(field, c, 120) > 80)
                return {};
            double const below = std::min(altitude_at(field, c, 1200, towards), altitude_at(field, c, 2200, towards));
            Skyline const ahead = skyline(field, c, planet_radius, towards - 35, towards + 35);
            return 4 * ahead.jags - std::abs(ahead.mean - 6) + 12 * std::min((c.altitude - below) / highest, 0.25);
        });
        if (found.score > noon.score) noon = found, heading = towards;
    }
    return {{"valley", valley.east, valley.north, valley.altitude, 85},
            {"ridge", ridge.east, ridge.north, ridge.altitude, 270},
            {"noon", noon.east, noon.north, noon.altitude, heading}};
}

} // namespace alpenglow
