#pragma once

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <linux/capability.h>
#include <map>
#include <optional>
#include <poll.h>
#include <stdexcept>
#include <string>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace alpenglow::test {

/// A program to start. It gets this process's environment with `environment` laid over it, and keeps to the permissions of
/// files even where root runs the tests.
struct ProcessOptions {
    std::filesystem::path program;
    std::vector<std::string> arguments{};
    std::map<std::string, std::string> environment{};
    std::filesystem::path folder{};               ///< to start in; empty: this process's own
    std::optional<rlim_t> largest_file{};         ///< [bytes] a write beyond fails, as on a full disk
    std::optional<std::filesystem::path> output{}; ///< where stdout goes instead of `ProcessResult::output`
};

struct ProcessResult {
    int exit_code = -1; ///< -1 where a signal ended it
    int signal = 0;     ///< 0 where it ended by itself
    std::string output, errors;
};

namespace process_detail {

/// Runs in the child, where only calls that are safe after fork() of a program with threads are made.
[[noreturn]] inline void become(ProcessOptions const& options, char* const* arguments, char* const* environment, int out, int err) {
    if (options.output) out = ::open(options.output->c_str(), O_WRONLY);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(err, STDERR_FILENO);
    if (!options.folder.empty() && ::chdir(options.folder.c_str()) != 0) ::_exit(126);
    ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0);
    ::prctl(PR_CAPBSET_DROP, CAP_DAC_READ_SEARCH, 0, 0, 0);
    if (options.largest_file) {
        rlimit const limit{*options.largest_file, *options.largest_file};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        ::signal(SIGXFSZ, SIG_IGN); // stays ignored after execve: write() then gives EFBIG
    }
    ::execve(options.program.c_str(), arguments, environment);
    ::_exit(127);
}

inline std::vector<std::string> merged_environment(std::map<std::string, std::string> const& changes) {
    std::vector<std::string> result;
    for (char** entry = environ; *entry; ++entry) {
        std::string const text = *entry;
        if (!changes.contains(text.substr(0, text.find('=')))) result.push_back(text);
    }
    for (auto const& [name, value] : changes) result.push_back(name + "=" + value);
    return result;
}

inline std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> result;
    for (std::string& text : texts) result.push_back(text.data());
    result.push_back(nullptr);
    return result;
}

/// Both pipes until the child has closed them.
inline void drain(int out, int err, ProcessResult& result) {
    std::array<pollfd, 2> open{pollfd{out, POLLIN, 0}, pollfd{err, POLLIN, 0}};
    std::array<std::string*, 2> const texts{&result.output, &result.errors};
    while (open[0].fd >= 0 || open[1].fd >= 0) {
        if (::poll(open.data(), open.size(), -1) < 0 && errno != EINTR) return;
        for (std::size_t i = 0; i < open.size(); ++i) {
            if (open[i].fd < 0 || open[i].revents == 0) continue;
            char block[4096];
            ssize_t const got = ::read(open[i].fd, block, sizeof block);
            if (got > 0) texts[i]->append(block, static_cast<std::size_t>(got));
            else open[i].fd = -1;
        }
    }
}

} // namespace process_detail

/// Starts the program and waits for its end.
inline ProcessResult run(ProcessOptions const& options) {
    using namespace process_detail;
    std::vector<std::string> arguments{options.program.string()}, environment = merged_environment(options.environment);
    arguments.insert(arguments.end(), options.arguments.begin(), options.arguments.end());
    std::vector<char*> const argument_pointers = pointers(arguments), environment_pointers = pointers(environment);
    std::array<int, 2> out{}, err{};
    if (::pipe2(out.data(), O_CLOEXEC) != 0 || ::pipe2(err.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    pid_t const child = ::fork();
    if (child < 0) throw std::runtime_error("no child process");
    if (child == 0) become(options, argument_pointers.data(), environment_pointers.data(), out[1], err[1]);
    ::close(out[1]);
    ::close(err[1]);
    ProcessResult result;
    drain(out[0], err[0], result);
    ::close(out[0]);
    ::close(err[0]);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {}
    if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
    else result.signal = WTERMSIG(status);
    return result;
}

} // namespace alpenglow::test
