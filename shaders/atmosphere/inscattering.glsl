// What the air at one point sends towards the camera, and the march through unshadowed air. Everything is per unit of
// solar irradiance above the air: multiply by Atmosphere.solar_irradiance once, at the end.
#ifndef ALPENGLOW_ATMOSPHERE_INSCATTERING_GLSL
#define ALPENGLOW_ATMOSPHERE_INSCATTERING_GLSL
#include "atmosphere/multiple_scattering.glsl"
SHADER_NAMESPACE_BEGIN

// Diffuse light where meshes hide the share 1 - `seen` of the sun. The glow around the sun is hidden with it, and the phases' series say
// what of it was scattered into the ray; light from a map has none. Where nothing is known of what meshes hide, they hide more: most of
// what a forward phase scatters on, and of an even phase's the part that came from there. That part is tuned against the path tracer
// in valleys.
CONSTANT float SHADED_SHARE = 0.4f;

INLINE DiffuseLight shaded_light(IN(Atmosphere) atmosphere, IN(RayPhases) phases, DiffuseLight light, float seen) {
    for (int i = 0; i < AIR_COMPONENTS; ++i)
        if (component_scatters(atmosphere, i)) {
            PhaseMoments phase = AIR_CONTENT(atmosphere).components[i].moments;
            vec3 without_glow = max(light.gain[i] - light.glow * phases.series[i], vec3(0.0f));
            vec3 shaded = mix(light.gain[i] * (SHADED_SHARE * (phase.degree[0] - phase.degree[1])), without_glow, light.known);
            light.gain[i] = mix(shaded, light.gain[i], seen);
        }
    return light;
}

// Radiance per metre [1/(sr m)] that the medium adds to the ray: sunlight `sun` at the point (transmittance times
// shadow) by the phases, and diffuse light.
INLINE vec3 inscattering_source(IN(Medium) medium, IN(RayPhases) phases, vec3 sun, IN(DiffuseLight) diffuse) {
    return directed_scattering(medium, phases) * sun + diffuse_source(medium, diffuse);
}

// All orders between two distances [m] of a ray inside the air, in n cells: inscattered radiance [1/sr] and the
// transmittance of scattered light, without shadows but the planet's own.
INLINE AirLight compute_air_light(IN(Atmosphere) atmosphere, sampler2D sunlight_table,
                                  sampler2D multiple_scattering_table, AirRay ray, float begin, float end, int n) {
    MarchCells cells = make_march_cells(atmosphere, ray, begin, end);
    RayPhases phases = phases_of(atmosphere, ray.nu);
    AirLight light = no_air_light();
    float from = begin;
    int i = 0;
    do {
        MarchCell cell = march_cell_from(cells, from, i, n);
        from = cell.end;
        AirPoint point = air_point_at(ray, cell.middle);
        Medium medium = medium_at(atmosphere, point.altitude);
        vec3 sun = sample_sun_transmittance(sunlight_table, atmosphere, point.altitude, point.mu_s);
        DiffuseLight diffuse = sample_diffuse_light(multiple_scattering_table, atmosphere, point, ray.nu);
        vec3 source = inscattering_source(medium, phases, sun, diffuse);
        add_cell(light, source, diffuse_extinction(atmosphere, medium), cell.end - cell.begin);
    } while (++i < n);
    return light;
}

SHADER_NAMESPACE_END
#endif
