#pragma once

#include "core/error.h"
#include "core/files.h"
#include "support/temporary_folder.h"

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <string>

namespace alpenglow::test {

inline std::filesystem::path assets() { return std::filesystem::path(ALPENGLOW_SOURCE) / "assets"; }

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
