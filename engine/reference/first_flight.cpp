#include "reference/first_flight.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace alpenglow {

namespace {

constexpr int LEG_CELLS = 8;           ///< on the way down to the closest approach, and on the way up
constexpr double CELL_HEIGHT = 20'000; ///< [m] scale height of their spacing; tuned for low noise
constexpr double EVEN = 4;             ///< ratio of the light in a cell that is left as it is; tuned for low noise
constexpr double LEAST_LIGHT = 5e-3;   ///< of all, in a cell that is worth halving
constexpr int ROUNDS = 5;              ///< of halving
// Shares of the choices; the guide's light has what is left.
constexpr double SHARE_ONCE = 0.4, SHARE_PLAIN = 0.09;
constexpr double ANYWHERE = 0.01; ///< all cells alike: none is impossible

double mean(glm::dvec3 const& color) { return (color.x + color.y + color.z) / 3; }

/// In place: to the sum 1. False where there is nothing.
bool normalize_sum(std::vector<double>& weights) {
    double const sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    if (!(sum > 0)) return false;
    for (double& w : weights) w /= sum;
    return true;
}

/// Distances of the edges from the lower end of a stretch to its upper end, at altitude quantiles that are dense at the
/// lower one.
std::vector<double> leg_edges(Ray const& ray, double from, double to, double radius) {
    double const lowest = ray.radius_at(from) - radius, highest = ray.radius_at(to) - radius;
    double const widest = std::sqrt(-std::expm1(-(highest - lowest) / CELL_HEIGHT));
    double const sign = to > from ? 1 : -1;
    std::vector<double> edges{from};
    for (int i = 1; i < LEG_CELLS; ++i) {
        double const x = widest * i / LEG_CELLS;
        double const r = radius + lowest - CELL_HEIGHT * std::log1p(-x * x);
        // Near the closest approach the root is off by centimetres.
        double const distance = -ray.along + sign * std::sqrt(std::max(0.0, r * r - ray.closest_squared));
        edges.push_back(std::clamp(distance, std::min(from, to), std::max(from, to)));
    }
    edges.push_back(to);
    return edges;
}

} // namespace

/// By Simpson's rule.
FirstFlight::Light FirstFlight::Cell::light() const {
    double const width = std::max(0.0, to - from);
    auto const integral = [&](double Light::*part) { return width / 6 * (start.*part + 4 * middle.*part + end.*part); };
    return {integral(&Light::once), integral(&Light::bright), integral(&Light::plain)};
}

bool FirstFlight::Cell::uneven() const {
    auto const [least, most] = std::minmax({start.once, middle.once, end.once});
    return most > EVEN * least;
}

FirstFlight::FirstFlight(Medium const& medium, OpticalDepth const& depth, Sunlight const& sun, LightGuide const& guide,
                         Ray const& ray, double from, double to)
    : ray_(ray), depth_(depth, ray), start_(depth_.at(from)) {
    Surroundings const around{medium, sun, guide};
    std::vector<double> edges = first_edges(from, to, medium.radius);
    cut_at_nodes(edges, medium);
    cut_at_shadow(edges, sun);
    std::vector<Cell> cells = make_cells(around, edges);
    halve_uneven(around, cells);
    set_shares(cells);
}

std::vector<double> FirstFlight::first_edges(double from, double to, double radius) const {
    double const closest = std::clamp(-ray_.along, from, to);
    std::vector<double> edges;
    if (closest > from) edges = leg_edges(ray_, closest, from, radius);
    std::ranges::reverse(edges);
    if (closest < to) {
        if (!edges.empty()) edges.pop_back();
        std::ranges::copy(leg_edges(ray_, closest, to, radius), std::back_inserter(edges));
    }
    // Near the camera cells shrink with the distance.
    double const first = edges[1] - edges[0];
    for (double const share : {0.5, 0.25, 0.1, 0.03}) edges.insert(edges.begin() + 1, from + share * first);
    return edges;
}

