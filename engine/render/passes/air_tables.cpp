#include "render/passes/air_tables.h"

#include "interop/air_tables.h"
#include "render/air_table_store.h"

namespace alpenglow {

namespace {

/// The two images of a table in the frame. The one that is finished behind the frame's passes has the table's name.
struct Twofold {
    std::array<ImageId, 2> images;
    std::size_t finished;
};

class Maker {
public:
    Maker(FrameGraph& graph, ModelTables const& air, ConstantsId frame, bool ahead)
        : graph_(graph), air_(air), frame_(frame), ahead_(ahead) {
        for (std::size_t i = 0; i < air.model.tables.size(); ++i) import(i);
        for (StepSlice const& slice : air.slices) make(slice);
    }
    std::vector<ImageId> finished() const;

private:
    void import(std::size_t index);
    void make(StepSlice const& slice);
    bool ends(StepSlice const& slice) const {
        return slice.first + slice.count == air_.steps[slice.step].groups;
    }

    FrameGraph& graph_;
    ModelTables const& air_;
    ConstantsId frame_;
    bool ahead_; ///< two models may have tables of one name; those that the frame doesn't read are not shown
    std::vector<Twofold> tables_;
};

void Maker::import(std::size_t index) {
    AirTable const& table = air_.model.tables[index];
    TwofoldTable const& kept = air_.tables[index];
    std::string const name = ahead_ ? table.name + "_ahead" : table.name;
    std::size_t last = kept.finished;
    bool is_made = false;
    for (StepSlice const& slice : air_.slices) {
        if (air_.steps[slice.step].makes.table != index) continue;
        is_made = true;
        if (ends(slice)) last = 1 - last;
    }
    Twofold& twofold = tables_.emplace_back(Twofold{{}, kept.finished});
    twofold.images[last] =
        graph_.import(*kept.images[last], name, ahead_ ? ShowScale::number : table.scale, kept.has_content[last]);
    if (!is_made) return;
    std::size_t const other = 1 - last;
    twofold.images[other] =
        graph_.import(*kept.images[other], name + "_before", ShowScale::number, kept.has_content[other]);
}

void Maker::make(StepSlice const& slice) {
    AirTableStep const& step = air_.steps[slice.step];
    Twofold& made = tables_[step.makes.table];
    ImageId const target = made.images[1 - made.finished];
    std::vector<Slot> slots{constants(FRAME_SLOT, frame_), step.updates ? updated(step.makes.slot, target)
                                                                             : stored(step.makes.slot, target)};
    for (TableUse const& use : step.reads) {
        Twofold const& table = tables_[use.table];
        slots.push_back(sampled(use.slot, table.images[table.finished], use.sampler));
    }
    shader::AirTablePush const push{static_cast<int>(slice.first), step.mode};
    graph_.add(ComputePass{step.pass, step.shader, std::move(slots), {slice.count * WORKGROUP_SIZE, WORKGROUP_SIZE},
                           bytes_of(push)});
    if (ends(slice)) made.finished = 1 - made.finished;
}

std::vector<ImageId> Maker::finished() const {
    std::vector<ImageId> result;
    for (Twofold const& table : tables_) result.push_back(table.images[table.finished]);
    return result;
}

} // namespace

AirTables add_air_tables(FrameGraph& graph, FrameInputs const& in, ConstantsId frame) {
    if (in.air_ahead) Maker(graph, *in.air_ahead, frame, true);
    AirTableInputs const inputs{in, frame, Maker(graph, in.air, frame, false).finished()};
    AirModel const& model = in.air.model;
    return {model.slots(graph, inputs),
            in.terrain.light_is_new ? model.sky(graph, inputs, in.terrain_ground) : SkyTables{}};
}

} // namespace alpenglow
