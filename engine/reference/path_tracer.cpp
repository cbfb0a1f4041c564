#include "reference/path_tracer.h"

#include "core/error.h"
#include "reference/phase.h"
#include "reference/surface_scattering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace alpenglow {

namespace {

constexpr std::size_t MOST_COMPONENTS = 16;
/// A path is led by the guide up to this event. Longer walks go as the light does: weights of many led steps would
/// multiply to rare, large ones.
constexpr int LED_EVENTS = 3;
constexpr double LED_SHARE = 0.5; ///< of the turns in air that go where light comes from
constexpr double THIN = 0.002; ///< share of a flight's light that gets through, above which its collision is forced

double sum(glm::dvec3 const& color) { return color.x + color.y + color.z; }

bool is_black(GroundPoint const& point) {
    return point.surface.gloss == 0 && point.surface.diffuse == glm::dvec3(0) && point.emission == glm::dvec3(0);
}

/// How many of the paths of a ray to the ground begin in the air before it.
int share_of_air(glm::dvec3 const& transmittance, int paths) {
    double const opacity = 1 - sum(transmittance) / 3;
    return std::max(1, static_cast<int>(std::lround(paths * std::clamp(opacity, 0.25, 0.75))));
}

/// What scatters at one place of the air.
class Scatterers {
public:
    Scatterers(Medium const& medium, double altitude) : components_(medium.components) {
        for (std::size_t i = 0; i < components_.size(); ++i) {
            scattering_[i] = components_[i].scattering * density(components_[i].profile, altitude);
            total_ += scattering_[i];
        }
    }

    glm::dvec3 const& total() const { return total_; } ///< [1/m]

    /// By the cosine of the turn [1/(m sr)].
    glm::dvec3 towards(double cosine) const {
        glm::dvec3 value(0);
        for (std::size_t i = 0; i < components_.size(); ++i) {
            value += scattering_[i] * phase_value(components_[i].phase, cosine);
        }
        return value;
    }

    /// The phase of the constituent that a number in (0, 1) means, each as likely as its share of the scattered light.
    PhaseLobes const& choose(glm::dvec3 const& light, double u) const {
        double left = u * dot(light, total_);
        std::size_t i = 0;
        for (; i + 1 < components_.size(); ++i) {
            left -= dot(light, scattering_[i]);
            if (left < 0) break;
        }
        return components_[i].phase;
    }

private:
    std::span<Component const> components_;
    std::array<glm::dvec3, MOST_COMPONENTS> scattering_; ///< [1/m]
    glm::dvec3 total_{0};
};

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
    double first_light = 0, first_brightness = 0; ///< carried to the first event, and how bright it was there
    int events = 0;
    glm::dvec3 radiance{0};
};

PathTracer::PathTracer(Medium const& medium, Ground const& ground, LightSource const& light, Options const& options)
    : medium_(medium), depth_(medium), tracking_(medium), ground_(&ground),
      sun_(light, depth_, ground, medium.top_radius()), guide_(medium, sun_), led_flight_(medium, guide_),
      options_(options) {
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
        flight.emplace(medium_, depth_, sun_, guide_, ray, air.in, air.out);
        behind = flight->transmittance();
    }
    auto const finish = [&](Path const& path, int of) {
        estimate.radiance += path.radiance / double(of);
        estimate.events += path.events;
    };
    int const from_air = flight ? ground && !is_black(*ground) ? share_of_air(behind, paths) : paths : 0;
    for (int i = 0; i < from_air; ++i) {
        Path path{.direction = direction,
                  .numbers = PathNumbers(hash(key, 1), first_index + static_cast<std::uint32_t>(i))};
        FirstFlight::Choice const choice = flight->choose(path.numbers.next());
        path.place = ray.at(choice.distance);
        path.throughput = choice.weight;
        walk_from_air(path);
        finish(path, from_air);
    }
    int const from_ground = ground ? std::max(paths - from_air, 1) : 0;
    for (int i = 0; i < from_ground; ++i) {
        Path path{.direction = direction,
                  .throughput = behind,
                  .numbers = PathNumbers(hash(key, 2), first_index + static_cast<std::uint32_t>(i))};
        walk_from_ground(path, *ground);
        finish(path, from_ground);
    }
    if (!ground) estimate.radiance += behind * sun_.source().background;
    return estimate;
}

void PathTracer::walk_from_air(Path& path) const {
    if (scatter_in_air(path)) walk(path);
}

void PathTracer::walk_from_ground(Path& path, GroundPoint const& point) const {
    if (scatter_on_ground(path, point)) walk(path);
}

