#include "support/gltf_builder.h"

#include <gtest/gtest.h>

using namespace alpenglow;

TEST(GltfProgress, counts_up_to_all_of_the_steps) {
    test::GltfBuilder const builder = test::one_triangle();
    std::vector<std::pair<std::size_t, std::size_t>> told;
    builder.load({.progress = [&](std::size_t done, std::size_t steps) { told.emplace_back(done, steps); }});
    ASSERT_GE(told.size(), 2u);
    for (std::size_t i = 0; i < told.size(); ++i) {
        EXPECT_EQ(told[i].second, told[0].second);
        if (i > 0) {
            EXPECT_GT(told[i].first, told[i - 1].first);
        }
    }
    EXPECT_EQ(told.back().first, told.back().second);
}
