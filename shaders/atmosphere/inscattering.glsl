// What the air at one point sends towards the camera, and the march through unshadowed air. Everything is per unit of
// solar irradiance above the air: multiply by Atmosphere.solar_irradiance once, at the end.
#ifndef ALPENGLOW_ATMOSPHERE_INSCATTERING_GLSL
#define ALPENGLOW_ATMOSPHERE_INSCATTERING_GLSL
#include "atmosphere/multiple_scattering.glsl"
SHADER_NAMESPACE_BEGIN

// The phases of one ray: constant along it.
struct RayPhases {
    float rayleigh; // [1/sr]
    float aerosol;  // [1/sr]
};

INLINE RayPhases phases_of(Atmosphere atmosphere, float nu) {
    return RayPhases(rayleigh_phase(nu), cornette_shanks_phase(nu, atmosphere.aerosol_g));
}

INLINE DiffuseLight no_diffuse_light() { return DiffuseLight(vec3(0.0f), vec3(0.0f)); }

INLINE DiffuseLight sample_diffuse_light(sampler2D table, Atmosphere atmosphere, AirPoint point, float nu) {
    LightMoments around = sample_light_moments(table, atmosphere, point.altitude, point.mu_s);
    LightByDegree towards = light_by_degree(around, sunward_direction(point.mu, point.mu_s, nu));
    vec3 mean = power32(around.root);
    return DiffuseLight(mean * scattered_gain(atmosphere.phase_moments[RAYLEIGH_MOMENTS], towards),
                        mean * scattered_gain(atmosphere.phase_moments[AEROSOL_MOMENTS], towards));
}

// What is left of the diffuse light where meshes hide the share 1 - `seen` of the sun. What hides the sun hides the bright
// sky around it too, and that is what a forward phase scatters on: its light goes, and of an even phase's the part that
// came from there. Tuned against the path tracer in valleys: SHADED_SHARE for an even phase.
CONSTANT float SHADED_SHARE = 0.4f;

INLINE float shaded_share(PhaseMoments phase, float seen) {
    return mix(SHADED_SHARE * (phase.degree[0] - phase.degree[1]), 1.0f, seen);
}

INLINE DiffuseLight shaded_light(Atmosphere atmosphere, DiffuseLight light, float seen) {
    return DiffuseLight(light.rayleigh * shaded_share(atmosphere.phase_moments[RAYLEIGH_MOMENTS], seen),
                        light.aerosol * shaded_share(atmosphere.phase_moments[AEROSOL_MOMENTS], seen));
}

// Radiance per metre [1/(sr m)] that the medium adds to the ray: sunlight `sun` at the point (transmittance times
// shadow) by the phases, and diffuse light.
INLINE vec3 inscattering_source(Medium medium, RayPhases phases, vec3 sun, DiffuseLight diffuse) {
    return medium.rayleigh_scattering * (sun * phases.rayleigh + diffuse.rayleigh) +
           medium.aerosol_scattering * (sun * phases.aerosol + diffuse.aerosol);
}

// All orders between two distances [m] of a ray inside the air, in n cells: inscattered radiance [1/sr] and the
// transmittance of scattered light, without shadows but the planet's own.
INLINE AirLight compute_air_light(Atmosphere atmosphere, sampler2D transmittance_table,
                                  sampler2D multiple_scattering_table, AirRay ray, float begin, float end, int n) {
    MarchCells cells = make_march_cells(atmosphere, ray, begin, end);
    RayPhases phases = phases_of(atmosphere, ray.nu);
    AirLight light = no_air_light();
    float from = begin;
    for (int i = 0; i < n; ++i) {
        MarchCell cell = march_cell_from(cells, from, i, n);
        from = cell.end;
        AirPoint point = air_point_at(ray, cell.middle);
        Medium medium = medium_at(atmosphere, point.altitude);
        vec3 sun = sample_sun_transmittance(transmittance_table, atmosphere, point.altitude, point.mu_s);
        DiffuseLight diffuse = sample_diffuse_light(multiple_scattering_table, atmosphere, point, ray.nu);
        vec3 source = inscattering_source(medium, phases, sun, diffuse);
        add_cell(light, source, diffuse_extinction(atmosphere, medium), cell.end - cell.begin);
    }
    return light;
}

SHADER_NAMESPACE_END
#endif
