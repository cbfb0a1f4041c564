#include "support/air.h"
#include "support/gauss_legendre.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace alpenglow;
using namespace alpenglow::shader;

namespace {

/// A table that is the same at all nodes.
test::Table table_of(std::array<Moments, 3> const& sums) {
    return {1, LIGHT_TILES * MULTIPLE_SCATTERING_HEIGHT, [&](vec2 uv) {
                int const tile = int(uv.y * LIGHT_TILES);
                return packed_moments(sums[std::size_t(tile / LIGHT_PARTS)]).part[tile % LIGHT_PARTS];
            }};
}

/// The mean over all directions of f(cosine with the axis, azimuth).
template <typename F> double mean_over_sphere(F const& f) {
    static test::GaussLegendre const rule(64);
    constexpr int AZIMUTHS = 64;
    return rule.integrate(-1, 1, [&](double x) {
        double sum = 0;
        for (int i = 0; i < AZIMUTHS; ++i) sum += f(x, 2 * std::numbers::pi * (i + 0.5) / AZIMUTHS);
        return 0.5 * sum / AZIMUTHS;
    });
}

SunwardDirection sunward(double nu, double azimuth) {
    return {float(nu), float(std::sqrt(1 - nu * nu) * std::cos(azimuth))};
}

/// Where the moments stand: degrees 0 to 4, each with m from 0 on.
constexpr std::array<std::array<int, 2>, 15> PLACES{
    {{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {1, 2}, {2, 0}, {2, 1}, {2, 2}, {2, 3}, {0, 3}, {3, 0}, {3, 1}, {3, 2}, {3, 3}}};
float component(Moments const& moments, std::size_t i) { return moments.part[PLACES[i][0]][PLACES[i][1]]; }

/// Light with the moments 1, 0.3, 0.2, ... : nowhere below 0.
constexpr std::array<float, PLACES.size()> SOME_LIGHT = {1,     0.3f,   0.2f,  0.1f,   -0.1f, 0.05f,  0.05f, 0.04f,
                                                         -0.03f, 0.02f, -0.04f, 0.03f, 0.02f, -0.03f, 0.04f};

Moments some_moments(float scale) {
    Moments moments = no_moments();
    for (std::size_t i = 0; i < PLACES.size(); ++i) moments.part[PLACES[i][0]][PLACES[i][1]] = SOME_LIGHT[i] * scale;
    return moments;
}

double some_radiance(double nu, double azimuth) {
    Moments const basis = moment_basis(sunward(nu, azimuth));
    double sum = 0;
    for (std::size_t i = 0; i < PLACES.size(); ++i) sum += SOME_LIGHT[i] * component(basis, i);
    return sum;
}

/// The sixteenth moment of that light, under a sun at mu_s.
double around_zenith(double mu_s) {
    double const sin_sun = std::sqrt(1 - mu_s * mu_s);
    return mean_over_sphere([&](double nu, double azimuth) {
        double const mu = nu * mu_s + std::sqrt(1 - nu * nu) * std::cos(azimuth) * sin_sun;
        return some_radiance(nu, azimuth) * double(zonal4(float(mu)));
    });
}

} // namespace

TEST(LightMoments, the_basis_is_orthonormal) {
    for (std::size_t i = 0; i < PLACES.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            double const mean = mean_over_sphere([&](double nu, double azimuth) {
                Moments const basis = moment_basis(sunward(nu, azimuth));
                return component(basis, i) * component(basis, j);
            });
            EXPECT_NEAR(mean, i == j ? 1 : 0, 1e-5) << i << " " << j;
        }
}

// Against vectors: x is the sun's azimuth, z the zenith.
TEST(LightMoments, a_direction_is_seen_from_the_sun) {
    for (double const sun : {1.2, 0.3, -0.1})
        for (double const elevation : {-0.8, 0.0, 0.7})
            for (double const azimuth : {0.1, 1.5, 3.0}) {
                dvec3 const s(std::cos(sun), 0, std::sin(sun));
                dvec3 const d(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                              std::sin(elevation));
                dvec3 const across(-std::sin(sun), 0, std::cos(sun)); // from the sun towards the zenith
                SunwardDirection const found = sunward_direction(float(d.z), float(s.z), float(dot(d, s)));
                EXPECT_NEAR(found.nu, dot(d, s), 1e-6);
                EXPECT_NEAR(found.w, dot(d, across), 1e-5);
            }
}

TEST(LightMoments, a_sun_at_the_zenith_leaves_no_trace_of_the_azimuth) {
    SunwardDirection const d = sunward_direction(0.6f, 1, 0.6f);
    EXPECT_EQ(d.nu, 0.6f);
    EXPECT_LT(std::abs(d.w), 0.8001f);
}

TEST(LightMoments, tiles_hold_what_was_packed) {
    for (float const scale : {3.0f, 1e-3f, 1e-12f}) {
        Moments const given = some_moments(scale), back = unpacked_moments(packed_moments(given));
        for (std::size_t i = 0; i < PLACES.size(); ++i)
            EXPECT_NEAR(component(back, i), component(given, i), 1e-5f * scale); // 32 times the rounding of the root
    }
    Moments const nothing = packed_moments(no_moments());
    EXPECT_TRUE(std::isfinite(nothing.part[0].x) && nothing.part[1] == vec4(0));
}

TEST(LightMoments, the_sixteenth_follows_from_the_others_of_its_degree) {
    for (float const mu_s : {0.9f, 0.2f, -0.3f}) {
        Moments const zenith = moment_basis(sunward_direction(1, mu_s, mu_s)), light = some_moments(1);
        float const implied = light.part[0].w * zenith.part[0].w + dot(light.part[3], zenith.part[3]);
        EXPECT_NEAR(implied / 3, around_zenith(double(mu_s)), 1e-5) << mu_s;
    }
}

// Uniform light of radiance L gives pi L to every surface. Light of degrees 0, 1, 2 and 4 gives the integral of its
// cosine; degree 3 gives nothing. A picture's surfaces, which don't read all of degree 4,
// get the same where they are level.
TEST(LightMoments, irradiance_meets_the_integral_over_the_hemisphere) {
    Moments even = no_moments();
    even.part[0].x = 2;
    std::array<Moments, 3> moments{some_moments(1), some_moments(1e-3f), even};
    moments[0].part[1].w = float(around_zenith(std::sin(0.4)));
    moments[1].part[1].w = 1e-3f * moments[0].part[1].w;
    test::Table const light = table_of(moments);
    Atmosphere const air = test::earth_air();
    double const sun = 0.4;
    for (double const tilt : {0.0, 0.9, 1.7, 3.0})
        for (double const turn : {0.0, 1.1, 3.1}) {
            dvec3 const s(std::cos(sun), 0, std::sin(sun)), across(-std::sin(sun), 0, std::cos(sun));
            dvec3 const n(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt));
            dvec3 const side(0, 1, 0); // s, across and side: right angles
            static test::GaussLegendre const rule(40);
            dvec3 const a = normalize(cross(n, std::abs(n.z) < 0.9 ? dvec3(0, 0, 1) : dvec3(1, 0, 0))), b = cross(n, a);
            double const exact = rule.integrate(0, 1, [&](double mu) {
                double sum = 0;
                for (int i = 0; i < 64; ++i) {
                    double const azimuth = 2 * std::numbers::pi * (i + 0.5) / 64;
                    dvec3 const d = mu * n + std::sqrt(1 - mu * mu) * (std::cos(azimuth) * a + std::sin(azimuth) * b);
                    sum += some_radiance(std::clamp(dot(d, s), -1.0, 1.0), std::atan2(dot(d, side), dot(d, across)));
                }
                return 2 * std::numbers::pi * mu * sum / 64;
            });
            float const mu = float(n.z), mu_s = float(s.z), nu = float(dot(n, s));
            vec3 const found = sample_diffuse_irradiance(light.sampler(), air, 0, mu_s, mu, nu);
            EXPECT_NEAR(found.x, exact, 1e-4) << tilt << " " << turn;
            EXPECT_NEAR(found.y, 1e-3 * exact, 1e-7);
            EXPECT_NEAR(found.z, 2 * std::numbers::pi, 1e-4);
            LightMoments const around = sample_surface_light(light.sampler(), air, 0, mu_s);
            vec3 const on_surface = power32(around.root) * irradiance_gain(surface_light_by_degree(around, mu, mu_s, nu));
            EXPECT_NEAR(on_surface.x, exact, tilt == 0 ? 1e-4 : 0.015 * exact) << tilt << " " << turn;
            EXPECT_NEAR(on_surface.z, 2 * std::numbers::pi, 1e-4);
        }
}

