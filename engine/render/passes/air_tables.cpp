#include "render/passes/air_tables.h"

#include "render/models/model.h"

namespace alpenglow {

AirTables add_air_tables(FrameGraph& graph, FrameInputs const& in, ConstantsId frame) {
    AirTableInputs inputs{in, frame, {}, in.air_is_stale};
    for (std::size_t i = 0; i < in.model.tables.size(); ++i) {
        AirTable const& table = in.model.tables[i];
        inputs.tables.push_back(graph.import(*in.air_tables[i], table.name, table.scale, !in.air_is_stale));
    }
    return {in.model.add_tables(graph, inputs)};
}

} // namespace alpenglow
