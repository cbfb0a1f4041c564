#include "sandbox/accuracy_document.h"

#include <gtest/gtest.h>

using namespace alpenglow;

namespace {

Evaluation row(std::string const& view, double flip, double rmse) {
    return {.view = view, .model = "march", .flip = flip, .rmse = rmse, .bias = -0.0123, .frame_ms = 12.3,
            .noise_flip = 0.004, .noise_rmse = 1e-5};
}

std::vector<Evaluation> const ROWS{row("ground-noon", 0.012344, 1.23456e-3), row("space", 0.25, 2e-7), row("terrain-12km", 0.1, 0.3)};

std::string document() {
    std::vector<std::string> const pictures{"pictures/a.png", "pictures/b.png"};
    return accuracy_document(ROWS, {"alpenglow evaluate", "a device", "2026-01-01", "320x180"}, pictures);
}

} // namespace

TEST(AccuracyDocument, its_table_is_read_back) {
    std::vector<RecordedError> const record = recorded_errors(document());
    ASSERT_EQ(record.size(), ROWS.size());
    for (std::size_t i = 0; i < record.size(); ++i) {
        EXPECT_EQ(record[i].view, ROWS[i].view);
        EXPECT_EQ(record[i].model, "march");
        EXPECT_NEAR(record[i].flip, ROWS[i].flip, 0.5e-5 + 1e-12); // five decimals
        EXPECT_NEAR(record[i].rmse / ROWS[i].rmse, 1, 0.5e-4);     // five digits
    }
}

TEST(AccuracyDocument, published_figures_stand_beside_their_views) {
    std::string const text = document();
    EXPECT_NE(text.find("| ground-noon | march | 0.01234 | 1.2346e-03 | -1.23 % | 12.3 | 0.00400 | 1.0e-05 | 0.019 | 0.078 |\n"), std::string::npos) << text;
    EXPECT_NE(text.find("| terrain-12km | march | 0.10000 | 3.0000e-01 | -1.23 % | 12.3 | 0.00400 | 1.0e-05 | | |\n"), std::string::npos) << text;
    EXPECT_NE(text.find("stops at four scattering events"), std::string::npos);
}

TEST(AccuracyDocument, shows_the_worst_first) {
    EXPECT_EQ(worst_rows(ROWS, 2), (std::vector<std::size_t>{1, 2}));
    EXPECT_EQ(worst_rows(ROWS, 9).size(), 3u);
    std::string const text = document();
    EXPECT_NE(text.find("![space](pictures/a.png)"), std::string::npos) << text;
    EXPECT_NE(text.find("![terrain-12km](pictures/b.png)"), std::string::npos) << text;
    EXPECT_EQ(text.find("![ground-noon]"), std::string::npos);
}

TEST(AccuracyDocument, what_moved_more_than_the_tolerance_is_told) {
    std::vector<RecordedError> const record{{"space", "march", 0.25, 2e-3}};
    RecordTolerance const tolerance{0.0005, 0.01};
    auto const told = [&](std::string const& view, double flip, double rmse) {
        return difference_from_record(row(view, flip, rmse), record, tolerance);
    };
    EXPECT_FALSE(told("space", 0.2504, 2.019e-3));
    EXPECT_TRUE(told("space", 0.2506, 2e-3));
    EXPECT_TRUE(told("space", 0.2494, 2e-3)); // better is not as recorded either
    EXPECT_TRUE(told("space", 0.25, 2.03e-3));
    EXPECT_NE(told("space", 0.25, 1.9e-3).value_or("").find("1.9000e-03"), std::string::npos);
    EXPECT_NE(told("ground-noon", 0.25, 2e-3).value_or("").find("ground-noon by march is not recorded"), std::string::npos);
    EXPECT_TRUE(difference_from_record(row("space", 0.25, NAN), record, tolerance));
}

TEST(AccuracyDocument, other_tables_are_no_record) {
    EXPECT_TRUE(recorded_errors("").empty());
    EXPECT_TRUE(recorded_errors("| view | model | FLIP | RMSE |\n|---|---|---|---|\n| a | b | c | d |\ntext 1 | 2 | 3\n").empty());
}
