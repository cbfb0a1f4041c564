#pragma once

#include "support/files.h"

namespace alpenglow::test {

/// docs/`name` must be this text; ALPENGLOW_WRITE_DOCUMENTS=1 stores it.
inline void expect_document(std::string const& name, std::string const& text) {
    std::filesystem::path const file = std::filesystem::path(ALPENGLOW_SOURCE) / "docs" / name;
    if (std::getenv("ALPENGLOW_WRITE_DOCUMENTS")) write_text_file(file, text);
    EXPECT_EQ(read_text_file(file), text) << "run this test with ALPENGLOW_WRITE_DOCUMENTS=1 to store the new text";
}

/// The part of docs/`name` between the lines "<!-- `section` -->" and "<!-- end of `section` -->" must be this text, as
/// expect_document.
inline void expect_section(std::string const& name, std::string const& section, std::string const& text) {
    std::filesystem::path const file = std::filesystem::path(ALPENGLOW_SOURCE) / "docs" / name;
    std::string whole = read_text_file(file);
    std::string const begin = "<!-- " + section + " -->\n", end = "<!-- end of " + section + " -->\n";
    std::size_t const first = whole.find(begin), last = whole.find(end);
    ASSERT_TRUE(first != std::string::npos && last != std::string::npos && first < last) << file << " lacks " << begin;
    std::size_t const from = first + begin.size();
    if (std::getenv("ALPENGLOW_WRITE_DOCUMENTS")) write_text_file(file, whole.replace(from, last - from, text));
    std::string const stored = read_text_file(file);
    EXPECT_EQ(stored.substr(from, stored.find(end) - from), text)
        << "run this test with ALPENGLOW_WRITE_DOCUMENTS=1 to store the new text";
}

} // namespace alpenglow::test
