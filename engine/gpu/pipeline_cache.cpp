#include "gpu/pipeline_cache.h"

#include "core/parallel.h"

#include <algorithm>

namespace alpenglow {

bool PipelineCache::Worker::has(std::string const& key) const {
    return making == key || std::ranges::find(requests, key, &Request::key) != requests.end();
}

void PipelineCache::throw_failure() {
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

Pipeline const& PipelineCache::get(PipelineRecipe const& recipe) {
    std::string const key = recipe.key();
    std::unique_lock lock(mutex_);
    throw_failure();
    auto const found = pipelines_.find(key);
    if (found != pipelines_.end()) return *found->second;
    ++misses_;
    changed_.wait(lock, [&] { return !is_being_made(key); });
    throw_failure();
    if (!pipelines_.contains(key)) pipelines_.emplace(key, make_(recipe));
    return *pipelines_.at(key);
}

bool PipelineCache::prepare(PipelineRecipe const& recipe, Need need) {
    std::string key = recipe.key();
    std::unique_lock const lock(mutex_);
    throw_failure();
    if (pipelines_.contains(key)) return true;
    // One that is wanted does not wait for the other thread, even where that is making it.
    if (wanted_.has(key) || (need == Need::likely && likely_.has(key))) return false;
    if (need == Need::wanted) std::erase_if(likely_.requests, [&](Request const& asked) { return asked.key == key; });
    Worker& by = worker(need);
    by.requests.push_back({std::move(key), recipe});
    if (!by.thread.joinable()) by.thread = std::jthread([this, need](std::stop_token const& stop) { work(stop, need); });
    changed_.notify_all();
    return false;
}

void PipelineCache::stop_preparing() {
    std::unique_lock lock(mutex_);
    wanted_.requests.clear(), likely_.requests.clear();
    changed_.wait(lock, [&] { return wanted_.idle() && likely_.idle(); });
}

bool PipelineCache::idle() {
    std::unique_lock const lock(mutex_);
    throw_failure();
    return wanted_.idle() && likely_.idle();
}

void PipelineCache::work(std::stop_token const& stop, Need need) {
    if (need == Need::likely) let_others_pass();
    Worker& self = worker(need);
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [&] { return !self.requests.empty(); }) && !stop.stop_requested()) {
        Request const request = std::move(self.requests.front());
        self.requests.pop_front();
        if (pipelines_.contains(request.key)) continue;
        self.making = request.key;
        lock.unlock();
        std::unique_ptr<Pipeline> pipeline;
        std::exception_ptr failure;
        try {
            pipeline = make_(request.recipe);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        self.making.clear();
        if (failure) {
            failure_ = failure;
            self.requests.clear();
        } else {
            pipelines_.try_emplace(request.key, std::move(pipeline));
        }
        changed_.notify_all();
    }
}

} // namespace alpenglow
