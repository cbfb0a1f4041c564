// Light that has been scattered before, along a ray. It changes slowly: a look into the six tiles of its table
// (light_moments.glsl) at both ends and in the middle of a run of cells serves them all, by a parabola between the 32nd
// roots, which follow an exponential nearly linearly.
#ifndef ALPENGLOW_ATMOSPHERE_DIFFUSE_RUN_GLSL
#define ALPENGLOW_ATMOSPHERE_DIFFUSE_RUN_GLSL
#include "atmosphere/geometry.glsl"
#include "atmosphere/light_moments.glsl"
SHADER_NAMESPACE_BEGIN

// Scattered into the ray, per unit of each scattering [1/sr].
struct DiffuseLight {
    vec3 rayleigh;
    vec3 aerosol;
};

struct DiffuseNode {
    vec3 root;          // of the mean diffuse light
    vec3 rayleigh_gain; // what each scatters of it into the ray, relative to the mean
    vec3 aerosol_gain;
};

CONSTANT int RUN = 8; // cells

// At distance t [m].
INLINE DiffuseNode diffuse_node(sampler2D table, Atmosphere atmosphere, AirRay ray, float t) {
    AirPoint point = air_point_at(ray, t);
    LightMoments around = sample_light_moments(table, atmosphere, point.altitude, point.mu_s);
    LightByDegree towards = light_by_degree(around, sunward_direction(point.mu, point.mu_s, ray.nu));
    return DiffuseNode(around.root, scattered_gain(atmosphere.phase_moments[RAYLEIGH_MOMENTS], towards),
                       scattered_gain(atmosphere.phase_moments[AEROSOL_MOMENTS], towards));
}

struct DiffuseRun {
    DiffuseNode near;
    DiffuseNode middle;
    DiffuseNode far;
};

INLINE vec3 on_parabola(vec3 near, vec3 middle, vec3 far, float share) {
    return near * ((1.0f - share) * (1.0f - 2.0f * share)) + middle * (4.0f * share * (1.0f - share)) +
           far * (share * (2.0f * share - 1.0f));
}

// At the share of the run's cells.
INLINE DiffuseLight diffuse_light_in(DiffuseRun run, float share) {
    vec3 mean = power32(max(on_parabola(run.near.root, run.middle.root, run.far.root, share), vec3(0.0f)));
    return DiffuseLight(
        mean * on_parabola(run.near.rayleigh_gain, run.middle.rayleigh_gain, run.far.rayleigh_gain, share),
        mean * on_parabola(run.near.aerosol_gain, run.middle.aerosol_gain, run.far.aerosol_gain, share));
}

SHADER_NAMESPACE_END
#endif
