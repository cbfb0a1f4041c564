#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <ctime>
#include <fstream>
#include <functional>
#include <string>

namespace alpenglow::test {

/// What an action took.
struct Cost {
    double seconds = 0;     ///< of processor time, all threads together: other programs don't count
    double wall = 0;        ///< [s]
    double mebibytes = 0;   ///< most memory beyond what the process had before
};

/// Linux keeps a process's largest resident size, which it can be told to begin anew.
Cost cost_of(std::function<void()> const& action);

/// No damaged or hostile file may take more than 2 s and 512 MiB; sanitizers take several times as much.
void expect_cheap(Cost const& cost, std::string const& what);

namespace detail {

/// [MiB] of a line of /proc/self/status, such as "VmRSS".
inline double memory_line(std::string const& name) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with(name + ":")) return std::stod(line.substr(name.size() + 1)) / 1024;
    }
    return 0;
}

inline void reset_largest_memory() { std::ofstream("/proc/self/clear_refs") << "5"; }

} // namespace detail

inline Cost cost_of(std::function<void()> const& action) {
    detail::reset_largest_memory();
    double const memory = detail::memory_line("VmRSS");
    auto const start = std::chrono::steady_clock::now();
    std::clock_t const ticks = std::clock();
    action();
    Cost cost;
    cost.seconds = static_cast<double>(std::clock() - ticks) / CLOCKS_PER_SEC;
    cost.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    cost.mebibytes = detail::memory_line("VmHWM") - memory;
    return cost;
}

inline void expect_cheap(Cost const& cost, std::string const& what) {
#if defined(__SANITIZE_ADDRESS__)
    constexpr double slower = 20, more_memory = 8; // shadow memory, quarantine and checks
#else
    constexpr double slower = 1, more_memory = 1;
#endif
    EXPECT_LT(cost.seconds, 2 * slower) << what;
    EXPECT_LT(cost.wall, 60) << what << ": it waits for something";
    EXPECT_LT(cost.mebibytes, 512 * more_memory) << what;
}

} // namespace alpenglow::test
