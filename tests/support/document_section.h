#pragma once

#include "support/files.h"

namespace alpenglow::test {

/// What stands between the lines "<!-- begin KEY -->" and "<!-- end KEY -->" of docs/`name` must be this text;
/// ALPENGLOW_WRITE_DOCUMENTS=1 stores it.
inline void expect_document_section(std::string const& name, std::string const& key, std::string const& text) {
    std::filesystem::path const file = std::filesystem::path(ALPENGLOW_SOURCE) / "docs" / name;
    std::string document = read_text_file(file);
    std::string const begin = "<!-- begin " + key + " -->\n", end = "<!-- end " + key + " -->\n";
    std::size_t const first = document.find(begin), last = document.find(end);
    ASSERT_TRUE(first != std::string::npos && last != std::string::npos) << file << " has no section " << key;
    std::size_t const start = first + begin.size();
    std::string const stored = document.substr(start, last - start);
    if (std::getenv("ALPENGLOW_WRITE_DOCUMENTS")) {
        write_text_file(file, document.replace(start, last - start, text));
        return;
    }
    EXPECT_EQ(stored, text) << "run this test with ALPENGLOW_WRITE_DOCUMENTS=1 to store the new text";
}

} // namespace alpenglow::test
