#include "core/log.h"

#include "core/plain_text.h"

#include <atomic>
#include <cstdio>

namespace alpenglow {

namespace {
std::atomic<bool> quiet_mode = false;

void print_line(char const* prefix, std::string_view line) {
    std::fprintf(stderr, "%s%s\n", prefix, plain_text(line).c_str());
}
} // namespace

void log_info(std::string_view line) {
    if (!quiet_mode) print_line("", line);
}
void log_warning(std::string_view line) { print_line("warning: ", line); }
void set_quiet(bool quiet) { quiet_mode = quiet; }

} // namespace alpenglow
