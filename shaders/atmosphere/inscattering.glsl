// What the air at one point sends towards the camera, and the march through unshadowed air. Everything is per unit of
// solar irradiance above the air: multiply by Atmosphere.solar_irradiance once, at the end.
#ifndef ALPENGLOW_ATMOSPHERE_INSCATTERING_GLSL
#define ALPENGLOW_ATMOSPHERE_INSCATTERING_GLSL
#include "atmosphere/multiple_scattering.glsl"
SHADER_NAMESPACE_BEGIN

// The phases of one ray: constant along it.
struct RayPhases {
    float of_component[AIR_COMPONENTS]; // [1/sr]
};

INLINE RayPhases phases_of(IN(Atmosphere) atmosphere, float nu) {
    RayPhases phases;
    for (int i = 0; i < AIR_COMPONENTS; ++i) {
        phases.of_component[i] = 0.0f;
        if (component_scatters(atmosphere, i)) phases.of_component[i] = component_phase(atmosphere.components[i], nu);
    }
    return phases;
}

// Radiance per metre [1/(sr m)] that the medium adds to the ray: sunlight `sun` at the point (transmittance times
// shadow) by the phases, and light of higher orders `psi` [1/sr], evenly.
INLINE vec3 inscattering_source(IN(Medium) medium, IN(RayPhases) phases, vec3 sun, vec3 psi) {
    vec3 towards_camera = medium.scattering[0] * phases.of_component[0];
    for (int i = 1; i < AIR_COMPONENTS; ++i) towards_camera += medium.scattering[i] * phases.of_component[i];
    return towards_camera * sun + total_scattering(medium) * psi;
}

// Inscattered radiance [1/sr] and transmittance between two distances [m] of a ray inside the air, without shadows but
// the planet's own, in n cells.
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
        vec3 psi = sample_multiple_scattering(multiple_scattering_table, atmosphere, point.altitude, point.mu_s);
        add_cell(light, inscattering_source(medium, phases, sun, psi), medium.extinction, cell.end - cell.begin);
    }
    return light;
}

SHADER_NAMESPACE_END
#endif
