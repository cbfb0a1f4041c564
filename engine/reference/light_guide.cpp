#include "reference/light_guide.h"

#include <algorithm>
#include <cmath>

namespace alpenglow {

namespace {

constexpr double LEAST = 1e-7;        ///< of the brightest place: none is taken as darker
constexpr double EVEN_SHARE = 0.15;   ///< of the directions' choices, made without regard to light
constexpr int ORDERS = 3;             ///< of scattering that are gathered
constexpr int STEPS = 14;             ///< of a gathering ray

double mean(glm::dvec3 const& color) { return (color.x + color.y + color.z) / 3; }

/// Signed squares: x from 0 to 1 for cosines -1 to 1, dense around the horizon.
double cosine_at(double x) { return (2 * x - 1) * std::abs(2 * x - 1); }
double place_of_cosine(double cosine) { return 0.5 + 0.5 * std::copysign(std::sqrt(std::abs(cosine)), cosine); }

/// The unit vector across `up` on the sun's side.
glm::dvec3 sunward(glm::dvec3 const& up, glm::dvec3 const& to_sun) {
    glm::dvec3 const across = to_sun - dot(to_sun, up) * up;
    if (dot(across, across) > 1e-12) return normalize(across);
    glm::dvec3 any, other;
    make_basis(up, any, other);
    return any;
}

/// The bin of a number in [0, 1) among `count` with these cumulative shares, and the place in it.
struct Pick {
    int bin;
    double inside;
};
Pick pick(float const* cumulative, int count, double u) {
    float const* const above = std::upper_bound(cumulative + 1, cumulative + count, static_cast<float>(u));
    int const bin = static_cast<int>(above - cumulative) - 1;
    double const share = double(cumulative[bin + 1]) - double(cumulative[bin]);
    return {bin, std::clamp((u - double(cumulative[bin])) / share, 0.0, 1.0)};
}

} // namespace

LightGuide::LightGuide(Medium const& medium, Sunlight const& sun)
    : radius_(medium.radius), top_(medium.top), to_sun_(sun.source().to_sun), light_(NODES, Light{1, 1}) {
    std::vector<float> bins(NODES * BINS, 0.0f); // none lit: all directions alike
    bool const dark = sun.source().irradiance == glm::dvec3(0) || medium.components.empty();
    if (!dark) {
        for (int node = 0; node < NODES; ++node) light_[node] = {mean(sun.unshadowed(place_of(node, 0))), 0};
        for (int order = 0; order < ORDERS; ++order) {
            gather(medium, bins);
            for (int node = 0; node < NODES; ++node) {
                light_[node].diffuse = 0; // bins are radiance times their solid angle
                for (int bin = 0; bin < BINS; ++bin) light_[node].diffuse += double(bins[node * BINS + bin]);
            }
        }
        double brightest = 0;
        for (Light const& light : light_) brightest = std::max(brightest, light.direct);
        for (Light& light : light_) {
            light.direct = std::max(light.direct, LEAST * brightest);
            light.diffuse = std::max(light.diffuse, LEAST * brightest);
        }
    }
    set_shares(bins);
}

glm::dvec3 LightGuide::place_of(int node, double lowest) const {
    double const x = double(node / SUNS) / (ALTITUDES - 1), cosine = cosine_at(double(node % SUNS) / (SUNS - 1));
    glm::dvec3 across, other;
    make_basis(to_sun_, across, other);
    glm::dvec3 const up = to_sun_ * cosine + across * std::sqrt(1 - cosine * cosine);
    return up * (radius_ + std::max(top_ * x * x, lowest));
}

void LightGuide::gather(Medium const& medium, std::vector<float>& bins) const {
    for (int node = 0; node < NODES; ++node) {
        glm::dvec3 const place = place_of(node, 1), up = normalize(place);
        glm::dvec3 const ahead = sunward(up, to_sun_), aside = cross(up, ahead);
        for (int bin = 0; bin < BINS; ++bin) {
            double const s0 = double(bin / COLUMNS) / ROWS, s1 = s0 + 1.0 / ROWS;
            double const mu = cosine_at(0.5 * (s0 + s1)), phi = M_PI * (bin % COLUMNS + 0.5) / COLUMNS;
            glm::dvec3 const direction =
                up * mu + (ahead * std::cos(phi) + aside * std::sin(phi)) * std::sqrt(1 - mu * mu);
            double const solid_angle = 2 * M_PI / COLUMNS * (cosine_at(s1) - cosine_at(s0));
            bins[node * BINS + bin] = static_cast<float>(scattered_along(medium, Ray(place, direction)) * solid_angle);
        }
    }
}

double LightGuide::scattered_along(Medium const& medium, Ray const& ray) const {
    double end = span_inside(ray, radius_ + top_).out;
    if (Span const body = span_inside(ray, radius_); ray.along < 0 && !body.empty()) end = body.in;
    double const cosine = dot(ray.direction, to_sun_);
    double depth = 0, light = 0;
    for (int i = 0; i < STEPS; ++i) { // steps grow with the distance
        double const t0 = end * i * i / (STEPS * STEPS), t1 = end * (i + 1) * (i + 1) / (STEPS * STEPS);
        glm::dvec3 const place = ray.at(0.5 * (t0 + t1));
        double const altitude = length(place) - radius_;
        Light const there = at(place);
        double scattered = 0, extinction = 0;
        for (Component const& component : medium.components) {
            double const column = density(component.profile, altitude) * (t1 - t0);
            double const straight = phase_value(component.phase, cosine);
            scattered += mean(component.scattering) * column * (there.direct * straight + there.diffuse / (4 * M_PI));
            extinction += mean(component.extinction) * column;
        }
        light += scattered * std::exp(-depth - 0.5 * extinction);
        depth += extinction;
    }
    return light;
}

void LightGuide::set_shares(std::vector<float> const& bins) {
    shares_.resize(NODES * NODE_SIZE);
    for (int node = 0; node < NODES; ++node) {
        float const* const light = &bins[node * BINS];
        float* const rows = &shares_[node * NODE_SIZE];
        double total = 0;
        for (int bin = 0; bin < BINS; ++bin) total += double(light[bin]);
        double below = 0;
        for (int row = 0; row < ROWS; ++row) {
            float* const columns = rows + (ROWS + 1) + row * (COLUMNS + 1);
            double row_light = 0;
            for (int c = 0; c < COLUMNS; ++c) row_light += double(light[row * COLUMNS + c]);
            double before = 0;
            for (int c = 0; c < COLUMNS; ++c) {
                double const lit = row_light > 0 ? double(light[row * COLUMNS + c]) / row_light : 1.0 / COLUMNS;
                before += (1 - EVEN_SHARE) * lit + EVEN_SHARE / COLUMNS;
                columns[c + 1] = static_cast<float>(before);
            }
            double const solid_angle = 0.5 * (cosine_at((row + 1.0) / ROWS) - cosine_at(double(row) / ROWS));
            below += (1 - EVEN_SHARE) * (total > 0 ? row_light / total : solid_angle) + EVEN_SHARE * solid_angle;
            rows[row + 1] = static_cast<float>(below);
        }
    }
}

LightGuide::Grid LightGuide::grid_at(glm::dvec3 const& place) const {
    double const radius = length(place), cosine = dot(place, to_sun_) / radius;
    return {std::sqrt(std::clamp((radius - radius_) / top_, 0.0, 1.0)) * (ALTITUDES - 1),
            std::clamp(place_of_cosine(cosine), 0.0, 1.0) * (SUNS - 1)};
}

LightGuide::Light LightGuide::at(glm::dvec3 const& place) const {
    Grid const grid = grid_at(place);
    int const i = std::min(static_cast<int>(grid.row), ALTITUDES - 2);
    int const k = std::min(static_cast<int>(grid.column), SUNS - 2);
    double const y = grid.row - i, x = grid.column - k;
    Light const* const node = &light_[i * SUNS + k];
    auto const between = [&](double Light::*part) {
        return (1 - y) * ((1 - x) * node[0].*part + x * node[1].*part) +
               y * ((1 - x) * node[SUNS].*part + x * node[SUNS + 1].*part);
    };
    return {between(&Light::direct), between(&Light::diffuse)};
}

LightGuide::Directions::Directions(LightGuide const& guide, glm::dvec3 const& place)
    : up_(normalize(place)), ahead_(sunward(up_, guide.to_sun_)), aside_(cross(up_, ahead_)) {
    Grid const grid = guide.grid_at(place);
    int const node = static_cast<int>(grid.row + 0.5) * SUNS + static_cast<int>(grid.column + 0.5);
    rows_ = &guide.shares_[node * NODE_SIZE];
}

glm::dvec3 LightGuide::Directions::sample(double u, double v) const {
    Pick const row = pick(rows_, ROWS, u);
    // The two sides of the sun mirror each other.
    double const side = v < 0.5 ? 1 : -1;
    Pick const column = pick(rows_ + (ROWS + 1) + row.bin * (COLUMNS + 1), COLUMNS, v < 0.5 ? 2 * v : 2 * v - 1);
    double const mu = cosine_at((row.bin + row.inside) / ROWS), phi = M_PI * (column.bin + column.inside) / COLUMNS;
    double const sine = std::sqrt(std::max(0.0, 1 - mu * mu));
    return normalize(up_ * mu + (ahead_ * std::cos(phi) + aside_ * (side * std::sin(phi))) * sine);
}

double LightGuide::Directions::density(glm::dvec3 const& direction) const {
    double const x = place_of_cosine(std::clamp(dot(direction, up_), -1.0, 1.0));
    double const phi = std::atan2(std::abs(dot(direction, aside_)), dot(direction, ahead_));
    int const row = std::min(static_cast<int>(x * ROWS), ROWS - 1);
    int const column = std::min(static_cast<int>(phi / M_PI * COLUMNS), COLUMNS - 1);
    float const* const columns = rows_ + (ROWS + 1) + row * (COLUMNS + 1);
    double const row_share = double(rows_[row + 1]) - double(rows_[row]);
    double const column_share = double(columns[column + 1]) - double(columns[column]);
    // d mu = 4 |2x - 1| dx, and each side has half of the choices.
    return row_share * ROWS / (4 * std::abs(2 * x - 1) + 1e-300) * column_share * COLUMNS / (2 * M_PI);
}

} // namespace alpenglow
