#pragma once

#include "gpu/buffer.h"
#include "gpu/pipeline_cache.h"
#include "render/frame_graph.h"

#include <memory>

namespace alpenglow {

struct PassTime {
    std::string name;
    double gpu_ms = 0;
    double cpu_ms = 0; ///< recording its commands
    std::uint64_t groups = 0; ///< workgroups of a compute pass
};

/// What a submit waits for and signals when a window is behind it.
struct PresentSync {
    VkSemaphore acquired = VK_NULL_HANDLE; ///< the swapchain image may be written
    VkSemaphore finished = VK_NULL_HANDLE; ///< the picture may be shown
};

/// Of images that live for a frame, and of those like them.
VkImageUsageFlags transient_usage(ImageShape const& shape);

/// Runs frame graphs on a device: derives descriptors, group counts, barriers, labels and timings from the
/// declarations. Keeps transient images, pipelines and samplers from frame to frame. Frames in flight have their own
/// copies of what the CPU writes.
class Executor {
public:
    explicit Executor(Device const& device, std::uint32_t frames_in_flight = 1);
    ~Executor();

    void submit(FrameGraph const& graph, PresentSync const& sync = {});
    /// Whether all pipelines of the graph are there. If not, a thread of the executor's own makes them; none of the
    /// scene that the graph draws may go before `stop_preparing`. Throws Error(device) where it could not make one.
    bool prepare(FrameGraph const& graph, Need need);
    void stop_preparing() { pipelines_.stop_preparing(); }
    /// Whether none is left to be made ahead. Throws as `prepare`.
    bool prepared() { return pipelines_.idle(); }
    /// How many pipelines `submit` had to make itself or to wait for.
    std::size_t pipelines_missed() const { return pipelines_.misses(); }
    /// Waits for all frames. Throws Error(device) where the device fails or stops answering.
    void wait();
    /// Timings of the newest frame that is finished, in order; passes of one name are added up.
    std::vector<PassTime> const& timings() const { return timings_; }
    /// A transient image of the last submitted graph; nullptr where there is none of that name.
    GpuImage* transient(std::string const& name);

private:
    struct InFlight;
    struct Recording;
    InFlight& next_slot();
    void collect(InFlight& slot);
    void upload_constants(InFlight& slot, FrameGraph const& graph);
    std::vector<GpuImage*> resolve_images(FrameGraph const& graph);
    std::vector<GpuBuffer*> resolve_work_lists(FrameGraph const& graph);
    void clear_images(Recording& recording, ComputePass const& pass);
    void prepare_work_lists(Recording& recording, ComputePass const& pass);
    void record_barriers_of(Recording& recording, std::vector<PlannedBarrier> const& barriers);
    void record(Recording& recording, ComputePass const& pass);
    void record(Recording& recording, RasterPass const& pass);
    void push_slots(Recording& recording, VkPipelineBindPoint point, VkPipelineLayout layout,
                    std::vector<Slot> const& slots);
    void submit_commands(InFlight& slot, PresentSync const& sync);

    class Draw;
    Device const& device_;
    PipelineCache pipelines_;
    SamplerCache samplers_;
    std::vector<std::unique_ptr<InFlight>> slots_;
    std::size_t next_ = 0;
    std::map<std::string, std::unique_ptr<GpuImage>> transients_;
    std::map<std::string, std::unique_ptr<GpuBuffer>> work_lists_;
    std::vector<PassTime> timings_;
};

} // namespace alpenglow
