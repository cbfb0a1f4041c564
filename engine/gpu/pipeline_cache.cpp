#include "gpu/pipeline_cache.h"

#include <algorithm>

namespace alpenglow {

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
    changed_.wait(lock, [&] { return making_ != key; });
    throw_failure();
    if (!pipelines_.contains(key)) pipelines_.emplace(key, make_(recipe));
    return *pipelines_.at(key);
}

bool PipelineCache::prepare(PipelineRecipe const& recipe, Need need) {
    std::string key = recipe.key();
    std::unique_lock const lock(mutex_);
    throw_failure();
    if (pipelines_.contains(key)) return true;
    if (making_ == key) return false;
    auto const asked = std::ranges::find(requests_, key, &Request::key);
    if (asked != requests_.end() && need == Need::likely) return false;
    if (asked != requests_.end()) requests_.erase(asked);
    requests_.insert(need == Need::wanted ? requests_.begin() : requests_.end(), {std::move(key), recipe});
    if (!worker_.joinable()) worker_ = std::jthread([this](std::stop_token const& stop) { work(stop); });
    changed_.notify_all();
    return false;
}

void PipelineCache::stop_preparing() {
    std::unique_lock lock(mutex_);
    requests_.clear();
    changed_.wait(lock, [&] { return making_.empty(); });
}

bool PipelineCache::idle() {
    std::unique_lock const lock(mutex_);
    throw_failure();
    return requests_.empty() && making_.empty();
}

void PipelineCache::work(std::stop_token const& stop) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [&] { return !requests_.empty(); }) && !stop.stop_requested()) {
        Request const request = std::move(requests_.front());
        requests_.pop_front();
        if (pipelines_.contains(request.key)) continue;
        making_ = request.key;
        lock.unlock();
        std::unique_ptr<Pipeline> pipeline;
        std::exception_ptr failure;
        try {
            pipeline = make_(request.recipe);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        making_.clear();
        if (failure) {
            failure_ = failure;
            requests_.clear();
        } else {
            pipelines_.try_emplace(request.key, std::move(pipeline));
        }
        changed_.notify_all();
    }
}

} // namespace alpenglow
