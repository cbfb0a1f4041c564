#include "interop/models/march.h"

#include "interop/multiple_scattering.h"
#include "render/models/model.h"
#include "render/passes/transmittance.h"

#include <embedded_shaders.h>

#include <utility>

namespace alpenglow {

namespace {

/// Orders of scattering behind the first, and how often the orders to come are added as a geometric series: an order is
/// worth 0.4 of the last on Earth, 0.85 on the dense planet.
constexpr int ROUNDS = 18, EXTRAPOLATION = 6;

/// A workgroup for each node.
Extent const NODES{MULTIPLE_SCATTERING_WIDTH * WORKGROUP_SIZE, MULTIPLE_SCATTERING_HEIGHT * WORKGROUP_SIZE};

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

void add_all_orders(FrameGraph& graph, ConstantsId frame, ImageId transmittance, ImageId moments) {
    ImageShape const shape = graph.shape(moments);
    ImageId const first_order = graph.add_image("first_order", shape, ShowScale::logarithm);
    ImageId const between = graph.add_image("orders", shape, ShowScale::logarithm);
    ImageId before = ROUNDS % 2 == 0 ? moments : between;
    ImageId table = ROUNDS % 2 == 0 ? between : moments;
    add_first_order(graph, frame, transmittance, first_order, before);
    for (int round = 1; round <= ROUNDS; ++round) {
        add_order(graph, frame, first_order, before, table, round % EXTRAPOLATION == 0);
        std::swap(before, table);
    }
}

std::vector<Slot> add_tables(FrameGraph& graph, AirTableInputs const& inputs) {
    ImageId const transmittance = inputs.tables[0], moments = inputs.tables[1];
    if (inputs.stale) {
        add_transmittance(graph, inputs.frame, transmittance);
        add_all_orders(graph, inputs.frame, transmittance, moments);
    }
    return {sampled(MARCH_TRANSMITTANCE_SLOT, transmittance), sampled(MARCH_MULTIPLE_SCATTERING_SLOT, moments)};
}

} // namespace

AirModel make_march() {
    return {.name = "march",
            .help = "each pixel's ray marched; the sun's way and all further orders from tables",
            .lighting = shaders::lighting_march_comp,
            .tables = {{"transmittance", {TRANSMITTANCE_WIDTH, TRANSMITTANCE_HEIGHT}, ShowScale::optical_depth},
                       {"multiple_scattering",
                        {MULTIPLE_SCATTERING_WIDTH, LIGHT_TILES * MULTIPLE_SCATTERING_HEIGHT},
                        ShowScale::logarithm}},
            .add_tables = add_tables,
            .limits = [](World const&, Settings const&, bool) -> std::string_view { return {}; }};
}

} // namespace alpenglow
