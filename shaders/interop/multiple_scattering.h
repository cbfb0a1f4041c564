// Passes `first_order` and `multiple_scattering`: the moments of the light around each node, after `sunlight`. A
// workgroup a node, a thread a share of its directions. The second pass runs in rounds, an order of scattering each.
// Tables: rgba32f, the nodes' width x LIGHT_TILES times their height, see atmosphere/light_moments.glsl.
#ifndef ALPENGLOW_INTEROP_MULTIPLE_SCATTERING_H
#define ALPENGLOW_INTEROP_MULTIPLE_SCATTERING_H
#include "interop/frame.h"

#define FIRST_ORDER_SUNLIGHT_SLOT 1 // in, the table of sunlight: linear filter, clamped to the edge
#define FIRST_ORDER_TABLE_SLOT 2         // out, light scattered once

#define MULTIPLE_SCATTERING_FIRST_ORDER_SLOT 1 // in, light scattered once, at the same nodes
#define MULTIPLE_SCATTERING_BEFORE_SLOT 2      // in, orders up to the last, at any nodes: linear filter, clamped to the edge
#define MULTIPLE_SCATTERING_TABLE_SLOT 3       // out, one order more; in, where it extrapolates: one order less

// Mode: adds the orders to come as a geometric series; `before` is at the same nodes.
#define MULTIPLE_SCATTERING_EXTRAPOLATES 1

#endif
