// Optical depth along a ray by integration: exponential densities by quadrature, the linear ones ramp by ramp, so that
// a shell as thin as a metre is not missed.
#ifndef ALPENGLOW_ATMOSPHERE_OPTICAL_DEPTH_GLSL
#define ALPENGLOW_ATMOSPHERE_OPTICAL_DEPTH_GLSL
#include "atmosphere/density.glsl"
#include "atmosphere/march_samples.glsl"
SHADER_NAMESPACE_BEGIN

// Three Gauss-Legendre nodes in each cell: 0.2 % at most where T > 1e-4.
CONSTANT int OPTICAL_DEPTH_CELLS = 40;
CONSTANT float GAUSS_OFFSET = 0.774596669f; // of the outer nodes, in halves of a cell; their weights are 5, 8, 5 of 18

INLINE void add_exponential(INOUT(vec3) extinction, IN(Atmosphere) atmosphere, int i, float h) {
    if ((component_code(atmosphere, i) & 127) == 1)
        extinction += AIR_CONTENT(atmosphere).components[i].extinction *
                      exp(h * AIR_CONTENT(atmosphere).components[i].falloff);
}

// Extinction of the exponential components [1/m] at altitude h [m].
INLINE vec3 exponential_extinction(IN(Atmosphere) atmosphere, float h) {
    vec3 sum = vec3(0.0f);
    add_exponential(sum, atmosphere, 0, h);
    add_exponential(sum, atmosphere, 1, h);
    add_exponential(sum, atmosphere, 2, h);
    add_exponential(sum, atmosphere, 3, h);
    add_exponential(sum, atmosphere, 4, h);
    add_exponential(sum, atmosphere, 5, h);
    add_exponential(sum, atmosphere, 6, h);
    add_exponential(sum, atmosphere, 7, h);
    return sum;
}

INLINE vec3 exponential_depth(IN(Atmosphere) atmosphere, AirRay ray, float begin, float end) {
    MarchCells cells = make_march_cells(atmosphere, ray, begin, end);
    vec3 depth = vec3(0.0f);
    float from = begin;
    for (int i = 1; i <= OPTICAL_DEPTH_CELLS; ++i) {
        float to = march_distance(cells, float(i) / float(OPTICAL_DEPTH_CELLS));
        float middle = 0.5f * (from + to);
        float offset = GAUSS_OFFSET * 0.5f * (to - from);
        vec3 outer = exponential_extinction(atmosphere, altitude_at(ray, middle - offset)) +
                     exponential_extinction(atmosphere, altitude_at(ray, middle + offset));
        vec3 inner = exponential_extinction(atmosphere, altitude_at(ray, middle));
        depth += (outer * vec3(5.0f / 18.0f) + inner * vec3(8.0f / 18.0f)) * (to - from);
        from = to;
    }
    return depth;
}

// Where the ray is below altitude h [m], between two distances [m]; empty, at its lowest point, where it never is.
INLINE vec2 stretch_below(AirRay ray, float begin, float end, float h) {
    float power = power_above_origin(ray, h);
    float square = ray.along * ray.along + power;
    if (square <= 0.0f) return vec2(clamp(-ray.along, begin, end));
    float far = sqrt(square) + abs(ray.along); // from the origin to the crossing that is farther off
    float near = power / far;
    vec2 crossings = ray.along > 0.0f ? vec2(-far, near) : vec2(-near, far);
    return vec2(clamp(crossings.x, begin, end), clamp(crossings.y, begin, end));
}

// The integral of a ramp's share over a stretch on which altitude only rises or only falls: a parabola, nearly.
INLINE float ramp_share_path(vec3 ramp, AirRay ray, float from, float to) {
    float middle = 0.5f * (from + to);
    float offset = GAUSS_OFFSET * 0.5f * (to - from);
    float outer =
        ramp_share(ramp, altitude_at(ray, middle - offset)) + ramp_share(ramp, altitude_at(ray, middle + offset));
    return (outer * (5.0f / 18.0f) + ramp_share(ramp, altitude_at(ray, middle)) * (8.0f / 18.0f)) * (to - from);
}

// The integral of a ramp's share [m] between two distances.
INLINE float ramp_path(vec3 ramp, AirRay ray, float begin, float end) {
    vec2 below = stretch_below(ray, begin, end, ramp.x);
    vec2 on = stretch_below(ray, begin, end, ramp.x + 1.0f / ramp.y);
    float above = (end - on.y) + (on.x - begin);
    return above + ramp_share_path(ramp, ray, on.x, below.x) + ramp_share_path(ramp, ray, below.y, on.y);
}

INLINE void add_ramps(INOUT(vec3) depth, IN(Atmosphere) atmosphere, int i, INOUT(int) next_ramp, AirRay ray,
                      float begin, float end) {
    int ramps = max((component_code(atmosphere, i) & 127) - 1, 0);
    float path = 0.0f;
    for (int j = 0; j < ramps; ++j) {
        vec3 ramp = AIR_CONTENT(atmosphere).ramps[next_ramp + j];
        path += ramp.z * ramp_path(ramp, ray, begin, end);
    }
    next_ramp += ramps;
    depth += AIR_CONTENT(atmosphere).components[i].extinction * max(path, 0.0f);
}

// Between two distances [m] of a ray inside the air.
INLINE vec3 compute_optical_depth(IN(Atmosphere) atmosphere, AirRay ray, float begin, float end) {
    vec3 depth = exponential_depth(atmosphere, ray, begin, end);
    int ramp = 0;
    add_ramps(depth, atmosphere, 0, ramp, ray, begin, end);
    add_ramps(depth, atmosphere, 1, ramp, ray, begin, end);
    add_ramps(depth, atmosphere, 2, ramp, ray, begin, end);
    add_ramps(depth, atmosphere, 3, ramp, ray, begin, end);
    add_ramps(depth, atmosphere, 4, ramp, ray, begin, end);
    add_ramps(depth, atmosphere, 5, ramp, ray, begin, end);
    add_ramps(depth, atmosphere, 6, ramp, ray, begin, end);
    add_ramps(depth, atmosphere, 7, ramp, ray, begin, end);
    return depth;
}

// From altitude h [m] in the direction mu to the top of the air, as if there were no ground.
INLINE vec3 compute_optical_depth_to_top(IN(Atmosphere) atmosphere, float h, float mu) {
    AirRay ray = make_air_ray(atmosphere.ground_radius, h, mu, 0.0f, 0.0f);
    return compute_optical_depth(atmosphere, ray, 0.0f, max(distance_out_of(ray, atmosphere.top_altitude), 0.0f));
}

SHADER_NAMESPACE_END
#endif
