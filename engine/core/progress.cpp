#include "core/progress.h"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace alpenglow {

Progress::Progress(std::string title, std::size_t steps, std::size_t begun, std::chrono::milliseconds patience)
    : title_(std::move(title)), steps_(std::max<std::size_t>(steps, 1)), begun_(begun), patience_(patience),
      terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (open_line_) std::fputc('\n', stderr);
}

void Progress::update(std::size_t done, std::string const& note) {
    Clock::time_point const now = Clock::now();
    auto const shortest = terminal_ ? std::chrono::milliseconds(50) : std::chrono::milliseconds(5000);
    bool const last = done >= steps_;
    if (printed_ == Clock::time_point{} && now - start_ < patience_) return;
    if (!last && printed_ != Clock::time_point{} && now - printed_ < shortest) return;
    printed_ = now;

    double const fraction = std::min(1.0, static_cast<double>(done) / static_cast<double>(steps_));
    double const elapsed = std::chrono::duration<double>(now - start_).count();
    double const new_steps = static_cast<double>(done) - static_cast<double>(begun_);
    double const steps_left = static_cast<double>(steps_) - static_cast<double>(done);
    std::string const eta = last ? fmt::format("done in {:.1f} s", elapsed)
                          : new_steps > 0 ? fmt::format("{:.0f} s left", elapsed * steps_left / new_steps)
                                          : std::string("…");
    constexpr int width = 24;
    int const filled = static_cast<int>(fraction * width);
    std::string const line = fmt::format("{} [{:#<{}}{:.<{}}] {:3.0f} % {} {}", title_, "", filled, "", width - filled,
                                         100 * fraction, eta, last ? "" : note);
    std::fputs(terminal_ ? fmt::format("\r{:<100}", line).c_str() : (line + "\n").c_str(), stderr);
    std::fflush(stderr);
    open_line_ = terminal_ && !last;
    if (terminal_ && last) std::fputc('\n', stderr);
}

} // namespace alpenglow
