#include "reference/surface_scattering.h"

#include "reference/ray.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/glm.hpp>

// The description of surfaces with `float` read as `double`, in namespace alpenglow::shader_double: in single precision
// the narrowest lobes reflect 2 % too much.
#define ALPENGLOW_SHADER_DOUBLE
#define float double
#include "surface/brdf.glsl"
#undef float

namespace alpenglow {

namespace {

constexpr double PI = std::numbers::pi;
constexpr double LEAST_COSINE = 1e-4; // of the viewer with the shading normal, as in reflect_light

/// The shading normal's frame, the viewer in it, and how directions are chosen there.
struct Lobes {
    glm::dmat3 world_from_local; // +z is the shading normal
    glm::dvec3 viewer;           // local, kept above the horizon for the choice of facets
    double alpha;                // GGX width
    double gloss_share;          // probability of the mirror

    double facet_density(glm::dvec3 const& facet) const;
};

glm::dmat3 frame_around(glm::dvec3 const& n) {
    glm::dmat3 frame(n, n, n);
    make_basis(n, frame[0], frame[1]);
    return frame;
}

double brightest(glm::dvec3 const& c) { return std::max({c.x, c.y, c.z}); }

/// Half for each where there is any diffuse light to speak of: the diffuse lobe also covers what GGX's facets miss.
double gloss_share(GroundPoint const& point, double viewer_cosine) {
    if (point.surface.gloss == 0) return 0;
    glm::dvec3 const gloss = shader_double::fresnel(point.surface.specular, viewer_cosine);
    double const bright = brightest(gloss), diffuse = brightest(point.surface.diffuse) * (1 - bright);
    return std::clamp(bright / std::max(bright + diffuse, 1e-9), 0.1, 0.9);
}

Lobes lobes_of(GroundPoint const& point, glm::dvec3 const& to_viewer) {
    glm::dmat3 const frame = frame_around(point.shading);
    glm::dvec3 viewer = to_viewer * frame; // the transpose's product
    viewer.z = std::max(viewer.z, LEAST_COSINE);
    viewer = glm::normalize(viewer);
    return {frame, viewer, point.surface.alpha, gloss_share(point, viewer.z)};
}

/// Of facet normals that the viewer sees (Heitz 2018, "Sampling the GGX Distribution of Visible Normals", Eq. 3)
/// [1/sr].
double Lobes::facet_density(glm::dvec3 const& facet) const {
    if (facet.z <= 0) return 0;
    double const a2 = alpha * alpha, across = facet.x * facet.x + facet.y * facet.y;
    double const d = across + facet.z * facet.z * a2;
    double const distribution = a2 / (PI * d * d);
    // G1 / cosine: masking by Smith for GGX.
    double const masked = 2 / (viewer.z + std::sqrt(a2 + (1 - a2) * viewer.z * viewer.z));
    return masked * std::max(glm::dot(viewer, facet), 0.0) * distribution;
}

/// Heitz 2018, Listing 1.
glm::dvec3 sample_facet(Lobes const& lobes, double u1, double u2) {
    glm::dvec3 const& v = lobes.viewer;
    glm::dvec3 const stretched = glm::normalize(glm::dvec3(lobes.alpha * v.x, lobes.alpha * v.y, v.z));
    double const across = stretched.x * stretched.x + stretched.y * stretched.y;
    glm::dvec3 const t1 =
        across > 0 ? glm::dvec3(-stretched.y, stretched.x, 0) / std::sqrt(across) : glm::dvec3(1, 0, 0);
    glm::dvec3 const t2 = glm::cross(stretched, t1);
    double const r = std::sqrt(u1), angle = 2 * PI * u2, x = r * std::cos(angle), s = 0.5 * (1 + stretched.z);
    double const y = (1 - s) * std::sqrt(1 - x * x) + s * r * std::sin(angle);
    glm::dvec3 const n = x * t1 + y * t2 + std::sqrt(std::max(0.0, 1 - x * x - y * y)) * stretched;
    return glm::normalize(glm::dvec3(lobes.alpha * n.x, lobes.alpha * n.y, std::max(n.z, 1e-12)));
}

glm::dvec3 sample_cosine(double u1, double u2) {
    double const r = std::sqrt(u1), angle = 2 * PI * u2;
    return {r * std::cos(angle), r * std::sin(angle), std::sqrt(1 - u1)};
}

/// Of `light`, local, for a viewer who really stands at `viewer` [1/sr].
double density(Lobes const& lobes, glm::dvec3 const& viewer, glm::dvec3 const& light) {
    double const diffuse = (1 - lobes.gloss_share) * std::max(light.z, 0.0) / PI;
    if (lobes.gloss_share == 0) return diffuse;
    glm::dvec3 const half = glm::normalize(viewer + light);
    double const cosine = glm::dot(viewer, half);
    double const gloss = cosine > 0 ? lobes.facet_density(half) / (4 * cosine) : 0;
    return diffuse + lobes.gloss_share * gloss;
}

} // namespace

GroundSurface make_ground_surface(glm::dvec3 const& albedo, double metalness, double roughness, double gloss) {
    shader_double::Surface const surface = shader_double::make_surface(albedo, metalness, roughness, gloss);
    return {surface.diffuse, surface.specular, surface.alpha, surface.gloss};
}

glm::dvec3 reflect(GroundPoint const& point, glm::dvec3 const& to_viewer, glm::dvec3 const& to_light) {
    double const cosine = glm::dot(point.shading, to_light);
    if (cosine <= 0 || glm::dot(point.facing, to_light) <= 0) return glm::dvec3(0);
    if (point.surface.gloss == 0) return point.surface.diffuse * (cosine / PI);
    auto const& [diffuse, specular, alpha, gloss] = point.surface;
    return shader_double::reflect_light({diffuse, specular, alpha, gloss}, point.shading, to_viewer, to_light);
}

std::optional<ReflectionSample> sample_reflection(GroundPoint const& point, glm::dvec3 const& to_viewer, double u1,
                                                  double u2, double u3) {
    Lobes const lobes = lobes_of(point, to_viewer);
    glm::dvec3 const viewer = to_viewer * lobes.world_from_local;
    glm::dvec3 light = sample_cosine(u2, u3);
    if (u1 < lobes.gloss_share) {
        glm::dvec3 const facet = sample_facet(lobes, u2, u3);
        if (glm::dot(viewer, facet) <= 0) return {}; // its back: `density` knows fronts only
        light = glm::reflect(-viewer, facet);
    }
    glm::dvec3 const direction = glm::normalize(lobes.world_from_local * light);
    glm::dvec3 const value = reflect(point, to_viewer, direction);
    if (value == glm::dvec3(0)) return {};
    double const chance = density(lobes, viewer, light);
    if (!(chance > 0)) return {};
    return ReflectionSample{direction, value / chance};
}

} // namespace alpenglow
