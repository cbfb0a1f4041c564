#pragma once

#include "support/files.h"

namespace alpenglow::test {

/// docs/`name` must be this text; ALPENGLOW_WRITE_DOCUMENTS=1 stores it.
inline void expect_document(std::string const& name, std::string const& text) {
    std::filesystem::path const file = std::filesystem::path(ALPENGLOW_SOURCE) / "docs" / name;
    if (std::getenv("ALPENGLOW_WRITE_DOCUMENTS")) write_text_file(file, text);
    EXPECT_EQ(read_text_file(file), text) << "run this test with ALPENGLOW_WRITE_DOCUMENTS=1 to store the new text";
}

} // namespace alpenglow::test
