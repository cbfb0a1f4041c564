#include "sandbox/shaft_error.h"
#include "support/files.h"
#include "support/stage_test.h"

using namespace alpenglow;

namespace {

constexpr Extent SIZE{240, 135};

/// What docs/shafts.md promises of shafts=default on these scenes.
constexpr double MOST_FLIP = 0.006, MOST_MASKED = 0.015, MOST_RMSE = 0.005, MOST_P999 = 0.022;

class ShaftQuality : public test::StageTest, public testing::WithParamInterface<char const*> {
protected:
    void SetUp() override {
        View const view = load_view(test::assets() / "views/shafts" / (std::string(GetParam()) + ".json"));
        case_ = make_shaft_case(stage(), view, SIZE);
    }
    ShaftError error_of(ShaftLevel const& level) {
        return shaft_error(draw_shafts(stage(), case_.view, level, SIZE, 0).radiance, case_);
    }
    ShaftCase case_;
};

} // namespace

TEST_P(ShaftQuality, default_is_close_to_exact_and_others_are_not) {
    ShaftError const error = error_of({"default", {{"shafts", "default"}}});
    EXPECT_LE(error.flip, MOST_FLIP);
    EXPECT_LE(error.masked_flip.value(), MOST_MASKED);
    EXPECT_LE(error.rmse, MOST_RMSE);
    EXPECT_LE(error.p999, MOST_P999);
    // Without this the bounds above would say nothing of shafts.
    EXPECT_GE(error_of(no_shafts()).masked_flip.value(), 3 * MOST_MASKED);
    EXPECT_GE(error_of(even_steps(20)).masked_flip.value(), 3 * MOST_MASKED);
}

INSTANTIATE_TEST_SUITE_P(Views, ShaftQuality, testing::Values("valley", "walls"),
                         [](auto const& view) { return std::string(view.param); });
