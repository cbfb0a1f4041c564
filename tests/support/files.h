#pragma once

#include "core/error.h"
#include "core/files.h"

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace alpenglow::test {

inline std::filesystem::path assets() { return std::filesystem::path(ALPENGLOW_SOURCE) / "assets"; }

/// A folder that goes away with the test.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "alpenglow_XXXXXX").string();
        if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(TemporaryFolder const&) = delete;
    TemporaryFolder& operator=(TemporaryFolder const&) = delete;

    std::filesystem::path const& path() const { return path_; }
    std::filesystem::path write(std::string const& name, std::string const& text) const {
        write_text_file(path_ / name, text);
        return path_ / name;
    }

private:
    std::filesystem::path path_;
};

/// `action` must throw an Error of this kind whose one line holds every one of `parts`.
inline void expect_error(ErrorKind kind, std::vector<std::string> const& parts, std::function<void()> const& action) {
    try {
        action();
        ADD_FAILURE() << "nothing was refused; expected " << ::testing::PrintToString(parts);
    } catch (Error const& error) {
        EXPECT_EQ(error.kind(), kind) << error.what();
        for (std::string const& part : parts) EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << part << " is not in: " << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        EXPECT_LT(std::string(error.what()).size(), 1200u) << error.what();
    }
}

} // namespace alpenglow::test
