#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace alpenglow {

/// A progress bar with an ETA on stderr. On a terminal the line is redrawn; elsewhere a line is printed now and then,
/// so that a log stays readable.
class Progress {
public:
    /// `begun`: steps that were done before, which say nothing of the time that is left.
    Progress(std::string title, std::size_t steps, std::size_t begun = 0);
    ~Progress();
    Progress(Progress const&) = delete;
    Progress& operator=(Progress const&) = delete;

    /// `done` of the steps are done; `note` says what comes next.
    void update(std::size_t done, std::string const& note = {});

private:
    using Clock = std::chrono::steady_clock;
    std::string title_;
    std::size_t steps_, begun_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point printed_{};
    bool terminal_;
    bool open_line_ = false;
};

} // namespace alpenglow
