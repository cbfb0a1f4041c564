// Model `naive`: single scattering, with both integrals marched for each pixel and no tables (Dereyne, section 11.3).
// Mended: the way to the sun starts at the sample and not at the camera; phases are normalised to 1, ozone is the
// planet's own; both marches tile their way, with cells placed by altitude (even ones are 10 to 40 % off).
#include "atmosphere/inscattering.glsl"
#include "frame/air_model.glsl"

// What the air and the planet let through of the sun at distance t [m] of a ray inside the air, marched in n cells.
vec3 march_to_sun(Atmosphere atmosphere, AirRay ray, float t, int n) {
    AirRay to_sun;
    to_sun.ground_radius = ray.ground_radius;
    to_sun.altitude = max(altitude_at(ray, t), 0.0);
    float sun_along = ray.sun_along + t * ray.nu;
    float above = sun_above_horizon_along(atmosphere, to_sun.altitude, sun_along);
    // Where the sun's centre has set, the part of it that is still up stands in for the whole.
    to_sun.along = max(sun_along, -sqrt(power_from_altitude(ray.ground_radius, to_sun.altitude)));
    MarchCells cells = make_march_cells(atmosphere, to_sun, 0.0, max(distance_out_of(to_sun, atmosphere.top_altitude), 0.0));
    vec3 depth = vec3(0.0);
    float from = 0.0;
    for (int i = 0; i < n; ++i) {
        MarchCell cell = march_cell_from(cells, from, i, n);
        from = cell.end;
        depth += medium_at(atmosphere, altitude_at(to_sun, cell.middle)).extinction * (cell.end - cell.begin);
    }
    return exp(-depth) * above;
}

#ifdef LIGHT_OF_RAYS
#include "frame/sun_shadow.glsl"

AirLight air_light(ViewRay view) {
    Atmosphere atmosphere = frame.atmosphere;
    float entry;
    AirRay ray = enter_air(atmosphere, view.air, entry);
    float end = air_segment(atmosphere, ray).end;
    if (view.distance >= 0.0) end = min(view.distance - entry, distance_out_of(ray, atmosphere.top_altitude));
    if (end <= 0.0 || (entry > 0.0 && closest_altitude(view.air) >= atmosphere.top_altitude)) return no_air_light();

    RayPhases phases = phases_of(atmosphere, ray.nu);
    MarchCells cells = make_march_cells(atmosphere, ray, 0.0, end);
    AirLight light = no_air_light();
    float from = 0.0;
    for (int i = 0; i < frame.samples; ++i) {
        MarchCell cell = march_cell_from(cells, from, i, frame.samples);
        from = cell.end;
        Medium medium = medium_at(atmosphere, altitude_at(ray, cell.middle));
        vec3 sun = march_to_sun(atmosphere, ray, cell.middle, frame.samples);
        if ((frame.flags & FRAME_SHAFTS) != 0) sun *= air_visibility(view.light * (cell.middle + entry));
        add_cell(light, inscattering_source(medium, phases, sun, no_diffuse_light()), medium.extinction, cell.end - cell.begin);
    }
    return light;
}
#endif

SurfaceLight surface_light(AirPoint place, SurfaceDirections at) {
    AirRay here = make_air_ray(frame.atmosphere.ground_radius, place.altitude, 1.0, place.mu_s, place.mu_s);
    return SurfaceLight(march_to_sun(frame.atmosphere, here, 0.0, frame.samples), vec3(0.0), Mirrored(vec3(0.0), vec3(0.0)));
}
