#include "render/executor.h"

#include "core/error.h"
#include "interop/work_list.h"

#include <algorithm>
#include <chrono>

namespace alpenglow {

namespace {

constexpr std::uint32_t MOST_PASSES = 1024;
constexpr std::uint64_t DEVICE_PATIENCE_NS = 120'000'000'000; // software devices take seconds for a heavy frame
constexpr std::uint32_t WORKGROUP = 8;                        // interop/language.h: WORKGROUP_SIZE

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

Extent workgroups(ComputePass const& pass) {
    return {(pass.threads.width + WORKGROUP - 1) / WORKGROUP, (pass.threads.height + WORKGROUP - 1) / WORKGROUP};
}

std::uint64_t workgroups(FrameGraph::Pass const& pass) {
    ComputePass const* const compute = std::get_if<ComputePass>(&pass.work);
    return compute && !worked_off(*compute) ? workgroups(*compute).pixels() : 0;
}

VkRenderingAttachmentInfo attachment(VkImageView view, VkImageLayout layout, bool clear) {
    VkRenderingAttachmentInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
    info.imageView = view;
    info.imageLayout = layout;
    info.loadOp = clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
    info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    return info;
}

/// Everything after it waits for everything before it and sees what that wrote.
void full_barrier(VkCommandBuffer commands) {
    VkMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
    barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    VkDependencyInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    info.memoryBarrierCount = 1;
    info.pMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &info);
}

} // namespace

VkImageUsageFlags transient_usage(ImageShape const& shape) {
    VkImageUsageFlags const common = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    if (shape.is_depth()) return common | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    if (shape.format == VK_FORMAT_R32G32B32A32_SFLOAT || shape.format == VK_FORMAT_R16G16B16A16_SFLOAT ||
        shape.format == VK_FORMAT_R32_SFLOAT || shape.format == VK_FORMAT_R32G32_SFLOAT)
        return common | VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    if (shape.format == VK_FORMAT_R8G8B8A8_UNORM)
        return common | VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    return common | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
}

struct Executor::InFlight {
    VkCommandPool pool = VK_NULL_HANDLE;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkFence fence = VK_NULL_HANDLE;
    VkQueryPool queries = VK_NULL_HANDLE;
    bool submitted = false;
    std::unique_ptr<GpuBuffer> constants;
    std::vector<VkDeviceSize> offsets; ///< of each constant block
    std::vector<PassTime> passes;      ///< one for each pair of queries
};

struct Executor::Recording {
    InFlight& slot;
    FrameGraph const& graph;
    std::vector<GpuImage*> images;
    std::vector<GpuBuffer*> work_lists;
    VkCommandBuffer commands() const { return slot.commands; }
};

Executor::Executor(Device const& device, std::uint32_t frames_in_flight)
    : device_(device), pipelines_([&device](PipelineRecipe const& recipe) { return make_pipeline(device, recipe); }),
      samplers_(device) {
    for (std::uint32_t i = 0; i < frames_in_flight; ++i) {
        InFlight& slot = *slots_.emplace_back(std::make_unique<InFlight>());
        VkCommandPoolCreateInfo pool{};
        pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
        pool.queueFamilyIndex = device.queue_family();
        check(vkCreateCommandPool(device.handle(), &pool, nullptr, &slot.pool), "making a command pool");
        VkCommandBufferAllocateInfo allocate{};
        allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
        allocate.commandPool = slot.pool;
        allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
        allocate.commandBufferCount = 1;
        check(vkAllocateCommandBuffers(device.handle(), &allocate, &slot.commands), "making a command buffer");
        VkFenceCreateInfo fence{};
        fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
        check(vkCreateFence(device.handle(), &fence, nullptr, &slot.fence), "making a fence");
        VkQueryPoolCreateInfo queries{};
        queries.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
        queries.queryType = VK_QUERY_TYPE_TIMESTAMP;
        queries.queryCount = 2 * MOST_PASSES;
        check(vkCreateQueryPool(device.handle(), &queries, nullptr, &slot.queries), "making timers");
    }
}

Executor::~Executor() {
    vkDeviceWaitIdle(device_.handle());
    for (auto const& slot : slots_) {
        vkDestroyQueryPool(device_.handle(), slot->queries, nullptr);
        vkDestroyFence(device_.handle(), slot->fence, nullptr);
        vkDestroyCommandPool(device_.handle(), slot->pool, nullptr);
    }
}

bool Executor::prepare(FrameGraph const& graph, Need need) {
    bool all = true;
    for (PipelineRecipe const& recipe : graph.recipes()) all = pipelines_.prepare(recipe, need) && all;
    return all;
}

GpuImage* Executor::transient(std::string const& name) {
    auto const found = transients_.find(name);
    return found == transients_.end() ? nullptr : found->second.get();
}