/// Takes the sun's light at the path's place, and turns it. False where it ends here.
bool PathTracer::scatter_in_air(Path& path) const {
    Scatterers const air(medium_, length(path.place) - medium_.radius);
    if (!survives(path, dot(path.throughput, air.total()))) return false;
    ++path.events;
    // One set of numbers for the turn, one for the sun and the flight: the same dimensions for every path.
    double const choice = path.numbers.next(), u = path.numbers.next(), v = path.numbers.next();
    path.numbers.next_set();
    double const turn = path.numbers.next(), offset = path.numbers.next();
    SunRay const sun = sun_.sample(path.place, offset, turn);
    if (sun.irradiance != glm::dvec3(0)) {
        path.radiance += path.throughput * air.towards(dot(path.direction, sun.direction)) * sun.irradiance;
    }
    if (path.events == options_.orders) return false;

    // To where the light comes from, or as the air's constituents turn it.
    double const led_share = path.events <= LED_EVENTS ? LED_SHARE : 0;
    LightGuide::Directions const led(guide_, path.place);
    glm::dvec3 direction;
    if (choice < led_share) {
        direction = led.sample(u, v);
    } else {
        PhaseLobes const& phase = air.choose(path.throughput, (choice - led_share) / (1 - led_share));
        direction = around(path.direction, sample_phase_cosine(phase, u), v);
    }
    glm::dvec3 const value = path.throughput * air.towards(dot(path.direction, direction));
    double const by_phase = sum(value) / dot(path.throughput, air.total());
    path.throughput = value / (led_share * led.density(direction) + (1 - led_share) * by_phase);
    path.direction = direction;
    return true;
}

bool PathTracer::scatter_on_ground(Path& path, GroundPoint const& point) const {
    path.place = point.position;
    if (!survives(path, sum(path.throughput))) return false;
    path.radiance += path.throughput * point.emission;
    ++path.events;
    glm::dvec3 const to_viewer = -path.direction;
    double const u1 = path.numbers.next(), u2 = path.numbers.next(), u3 = path.numbers.next();
    path.numbers.next_set();
    double const turn = path.numbers.next(), offset = path.numbers.next();
    SunRay const sun = sun_.sample(point.position, offset, turn);
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
    for (;;) {
        Ray const ray(path.place, path.direction);
        std::optional<GroundPoint> const ground = ground_->first_hit(path.place, path.direction);
        if (!fly(path, ray, ground)) {
            path.radiance += ground ? glm::dvec3(0) : path.throughput * sun_.source().background;
            if (!ground || !scatter_on_ground(path, *ground)) return;
        } else if (!scatter_in_air(path)) {
            return;
        }
    }
}

/// To the next collision, or through to the ground or out, where it returns false; weighs the throughput by the flight.
bool PathTracer::fly(Path& path, Ray const& ray, std::optional<GroundPoint> const& ground) const {
    Span air = span_inside(ray, medium_.top_radius());
    air.in = std::max(air.in, 0.0);
    if (ground) air.out = std::min(air.out, ground->distance);
    if (air.empty() || medium_.components.empty()) {
        path.numbers.next();
        path.numbers.next_set();
        return false;
    }
    DepthAlong const depth(depth_, ray);
    glm::dvec3 const start = depth.at(air.in), through = exp(start - depth.at(air.out));
    double const share_through = dot(through, path.throughput) / sum(path.throughput);
    if (share_through < THIN || path.events > LED_EVENTS) return fly_tracked(path, ray, air, depth, start);

    bool const leads_nowhere = ground ? is_black(*ground) : sun_.source().background == glm::dvec3(0);
    double const passing = leads_nowhere ? 0 : share_through, choice = path.numbers.next(), u = path.numbers.next();
    path.numbers.next_set();
    if (choice < passing) {
        path.throughput *= through / passing;
        return false;
    }
    LedFlight::Choice const collision = led_flight_.choose(ray, air.in, air.out, path.throughput, u);
    path.throughput *= exp(start - depth.at(collision.distance)) / (collision.density * (1 - passing));
    path.place = ray.at(collision.distance);
    return true;
}

/// The same by delta tracking in one channel, weighed by all channels' chances of ending where it did.
bool PathTracer::fly_tracked(Path& path, Ray const& ray, Span const& air, DepthAlong const& depth,
                             glm::dvec3 const& start) const {
    int const channel = choose_channel(path.throughput, path.numbers.next());
    std::optional<double> const collision = tracking_.fly(ray, air.in, air.out, channel, path.numbers);
    path.numbers.next_set();
    glm::dvec3 const transmittance = exp(start - depth.at(collision.value_or(air.out)));
    glm::dvec3 chance = path.throughput / sum(path.throughput) * transmittance;
    if (collision) {
        path.place = ray.at(*collision);
        chance *= medium_.extinction(ray.radius_at(*collision) - medium_.radius);
    }
    path.throughput *= transmittance / sum(chance);
    return collision.has_value();
}

/// Russian roulette on paths that promise less than a tenth of what they did at first: by the light they carry to an
/// event and, while they are led, by how much brighter or darker it is there than at the first.
bool PathTracer::survives(Path& path, double light) const {
    if (path.events == 0) path.first_light = light, path.first_brightness = guide_.at(path.place).all();
    double promise = light;
    if (path.events <= LED_EVENTS) promise *= std::sqrt(guide_.at(path.place).all() / path.first_brightness);
    double const least = 0.1 * path.first_light;
    if (!(promise > 0)) return false;
    if (promise >= least) return true;
    if (path.numbers.independent() * least >= promise) return false;
    path.throughput *= least / promise;
    return true;
}

} // namespace alpenglow
