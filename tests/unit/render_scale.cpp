#include "sandbox/render_scale.h"

#include <gtest/gtest.h>

using namespace alpenglow;

TEST(RenderScale, a_still_picture_is_whole_whatever_it_costs) {
    RenderScale scale;
    scale.note(5000, 1);
    EXPECT_LT(scale.share(true), 1);
    EXPECT_EQ(scale.share(false), 1);
}

TEST(RenderScale, a_moving_picture_is_as_large_as_the_budget_allows) {
    for (double whole_ms : {1.0, 99.0, 150.0, 390.0, 500.0, 890.0}) {
        RenderScale scale;
        scale.note(whole_ms, 1);
        double const share = scale.share(true);
        EXPECT_LE(whole_ms * share * share, RenderScale::BUDGET_MS) << whole_ms;
        EXPECT_GT(whole_ms * share * share, whole_ms <= RenderScale::BUDGET_MS ? 0 : 0.5 * RenderScale::BUDGET_MS) << whole_ms;
    }
    RenderScale slow;
    slow.note(1e5, 1);
    EXPECT_EQ(slow.share(true), 1.0 / 3); // there is always a picture
}

TEST(RenderScale, the_size_stays_where_the_cost_only_wavers) {
    RenderScale scale;
    scale.note(390, 1);
    double const share = scale.share(true);
    for (double whole_ms : {399.0, 330.0, 380.0, 300.0, 399.0}) {
        scale.note(whole_ms * share * share, share);
        EXPECT_EQ(scale.share(true), share) << whole_ms;
    }
    scale.note(10 * share * share, share); // a lighter view
    EXPECT_EQ(scale.share(true), 1);
}

TEST(RenderScale, sizes_are_never_empty) {
    EXPECT_EQ(scaled({1280, 720}, 0.5), (Extent{640, 360}));
    EXPECT_EQ(scaled({1, 1}, 0.25), (Extent{1, 1}));
}