void Executor::collect(InFlight& slot) {
    if (!slot.submitted) return;
    VkResult const result = vkWaitForFences(device_.handle(), 1, &slot.fence, VK_TRUE, DEVICE_PATIENCE_NS);
    check(result, "waiting for a frame");
    if (result == VK_TIMEOUT)
        throw Error(ErrorKind::device, "the device did not answer for two minutes", device_.name(),
                    "try a smaller --size or fewer --set samples=N");
    check(vkResetFences(device_.handle(), 1, &slot.fence), "resetting a fence");
    slot.submitted = false;

    std::vector<std::uint64_t> stamps(2 * slot.passes.size());
    if (!stamps.empty()) {
        check(vkGetQueryPoolResults(device_.handle(), slot.queries, 0, static_cast<std::uint32_t>(stamps.size()),
                                    stamps.size() * 8, stamps.data(), 8,
                                    VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
              "reading timers");
    }
    timings_.clear();
    double const ms_per_tick = static_cast<double>(device_.limits().timestampPeriod) * 1e-6;
    for (std::size_t i = 0; i < slot.passes.size(); ++i) {
        double const gpu_ms = static_cast<double>(stamps[2 * i + 1] - stamps[2 * i]) * ms_per_tick;
        auto entry = std::ranges::find(timings_, slot.passes[i].name, &PassTime::name);
        if (entry == timings_.end()) entry = timings_.insert(timings_.end(), {slot.passes[i].name});
        entry->gpu_ms += gpu_ms;
        entry->cpu_ms += slot.passes[i].cpu_ms;
        entry->groups += slot.passes[i].groups;
    }
}

Executor::InFlight& Executor::next_slot() {
    InFlight& slot = *slots_[next_];
    next_ = (next_ + 1) % slots_.size();
    collect(slot);
    return slot;
}

void Executor::wait() {
    for (std::size_t i = 0; i < slots_.size(); ++i) collect(*slots_[(next_ + i) % slots_.size()]);
}

void Executor::upload_constants(InFlight& slot, FrameGraph const& graph) {
    VkDeviceSize const alignment = std::max<VkDeviceSize>(device_.limits().minUniformBufferOffsetAlignment, 16);
    VkDeviceSize bytes = 0;
    slot.offsets.clear();
    for (auto const& block : graph.constant_blocks()) {
        slot.offsets.push_back(bytes);
        bytes += (block.size() + alignment - 1) / alignment * alignment;
    }
    if (!slot.constants || slot.constants->bytes() < bytes) {
        slot.constants = std::make_unique<GpuBuffer>(device_, std::max<VkDeviceSize>(bytes, 1),
                                                     VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, BufferHome::host, "constants");
    }
    for (std::size_t i = 0; i < slot.offsets.size(); ++i) {
        auto const& block = graph.constant_blocks()[i];
        std::memcpy(slot.constants->mapped().data() + slot.offsets[i], block.data(), block.size());
    }
}

std::vector<GpuImage*> Executor::resolve_images(FrameGraph const& graph) {
    std::vector<GpuImage*> images;
    for (FrameGraph::Image const& image : graph.images()) {
        if (image.imported) {
            images.push_back(image.imported);
            continue;
        }
        std::unique_ptr<GpuImage>& kept = transients_[image.name];
        if (!kept || kept->shape() != image.shape) {
            if (kept) wait();
            kept.reset();
            kept = std::make_unique<GpuImage>(device_, image.shape, transient_usage(image.shape), image.name);
        }
        images.push_back(kept.get());
    }
    return images;
}

std::vector<GpuBuffer*> Executor::resolve_work_lists(FrameGraph const& graph) {
    std::vector<GpuBuffer*> lists;
    for (FrameGraph::WorkList const& list : graph.work_lists()) {
        VkDeviceSize const bytes = sizeof(shader::WorkListHead) + sizeof(std::uint32_t) * list.capacity;
        std::unique_ptr<GpuBuffer>& kept = work_lists_[list.name];
        if (!kept || kept->bytes() < bytes) {
            if (kept) wait();
            VkBufferUsageFlags const usage =
                VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
            kept = std::make_unique<GpuBuffer>(device_, bytes, usage, BufferHome::device, list.name);
        }
        lists.push_back(kept.get());
    }
    return lists;
}

/// Before a pass that fills lists or works them off.
void Executor::prepare_work_lists(Recording& recording, ComputePass const& pass) {
    for (Slot const& slot : pass.slots) {
        if (!slot.list) continue;
        full_barrier(recording.commands());
        if (slot.use != ImageUse::storage_write) continue;
        shader::WorkListHead const empty{{{0, 1, 1}, {0, 1, 1}}, {0, 0}};
        vkCmdUpdateBuffer(recording.commands(), recording.work_lists[slot.list.index]->handle(), 0, sizeof(empty), &empty);
        full_barrier(recording.commands());
    }
}

void Executor::submit(FrameGraph const& graph, PresentSync const& sync) {
    if (graph.passes().size() > MOST_PASSES) throw GraphError("a frame has more passes than timers");
    InFlight& slot = next_slot();
    Recording recording{slot, graph, resolve_images(graph), resolve_work_lists(graph)};
    upload_constants(slot, graph);

    std::vector<PlannedImage> planned;
    for (std::size_t i = 0; i < graph.images().size(); ++i) {
        planned.push_back({graph.images()[i].name, graph.images()[i].has_content, recording.images[i]->state});
    }
    Plan const frame_plan = plan(planned, graph.planned_passes());

    check(vkResetCommandPool(device_.handle(), slot.pool, 0), "resetting commands");
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(slot.commands, &begin), "recording commands");
    vkCmdResetQueryPool(slot.commands, slot.queries, 0, 2 * MOST_PASSES);
    slot.passes.clear();
    for (std::size_t i = 0; i < graph.passes().size(); ++i) {
        FrameGraph::Pass const& pass = graph.passes()[i];
        Clock::time_point const start = Clock::now();
        device_.begin_label(slot.commands, pass.name.c_str());
        record_barriers_of(recording, frame_plan.barriers[i]);
        std::uint32_t const query = 2 * static_cast<std::uint32_t>(i);
        vkCmdWriteTimestamp2(slot.commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, slot.queries, query);
        // lavapipe runs a dispatch at once, but a timestamp behind raster passes only when it next waits for them: without
        // a wait, a dispatch lies between two timestamps that are taken together.
        if (device_.is_software()) full_barrier(slot.commands);
        std::visit([&](auto const& work) { record(recording, work); }, pass.work);
        vkCmdWriteTimestamp2(slot.commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, slot.queries, query + 1);
        device_.end_label(slot.commands);
        slot.passes.push_back({pass.name, 0, milliseconds_since(start), workgroups(pass)});
    }
    if (graph.presented()) record_barriers_of(recording, frame_plan.barriers.back());
    for (std::size_t i = 0; i < recording.images.size(); ++i) recording.images[i]->state = frame_plan.after[i];
    check(vkEndCommandBuffer(slot.commands), "recording commands");
    submit_commands(slot, sync);
}

