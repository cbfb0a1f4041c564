// Lambert and GGX [1/sr] for the metallic-roughness material of glTF 2.0 (specification, appendix B).
#ifndef ALPENGLOW_SURFACE_BRDF
#define ALPENGLOW_SURFACE_BRDF
#include "atmosphere/math.glsl"
SHADER_NAMESPACE_BEGIN

struct Surface {
    vec3 diffuse;    // diffuse reflectance, 0 to 1
    vec3 specular;   // reflectance at normal incidence
    float alpha;     // GGX width: perceptual roughness squared
    float gloss;     // weight of the specular part; 0: Lambert alone
};

CONSTANT float LEAST_ROUGHNESS = 0.045f; // perceptual; narrower lobes alias and overflow
CONSTANT float USUAL_REFLECTANCE = 0.04f; // of a dielectric: an index of refraction of 1.5 (glTF 2.0, appendix B)

// `reflectance` is the dielectric's at normal incidence.
INLINE Surface make_surface(vec3 albedo, float metalness, float roughness, float gloss, float reflectance) {
    float rough = max(roughness, LEAST_ROUGHNESS);
    return Surface(albedo * (1.0f - metalness), mix(vec3(reflectance), albedo, metalness), rough * rough, gloss);
}

INLINE Surface make_surface(vec3 albedo, float metalness, float roughness, float gloss) {
    return make_surface(albedo, metalness, roughness, gloss, USUAL_REFLECTANCE);
}

INLINE Surface make_surface(vec3 albedo, float metalness, float roughness) {
    return make_surface(albedo, metalness, roughness, 1.0f);
}

// Trowbridge and Reitz 1975 [1/sr]; integrates to 1 over the projected hemisphere of half vectors.
INLINE float ggx_distribution(float n_h, float alpha) {
    float a2 = alpha * alpha;
    float d = (1.0f - n_h * n_h) + n_h * n_h * a2;
    return a2 / (PI * d * d);
}

// Height-correlated masking and shadowing over 4 (n.l) (n.v) (Heitz 2014, Eq. 99).
INLINE float ggx_visibility(float n_l, float n_v, float alpha) {
    float a2 = alpha * alpha;
    float l = n_v * sqrt(n_l * n_l * (1.0f - a2) + a2);
    float v = n_l * sqrt(n_v * n_v * (1.0f - a2) + a2);
    return 0.5f / max(l + v, 1e-6f);
}

INLINE vec3 fresnel(vec3 f0, float cosine) {
    float m = clamp(1.0f - cosine, 0.0f, 1.0f);
    float m2 = m * m;
    return f0 + (vec3(1.0f) - f0) * (m2 * m2 * m);
}

// Reflected radiance for a unit of irradiance across the light's direction [1/sr]. n, v, l are unit vectors away from the surface.
INLINE vec3 reflect_light(Surface surface, vec3 n, vec3 v, vec3 l) {
    vec3 h = normalize(v + l);
    float n_l = max(dot(n, l), 0.0f);
    float n_v = max(dot(n, v), 1e-4f);
    float n_h = clamp(dot(n, h), 0.0f, 1.0f);
    vec3 f = surface.gloss * fresnel(surface.specular, max(dot(v, h), 0.0f));
    vec3 gloss = f * (ggx_distribution(n_h, surface.alpha) * ggx_visibility(n_l, n_v, surface.alpha));
    return (surface.diffuse * (vec3(1.0f) - f) * (1.0f / PI) + gloss) * n_l;
}

// The share of light from all round that the specular part reflects towards a cosine n_v with the normal, by Schlick's
// Fresnel and without scattering between facets: f0 * plain + grazing.
struct SpecularShare {
    float plain;
    float grazing; // where facets are seen from the side, whatever f0
};

// Fits of ours to numeric integrals for roughness 0.05 to 1: `grazing` is within 0.01 (root mean square), `plain` within 0.02.
INLINE SpecularShare specular_share(float alpha, float n_v) {
    float roughness = sqrt(alpha), a = alpha, x = clamp(n_v, 0.0f, 1.0f), s = sqrt(x);
    float grazing = exp(-(0.836f + 7.969f * roughness - 5.894f * a) * roughness) *
                    pow(1.0f - x, 5.0f + (-8.5f + 9.009f * roughness - 0.422f * a) * roughness);
    float lost = a * (1.178f + (2.221f - 4.736f * s) * s + (-3.374f + (0.112f + 7.846f * s) * s) * roughness +
                      (2.153f - (1.292f + 3.409f * s) * s) * a);
    return SpecularShare(clamp(1.0f - lost - grazing, 0.0f, 1.0f), grazing);
}

// Where light comes from that is reflected: the mean of the directions, each as much as it is reflected.
struct Lobe {
    vec3 middle;       // unit
    float mean_length; // 1 of a mirror, about 0.6 of the roughest
};

struct SpecularLobes {
    Lobe plain, grazing; // of both parts of SpecularShare
};

// From parts away from the viewer, in parts of the mirror's, and along the normal.
INLINE Lobe lobe_from_mean(vec2 mean, vec3 n, vec3 v) {
    vec3 sum = mean.x * (dot(n, v) * n - v) + mean.y * n;
    float size = length(sum);
    return Lobe(sum / max(size, TINY), min(size, 1.0f));
}

// Fits of ours to numeric integrals, exact for a mirror: the mean of both, each as much as it counts, is within 0.05 of stone's and 0.1 of
// a metal's. Facets that are seen from the side reflect what is opposite, however rough they are and however the surface is seen.
INLINE SpecularLobes specular_lobes(float alpha, vec3 n, vec3 v) {
    float a = alpha, r = sqrt(a), x = clamp(dot(n, v), 0.0f, 1.0f);
    vec2 plain = vec2(1.0f + (-2.070f + 1.070f * a) * a + (0.547f * r - 0.556f * a * a) * x,
                      x + (1.069f + (-1.797f + 0.799f * x * x) * x) * r + (-0.918f * x * x * x + (-0.556f + 1.038f * x) * a) * a);
    vec2 grazing = vec2(1.0f + (-0.330f + 0.137f * a) * a + 0.717f * r * x * x,
                        x + (0.597f - 1.967f * x) * r + (0.994f * r * x - 0.273f * a) * a);
    return SpecularLobes(lobe_from_mean(plain, n, v), lobe_from_mean(grazing, n, v));
}

// Mean radiance [1/sr] in both lobes.
struct Mirrored {
    vec3 plain, grazing;
};

// Reflected radiance of light all round, from its irradiance and what is mirrored of it.
INLINE vec3 reflect_ambient(Surface surface, float n_v, vec3 irradiance, IN(Mirrored) mirrored) {
    SpecularShare share = specular_share(surface.alpha, n_v);
    vec3 plain = surface.gloss * share.plain * surface.specular;
    float grazing = surface.gloss * share.grazing;
    return surface.diffuse * (vec3(1.0f - grazing) - plain) * irradiance * (1.0f / PI) + plain * mirrored.plain + grazing * mirrored.grazing;
}

SHADER_NAMESPACE_END
#endif
