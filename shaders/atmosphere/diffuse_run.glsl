// Light that has been scattered before, along a ray. It changes slowly: a look into the twelve tiles of its table
// (light_moments.glsl) at both ends and in the middle of a run of cells serves them all, by a parabola between the 32nd
// roots, which follow an exponential nearly linearly.
#ifndef ALPENGLOW_ATMOSPHERE_DIFFUSE_RUN_GLSL
#define ALPENGLOW_ATMOSPHERE_DIFFUSE_RUN_GLSL
#include "atmosphere/density.glsl"
#include "atmosphere/geometry.glsl"
#include "atmosphere/light_moments.glsl"
SHADER_NAMESPACE_BEGIN

// Light that has been scattered before and is now scattered into a ray.
struct DiffuseLight {
    vec3 root;                 // 32nd root of its mean over all directions [1/sr]
    vec3 gain[AIR_COMPONENTS]; // what each component scatters of it, per unit of its scattering, relative to the mean
    vec3 glow;                 // 0 to 1: the share of the mean that comes from around the sun
    float known;               // 0 to 1: the share of it that knows what meshes hide
};

INLINE DiffuseLight no_diffuse_light() {
    DiffuseLight none;
    none.root = vec3(0.0f);
    none.glow = vec3(0.0f);
    none.known = 0.0f;
    for (int i = 0; i < AIR_COMPONENTS; ++i) none.gain[i] = vec3(0.0f);
    return none;
}

INLINE DiffuseLight sample_diffuse_light(sampler2D table, IN(Atmosphere) atmosphere, AirPoint point, float nu) {
    LightMoments around = sample_light_moments(table, atmosphere, point.altitude, point.mu_s);
    LightByDegree towards = light_by_degree(around, sunward_direction(point.mu, point.mu_s, nu));
    DiffuseLight light = no_diffuse_light();
    light.root = around.root;
    light.glow = glow_share(around);
    for (int i = 0; i < AIR_COMPONENTS; ++i)
        if (component_scatters(atmosphere, i))
            light.gain[i] = scattered_gain(AIR_CONTENT(atmosphere).components[i].moments, towards);
    return light;
}

// What the medium adds of it to the ray [1/(sr m)].
INLINE vec3 diffuse_source(IN(Medium) medium, IN(DiffuseLight) light) {
    vec3 sum = medium.scattering[0] * light.gain[0];
    for (int i = 1; i < AIR_COMPONENTS; ++i) sum += medium.scattering[i] * light.gain[i];
    return sum * power32(light.root);
}

CONSTANT int RUN = 8; // cells

struct DiffuseRun {
    DiffuseLight near;
    DiffuseLight middle;
    DiffuseLight far;
};

// At distance t [m] of the ray.
INLINE DiffuseLight diffuse_node(sampler2D table, IN(Atmosphere) atmosphere, AirRay ray, float t) {
    return sample_diffuse_light(table, atmosphere, air_point_at(ray, t), ray.nu);
}

INLINE vec3 on_parabola(vec3 near, vec3 middle, vec3 far, float share) {
    return near * ((1.0f - share) * (1.0f - 2.0f * share)) + middle * (4.0f * share * (1.0f - share)) +
           far * (share * (2.0f * share - 1.0f));
}

INLINE float on_lines(float near, float middle, float far, float share) {
    return mix(mix(near, middle, min(2.0f * share, 1.0f)), far, max(2.0f * share - 1.0f, 0.0f));
}

// At the share of the run's cells.
INLINE DiffuseLight diffuse_light_in(IN(Atmosphere) atmosphere, IN(DiffuseRun) run, float share) {
    DiffuseLight light = no_diffuse_light();
    light.root = max(on_parabola(run.near.root, run.middle.root, run.far.root, share), vec3(0.0f));
    light.glow = on_parabola(run.near.glow, run.middle.glow, run.far.glow, share);
    light.known = on_lines(run.near.known, run.middle.known, run.far.known, share);
    for (int i = 0; i < AIR_COMPONENTS; ++i)
        if (component_scatters(atmosphere, i))
            light.gain[i] = on_parabola(run.near.gain[i], run.middle.gain[i], run.far.gain[i], share);
    return light;
}

SHADER_NAMESPACE_END
#endif