/// Where the density of something that scatters bends or steps: a thin shell lies between the cells' own points.
void FirstFlight::cut_at_nodes(std::vector<double>& edges, Medium const& medium) const {
    double const from = edges.front(), to = edges.back();
    for (Component const& component : medium.components) {
        auto const* const linear = std::get_if<LinearProfile>(&component.profile);
        if (!linear || component.scattering == glm::dvec3(0)) continue;
        for (LinearProfile::Node const& node : linear->nodes) {
            double const radius = medium.radius + node.altitude;
            double const half_chord = std::sqrt(std::max(0.0, radius * radius - ray_.closest_squared));
            for (double const at : {-ray_.along - half_chord, -ray_.along + half_chord})
                if (at > from && at < to) edges.push_back(at);
        }
    }
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

/// The shadow of a ball is convex: where both ends of a cell are dark, so is all of it.
void FirstFlight::cut_at_shadow(std::vector<double>& edges, Sunlight const& sun) const {
    for (std::size_t i = 1; i < edges.size(); ++i) {
        double low = edges[i - 1], high = edges[i];
        bool const lit = sun.misses_planet(ray_.at(low));
        if (sun.misses_planet(ray_.at(high)) == lit) continue;
        for (int round = 0; round < 40; ++round) {
            double const middle = 0.5 * (low + high);
            (sun.misses_planet(ray_.at(middle)) == lit ? low : high) = middle;
        }
        edges.insert(edges.begin() + static_cast<std::ptrdiff_t>(i++), high);
    }
}

FirstFlight::Light FirstFlight::light_at(Surroundings const& around, double distance) const {
    double const cosine = dot(ray_.direction, around.sun.source().to_sun);
    double const altitude = ray_.radius_at(distance) - around.medium.radius;
    glm::dvec3 towards_camera(0), scattering(0);
    for (Component const& component : around.medium.components) {
        glm::dvec3 const here = component.scattering * density(component.profile, altitude);
        scattering += here;
        towards_camera += here * phase_value(component.phase, cosine);
    }
    glm::dvec3 const seen = exp(start_ - depth_.at(distance)), place = ray_.at(distance);
    double const plain = mean(seen * scattering);
    return {mean(seen * towards_camera * around.sun.unshadowed(place)), plain * around.guide.at(place).diffuse, plain};
}

std::vector<FirstFlight::Cell> FirstFlight::make_cells(Surroundings const& around,
                                                       std::vector<double> const& edges) const {
    std::vector<Cell> cells;
    Light start = light_at(around, edges.front());
    for (std::size_t i = 1; i < edges.size(); ++i) {
        double const from = edges[i - 1], to = edges[i];
        Light const end = light_at(around, to);
        cells.push_back({from, to, start, light_at(around, 0.5 * (from + to)), end});
        start = end;
    }
    return cells;
}

void FirstFlight::halve_uneven(Surroundings const& around, std::vector<Cell>& cells) const {
    for (int round = 0; round < ROUNDS; ++round) {
        double total = 0;
        for (Cell const& cell : cells) total += cell.light().once;
        std::vector<Cell> halved;
        for (Cell const& cell : cells) {
            if (!cell.uneven() || cell.light().once < LEAST_LIGHT * total) {
                halved.push_back(cell);
                continue;
            }
            double const middle = 0.5 * (cell.from + cell.to);
            auto const middle_of = [&](double a, double b) { return light_at(around, 0.5 * (a + b)); };
            halved.push_back({cell.from, middle, cell.start, middle_of(cell.from, middle), cell.middle});
            halved.push_back({middle, cell.to, cell.middle, middle_of(middle, cell.to), cell.end});
        }
        if (halved.size() == cells.size()) return;
        cells = std::move(halved);
    }
}

void FirstFlight::set_shares(std::vector<Cell> const& cells) {
    std::vector<double> once, bright, plain;
    for (Cell const& cell : cells) {
        Light const light = cell.light();
        once.push_back(light.once), bright.push_back(light.bright), plain.push_back(light.plain);
    }
    std::vector<double> anywhere(cells.size(), 1);
    double const share_once = normalize_sum(once) ? SHARE_ONCE : 0;
    double const share_plain = normalize_sum(plain) ? SHARE_PLAIN : 0;
    double const share_bright = normalize_sum(bright) ? 1 - ANYWHERE - share_once - share_plain : 0;
    double const share_anywhere = 1 - share_once - share_plain - share_bright;
    normalize_sum(anywhere);
    edges_.push_back(cells.front().from), cumulative_.push_back(0);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        double const share =
            share_once * once[i] + share_bright * bright[i] + share_plain * plain[i] + share_anywhere * anywhere[i];
        edges_.push_back(cells[i].to), cumulative_.push_back(cumulative_.back() + share);
    }
    cumulative_.back() = 1;
}

FirstFlight::Choice FirstFlight::choose(double u) const {
    auto const above = std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, u);
    auto const i = static_cast<std::size_t>(above - cumulative_.begin());
    double const share = cumulative_[i] - cumulative_[i - 1], width = edges_[i] - edges_[i - 1];
    double const distance = edges_[i - 1] + std::min((u - cumulative_[i - 1]) / share, 1.0) * width;
    return {distance, exp(start_ - depth_.at(distance)) * (width / share)};
}

glm::dvec3 FirstFlight::transmittance() const { return exp(start_ - depth_.at(edges_.back())); }

} // namespace alpenglow
