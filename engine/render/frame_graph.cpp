#include "render/frame_graph.h"

#include <algorithm>

namespace alpenglow {

namespace {

void refuse_repeated_slots(std::string const& pass, std::vector<Slot> const& slots) {
    for (std::size_t i = 0; i < slots.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (slots[i].slot == slots[j].slot)
                throw GraphError("pass " + pass + " binds slot " + std::to_string(slots[i].slot) + " twice");
        }
    }
}

void add_slot_accesses(std::vector<ImageAccess>& accesses, std::vector<Slot> const& slots) {
    for (Slot const& slot : slots) {
        if (slot.image) accesses.push_back({slot.image, slot.use});
    }
}

std::vector<SlotLayout> layout_of(std::vector<Slot> const& slots) {
    std::vector<SlotLayout> result;
    for (Slot const& slot : slots) result.push_back({slot.slot, slot.type});
    return result;
}

PlannedPass planned(std::string const& name, ComputePass const& pass) {
    PlannedPass result{name, {}};
    add_slot_accesses(result.accesses, pass.slots);
    return result;
}

PlannedPass planned(std::string const& name, RasterPass const& pass) {
    PlannedPass result{name, {}};
    add_slot_accesses(result.accesses, pass.slots);
    for (ImageId color : pass.colors)
        result.accesses.push_back({color, pass.clear_colors ? ImageUse::color_clear : ImageUse::color_update});
    if (pass.depth)
        result.accesses.push_back({pass.depth, pass.clear_depth ? ImageUse::depth_clear : ImageUse::depth_update});
    return result;
}

} // namespace

Slot const* worked_off(ComputePass const& pass) {
    auto const found = std::ranges::find_if(pass.slots, [](Slot const& slot) { return slot.list && slot.use == ImageUse::sample; });
    return found == pass.slots.end() ? nullptr : &*found;
}

ImageId FrameGraph::add_image(std::string name, ImageShape const& shape, ShowScale scale) {
    if (find(name)) throw GraphError("two images are called " + name);
    images_.push_back({std::move(name), shape, scale, nullptr, false});
    return {static_cast<std::uint32_t>(images_.size() - 1)};
}

ImageId FrameGraph::import(GpuImage& image, std::string name, ShowScale scale, bool has_content) {
    ImageId const id = add_image(std::move(name), image.shape(), scale);
    images_.back().imported = &image;
    images_.back().has_content = has_content;
    return id;
}

WorkListId FrameGraph::add_work_list(std::string name, std::size_t capacity) {
    work_lists_.push_back({std::move(name), capacity});
    return {static_cast<std::uint32_t>(work_lists_.size() - 1)};
}

void FrameGraph::note_work(ComputePass const& pass) {
    for (Slot const& slot : pass.slots) {
        if (!slot.list) continue;
        WorkList& list = work_lists_.at(slot.list.index);
        if (slot.use == ImageUse::storage_write)
            list.filled = true;
        else if (!list.filled)
            throw GraphError("pass " + pass.name + " works off " + list.name + ", which nobody filled");
    }
}

ConstantsId FrameGraph::add_constant_bytes(std::vector<std::byte> bytes) {
    constants_.push_back(std::move(bytes));
    return {static_cast<std::uint32_t>(constants_.size() - 1)};
}

void FrameGraph::add(ComputePass pass) {
    refuse_repeated_slots(pass.name, pass.slots);
    note_work(pass);
    std::string name = pass.name;
    passes_.push_back({std::move(name), std::move(pass)});
}

void FrameGraph::add(RasterPass pass) {
    refuse_repeated_slots(pass.name, pass.slots);
    std::string name = pass.name;
    passes_.push_back({std::move(name), std::move(pass)});
}

ImageId FrameGraph::find(std::string_view name) const {
    auto const found = std::ranges::find(images_, name, &Image::name);
    return found == images_.end() ? ImageId{} : ImageId{static_cast<std::uint32_t>(found - images_.begin())};
}

std::vector<PlannedPass> FrameGraph::planned_passes() const {
    std::vector<PlannedPass> result;
    for (Pass const& pass : passes_) {
        result.push_back(std::visit([&](auto const& work) { return planned(pass.name, work); }, pass.work));
    }
    if (presented_) result.push_back({"present", {{presented_, ImageUse::present}}});
    return result;
}

PipelineRecipe FrameGraph::recipe(ComputePass const& pass) const {
    std::vector<std::int32_t> specialization{pass.variant};
    specialization.insert(specialization.end(), specialization_.begin(), specialization_.end());
    return {ComputeState{pass.shader, std::move(specialization)}, layout_of(pass.slots)};
}

PipelineRecipe FrameGraph::recipe(RasterPass const& pass, std::size_t pipeline) const {
    RasterState state = pass.pipelines.at(pipeline);
    for (ImageId color : pass.colors) state.colors.push_back(shape(color).format);
    if (pass.depth) state.depth = shape(pass.depth).format;
    return {std::move(state), layout_of(pass.slots)};
}

std::vector<PipelineRecipe> FrameGraph::recipes() const {
    std::vector<PipelineRecipe> result;
    for (Pass const& pass : passes_) {
        if (ComputePass const* const compute = std::get_if<ComputePass>(&pass.work)) {
            result.push_back(recipe(*compute));
            continue;
        }
        RasterPass const& raster = std::get<RasterPass>(pass.work);
        for (std::size_t i = 0; i < raster.pipelines.size(); ++i) result.push_back(recipe(raster, i));
    }
    return result;
}

} // namespace alpenglow
