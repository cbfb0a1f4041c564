// Made-up stars with the real sky's numbers: as many of each magnitude, as bright relative to the sun, and fixed to the
// celestial sphere. Space around the unit sphere is cut into cubes with one candidate in each, at a place that the cube's
// index gives; those in a thin shell are stars. No two machines, resolutions or frames see others.
#ifndef ALPENGLOW_ATMOSPHERE_STARS_GLSL
#define ALPENGLOW_ATMOSPHERE_STARS_GLSL
#include "atmosphere/math.glsl"
SHADER_NAMESPACE_BEGIN

// The Hipparcos catalogue's counts (OEIS A053406), 15 stars brighter than magnitude 1, 49 than 2, up to 15 328 than 7,
// follow 5.06 * 10^(m/2) within 10 % from 1 on. So the share of the stars up to FAINTEST that is brighter than m is
// 10^((m - FAINTEST) / 2), and the irradiance at that share is that of FAINTEST / share^0.8.
CONSTANT float STAR_COUNT = 9000.0f;          // up to magnitude 6.5, the naked eye's
CONSTANT float FAINTEST_IRRADIANCE = 5.06e-14f; // 10^(-0.4 (6.5 + 26.74)), relative to the sun of magnitude -26.74
CONSTANT float BRIGHTEST_SHARE = 1.047e-4f;     // of magnitude -1.46: Sirius

CONSTANT float STAR_CELL = 0.026422f;    // side of a cube: sqrt(2 pi / STAR_COUNT)
CONSTANT float STAR_SHELL = 0.0066055f;  // half the shell's thickness: a quarter of a cube
CONSTANT float WIDEST_STAR_PIXEL = 0.1f; // [rad] beyond which a pixel doesn't find all its stars

struct Star {
    vec3 direction;  // unit; celestial sphere
    vec3 irradiance; // linear, relative to the sun's luminance; 0: no star
};

// Four random numbers of 32 bits from four: pcg4d of Jarzynski and Olano, Hash Functions for GPU Rendering, 2020.
INLINE uvec4 random_bits(uvec4 key) {
    uvec4 v = key * 1664525u + 1013904223u;
    v.x += v.y * v.w; v.y += v.z * v.x; v.z += v.x * v.y; v.w += v.y * v.z;
    v = v ^ (v >> 16u);
    v.x += v.y * v.w; v.y += v.z * v.x; v.z += v.x * v.y; v.w += v.y * v.z;
    return v;
}

INLINE float unit_from_bits(uint bits) { return (float(bits >> 8u) + 0.5f) * (1.0f / 16777216.0f); }

// Orange to blue around white; of luminance 1. Tuned: to the eye even bright stars are nearly white.
INLINE vec3 star_color(float warmth) {
    vec3 color = mix(vec3(0.75f, 0.9f, 1.25f), vec3(1.25f, 0.95f, 0.7f), warmth);
    return color / dot(color, vec3(0.2126f, 0.7152f, 0.0722f));
}

// The star of a cube. Needs indices below 2^20.
INLINE Star star_of_cell(ivec3 cell) {
    uvec4 bits = random_bits(uvec4(uint(cell.x + 1048576), uint(cell.y + 1048576), uint(cell.z + 1048576), 1u));
    vec3 inside = vec3(unit_from_bits(bits.x), unit_from_bits(bits.y), unit_from_bits(bits.z));
    vec3 place = (vec3(cell) + inside) * STAR_CELL;
    float radius = length(place);
    float share = max(unit_from_bits(bits.w), BRIGHTEST_SHARE);
    float irradiance = abs(radius - 1.0f) < STAR_SHELL ? FAINTEST_IRRADIANCE * pow(share, -0.8f) : 0.0f;
    return Star(place / max(radius, TINY), star_color(float(bits.x & 255u) * (1.0f / 255.0f)) * irradiance);
}

// A pixel of a perspective view; any axes.
struct ViewPixel {
    vec3 centre; // the view's axis, unit
    vec3 along;  // the ray through the pixel's centre, 1 along the axis
    vec3 right;  // what it grows by over a pixel
    vec3 down;
};

INLINE float solid_angle(ViewPixel pixel) {
    float distance = length(pixel.along);
    return length(pixel.right) * length(pixel.down) / (distance * distance * distance);
}

// The share of a star's light that falls on a pixel: a tent over two pixels, so that shares add up to 1 wherever the star
// stands, and a star that moves glides from pixel to pixel.
INLINE float star_share(ViewPixel pixel, vec3 direction) {
    float depth = dot(direction, pixel.centre);
    vec3 offset = direction / max(depth, 1e-6f) - pixel.along;
    float x = dot(offset, pixel.right) / dot(pixel.right, pixel.right);
    float y = dot(offset, pixel.down) / dot(pixel.down, pixel.down);
    return depth > 0.0f ? max(1.0f - abs(x), 0.0f) * max(1.0f - abs(y), 0.0f) : 0.0f;
}

// Mean radiance of the stars over a pixel in the axes of the celestial sphere, relative to the sun's luminance [1/sr].
// With `wanted` false nothing is looked for: a loop that does not run costs nothing, where a branch may.
INLINE vec3 star_radiance(ViewPixel pixel, bool wanted) {
    vec3 ray = normalize(pixel.along);
    float width = (length(pixel.right) + length(pixel.down)) / length(pixel.along);
    float reach = STAR_SHELL + min(width, WIDEST_STAR_PIXEL);
    ivec3 low = ivec3(floor((ray - vec3(reach)) / STAR_CELL)), high = ivec3(floor((ray + vec3(reach)) / STAR_CELL));
    int last = wanted ? high.z : low.z - 1;
    vec3 sum = vec3(0.0f);
    for (int z = low.z; z <= last; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) {
                Star star = star_of_cell(ivec3(x, y, z));
                sum += star.irradiance * star_share(pixel, star.direction);
            }
    return sum / solid_angle(pixel);
}

// The radiance of a sky in front of which no star is seen: a thousand times what the brightest star gives a pixel.
INLINE float drowning_radiance(ViewPixel pixel) {
    return 1000.0f * FAINTEST_IRRADIANCE * pow(BRIGHTEST_SHARE, -0.8f) / solid_angle(pixel);
}

SHADER_NAMESPACE_END
#endif
