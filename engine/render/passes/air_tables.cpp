#include "render/passes/air_tables.h"

#include "render/models/model.h"

#include <utility>

namespace alpenglow {

namespace {

/// Orders of scattering behind the first. An order is worth 0.43 of the last over Earth with a ground albedo of 0.3.
constexpr int ROUNDS = 12;

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

/// One order more: `table` from `before`.
void add_order(FrameGraph& graph, ConstantsId frame, ImageId first_order, ImageId before, ImageId table) {
    graph.add(ComputePass{"multiple_scattering",
                          shaders::multiple_scattering_comp,
                          {constants(MULTIPLE_SCATTERING_FRAME_SLOT, frame),
                           sampled(MULTIPLE_SCATTERING_FIRST_ORDER_SLOT, first_order, NEAREST_CLAMP),
                           sampled(MULTIPLE_SCATTERING_BEFORE_SLOT, before),
                           stored(MULTIPLE_SCATTERING_TABLE_SLOT, table)},
                          NODES});
}

} // namespace

AirTables add_air_tables(FrameGraph& graph, FrameInputs const& in, ConstantsId frame) {
    AirTableInputs inputs{in, frame, {}, in.air_is_stale};
    for (std::size_t i = 0; i < in.model.tables.size(); ++i) {
        AirTable const& table = in.model.tables[i];
        inputs.tables.push_back(graph.import(*in.air_tables[i], table.name, table.scale, !in.air_is_stale));
    }
    return {in.model.add_tables(graph, inputs)};
}

} // namespace alpenglow
