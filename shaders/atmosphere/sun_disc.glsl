// The sun's disc as a pixel sees it: radiance with limb darkening, averaged over the pixel. The disc is a sphere seen from
// afar: at the angle rho from its centre, x = sin(rho) / sin(its radius) and the cosine of the ray with its surface is
// sqrt(1 - x²). In the plane of x, equal areas give equal irradiance across the direction to the sun.
#ifndef ALPENGLOW_ATMOSPHERE_SUN_DISC_GLSL
#define ALPENGLOW_ATMOSPHERE_SUN_DISC_GLSL
#include "atmosphere/math.glsl"
SHADER_NAMESPACE_BEGIN

// Limb darkening, I(mu) / I(1) = sum of LIMB_k mu^k: Neckel and Labs, Solar limb darkening 1986-1990, Solar Physics 153
// (1994), interpolated between their wavelengths to 680, 550 and 440 nm. They sum to 1; the mean over the disc follows.
CONSTANT vec3 LIMB_0 = vec3(0.35763f, 0.26444f, 0.15740f);
CONSTANT vec3 LIMB_1 = vec3(1.33502f, 1.30550f, 1.25843f);
CONSTANT vec3 LIMB_2 = vec3(-1.93137f, -1.43070f, -0.98837f);
CONSTANT vec3 LIMB_3 = vec3(2.53369f, 1.67101f, 1.09123f);
CONSTANT vec3 LIMB_4 = vec3(-1.82592f, -1.12351f, -0.71213f);
CONSTANT vec3 LIMB_5 = vec3(0.53096f, 0.31327f, 0.19341f);
CONSTANT vec3 LIMB_MEAN = vec3(0.83850f, 0.80283f, 0.75655f); // sum of 2 LIMB_k / (k + 2)

// Radiance relative to the mean of the disc; mu: cosine of the ray with the sun's surface.
INLINE vec3 limb_darkening(float mu) {
    return (LIMB_0 + mu * (LIMB_1 + mu * (LIMB_2 + mu * (LIMB_3 + mu * (LIMB_4 + mu * LIMB_5))))) / LIMB_MEAN;
}

// A pixel in the plane of x: a parallelogram with two sides along the second axis.
struct DiscPixel {
    vec2 centre;
    float width;  // along the first axis
    float shear;  // how far the second coordinate moves over the width
    float height; // along the second axis
};

// arcsin, 1e-7: Sun's fdlibm (e_asinf.c of FreeBSD). GLSL's own may be off by 1e-4, and differences of it are needed.
INLINE float arc_sine(float x) {
    float a = min(abs(x), 1.0f);
    float z = a < 0.5f ? a * a : 0.5f - 0.5f * a;
    float r = z * (0.16666586697f + z * (-0.042743422091f - z * 0.0086563630030f)) / (1.0f - z * 0.70662963390f);
    float s = a < 0.5f ? a : sqrt(z);
    float result = a < 0.5f ? s + s * r : 0.5f * PI - 2.0f * (s + s * r);
    return x < 0.0f ? -result : result;
}

// The integral of the limb darkening along a chord at half length c, from its middle to y; |y| <= c. Each power by the
// one two below it: J_k = (y m^k + k c² J_(k-2)) / (k + 1) with m = sqrt(c² - y²).
INLINE vec3 chord_integral(float c, float y) {
    float c2 = c * c;
    float m = sqrt(max(c2 - y * y, 0.0f));
    float m2 = m * m;
    float j0 = y, j1 = 0.5f * (y * m + c2 * arc_sine(y / max(c, TINY)));
    float j2 = (y * m2 + 2.0f * c2 * j0) * (1.0f / 3.0f), j3 = 0.25f * (y * m2 * m + 3.0f * c2 * j1);
    float j4 = 0.2f * (y * m2 * m2 + 4.0f * c2 * j2), j5 = (y * m2 * m2 * m + 5.0f * c2 * j3) * (1.0f / 6.0f);
    return (LIMB_0 * j0 + LIMB_1 * j1 + LIMB_2 * j2 + LIMB_3 * j3 + LIMB_4 * j4 + LIMB_5 * j5) / LIMB_MEAN;
}

// A view ray `along`, which needs not be unit, and what it grows by from pixel to pixel to the right and down.
INLINE DiscPixel disc_pixel(vec3 along, vec3 right, vec3 down, vec3 to_sun, float angular_radius) {
    float scale = 1.0f / (length(along) * sin(max(angular_radius, 1e-6f)));
    vec3 ray = normalize(along);
    vec3 across = (right - ray * dot(ray, right)) * scale, below = (down - ray * dot(ray, down)) * scale;
    across = across - to_sun * dot(across, to_sun);
    below = below - to_sun * dot(below, to_sun);
    vec3 second = below / max(length(below), TINY), first = cross(second, to_sun);
    vec3 place = (ray - to_sun * dot(ray, to_sun)) / sin(max(angular_radius, 1e-6f));
    return DiscPixel(vec2(dot(place, first), dot(place, second)), max(abs(dot(across, first)), 1e-9f),
                     dot(across, second) * sign(dot(across, first)), max(length(below), 1e-9f));
}

// Whether a pixel in front of the sun's half of the sky may show any of the disc.
INLINE bool meets_disc(DiscPixel pixel, vec3 along, vec3 to_sun) {
    float reach = 1.0f + 0.5f * (pixel.width + abs(pixel.shear) + pixel.height);
    return dot(along, to_sun) > 0.0f && dot(pixel.centre, pixel.centre) < reach * reach;
}

// The mean over a pixel of the disc's radiance relative to the disc's own mean: exact along the second axis, `chords`
// midpoints along the first.
INLINE vec3 disc_share(DiscPixel pixel, int chords) {
    float from = arc_sine(clamp(pixel.centre.x - 0.5f * pixel.width, -1.0f, 1.0f));
    float to = arc_sine(clamp(pixel.centre.x + 0.5f * pixel.width, -1.0f, 1.0f));
    vec3 sum = vec3(0.0f);
    for (int i = 0; i < chords; ++i) {
        float angle = mix(from, to, (float(i) + 0.5f) / float(chords));
        float x = sin(angle), c = cos(angle);
        float middle = pixel.centre.y + pixel.shear * (x - pixel.centre.x) / pixel.width;
        float low = clamp(middle - 0.5f * pixel.height, -c, c), high = clamp(middle + 0.5f * pixel.height, -c, c);
        sum += (chord_integral(c, high) - chord_integral(c, low)) * c;
    }
    return sum * ((to - from) / (float(max(chords, 1)) * pixel.width * pixel.height));
}

// The disc's mean radiance for a unit of irradiance across the direction to it [1/sr].
INLINE float sun_mean_radiance(float angular_radius) {
    float sine = sin(max(angular_radius, 1e-6f));
    return 1.0f / (PI * sine * sine);
}

SHADER_NAMESPACE_END
#endif
