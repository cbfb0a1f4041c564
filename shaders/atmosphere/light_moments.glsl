// Diffuse light around a point as fifteen moments, and what follows from them: the light scattered into a direction, and
// the irradiance of a surface.
// The moments are those of the radiance that arrives from sky and ground, all orders from the first on, without the
// direct sun: m_i = mean over all directions of L B_i [1/sr per unit of solar irradiance above the air]. The B_i are
// the real spherical harmonics of degrees 0 to 4, whose square has the mean 1; their polar axis points to the sun and their
// azimuth starts in the plane of the zenith, which is a plane of symmetry, so that the sines of the azimuth drop out.
// Table: of any width and LIGHT_TILES times any height, tiles one above the other, LIGHT_PARTS for each channel:
// the 32nd root of m_0 and the others over m_0, in the order of `Moments`.
#ifndef ALPENGLOW_ATMOSPHERE_LIGHT_MOMENTS_GLSL
#define ALPENGLOW_ATMOSPHERE_LIGHT_MOMENTS_GLSL
#include "atmosphere/sun_mapping.glsl"
SHADER_NAMESPACE_BEGIN

// A direction as seen from the sun. w = sin(angle to the sun) cos(azimuth from the zenith's plane).
struct SunwardDirection {
    float nu; // cosine with the direction to the sun
    float w;
};

// A direction with the cosines mu to the zenith and nu to the sun, under a sun at mu_s. With the sun at the zenith the
// azimuth means nothing, and the moments that ask for it are 0.
INLINE SunwardDirection sunward_direction(float mu, float mu_s, float nu) {
    float sin_sun = sqrt(max(1.0f - mu_s * mu_s, 1e-8f));
    float side = sqrt(max(1.0f - nu * nu, 0.0f));
    return SunwardDirection(nu, clamp((mu - nu * mu_s) / sin_sun, -side, side));
}

// A number for each B_i, and one more: degrees 0, 1, 1 and 4, then 2, 2, 2 and the sixteenth, all of 3, the rest of 4; in each degree
// by rising multiples of the azimuth. The sixteenth is the moment of the harmonic of degree 4 around the zenith, which the others of
// that degree imply: with it the first SURFACE_PARTS know what surfaces ask for.
struct Moments {
    vec4 part[LIGHT_PARTS];
};

CONSTANT int SURFACE_PARTS = 3;

INLINE Moments no_moments() {
    Moments none;
    for (int i = 0; i < LIGHT_PARTS; ++i) none.part[i] = vec4(0.0f);
    return none;
}

INLINE Moments sum_of(Moments a, Moments b) {
    for (int i = 0; i < LIGHT_PARTS; ++i) a.part[i] += b.part[i];
    return a;
}

INLINE Moments scaled(Moments a, float scale) {
    for (int i = 0; i < LIGHT_PARTS; ++i) a.part[i] *= scale;
    return a;
}

// The harmonic of degree 4 around an axis, at this cosine.
INLINE float zonal4(float cosine) {
    float square = cosine * cosine;
    return 0.375f * (square * (35.0f * square - 30.0f) + 3.0f);
}

// The B_i of a direction; 0 in place of the sixteenth, which asks for the zenith.
INLINE Moments moment_basis(SunwardDirection d) {
    float nu2 = d.nu * d.nu, side2 = 1.0f - nu2, w2 = d.w * d.w;
    float twice = 2.0f * w2 - side2, thrice = d.w * (4.0f * w2 - 3.0f * side2), four = 8.0f * w2 * (w2 - side2) + side2 * side2; // sin^m cos(m azimuth)
    Moments b;
    b.part[0] = vec4(1.0f, 1.73205081f * d.nu, 1.73205081f * d.w, zonal4(d.nu));
    b.part[1] = vec4(1.11803399f * (3.0f * nu2 - 1.0f), 3.87298335f * d.nu * d.w, 1.93649167f * twice, 0.0f);
    b.part[2] = vec4(1.32287566f * d.nu * (5.0f * nu2 - 3.0f), 1.62018517f * d.w * (5.0f * nu2 - 1.0f), 5.12347538f * d.nu * twice, 2.09165007f * thrice);
    b.part[3] = vec4(2.37170825f * d.w * d.nu * (7.0f * nu2 - 3.0f), 1.67705098f * (7.0f * nu2 - 1.0f) * twice, 6.27495020f * d.nu * thrice, 2.21852993f * four);
    return b;
}

