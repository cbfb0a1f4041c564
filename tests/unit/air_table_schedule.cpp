#include "render/air_table_schedule.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace alpenglow;

namespace {

AirTableStep step(char const* pass, std::uint32_t groups) {
    return {.pass = pass, .shader = {}, .groups = groups, .reads = {}, .makes = {0, 1}};
}

std::vector<AirTableStep> const STEPS{step("cheap", 100), step("dear", 20), step("dear", 20)};
std::set<std::string> const PASSES{"cheap", "dear"};

/// A frame of 50 ms without tables; a group of "cheap" costs 1 ms, one of "dear" 3 ms.
TablePace known_pace() {
    TablePace pace;
    pace.note({{"lighting", 50, 0, 900}, {"cheap", 100, 0, 100}, {"dear", 60, 0, 20}}, PASSES);
    return pace;
}

double cost(std::vector<StepSlice> const& slices) {
    return std::accumulate(slices.begin(), slices.end(), 0.0, [](double sum, StepSlice const& slice) {
        return sum + slice.count * (STEPS[slice.step].pass == "cheap" ? 1.0 : 3.0);
    });
}

} // namespace

TEST(AirTableSchedule, at_once_is_all_that_is_left) {
    std::vector<StepSlice> const all{{0, 0, 100}, {1, 0, 20}, {2, 0, 20}}, rest{{1, 5, 15}, {2, 0, 20}};
    EXPECT_EQ(remaining_slices(STEPS, {}), all);
    EXPECT_EQ(remaining_slices(STEPS, {1, 5}), rest);
    EXPECT_TRUE(remaining_slices(STEPS, {3, 0}).empty());
}

TEST(AirTableSchedule, every_frame_keeps_to_its_share_and_all_groups_run_once_in_order) {
    TablePace const pace = known_pace();
    TableProgress progress;
    std::vector<std::uint32_t> done(STEPS.size());
    int frames = 0;
    for (; progress.step < STEPS.size(); ++frames) {
        std::vector<StepSlice> const slices = next_slices(STEPS, progress, pace);
        ASSERT_FALSE(slices.empty());
        EXPECT_LE(cost(slices), TABLES_SHARE * 50);
        for (StepSlice const& slice : slices) {
            EXPECT_EQ(slice.first, done[slice.step]);
            if (slice.step > 0) {
                EXPECT_EQ(done[slice.step - 1], STEPS[slice.step - 1].groups);
            }
            done[slice.step] += slice.count;
        }
        progress = advanced(STEPS, progress, slices);
    }
    EXPECT_EQ(done, (std::vector<std::uint32_t>{100, 20, 20}));
    EXPECT_EQ(frames, 10 + 14); // 100 groups of 1 ms, then 40 of 3 ms, three of which fit into 10 ms
}

TEST(AirTableSchedule, goes_on_with_the_next_step_in_what_is_left_of_a_share) {
    std::vector<StepSlice> const expected{{0, 96, 4}, {1, 0, 2}};
    EXPECT_EQ(next_slices(STEPS, {0, 96}, known_pace()), expected);
}

TEST(AirTableSchedule, of_a_pass_of_unknown_or_too_high_cost_one_group_runs) {
    std::vector<StepSlice> const one{{0, 0, 1}};
    EXPECT_EQ(next_slices(STEPS, {}, TablePace{}), one);
    TablePace slow;
    slow.note({{"lighting", 1, 0, 900}, {"cheap", 100, 0, 100}}, PASSES);
    EXPECT_EQ(next_slices(STEPS, {}, slow), one);
    std::vector<StepSlice> const last_of_the_known{{0, 99, 1}};
    EXPECT_EQ(next_slices(STEPS, {0, 99}, slow), last_of_the_known);
}

TEST(AirTableSchedule, a_frame_that_was_held_up_does_not_let_the_next_take_longer) {
    TablePace pace = known_pace();
    pace.note({{"lighting", 5000, 0, 900}}, PASSES);
    EXPECT_EQ(pace.frame_ms(), 50);
    for (int i = 0; i < 8; ++i) pace.note({{"lighting", 200, 0, 900}}, PASSES); // a larger picture
    EXPECT_EQ(pace.frame_ms(), 200);
}
