#include "reference/path_tracer.h"

#include "core/error.h"
#include "reference/surface_scattering.h"

#include <array>
#include <cmath>

namespace alpenglow {

namespace {

constexpr std::size_t MOST_COMPONENTS = 16;

double sum(glm::dvec3 const& color) { return color.x + color.y + color.z; }

/// Which of three channels a number in (0, 1) means, each as likely as its share of the light.
int choose_channel(glm::dvec3 const& light, double u) {
    double const at = u * sum(light);
    return at < light.x ? 0 : at < light.x + light.y ? 1 : 2;
}

} // namespace

/// A light path on its way back from the camera to the sun.
struct PathTracer::Path {
    glm::dvec3 place{0};      ///< world [m]
    glm::dvec3 direction{0};  ///< unit, of travel away from the camera
    glm::dvec3 throughput{1}; ///< in air: before the collision's scattering coefficient [m]
    PathNumbers numbers;
    double start = 1;         ///< of the throughput's sum, for Russian roulette
    int events = 0;
    glm::dvec3 radiance{0};
};

PathTracer::PathTracer(Medium const& medium, Ground const& ground, LightSource const& light, Options const& options)
    : medium_(medium), depth_(medium), tracking_(medium), ground_(&ground),
      sun_(light, depth_, ground, medium.top_radius()), options_(options) {
    if (medium.components.size() > MOST_COMPONENTS) {
        throw Error(ErrorKind::bad_input, "the air has more than 16 components");
    }
}

PathTracer::Estimate PathTracer::trace(glm::dvec3 const& origin, glm::dvec3 const& direction, double pixel_angle,
                                       std::uint64_t key, std::uint32_t first_index, int paths) const {
    Ray const ray(origin, direction);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::optional<GroundPoint> const ground = ground_->first_hit(origin, direction, infinity, pixel_angle);
    Span air = span_inside(ray, medium_.top_radius());
    air.in = std::max(air.in, 0.0);
    if (ground) air.out = std::min(air.out, ground->distance);

    Estimate estimate;
    glm::dvec3 behind(1); // transmittance up to what is behind the air
    std::optional<FirstFlight> flight;
    if (!air.empty() && !medium_.components.empty()) {
        flight.emplace(medium_, depth_, sun_, ray, air.in, air.out);
        behind = flight->transmittance();
    }
    auto const finish = [&](Path const& path) {
        estimate.radiance += path.radiance / double(paths);
        estimate.events += path.events;
    };
    for (int i = 0; i < paths; ++i) {
        std::uint32_t const index = first_index + static_cast<std::uint32_t>(i);
        if (flight) {
            Path path{.direction = direction, .numbers = PathNumbers(hash(key, 1), index)};
            FirstFlight::Choice const choice = flight->choose(path.numbers.next());
            path.place = ray.at(choice.distance);
            path.throughput = choice.weight;
            walk_from_air(path);
            finish(path);
        }
        if (ground) {
            Path path{.direction = direction, .throughput = behind, .numbers = PathNumbers(hash(key, 2), index)};
            walk_from_ground(path, *ground);
            finish(path);
        }
    }
    if (!ground) estimate.radiance += behind * sun_.source().background;
    return estimate;
}

void PathTracer::walk_from_air(Path& path) const {
    if (!scatter_in_air(path)) return;
    path.start = sum(path.throughput);
    walk(path);
}

void PathTracer::walk_from_ground(Path& path, GroundPoint const& point) const {
    path.start = sum(path.throughput);
    if (scatter_on_ground(path, point)) walk(path);
}

/// Takes the sun's light at the path's place, and turns it. False where it ends here.
bool PathTracer::scatter_in_air(Path& path) const {
    std::size_t const count = medium_.components.size();
    std::array<glm::dvec3, MOST_COMPONENTS> scattering; // [1/m], times the throughput [m]
    glm::dvec3 total(0);
    double const altitude = length(path.place) - medium_.radius;
    for (std::size_t i = 0; i < count; ++i) {
        Component const& component = medium_.components[i];
        scattering[i] = path.throughput * component.scattering * density(component.profile, altitude);
        total += scattering[i];
    }
    auto const towards = [&](glm::dvec3 const& direction) {
        glm::dvec3 value(0);
        double const cosine = dot(path.direction, direction);
        for (std::size_t i = 0; i < count; ++i) {
            value += scattering[i] * phase_value(medium_.components[i].phase, cosine);
        }
        return value;
    };
    ++path.events;
    // One set of numbers for the turn, one for the sun and the flight: the same dimensions for every path.
    double const chosen = path.numbers.next() * sum(total), u = path.numbers.next(), turn = path.numbers.next();
    path.numbers.next_set();
    SunRay const sun = sun_.sample(path.place, path.numbers.next(), path.numbers.next());
    if (sun.irradiance != glm::dvec3(0)) path.radiance += towards(sun.direction) * sun.irradiance;
    if (path.events == options_.orders || !(sum(total) > 0)) return false;

    std::size_t turning = 0;
    for (double below = sum(scattering[0]); turning + 1 < count && chosen >= below; below += sum(scattering[turning])) {
        ++turning;
    }
    double const cosine = sample_phase_cosine(medium_.components[turning].phase, u);
    glm::dvec3 const direction = around(path.direction, cosine, turn);
    glm::dvec3 const value = towards(direction);
    path.throughput = value * (sum(total) / sum(value));
    path.direction = direction;
    return true;
}

bool PathTracer::scatter_on_ground(Path& path, GroundPoint const& point) const {
    path.place = point.position;
    path.radiance += path.throughput * point.emission;
    ++path.events;
    glm::dvec3 const to_viewer = -path.direction;
    double const u1 = path.numbers.next(), u2 = path.numbers.next(), u3 = path.numbers.next();
    path.numbers.next_set();
    SunRay const sun = sun_.sample(point.position, path.numbers.next(), path.numbers.next());
    if (sun.irradiance != glm::dvec3(0)) {
        path.radiance += path.throughput * reflect(point, to_viewer, sun.direction) * sun.irradiance;
    }
    if (path.events == options_.orders) return false;
    std::optional<ReflectionSample> const reflection = sample_reflection(point, to_viewer, u1, u2, u3);
    if (!reflection) return false;
    path.throughput *= reflection->weight;
    path.direction = reflection->direction;
    return true;
}

/// Flies from event to event until the path ends.
void PathTracer::walk(Path& path) const {
    while (survives(path)) {
        Ray const ray(path.place, path.direction);
        Span const air = span_inside(ray, medium_.top_radius());
        double const from = std::max(air.in, 0.0), radius = medium_.radius;
        bool const meets_planet = ray.along < 0 && ray.closest_squared < radius * radius;
        double const end = meets_planet ? -ray.along - std::sqrt(radius * radius - ray.closest_squared) : air.out;
        int const channel = choose_channel(path.throughput, path.numbers.next());
        std::optional<double> collision;
        if (end > from) collision = tracking_.fly(ray, from, end, channel, path.numbers);
        path.numbers.next_set();

        constexpr double infinity = std::numeric_limits<double>::infinity();
        std::optional<GroundPoint> const ground =
            ground_->first_hit(path.place, path.direction, collision.value_or(infinity));
        double const stop = ground ? std::min(ground->distance, air.out) : collision.value_or(air.out);
        glm::dvec3 transmittance(1);
        if (stop > from && !medium_.components.empty()) {
            DepthAlong const depth(depth_, ray);
            transmittance = exp(depth.at(from) - depth.at(stop));
        }
        // The density with which any of the channels would have come this far and, in air, collided here.
        glm::dvec3 made = path.throughput / sum(path.throughput) * transmittance;
        if (!ground && collision) made *= medium_.extinction(ray.radius_at(*collision) - radius);
        path.throughput *= transmittance / sum(made);
        if (ground) {
            if (!scatter_on_ground(path, *ground)) return;
        } else if (collision) {
            path.place = ray.at(*collision);
            if (!scatter_in_air(path)) return;
        } else {
            path.radiance += path.throughput * sun_.source().background;
            return;
        }
    }
}

/// Russian roulette on paths that carry less than a tenth of what they began with.
bool PathTracer::survives(Path& path) const {
    double const light = sum(path.throughput), least = 0.1 * path.start;
    if (!(light > 0)) return false;
    if (light >= least) return true;
    if (path.numbers.independent() * least >= light) return false;
    path.throughput *= least / light;
    return true;
}

} // namespace alpenglow