// The moments of the three channels, relative to m_0.
struct LightMoments {
    vec3 root; // 32nd root of m_0
    Moments channel[3];
};

// Light from one direction by degrees, relative to m_0 (which is degree 0's).
struct LightByDegree {
    vec3 first;
    vec3 second;
    vec3 third;
    vec3 fourth;
};

INLINE LightByDegree light_by_degree(IN(LightMoments) light, SunwardDirection direction) {
    Moments b = moment_basis(direction);
    LightByDegree by;
    for (int c = 0; c < 3; ++c) {
        vec4 low = light.channel[c].part[0] * b.part[0], second = light.channel[c].part[1] * b.part[1];
        by.first[c] = low.y + low.z;
        by.second[c] = second.x + second.y + second.z;
        by.third[c] = dot(light.channel[c].part[2], b.part[2]);
        by.fourth[c] = low.w + dot(light.channel[c].part[3], b.part[3]);
    }
    return by;
}

// The B_i of the sun's own direction.
INLINE Moments sun_basis() { return moment_basis(SunwardDirection(1.0f, 0.0f)); }

// What the glow around the sun has of degree 4, of what so much light from the sun's own direction has, and what a sky without glow has:
// tuned against the path tracer, docs/decisions/0008_light_in_shadow.md.
CONSTANT float GLOW_DEGREE_4 = 0.625f, EVEN_SKY_DEGREE_4 = 0.0375f;

// The share of the light that comes from around the sun, by the moment of degree 4.
INLINE vec3 glow_share(IN(LightMoments) light) {
    vec3 along4 = vec3(light.channel[0].part[0].w, light.channel[1].part[0].w, light.channel[2].part[0].w) * vec3(1.0f / sun_basis().part[0].w);
    return clamp((along4 - vec3(EVEN_SKY_DEGREE_4)) * vec3(1.0f / GLOW_DEGREE_4), vec3(0.0f), vec3(1.0f));
}

// What a medium of this phase scatters of light from the sun's own direction, of mean 1, by the degrees that are known of it: the
// theorem of Funk and Hecke.
INLINE float phase_series(PhaseMoments phase, float nu) {
    Moments b = moment_basis(SunwardDirection(nu, 0.0f)), sun = sun_basis();
    return phase.degree[0] + phase.degree[1] * b.part[0].y * sun.part[0].y + phase.degree[2] * b.part[1].x * sun.part[1].x +
           phase.degree[3] * b.part[2].x * sun.part[2].x + phase.degree[4] * b.part[0].w * sun.part[0].w;
}

// Light that a medium of this phase scatters into the direction, per unit of its scattering, relative to m_0: the
// theorem of Funk and Hecke. A cut-off series may dip below 0 where there is next to nothing.
INLINE vec3 scattered_gain(PhaseMoments phase, LightByDegree light) {
    return max(vec3(phase.degree[0]) + phase.degree[1] * light.first + phase.degree[2] * light.second +
                   phase.degree[3] * light.third + phase.degree[4] * light.fourth,
               vec3(0.0f));
}

// Irradiance of a surface whose normal is `direction`, relative to m_0: the coefficients of the cosine lobe (Ramamoorthi
// and Hanrahan 2001, Eq. 8), times the 4 pi of the mean.
INLINE vec3 irradiance_gain(LightByDegree light) {
    return max(vec3(PI) + (2.0f / 3.0f * PI) * light.first + (PI / 4.0f) * light.second - (PI / 24.0f) * light.fourth,
               vec3(0.0f));
}

