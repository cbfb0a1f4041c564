// The planet's procedural surface: seas, land and ice as one function of the place, made for looking at from 2 m to 20 000 km.
// Colours are tuned by eye against photographs of the Earth; albedos are linear.
#ifndef ALPENGLOW_SURFACE_PLANET_LOOK
#define ALPENGLOW_SURFACE_PLANET_LOOK
#include "interop/frame.h"
SHADER_NAMESPACE_BEGIN

struct GroundLookAt {
    vec3 albedo;
    float roughness;
    float water;     // 0 land, 1 sea
};

// 32-bit integer hash of a lattice point to 0..1 (Jarzynski and Olano 2020, pcg3d, first component).
INLINE float lattice_hash(ivec3 p) {
    uvec3 v = uvec3(p) * 1664525u + uvec3(1013904223u);
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v = v ^ (v >> 16u);
    v.x += v.y * v.z;
    return float(v.x >> 8u) * (1.0f / 16777216.0f);
}

INLINE ivec3 wrap_lattice(ivec3 p, int period) { return ivec3(p.x % period, p.y % period, p.z % period); }

// Value noise with quintic blending, -1 to 1. The lattice repeats after `period` cells; p must not be negative.
INLINE float lattice_noise(vec3 p, int period) {
    vec3 base = floor(p);
    vec3 f = p - base;
    vec3 w = f * f * f * (f * (f * 6.0f - vec3(15.0f)) + vec3(10.0f));
    ivec3 i = ivec3(base);
    float c[8];
    for (int corner = 0; corner < 8; ++corner) {
        c[corner] = lattice_hash(wrap_lattice(i + ivec3(corner & 1, (corner >> 1) & 1, corner >> 2), period));
    }
    float low = mix(mix(c[0], c[1], w.x), mix(c[2], c[3], w.x), w.y);
    float high = mix(mix(c[4], c[5], w.x), mix(c[6], c[7], w.x), w.y);
    return 2.0f * mix(low, high, w.z) - 1.0f;
}

// How much of an octave of the given wavelength a pixel can still show: 1 where it spans many pixels, 0 where it is smaller.
INLINE float octave_weight(float wavelength, float footprint) { return smoothstep(1.0f, 3.0f, wavelength / max(footprint, 1e-3f)); }

// Sum of octaves that halve in wavelength from `wavelength` [rad, as unit-sphere length], each 0.55 of the one before,
// faded where a pixel's footprint [rad] is too wide. -1 to 1 or so.
INLINE float planet_noise(vec3 unit, float wavelength, int octaves, float footprint, float seed) {
    float sum = 0.0f, amplitude = 0.5f;
    for (int i = 0; i < octaves && wavelength > footprint; ++i) {
        float weight = octave_weight(wavelength, footprint);
        vec3 p = (unit + vec3(1.5f + seed)) / wavelength;
        sum += weight * amplitude * lattice_noise(p, 1 << 20);
        amplitude *= 0.55f;
        wavelength *= 0.47f;
    }
    return sum;
}

// Fine grain of the land between 0.5 m and 4 km from the place within the period [m], where a float is exact to a millimetre.
INLINE float land_grain(vec3 in_period, float footprint) {
    float sum = 0.0f, amplitude = 0.3f;
    int cells = 2;
    for (int i = 0; i < 13 && GROUND_PERIOD > footprint * float(cells); ++i) {
        float wavelength = GROUND_PERIOD / float(cells);
        sum += octave_weight(wavelength, footprint) * amplitude * lattice_noise(in_period / wavelength, cells);
        amplitude *= 0.8f;
        cells *= 2;
    }
    return sum;
}

// Gives the sphere four tenths of land, and 1100 km of sea around the default scene's place (46 N, 7.5 E).
CONSTANT float CONTINENTS_SEED = 18.016f;

// What stands at `unit` (direction from the planet's centre; +z the north pole), seen with a pixel `footprint_angle` [rad] wide.
INLINE GroundLookAt planet_look(vec3 unit, vec3 in_period, float footprint_angle, float radius) {
    float footprint = footprint_angle * radius;
    float continents = planet_noise(unit, 0.9f, 14, footprint_angle, CONTINENTS_SEED) * 1.25f - 0.06f;
    float moisture = planet_noise(unit, 0.35f, 7, footprint_angle, 4.1f);
    float highland = planet_noise(unit, 0.16f, 9, footprint_angle, 7.7f);
    float latitude = abs(unit.z); // sine of it

    float shore = smoothstep(-0.004f, 0.004f, continents);
    float warmth = 1.0f - smoothstep(0.35f, 0.95f, latitude + 0.10f * highland);
    float dry = smoothstep(0.0f, 0.40f, moisture + 0.5f * (1.0f - abs(latitude - 0.42f) * 4.0f) * 0.5f);
    float grain = land_grain(in_period, footprint);

    vec3 forest = vec3(0.026f, 0.052f, 0.018f);
    vec3 steppe = vec3(0.095f, 0.100f, 0.040f);
    vec3 desert = vec3(0.330f, 0.240f, 0.150f);
    vec3 tundra = vec3(0.130f, 0.120f, 0.095f);
    vec3 snow = vec3(0.780f, 0.800f, 0.830f);
    vec3 land = mix(mix(forest, steppe, smoothstep(-0.25f, 0.15f, moisture)), desert, dry);
    land = mix(tundra, land, smoothstep(0.05f, 0.35f, warmth));
    land = land * (1.0f + 0.35f * highland + 0.5f * grain);
    float ice = smoothstep(0.86f, 0.93f, latitude + 0.06f * highland + 0.04f * moisture);
    land = mix(land, snow, max(ice, smoothstep(0.35f, 0.55f, highland + 0.4f * latitude) * smoothstep(0.5f, 0.8f, latitude)));

    // Deep water gives back little and blue; shelves are lighter and greener.
    float shelf = smoothstep(-0.09f, 0.0f, continents);
    vec3 sea = mix(vec3(0.006f, 0.018f, 0.045f), vec3(0.016f, 0.060f, 0.070f), shelf * shelf);
    float sea_ice = smoothstep(0.93f, 0.96f, latitude + 0.05f * highland);

    GroundLookAt look;
    look.albedo = clamp(mix(mix(sea, snow * 0.9f, sea_ice), land, shore), vec3(0.0f), vec3(0.95f));
    look.water = (1.0f - shore) * (1.0f - sea_ice);
    look.roughness = mix(0.95f, 0.45f, look.water); // wind-roughened sea seen as a whole: slopes of 0.2 (Cox and Munk 1954, 7 m/s)
    return look;
}

SHADER_NAMESPACE_END
#endif
