#include "support/single_scattering.h"
#include "support/traced_world.h"

#include <gtest/gtest.h>

#include <random>

/// Where the sun's light on a planet goes: photons launched from the sun and followed by a tally that shares nothing
/// with the tracer, against the light that cameras all around see leave. Shares of what meets the top of the air.
using namespace alpenglow;
using namespace alpenglow::test;

namespace {

dvec3 const TO_SUN(0, 0, 1);

class Photons {
public:
    Photons(Planet const& planet, int channel)
        : planet_(planet), channel_(channel), top_(planet.radius + planet.air.top_altitude) {}

    struct Shares {
        double direct = 0;    ///< past the planet without an event
        double scattered = 0; ///< out again after an event
        double in_air = 0, in_ground = 0;
    };

    Shares launch(int count) {
        for (int i = 0; i < count; ++i) follow(1.0 / count);
        return shares_;
    }

private:
    double uniform() { return std::uniform_real_distribution<double>()(random_); }

    /// Extinction and scattering of the constituents that scatter [1/m].
    struct Here {
        double extinction, rayleigh, aerosol;
    };
    Here here(double h) const {
        AirComponent const &rayleigh = planet_.air.at("rayleigh"), &aerosol = planet_.air.at("aerosol");
        double const r = std::exp(-h / 8000), a = std::exp(-h / 1200), ozone = std::max(0.0, 1 - std::abs(h - 25000) / 15000);
        return {r * rayleigh.extinction()[channel_] + a * aerosol.extinction()[channel_] +
                    ozone * planet_.air.at("ozone").absorption[channel_],
                r * rayleigh.scattering[channel_], a * aerosol.scattering[channel_]};
    }

    /// Of the air above altitude h: air and aerosol thin out, and the ozone's peak is the most of it.
    double bound_above(double h) const {
        Here const least = here(h);
        return least.extinction + planet_.air.at("ozone").absorption[channel_];
    }

    dvec3 direction_around(dvec3 const& axis, double cosine) {
        dvec3 const side = glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
        double const turn = 2 * std::numbers::pi * uniform(), sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
        return cosine * axis + sine * (std::cos(turn) * side + std::sin(turn) * glm::cross(axis, side));
    }

    /// By rejection: under the phase's largest value.
    template <typename F> double cosine_of(F const& phase, double most) {
        for (;;) {
            double const cosine = 2 * uniform() - 1;
            if (uniform() * most < phase(cosine)) return cosine;
        }
    }
    double rayleigh_cosine() {
        return cosine_of([](double c) { return 1 + c * c; }, 2);
    }
    double aerosol_cosine() {
        double const g = planet_.air.at("aerosol").phase.g;
        auto const phase = [g](double c) { return (1 + c * c) / std::pow(1 + g * g - 2 * g * c, 1.5); };
        return cosine_of(phase, std::max(phase(1), phase(-1)));
    }

    void follow(double share) {
        double const r = top_ * std::sqrt(uniform()), turn = 2 * std::numbers::pi * uniform();
        dvec3 place(r * std::cos(turn), r * std::sin(turn), std::sqrt(std::max(0.0, top_ * top_ - r * r)));
        dvec3 direction = -TO_SUN;
        bool scattered = false;
        for (;;) {
            double const along = glm::dot(place, direction), r2 = glm::dot(place, place);
            double const past = r2 - along * along, radius = planet_.radius; // closest approach, squared
            bool const ground = along < 0 && past < radius * radius;
            double const end =
                ground ? -along - std::sqrt(radius * radius - past) : -along + std::sqrt(top_ * top_ - past);
            double const lowest = std::sqrt(along < 0 ? past : r2) - radius;
            double const bound = bound_above(std::max(0.0, lowest));
            double t = 0;
            Here now{};
            do {
                t -= std::log(1 - uniform()) / bound;
                if (t >= end) break;
                now = here(glm::length(place + t * direction) - radius);
            } while (uniform() * bound >= now.extinction);
            if (t >= end && !ground) {
                (scattered ? shares_.scattered : shares_.direct) += share;
                return;
            }
            place += std::min(t, end) * direction;
            scattered = true;
            if (t >= end) {
                if (uniform() >= planet_.ground_albedo[channel_]) return void(shares_.in_ground += share);
                place = glm::normalize(place) * radius * (1 + 1e-13);
                direction = direction_around(glm::normalize(place), std::sqrt(uniform()));
                continue;
            }
            double const chosen = uniform() * now.extinction;
            if (chosen >= now.rayleigh + now.aerosol) return void(shares_.in_air += share);
            direction = direction_around(direction, chosen < now.rayleigh ? rayleigh_cosine() : aerosol_cosine());
        }
    }

