#pragma once

#include <array>
#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <map>
#include <optional>
#include <signal.h>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace alpenglow::test {

/// A program that runs beside the test, with its outputs in a file; ended with the test at the latest.
class BackgroundProcess {
public:
    struct Setup {
        std::filesystem::path folder = ".";           ///< where it runs
        std::filesystem::path output = "/dev/null";   ///< stdout and stderr
        std::map<std::string, std::string> environment{}; ///< laid over the test's own
        int keep_open = -1;                           ///< a file descriptor that it inherits
    };

    BackgroundProcess(std::vector<std::string> arguments, Setup const& setup) : id_(::fork()) {
        if (id_ < 0) throw std::runtime_error("no process can be started");
        if (id_ == 0) become(arguments, setup);
    }
    ~BackgroundProcess() {
        if (id_ <= 0) return;
        ::kill(id_, SIGKILL);
        ::waitpid(id_, nullptr, 0);
    }
    BackgroundProcess(BackgroundProcess const&) = delete;
    BackgroundProcess& operator=(BackgroundProcess const&) = delete;

    /// As Ctrl-C in a terminal.
    void interrupt() { if (id_ > 0) ::kill(id_, SIGINT); }

    /// Its exit code; nothing where it still runs. A signal is 128 and its number.
    std::optional<int> exit_code() {
        if (id_ > 0) {
            int status = 0;
            if (::waitpid(id_, &status, WNOHANG) != id_) return {};
            id_ = 0;
            code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        }
        return code_;
    }

private:
    [[noreturn]] static void become(std::vector<std::string> const& arguments, Setup const& setup) {
        int const output = ::open(setup.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
        if (output < 0 || ::chdir(setup.folder.c_str()) != 0) ::_exit(127);
        ::dup2(output, STDOUT_FILENO);
        ::dup2(output, STDERR_FILENO);
        if (setup.keep_open >= 0) ::fcntl(setup.keep_open, F_SETFD, 0);
        for (auto const& [name, value] : setup.environment) ::setenv(name.c_str(), value.c_str(), 1);
        std::vector<char*> pointers;
        for (std::string const& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
        pointers.push_back(nullptr);
        ::execvp(pointers[0], pointers.data());
        ::_exit(127);
    }

    pid_t id_;
    int code_ = 0;
};

/// Looks every 50 ms whether `done` is true; false where it never was in `patience` seconds.
template <typename Done>
bool wait_until(Done const& done, double patience) {
    auto const end = std::chrono::steady_clock::now() + std::chrono::duration<double>(patience);
    while (!done()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return true;
}

} // namespace alpenglow::test