void Executor::submit_commands(InFlight& slot, PresentSync const& sync) {
    auto const semaphore_info = [](VkSemaphore semaphore) {
        VkSemaphoreSubmitInfo info{};
        info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO;
        info.semaphore = semaphore;
        info.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
        return info;
    };
    VkSemaphoreSubmitInfo const wait = semaphore_info(sync.acquired), signal = semaphore_info(sync.finished);
    VkCommandBufferSubmitInfo commands{};
    commands.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
    commands.commandBuffer = slot.commands;
    VkSubmitInfo2 info{};
    info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
    info.waitSemaphoreInfoCount = sync.acquired ? 1 : 0;
    info.pWaitSemaphoreInfos = &wait;
    info.commandBufferInfoCount = 1;
    info.pCommandBufferInfos = &commands;
    info.signalSemaphoreInfoCount = sync.finished ? 1 : 0;
    info.pSignalSemaphoreInfos = &signal;
    check(vkQueueSubmit2(device_.queue(), 1, &info, slot.fence), "submitting a frame");
    slot.submitted = true;
}

void Executor::record_barriers_of(Recording& recording, std::vector<PlannedBarrier> const& barriers) {
    std::vector<VkImageMemoryBarrier2> list;
    for (PlannedBarrier const& barrier : barriers) {
        GpuImage const& image = *recording.images[barrier.image.index];
        list.push_back(image_barrier(image.handle(), image.shape().aspect(), barrier.before, barrier.after));
    }
    record_barriers(recording.commands(), list);
}

void Executor::push_slots(Recording& recording, VkPipelineBindPoint point, VkPipelineLayout layout,
                          std::vector<Slot> const& slots) {
    std::vector<VkDescriptorImageInfo> images(slots.size());
    std::vector<VkDescriptorBufferInfo> buffers(slots.size());
    std::vector<VkWriteDescriptorSet> writes(slots.size());
    for (std::size_t i = 0; i < slots.size(); ++i) {
        Slot const& slot = slots[i];
        writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        writes[i].dstBinding = slot.slot;
        writes[i].descriptorCount = 1;
        writes[i].descriptorType = slot.type;
        writes[i].pImageInfo = &images[i];
        writes[i].pBufferInfo = &buffers[i];
        if (slot.type == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER) {
            std::uint32_t const block = slot.constants.index;
            buffers[i] = {recording.slot.constants->handle(), recording.slot.offsets.at(block),
                          recording.graph.constant_blocks()[block].size()};
            continue;
        }
        if (slot.type == VK_DESCRIPTOR_TYPE_STORAGE_BUFFER) {
            buffers[i] = {recording.work_lists[slot.list.index]->handle(), 0, VK_WHOLE_SIZE};
            continue;
        }
        GpuImage const& image = *recording.images[slot.image.index];
        images[i].imageView = slot.as_array ? image.array_view() : image.view();
        images[i].imageLayout = state_of(slot.use).layout;
        if (slot.type == VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER) images[i].sampler = samplers_.get(slot.sampler);
    }
    device_.push_descriptors()(recording.commands(), point, layout, 0, static_cast<std::uint32_t>(writes.size()),
                               writes.data());
}

