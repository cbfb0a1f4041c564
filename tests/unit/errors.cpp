#include "core/error.h"
#include "core/files.h"

#include <gtest/gtest.h>

using namespace alpenglow;

TEST(Errors, are_one_line_that_says_what_where_and_what_to_do) {
    Error const error(ErrorKind::bad_input, "has no\nradius", "earth.json", "add it");
    EXPECT_STREQ(error.what(), "earth.json: has no radius (add it)");
    EXPECT_EQ(error.exit_code(), 3);
}

TEST(Files, what_is_not_a_regular_file_is_refused) {
    EXPECT_THROW(read_file("/dev/zero"), Error);
    EXPECT_THROW(read_file("/nonexistent"), Error);
    EXPECT_THROW(read_file("/tmp"), Error);
}

TEST(Files, a_write_that_fails_leaves_nothing_behind) {
    EXPECT_THROW(write_text_file("/proc/alpenglow/x.txt", "x"), Error);
    EXPECT_THROW(write_text_file("/dev/full/x.txt", "x"), Error);
}