// A medium's scattered light is the light folded with its phase (Funk and Hecke). Rayleigh's phase knows degrees 0 and 2.
TEST(LightMoments, scattered_light_meets_the_integral_over_the_phase) {
    PhaseMoments const rayleigh = {{1, 0, 0.1f, 0, 0}};
    double const nu = 0.3, azimuth = 0.8;
    dvec3 const out(std::sqrt(1 - nu * nu) * std::cos(azimuth), std::sqrt(1 - nu * nu) * std::sin(azimuth), nu);
    double const exact = mean_over_sphere([&](double x, double turn) {
        dvec3 const in(std::sqrt(1 - x * x) * std::cos(turn), std::sqrt(1 - x * x) * std::sin(turn), x);
        return 4 * std::numbers::pi * double(draine_phase(float(dot(in, out)), 0, 1)) * some_radiance(x, turn);
    });
    test::Table const node = table_of({some_moments(1), some_moments(1), some_moments(1)});
    LightMoments const light = sample_light_moments(node.sampler(), test::earth_air(), 0, 0.4f);
    vec3 const found = scattered_gain(rayleigh, light_by_degree(light, sunward(nu, azimuth)));
    EXPECT_NEAR(found.x, exact / SOME_LIGHT[0], 1e-5);
}

// Even light of which a share comes from the sun's own direction: without that share a phase's series scatters the even rest alone.
TEST(LightMoments, the_glow_is_what_comes_from_around_the_sun) {
    constexpr float SHARE = 0.3f;
    LightMoments light{};
    for (Moments& channel : light.channel) channel = scaled(sun_basis(), SHARE);
    LightMoments wide = light; // the glow as wide as it is, and an uneven sky
    wide.channel[0].part[0].w = (SHARE * GLOW_DEGREE_4 + EVEN_SKY_DEGREE_4) * sun_basis().part[0].w;
    EXPECT_NEAR(glow_share(wide).x, SHARE, 1e-6);
    PhaseMoments const forward = {{0.67f, 0.43f, 0.25f, 0.12f, 0.05f}};
    for (double const nu : {1.0, 0.8, 0.3}) {
        float const gain = scattered_gain(forward, light_by_degree(light, sunward(nu, 0.8))).x;
        EXPECT_NEAR(gain - SHARE * phase_series(forward, float(nu)), (1 - SHARE) * forward.degree[0], 1e-5) << nu;
    }
    wide.channel[0].part[0].w = 0.5f * EVEN_SKY_DEGREE_4;
    EXPECT_EQ(glow_share(wide).x, 0);
}

