#pragma once

#include <exception>
#include <string>

namespace alpenglow {

/// What kind of failure this is; the value is the program's exit code.
enum class ErrorKind {
    wrong_use = 2, ///< the command line asks for something that does not exist
    bad_input = 3, ///< a file, or a value in it, can't be used; or output can't be written
    device = 4,    ///< no usable device, or a device that failed
};

/// The one exception type for "the world failed". One line: what happened, where, and what to do about it.
class Error : public std::exception {
public:
    Error(ErrorKind kind, std::string what, std::string where = {}, std::string advice = {});

    ErrorKind kind() const { return kind_; }
    int exit_code() const { return static_cast<int>(kind_); }
    /// "WHERE: WHAT (ADVICE)", on one line whatever the parts hold.
    char const* what() const noexcept override { return line_.c_str(); }

private:
    ErrorKind kind_;
    std::string line_;
};

} // namespace alpenglow
