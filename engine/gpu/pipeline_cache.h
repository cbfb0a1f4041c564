#pragma once

#include "gpu/pipeline.h"

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

namespace alpenglow {

/// How soon a pipeline that is made ahead will be used.
enum class Need {
    wanted, ///< a picture waits for it: made before all others
    likely,
};

/// Makes pipelines once and keeps them: for whoever needs one at once, or ahead of that on a thread of its own, which
/// the first that is to be made ahead starts. What fails there is thrown by the next call.
class PipelineCache {
public:
    /// Called on any thread, on several at once; throws where it can't.
    using Make = std::function<std::unique_ptr<Pipeline>(PipelineRecipe const&)>;
    explicit PipelineCache(Make make) : make_(std::move(make)) {}
    /// Waits for the pipeline that is being made; what is still to be made is not.
    ~PipelineCache() = default;
    PipelineCache(PipelineCache const&) = delete;
    PipelineCache& operator=(PipelineCache const&) = delete;

    /// Makes the pipeline now where it is not there, or waits for it where it is being made. Throws what `Make` throws.
    Pipeline const& get(PipelineRecipe const& recipe);
    /// Whether `get` would find the pipeline. If not, it is made ahead. Throws what failed ahead before.
    bool prepare(PipelineRecipe const& recipe, Need need);
    /// Makes nothing ahead any more but what `prepare` asks for from now on. Waits for the pipeline that is being made.
    void stop_preparing();
    /// Whether nothing is left to be made ahead. Throws what failed ahead before.
    bool idle();
    /// How often `get` did not find what it was asked for.
    std::size_t misses() const { return misses_; }

private:
    struct Request {
        std::string key;
        PipelineRecipe recipe;
    };
    void work(std::stop_token const& stop);
    void throw_failure();

    Make make_;
    std::size_t misses_ = 0;
    std::mutex mutex_; ///< of all that follows
    std::condition_variable_any changed_;
    std::map<std::string, std::unique_ptr<Pipeline>> pipelines_; ///< by their keys
    std::deque<Request> requests_;
    std::string making_; ///< key of the pipeline that `worker_` makes now, or empty
    std::exception_ptr failure_;
    std::jthread worker_; ///< last: it ends before the rest goes
};

} // namespace alpenglow
