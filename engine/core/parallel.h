#pragma once

#include <functional>

namespace alpenglow {

/// Calls `work(i)` once for each i in [0, count) on `threads` threads (0: one for each core). Calls must not depend on
/// each other, so that the result is the same for any number of threads. Rethrows the first exception.
void parallel_for(int count, int threads, std::function<void(int)> const& work);

/// From now on the calling thread, and threads that it starts, go behind others that want a core. They can't go back.
void let_others_pass();

} // namespace alpenglow