void Executor::clear_images(Recording& recording, ComputePass const& pass) {
    for (Slot const& slot : pass.slots) {
        if (slot.use != ImageUse::storage_clear) continue;
        VkClearColorValue const value{{slot.clear, slot.clear, slot.clear, slot.clear}};
        VkImageSubresourceRange const whole{VK_IMAGE_ASPECT_COLOR_BIT, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};
        vkCmdClearColorImage(recording.commands(), recording.images[slot.image.index]->handle(), VK_IMAGE_LAYOUT_GENERAL, &value, 1, &whole);
        full_barrier(recording.commands());
    }
}

void Executor::record(Recording& recording, ComputePass const& pass) {
    Pipeline const& pipeline = pipelines_.get(recording.graph.recipe(pass));
    VkCommandBuffer const commands = recording.commands();
    clear_images(recording, pass);
    prepare_work_lists(recording, pass);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.handle());
    push_slots(recording, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.layout(), pass.slots);
    if (!pass.push.empty()) {
        vkCmdPushConstants(commands, pipeline.layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0,
                           static_cast<std::uint32_t>(pass.push.size()), pass.push.data());
    }
    if (Slot const* const work = worked_off(pass)) {
        vkCmdDispatchIndirect(commands, recording.work_lists[work->list.index]->handle(), work->kind * sizeof(shader::WorkGroups));
        return;
    }
    Extent const groups = workgroups(pass);
    vkCmdDispatch(commands, groups.width, groups.height, 1);
}

class Executor::Draw final : public DrawContext {
public:
    Draw(Executor& executor, Recording& recording, RasterPass const& pass)
        : executor_(executor), recording_(recording), pass_(pass) {}

    VkCommandBuffer commands() const override { return recording_.commands(); }

    void use(std::size_t index) override {
        Pipeline const& pipeline = executor_.pipelines_.get(recording_.graph.recipe(pass_, index));
        layout_ = pipeline.layout();
        vkCmdBindPipeline(commands(), VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.handle());
        executor_.push_slots(recording_, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, pass_.slots);
    }
    void push(std::span<std::byte const> bytes) override {
        vkCmdPushConstants(commands(), layout_, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                           static_cast<std::uint32_t>(bytes.size()), bytes.data());
    }
    void bind_set1(VkDescriptorSet set) override {
        vkCmdBindDescriptorSets(commands(), VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 1, 1, &set, 0, nullptr);
    }

private:
    Executor& executor_;
    Recording& recording_;
    RasterPass const& pass_;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
};

void Executor::record(Recording& recording, RasterPass const& pass) {
    Extent extent{};
    std::vector<VkRenderingAttachmentInfo> colors;
    for (ImageId color : pass.colors) {
        colors.push_back(attachment(recording.images[color.index]->view(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                    pass.clear_colors));
        extent = recording.graph.shape(color).extent;
    }
    VkRenderingAttachmentInfo depth{};
    if (pass.depth) {
        depth = attachment(recording.images[pass.depth.index]->layer_view(pass.depth_layer),
                           VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, pass.clear_depth.has_value());
        depth.clearValue.depthStencil.depth = pass.clear_depth.value_or(0.0f);
        extent = recording.graph.shape(pass.depth).extent;
    }
    VkRenderingInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
    info.renderArea.extent = {extent.width, extent.height};
    info.layerCount = 1;
    info.colorAttachmentCount = static_cast<std::uint32_t>(colors.size());
    info.pColorAttachments = colors.data();
    info.pDepthAttachment = pass.depth ? &depth : nullptr;

    VkCommandBuffer const commands = recording.commands();
    vkCmdBeginRendering(commands, &info);
    VkViewport const viewport{0, 0, static_cast<float>(extent.width), static_cast<float>(extent.height), 0, 1};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &info.renderArea);
    vkCmdSetCullMode(commands, VK_CULL_MODE_NONE);
    vkCmdSetFrontFace(commands, VK_FRONT_FACE_COUNTER_CLOCKWISE);
    Draw draw(*this, recording, pass);
    pass.draw(draw);
    vkCmdEndRendering(commands);
}

} // namespace alpenglow
