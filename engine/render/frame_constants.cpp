#include "render/frame_constants.h"

#include "atmosphere/sun_share.glsl"
#include "interop/display.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alpenglow {

namespace {

constexpr int EXACT_CLEAR_SHARE_PERCENT = 8; ///< cells where nothing shades the air, for each exact one: 128 for 1600
constexpr int FAST_LOOKS = 8, DEFAULT_LOOKS = 24; ///< at the sun from each of the march's cells: docs/shafts.md
constexpr int FAST_SAVES = 8;                     ///< one of so many samples
constexpr int EXACT_LOOKS = 8;                    ///< at the sun's disc from each place; at a point one is enough
static_assert(std::max({FAST_LOOKS, DEFAULT_LOOKS, EXACT_LOOKS}) <= 32); // a bit for each

glm::mat4 view_clip(Camera const& camera, Extent extent, glm::dvec2 const& jitter) {
    double const scale = 1.0 / std::tan(0.5 * camera.vertical_fov);
    double const aspect = static_cast<double>(extent.width) / extent.height;
    glm::dmat4 clip(0.0);
    clip[0][0] = scale / aspect;
    clip[1][1] = -scale;
    clip[2] = glm::dvec4(-jitter, 0.0, -1.0);
    clip[3][2] = NEAR_PLANE;
    return glm::mat4(clip * glm::dmat4(glm::transpose(camera.world_from_camera)));
}

glm::mat4 cascade_clip(ShadowFit const& fit, CascadeFit const& cascade, glm::dvec3 const& camera_in_light) {
    double const scale = 1.0 / cascade.half_width;
    double const depth = 1.0 / (fit.farthest - fit.nearest);
    glm::dmat4 clip(1.0);
    clip[0][0] = clip[1][1] = scale;
    clip[2][2] = depth;
    clip[3] = glm::dvec4((glm::dvec2(camera_in_light) - cascade.centre) * scale,
                         (camera_in_light.z - fit.nearest) * depth, 1.0);
    return glm::mat4(clip * glm::dmat4(fit.light_from_world));
}

void set_cascades(shader::FrameConstants& frame, ShadowFit const& fit, glm::dvec3 const& camera) {
    glm::dvec3 const in_light = fit.light_from_world * camera;
    frame.light_from_world = glm::mat3(fit.light_from_world);
    frame.cascade_count = static_cast<int>(fit.cascades.size());
    frame.shadow_fade = 0.08f;
    double const depth = fit.cascades.empty() ? 1.0 : 1.0 / (fit.farthest - fit.nearest);
    frame.light_depth = glm::vec2(depth, (in_light.z - fit.nearest) * depth);
    for (std::size_t i = 0; i < MOST_CASCADES && !fit.cascades.empty(); ++i) {
        CascadeFit const& cascade = fit.cascades[std::min(i, fit.cascades.size() - 1)];
        frame.clip_from_relative[PROJECTION_CASCADE + i] = cascade_clip(fit, cascade, in_light);
        double const scale = 0.5 / cascade.half_width;
        frame.cascades[i].scale = static_cast<float>(scale);
        frame.cascades[i].offset = glm::vec2((glm::dvec2(in_light) - cascade.centre) * scale + 0.5);
        frame.cascades[i].texel = static_cast<float>(cascade.texel);
    }
}

int flags_of(World const& world, Settings const& settings, bool cascades) {
    int flags = 0;
    auto const set = [&](bool on, int flag) { flags |= on ? flag : 0; };
    set(world.planet.has_air, FRAME_HAS_AIR);
    set(world.planet.has_air && settings.air, FRAME_AIR);
    set(settings.shafts != "off" && cascades, FRAME_SHAFTS);
    set(settings.shadows && cascades, FRAME_SHADOWS);
    set(settings.march_dither, FRAME_MARCH_DITHER);
    set(settings.sun_disc, FRAME_SUN_DISC);
    set(world.studio.has_value(), FRAME_STUDIO);
    set(settings.stars, FRAME_STARS);
    set(settings.ambient_occlusion, FRAME_AMBIENT_OCCLUSION);
    set(world.planet.look == GroundLook::procedural, FRAME_PROCEDURAL_GROUND);
    return flags;
}

/// Where that share of the disc lies on one side: of its radius, from its centre.
float across_disc(float share) {
    float low = -1, high = 1;
    for (int halvings = 0; halvings < 20; ++halvings) {
        float const middle = 0.5f * (low + high);
        (shader::disc_share_above(middle) < share ? low : high) = middle;
    }
    return low;
}

void set_disc_slices(shader::FrameConstants& frame) {
    static std::array const slices = [] {
        std::array<float, DISC_SLICES> across;
        for (int i = 0; i < DISC_SLICES; ++i) across[i] = across_disc((static_cast<float>(i) + 0.5f) / DISC_SLICES);
        return across;
    }();
    std::ranges::copy(slices, frame.disc_across);
}

void set_samples(shader::FrameConstants& frame, Settings const& settings) {
    bool const exact = settings.shafts == "exact" && (frame.flags & FRAME_SHAFTS) != 0, fast = settings.shafts == "fast";
    frame.samples = exact ? std::max(settings.exact_steps * EXACT_CLEAR_SHARE_PERCENT / 100, 16)
                          : settings.samples - (fast ? settings.samples / FAST_SAVES : 0);
    frame.exact_cells = exact ? settings.exact_steps : 0;
    frame.shaft_looks = exact ? EXACT_LOOKS : fast ? FAST_LOOKS : DEFAULT_LOOKS;
}

} // namespace