// What is left of degrees 1 to 4 in the mean over a lobe whose directions have a mean of this length: that is degree 1's, and the others
// as of a Gaussian on the sphere, which loses exp(-l (l + 1) w) of degree l. The cosine's lobe keeps 2/3 and 1/4.
INLINE vec4 lobe_shares(float mean_length) {
    float third = mean_length * mean_length * mean_length;
    return vec4(mean_length, third, third * third, third * third * third * mean_length);
}

// Mean radiance in a lobe around the direction, relative to m_0.
INLINE vec3 lobe_gain(LightByDegree light, float mean_length) {
    vec4 kept = lobe_shares(mean_length);
    return max(vec3(1.0f) + kept.x * light.first + kept.y * light.second + kept.z * light.third + kept.w * light.fourth, vec3(0.0f));
}

// Row of the first tile: the table's upper and lower half rows belong to the edge, so that tiles do not mix.
INLINE vec2 light_moments_uv(IN(Atmosphere) atmosphere, ivec2 size, float h, float mu_s) {
    vec2 uv = sun_table_uv(atmosphere, h, mu_s, size.x, size.y / LIGHT_TILES);
    return vec2(uv.x, uv.y / float(LIGHT_TILES));
}

INLINE vec4 sample_light_tile(sampler2D table, vec2 uv, int tile) {
    return sample_bilinear(table, uv + vec2(0.0f, float(tile) / float(LIGHT_TILES)));
}

INLINE LightMoments sample_light_parts(sampler2D table, IN(Atmosphere) atmosphere, float h, float mu_s, int parts) {
    vec2 uv = light_moments_uv(atmosphere, textureSize(table, 0), h, mu_s);
    LightMoments light;
    for (int c = 0; c < 3; ++c) {
        light.channel[c] = no_moments();
        for (int i = 0; i < parts; ++i) light.channel[c].part[i] = sample_light_tile(table, uv, LIGHT_PARTS * c + i);
        light.root[c] = light.channel[c].part[0].x;
    }
    return light;
}

INLINE LightMoments sample_light_moments(sampler2D table, IN(Atmosphere) atmosphere, float h, float mu_s) {
    return sample_light_parts(table, atmosphere, h, mu_s, LIGHT_PARTS);
}

// Irradiance [per unit of solar irradiance] from sky and ground on a surface at altitude h [m], whose normal has the
// cosines mu with the zenith and nu with the direction to the sun.
INLINE vec3 sample_diffuse_irradiance(sampler2D table, IN(Atmosphere) atmosphere, float h, float mu_s, float mu,
                                      float nu) {
    LightMoments light = sample_light_moments(table, atmosphere, h, mu_s);
    return power32(light.root) * irradiance_gain(light_by_degree(light, sunward_direction(mu, mu_s, nu)));
}

// Of a picture's surfaces, which are many: of degree 4 only what the first parts know.
INLINE LightMoments sample_surface_light(sampler2D table, IN(Atmosphere) atmosphere, float h, float mu_s) {
    return sample_light_parts(table, atmosphere, h, mu_s, SURFACE_PARTS);
}

// Theirs from a direction with the cosines mu to the zenith and nu to the sun, under a sun at mu_s: of degree 4 what is even around
// the sun, and as much around the zenith as makes it exact there.
INLINE LightByDegree surface_light_by_degree(IN(LightMoments) light, float mu, float mu_s, float nu) {
    LightByDegree by = light_by_degree(light, sunward_direction(mu, mu_s, nu));
    for (int c = 0; c < 3; ++c) {
        float around_zenith = light.channel[c].part[1].w - light.channel[c].part[0].w * zonal4(mu_s) / 3.0f;
        by.fourth[c] += around_zenith * zonal4(mu);
    }
    return by;
}

SHADER_NAMESPACE_END
#endif
