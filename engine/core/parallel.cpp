#include "core/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace alpenglow {

void parallel_for(int count, int threads, std::function<void(int)> const& work) {
    if (threads <= 0) threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    threads = std::min(threads, count);
    std::atomic<int> next = 0;
    std::exception_ptr failure;
    std::mutex failure_mutex;
    auto const run = [&] {
        try {
            for (int i = next++; i < count; i = next++) work(i);
        } catch (...) {
            std::lock_guard const lock(failure_mutex);
            if (!failure) failure = std::current_exception();
            next = count;
        }
    };
    std::vector<std::jthread> others;
    for (int t = 1; t < threads; ++t) others.emplace_back(run);
    run();
    others.clear();
    if (failure) std::rethrow_exception(failure);
}

void let_others_pass() {
    constexpr int NICENESS = 10; // a tenth of a core that the others want too
    id_t const thread = static_cast<id_t>(gettid());
    setpriority(PRIO_PROCESS, thread, getpriority(PRIO_PROCESS, thread) + NICENESS);
}

} // namespace alpenglow