glm::dvec2 supersample_offset(int index, int count) {
    // A square grid turned a little: no two samples share a row or a column, and their mean is the pixel's centre.
    int const side = static_cast<int>(std::lround(std::sqrt(count)));
    int const a = index / side, b = index % side;
    return glm::dvec2(a + (b + 0.5) / side, b + (side - 1 - a + 0.5) / side) / static_cast<double>(side) - 0.5;
}

int curve_index(std::string_view name) {
    constexpr std::array<std::string_view, CURVE_COUNT> NAMES{"filmic", "exponential", "reinhard", "aces",
                                                              "lottes", "uchimura",    "agx",      "linear"};
    return static_cast<int>(std::ranges::find(NAMES, name) - NAMES.begin());
}

shader::FrameConstants make_frame_constants(World const& world, Settings const& settings, Extent extent,
                                            ShadowFit const& shadow, CeilingFit const& ceiling,
                                            TerrainFit const& terrain, int sample_index) {
    Camera const& camera = world.camera;
    shader::FrameConstants frame{};
    frame.atmosphere = atmosphere_of(world.planet);
    glm::dvec2 const size(extent.width, extent.height);
    glm::dvec2 const jitter = 2.0 * supersample_offset(sample_index, settings.aa) / size;
    frame.clip_from_relative[PROJECTION_VIEW] = view_clip(camera, extent, jitter);
    set_cascades(frame, shadow, camera.position);
    frame.ceiling = ceiling_constants(ceiling, shadow.light_from_world, camera.position);
    frame.terrain = terrain_constants(terrain, camera.position);
    frame.shaded_altitude = static_cast<float>(ceiling.shaded_altitude);
    set_shaded_slabs(frame, ceiling);

    double const ty = std::tan(0.5 * camera.vertical_fov), tx = ty * size.x / size.y;
    frame.ray_centre = glm::vec3(camera.forward());
    frame.ray_right = glm::vec3(camera.world_from_camera[0] * tx);
    frame.ray_up = glm::vec3(camera.world_from_camera[1] * -ty);
    frame.near_plane = static_cast<float>(NEAR_PLANE);
    frame.inverse_size = glm::vec2(1.0 / size);
    frame.jitter = glm::vec2(jitter);
    double const distance = glm::length(camera.position);
    frame.camera_up = glm::vec3(camera.position / distance);
    frame.camera_altitude = static_cast<float>(distance - world.planet.radius);
    frame.camera_planet = glm::vec3(camera.position / world.planet.radius);
    frame.camera_in_period = glm::vec3(glm::mod(camera.position, glm::dvec3(GROUND_PERIOD)));
    frame.to_sun = glm::vec3(world.to_sun);
    frame.ground_tint = glm::vec3(world.planet.ground_albedo);
    if (world.studio) frame.fill = glm::vec3(world.studio->fill), frame.backdrop = glm::vec3(world.studio->backdrop);
    frame.pixel_angle = static_cast<float>(2.0 * ty / size.y);
    frame.texture_bias = static_cast<float>(-0.5 * std::log2(settings.aa));
    frame.flags = flags_of(world, settings, !shadow.cascades.empty());
    set_samples(frame, settings);
    set_disc_slices(frame);
    frame.sample_index = sample_index;
    return frame;
}

} // namespace alpenglow
