#include "render/rehearsal.h"

#include "core/log.h"
#include "core/parallel.h"
#include "render/executor.h"

#include <bit>
#include <fmt/format.h>

namespace alpenglow {

namespace {

/// A few texels that are a power of two where the side is.
std::uint32_t stand_in_side(std::uint32_t side) { return std::has_single_bit(side) ? 8 : 12; }

ImageShape stand_in(ImageShape shape) {
    shape.extent = {stand_in_side(shape.extent.width), stand_in_side(shape.extent.height)};
    return shape;
}

} // namespace

Rehearsal::Rehearsal(Device const& device)
    : worker_([this, index = device.index()](std::stop_token const& stop) { work(stop, index); }) {}

Rehearsal::Part Rehearsal::part_of(FrameGraph const& graph, ComputePass const& pass) {
    PipelineRecipe const recipe = graph.recipe(pass);
    Part part{pass, graph.specialization(), {}, {}, recipe.key()};
    part.pass.threads = {0, 0};
    for (Slot const& slot : pass.slots) {
        bool const constants = slot.type == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
        part.constant_bytes.push_back(constants ? graph.constant_blocks()[slot.constants.index].size() : 0);
        ImageShape const shape = slot.image ? stand_in(graph.shape(slot.image)) : ImageShape{};
        part.images.push_back(shape);
        part.key += fmt::format(" {} {} {} {}", static_cast<int>(shape.format), shape.extent.width,
                                shape.extent.height, shape.layers);
    }
    return part;
}

std::vector<Rehearsal::Part> Rehearsal::unseen(FrameGraph const& graph) {
    std::vector<Part> parts;
    for (FrameGraph::Pass const& pass : graph.passes()) {
        ComputePass const* const compute = std::get_if<ComputePass>(&pass.work);
        if (!compute) continue;
        Part part = part_of(graph, *compute);
        if (seen_.insert(part.key).second) parts.push_back(std::move(part));
    }
    return parts;
}

void Rehearsal::skip(FrameGraph const& graph) { unseen(graph); }

void Rehearsal::add(FrameGraph const& graph) {
    std::vector<Part> parts = unseen(graph);
    std::lock_guard const lock(mutex_);
    for (Part& part : parts) parts_.push_back(std::move(part));
    changed_.notify_all();
}

bool Rehearsal::idle() const {
    std::lock_guard const lock(mutex_);
    return ended_ || (parts_.empty() && !busy_);
}

void Rehearsal::rehearse(Part const& part, Executor& executor, Device const& device) {
    FrameGraph graph;
    graph.specialize(part.specialization);
    ComputePass pass = part.pass;
    std::vector<std::unique_ptr<GpuImage>> images;
    for (std::size_t i = 0; i < pass.slots.size(); ++i) {
        if (part.constant_bytes[i] > 0) {
            pass.slots[i].constants = graph.add_constant_bytes(std::vector<std::byte>(part.constant_bytes[i]));
            continue;
        }
        std::string const name = fmt::format("stand_in_{}", i);
        if (pass.slots[i].list) {
            pass.slots[i] = fills(pass.slots[i].slot, graph.add_work_list(name, 1)); // empty
            continue;
        }
        ImageShape const& shape = part.images[i];
        images.push_back(std::make_unique<GpuImage>(device, shape, transient_usage(shape), name));
        pass.slots[i].image = graph.import(*images.back(), name, ShowScale::number, true);
    }
    graph.add(std::move(pass));
    executor.submit(graph);
    executor.wait();
}

void Rehearsal::work(std::stop_token const& stop, int device_index) {
    let_others_pass(); // and with this thread those of its device
    try {
        Device const device(DeviceOptions{.index = device_index});
        Executor executor(device);
        while (std::optional<Part> const part = next(stop)) rehearse(*part, executor, device);
    } catch (std::exception const& failure) {
        log_warning(std::string("shaders are compiled when they are first used: ") + failure.what());
    }
    std::lock_guard const lock(mutex_);
    busy_ = false, ended_ = true;
}

/// Waits for it; nothing when all has to stop.
std::optional<Rehearsal::Part> Rehearsal::next(std::stop_token const& stop) {
    std::unique_lock lock(mutex_);
    busy_ = false;
    changed_.wait(lock, stop, [&] { return !parts_.empty(); });
    if (stop.stop_requested()) return std::nullopt;
    busy_ = true;
    Part part = std::move(parts_.front());
    parts_.pop_front();
    return part;
}

} // namespace alpenglow
