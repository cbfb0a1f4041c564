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
    Maker(FrameGraph& graph, FrameInputs const& in, ConstantsId frame) : graph_(graph), in_(in), frame_(frame) {
        for (std::size_t i = 0; i < in.model.tables.size(); ++i) import(i);
    }
    void make(StepSlice const& slice);
    std::vector<ImageId> finished() const;

private:
    void import(std::size_t table);
    bool ends(StepSlice const& slice) const {
        return slice.first + slice.count == in_.model.steps[slice.step].groups;
    }

    FrameGraph& graph_;
    FrameInputs const& in_;
    ConstantsId frame_;
    std::vector<Twofold> tables_;
};

void Maker::import(std::size_t index) {
    AirTable const& table = in_.model.tables[index];
    TwofoldTable const& kept = in_.air_tables[index];
    std::size_t last = kept.finished;
    bool is_made = false;
    for (StepSlice const& slice : in_.table_slices) {
        if (in_.model.steps[slice.step].makes.table != index) continue;
        is_made = true;
        if (ends(slice)) last = 1 - last;
    }
    Twofold& twofold = tables_.emplace_back(Twofold{{}, kept.finished});
    twofold.images[last] = graph_.import(*kept.images[last], table.name, table.scale, kept.has_content[last]);
    if (!is_made) return;
    std::size_t const other = 1 - last;
    twofold.images[other] =
        graph_.import(*kept.images[other], table.name + "_before", ShowScale::number, kept.has_content[other]);
}

void Maker::make(StepSlice const& slice) {
    AirTableStep const& step = in_.model.steps[slice.step];
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
    Maker maker(graph, in, frame);
    for (StepSlice const& slice : in.table_slices) maker.make(slice);
    return {in.model.slots(graph, {in, frame, maker.finished()})};
}

} // namespace alpenglow
