#pragma once

#include "render/frame_graph.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

namespace alpenglow {

class Executor;

/// A software device compiles a shader only when it runs, in the middle of a frame, and anew for other kinds of images:
/// formats, and whether sides are powers of two. A rehearsal binds compute passes to images of those kinds on a second
/// device and starts no threads of them, so that the code is in the driver's cache on disk when a frame needs it.
/// Frames go before it. Where it fails, shaders are compiled in frames, and the log says so.
class Rehearsal {
public:
    /// `device` is the one whose frames are rehearsed.
    explicit Rehearsal(Device const& device);
    /// Waits for the pass that is being rehearsed.
    ~Rehearsal() = default;
    Rehearsal(Rehearsal const&) = delete;
    Rehearsal& operator=(Rehearsal const&) = delete;

    /// Rehearses the graph's compute passes, but those that it has seen before.
    void add(FrameGraph const& graph);
    /// The graph has run: nothing of it is to be rehearsed.
    void skip(FrameGraph const& graph);
    /// Whether nothing is left to rehearse.
    bool idle() const;

private:
    /// A pass with what a stand-in has to be like.
    struct Part {
        ComputePass pass;
        std::vector<std::int32_t> specialization;
        std::vector<ImageShape> images;          ///< of each slot
        std::vector<std::size_t> constant_bytes; ///< of each slot
        std::string key;
    };
    static Part part_of(FrameGraph const& graph, ComputePass const& pass);
    std::vector<Part> unseen(FrameGraph const& graph);
    void work(std::stop_token const& stop, int device_index);
    static void rehearse(Part const& part, Executor& executor, Device const& device);
    std::optional<Part> next(std::stop_token const& stop);

    std::set<std::string> seen_; ///< keys
    mutable std::mutex mutex_;   ///< of all that follows
    std::condition_variable_any changed_;
    std::deque<Part> parts_;
    bool busy_ = false, ended_ = false;
    std::jthread worker_; ///< last: it ends before the rest goes
};

} // namespace alpenglow
