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
    wanted, ///< a picture waits for it
    likely, ///< made where nobody else wants the processor
};

/// Makes pipelines and keeps them: for whoever needs one at once, or ahead of that on threads of its own, one for each
/// need, which the first request starts. What fails there is thrown by the next call.
class PipelineCache {
public:
    /// Called on any thread, on several at once; throws where it can't.
    using Make = std::function<std::unique_ptr<Pipeline>(PipelineRecipe const&)>;
    explicit PipelineCache(Make make) : make_(std::move(make)) {}
    /// Waits for the pipelines that are being made; what is still to be made is not.
    ~PipelineCache() = default;
    PipelineCache(PipelineCache const&) = delete;
    PipelineCache& operator=(PipelineCache const&) = delete;

    /// Makes the pipeline now where it is not there, or waits for it where it is being made. Throws what `Make` throws.
    Pipeline const& get(PipelineRecipe const& recipe);
    /// Whether `get` would find the pipeline. If not, it is made ahead. Throws what failed ahead before.
    bool prepare(PipelineRecipe const& recipe, Need need);
    /// Makes nothing ahead any more but what `prepare` asks for from now on. Waits for those that are being made.
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
    struct Worker {
        std::deque<Request> requests{};
        std::string making{}; ///< key of the pipeline that it makes now, or empty
        std::jthread thread{};

        bool has(std::string const& key) const;
        bool idle() const { return requests.empty() && making.empty(); }
    };
    void work(std::stop_token const& stop, Need need);
    bool is_being_made(std::string const& key) const { return wanted_.making == key || likely_.making == key; }
    Worker& worker(Need need) { return need == Need::wanted ? wanted_ : likely_; }
    void throw_failure();

    Make make_;
    std::size_t misses_ = 0;
    std::mutex mutex_; ///< of all that follows
    std::condition_variable_any changed_;
    std::map<std::string, std::unique_ptr<Pipeline>> pipelines_; ///< by their keys
    std::exception_ptr failure_;
    Worker wanted_, likely_; ///< last: their threads end before the rest goes
};

} // namespace alpenglow