TEST(GatherRays, cover_all_directions_once) {
    Atmosphere const air = test::earth_air();
    for (GatherRays const rays : {FIRST_ORDER_RAYS, HIGHER_ORDER_RAYS})
        for (float const h : {0.0f, 30e3f, 100e3f}) {
            double all = 0, up = 0, up2 = 0, sun2 = 0;
            for (int i = 0; i < gather_count(rays); ++i) {
                GatherDirection const d = gather_direction(air, rays, h, 0.3f, i);
                all += double(d.weight), up += double(d.weight * d.mu), up2 += double(d.weight * d.mu * d.mu);
                sun2 += double(d.weight * d.sunward.nu * d.sunward.nu);
            }
            EXPECT_NEAR(all, 1, 1e-5);
            EXPECT_NEAR(up, 0, 1e-4);
            EXPECT_NEAR(up2, 1.0 / 3, 1e-4);
            EXPECT_NEAR(sun2, 1.0 / 3, 1e-4);
        }
}

TEST(LightMoments, a_narrow_lobe_sees_the_radiance_and_one_as_wide_as_the_cosines_nearly_what_a_wall_does) {
    std::array<Moments, 3> const sums = {some_moments(1), some_moments(1), some_moments(1)};
    test::Table const table = table_of(sums);
    Atmosphere const air = test::earth_air();
    LightMoments const around = sample_light_moments(table.sampler(), air, 100, 0.5f);
    for (double const nu : {-0.8, 0.1, 0.9}) {
        LightByDegree const light = light_by_degree(around, sunward(nu, 0.7));
        EXPECT_NEAR(lobe_gain(light, 1).x, some_radiance(nu, 0.7), 1e-4);
        EXPECT_NEAR(lobe_gain(light, 2.0f / 3).x, irradiance_gain(light).x / PI, 0.03); // but for what a Gaussian keeps of higher degrees
    }
}