    Planet planet_;
    int channel_;
    double top_;
    std::mt19937_64 random_{17};
    Shares shares_;
};

Planet planet_with(double rayleigh_factor) {
    Planet planet = make_earth();
    planet.look = GroundLook::uniform;
    planet.ground_albedo = {0.2, 0.3, 0.4};
    planet.air.at("rayleigh").scattering *= rayleigh_factor;
    return planet;
}

/// Share of the sun's light that cameras at the top of the air see leave, looking in from places and directions that
/// are distributed as light that leaves an even ball. The mean radiance L of these is flux / (pi * 4 pi r^2). A batch's
/// places are one for each of even steps from the night's pole to the day's.
Measured seen_leaving(Planet const& planet) {
    constexpr int PLACES = 600;
    TracedWorld const world(planet, LightSource{.to_sun = TO_SUN}, 0);
    double const r = planet.radius + planet.air.top_altitude;
    std::mt19937_64 random(23);
    std::uniform_real_distribution<double> uniform;
    Tally tallies[3];
    for (int batch = 0; batch < batches(); ++batch) {
        dvec3 sum(0);
        for (int i = 0; i < PLACES; ++i) {
            dvec3 const up = around(TO_SUN, 2 * (i + uniform(random)) / PLACES - 1, uniform(random));
            dvec3 const out = around(up, std::sqrt(uniform(random)), uniform(random));
            std::uint64_t const key = hash(static_cast<std::uint64_t>(batch), static_cast<std::uint64_t>(i));
            sum += world.tracer.trace(r * (1 + 1e-9) * up, -out, 0, key, 0, 1).radiance;
        }
        for (int c = 0; c < 3; ++c) tallies[c].add(4 * std::numbers::pi / PLACES * sum[c]);
    }
    Measured measured;
    for (int c = 0; c < 3; ++c) measured.mean[c] = tallies[c].mean(), measured.deviation[c] = tallies[c].deviation();
    return measured;
}

int const PHOTONS = (long_proofs() ? 25 : 1) * 200000;

double deviation_of(double share) { return std::sqrt(share * (1 - share) / PHOTONS); }

} // namespace

TEST(ReferenceEnergy, what_leaves_is_what_the_tally_counts) {
    Planet const earth = planet_with(1);
    Measured const seen = seen_leaving(earth);
    for (int c = 0; c < 3; ++c) {
        Photons::Shares const tally = Photons(earth, c).launch(PHOTONS);
        EXPECT_NEAR(tally.direct + tally.scattered + tally.in_air + tally.in_ground, 1, 1e-9);
        double const deviation = std::hypot(seen.deviation[c], deviation_of(tally.scattered));
        EXPECT_NEAR(seen.mean[c], tally.scattered, BOUND * deviation) << "channel " << c;
        // What the cameras see, what passes and what is absorbed make what came in.
        EXPECT_NEAR(seen.mean[c] + tally.direct + tally.in_air + tally.in_ground, 1, BOUND * deviation);
        EXPECT_LT(deviation, 0.015 * seen.mean[c]);
    }
}

TEST(ReferenceEnergy, the_tally_passes_light_as_quadrature_does) {
    Planet const earth = planet_with(1);
    SingleScatteringQuadrature const quadrature(earth);
    double const radius = earth.radius, top = radius + earth.air.top_altitude;
    GaussLegendre const rule(60);
    // Rays past the planet at the distance b from its centre.
    dvec3 const direct = rule.integrate(radius, top, [&](double b) {
        return 2 * b / (top * top) * glm::exp(-quadrature.depth_to({b, 0, 2 * top}, -TO_SUN));
    });
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(Photons(earth, c).launch(PHOTONS).direct, direct[c], BOUND * deviation_of(direct[c]));
}

TEST(ReferenceEnergy, other_air_is_noticed) {
    Planet const earth = planet_with(1), thicker = planet_with(1.3);
    Measured const seen = seen_leaving(thicker);
    double const tallied = Photons(earth, 2).launch(PHOTONS).scattered;
    EXPECT_GT(std::abs(seen.mean.z - tallied), BOUND * std::hypot(seen.deviation.z, deviation_of(tallied)));
}
