// Passes `lighting` and `sky`: radiance of each pixel, of surfaces under sun and sky and of what stands in the sky, then the air in front
// of it. Each works off its own pixels of interop/pixel_work.h.
#ifndef ALPENGLOW_INTEROP_LIGHTING_H
#define ALPENGLOW_INTEROP_LIGHTING_H
#include "interop/air_model.h"
#include "interop/frame.h"

#define LIGHTING_ALBEDO_SLOT 1              // in, the G-buffer: interop/gbuffer.h
#define LIGHTING_NORMAL_SLOT 2
#define LIGHTING_MATERIAL_SLOT 3
#define LIGHTING_EMISSION_SLOT 4
#define LIGHTING_DEPTH_SLOT 5
#define LIGHTING_SHADOW_SLOT 6              // in, cascades: depth array with comparison
#define LIGHTING_LIT_SLOT 7                 // out of both, rgba32f: radiance, relative to the sun's irradiance
#define LIGHTING_OPEN_SLOT 8                // in: share of the light from all round that reaches the surface
#define LIGHTING_INSCATTERED_SLOT 9         // in, what the air in front of the pixel adds and lets through: interop/air.h
#define LIGHTING_TRANSMITTANCE_SLOT 10
#define LIGHTING_CEILING_SLOT 11            // in, interop/shadow_ceiling.h: linear filter, clamped to the edge
#define LIGHTING_TERRAIN_SLOT 12            // in, interop/terrain_light.h: likewise
#define LIGHTING_WORK_SLOT 13               // in

// What the shader shows in place of the radiance.
#define LIGHTING_RESULT 0
#define LIGHTING_SHOW_CASCADES 1            // which cascade shades what

SHADER_NAMESPACE_BEGIN
struct LightingPush {
    int show; // LIGHTING_…
};
struct SkyPush {
    vec2 celestial_turn; // cosine and sine of the angle from the world's axes to those of the stars
};
SHADER_NAMESPACE_END
#endif
