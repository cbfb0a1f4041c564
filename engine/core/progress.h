#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace alpenglow {

/// A progress bar with an ETA on stderr. On a terminal the line is redrawn; elsewhere a line is printed now and then,
/// so that a log stays readable.
class Progress {
public:
    /// `begun`: steps that were done before, which say nothing of the time that is left. `patience`: nothing is shown
    /// before that time has passed, and nothing at all where everything is done by then.
    Progress(std::string title, std::size_t steps, std::size_t begun = 0, std::chrono::milliseconds patience = {});
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
    std::chrono::milliseconds patience_;
    Clock::time_point printed_{};
    bool terminal_;
    bool open_line_ = false;
};

} // namespace alpenglow
