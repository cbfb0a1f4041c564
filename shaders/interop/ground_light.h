// Passes `ground_response` and `ground_light`: light of ground that is not the planet's mean, see
// atmosphere/ground_response.glsl. The first is made in rounds, an order of scattering each, a workgroup a node; the
// second adds it to the table of all orders, a thread a node.
#ifndef ALPENGLOW_INTEROP_GROUND_LIGHT_H
#define ALPENGLOW_INTEROP_GROUND_LIGHT_H
#include "interop/frame.h"

#define GROUND_RESPONSE_BEFORE_SLOT 1 // in, orders up to the last: linear filter, clamped to the edge
#define GROUND_RESPONSE_TABLE_SLOT 2  // out, one order more; in, where it extrapolates: one order less

// Modes, beside MULTIPLE_SCATTERING_EXTRAPOLATES: the first round, whatever `before` holds.
#define GROUND_RESPONSE_STARTS 2

#define GROUND_LIGHT_SUNLIGHT_SLOT 1 // in: linear filter, clamped to the edge, as all
#define GROUND_LIGHT_ORDERS_SLOT 2        // in, all orders over the planet's mean albedo
#define GROUND_LIGHT_RESPONSE_SLOT 3      // in
#define GROUND_LIGHT_TABLE_SLOT 4         // out, all orders over the ground of GroundLightPush

SHADER_NAMESPACE_BEGIN
struct GroundLightPush {
    vec3 albedo;    // 0 to 1
    float altitude; // [m] where that ground lies, inside the air
};
SHADER_NAMESPACE_END

#endif
