#include "render/passes/air_tables.h"

#include "interop/multiple_scattering.h"
#include "interop/transmittance.h"

#include <embedded_shaders.h>

#include <utility>

namespace alpenglow {

namespace {

/// Orders of scattering behind the first, and how often the orders to come are added as a geometric series: an order is
/// worth 0.4 of the last on Earth, 0.85 on the dense planet.
constexpr int ROUNDS = 12, EXTRAPOLATION = 4;

/// A workgroup for each node.
Extent const NODES{MULTIPLE_SCATTERING_WIDTH * WORKGROUP_SIZE, MULTIPLE_SCATTERING_HEIGHT * WORKGROUP_SIZE};

void add_transmittance(FrameGraph& graph, ConstantsId frame, ImageId table) {
    graph.add(ComputePass{"transmittance",
                          shaders::transmittance_comp,
                          {constants(TRANSMITTANCE_FRAME_SLOT, frame), stored(TRANSMITTANCE_TABLE_SLOT, table)},
                          graph.shape(table).extent});
}

void add_first_order(FrameGraph& graph, ConstantsId frame, ImageId transmittance, ImageId table, ImageId start) {
    graph.add(ComputePass{"first_order",
                          shaders::first_order_comp,
                          {constants(FIRST_ORDER_FRAME_SLOT, frame),
                           sampled(FIRST_ORDER_TRANSMITTANCE_SLOT, transmittance),
                           stored(FIRST_ORDER_TABLE_SLOT, table), stored(FIRST_ORDER_START_SLOT, start)},
                          NODES});
}

/// One order more: `table` from `before`. Where it extrapolates `table` holds one order less than `before`.
void add_order(FrameGraph& graph, ConstantsId frame, ImageId first_order, ImageId before, ImageId table,
               bool extrapolates) {
    shader::MultipleScatteringPush const push{extrapolates ? 1 : 0};
    graph.add(ComputePass{"multiple_scattering",
                          shaders::multiple_scattering_comp,
                          {constants(MULTIPLE_SCATTERING_FRAME_SLOT, frame),
                           sampled(MULTIPLE_SCATTERING_FIRST_ORDER_SLOT, first_order, NEAREST_CLAMP),
                           sampled(MULTIPLE_SCATTERING_BEFORE_SLOT, before),
                           extrapolates ? updated(MULTIPLE_SCATTERING_TABLE_SLOT, table)
                                        : stored(MULTIPLE_SCATTERING_TABLE_SLOT, table)},
                          NODES,
                          bytes_of(push)});
}

} // namespace

AirTables add_air_tables(FrameGraph& graph, FrameInputs const& in, ConstantsId frame) {
    bool const kept = !in.air_is_stale;
    AirTables const air{graph.import(in.transmittance, "transmittance", ShowScale::optical_depth, kept),
                        graph.import(in.multiple_scattering, "multiple_scattering", ShowScale::logarithm, kept)};
    if (kept) return air;
    ImageShape const shape = graph.shape(air.multiple_scattering);
    ImageId const first_order = graph.add_image("first_order", shape, ShowScale::logarithm);
    ImageId const between = graph.add_image("orders", shape, ShowScale::logarithm);
    add_transmittance(graph, frame, air.transmittance);
    ImageId before = ROUNDS % 2 == 0 ? air.multiple_scattering : between;
    ImageId table = ROUNDS % 2 == 0 ? between : air.multiple_scattering;
    add_first_order(graph, frame, air.transmittance, first_order, before);
    for (int round = 1; round <= ROUNDS; ++round) {
        add_order(graph, frame, first_order, before, table, round % EXTRAPOLATION == 0);
        std::swap(before, table);
    }
    return air;
}

} // namespace alpenglow
