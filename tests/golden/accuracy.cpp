#include "core/error.h"
#include "image/exr.h"
#include "sandbox/accuracy_document.h"
#include "support/files.h"
#include "support/stage_test.h"

using namespace alpenglow;
namespace fs = std::filesystem;

namespace {

fs::path const SOURCE = ALPENGLOW_SOURCE;
constexpr Extent SMALL{48, 32};

View comparison_view(std::string const& name) {
    View view = load_view(SOURCE / "assets/views/comparison" / (name + ".json"));
    view.settings.aa = EVALUATION_AA;
    return view;
}

Evaluation evaluated(Stage& stage, View const& view, ViewReference const& reference) {
    ViewError const error = measure_error(stage, view, reference);
    return {.view = view.name, .model = "march", .flip = error.flip, .rmse = error.rmse, .bias = error.bias};
}

/// A reference of a view that is the renderer's own picture times `factor`.
void write_reference(Stage& stage, View const& view, fs::path const& file, float factor,
                     std::map<std::string, std::string> const& attributes = {{"noise_flip", "0.25"}, {"noise_rmse", "1.5e-3"}}) {
    World const world = stage.prepare(view);
    stage.draw(view, world, SMALL);
    RadianceRecord record{stage.renderer().radiance(), {}, attributes};
    for (float& value : record.radiance.rgba) value *= factor;
    write_exr(file, record);
}

class Accuracy : public test::StageTest {};

} // namespace

TEST_F(Accuracy, comparison_views_come_in_the_order_of_the_published_table) {
    std::vector<std::string> names;
    for (fs::path const& file : comparison_views()) names.push_back(file.stem().string());
    EXPECT_EQ(names, (std::vector<std::string>{"ground-dawn", "ground-sunrise", "ground-noon", "plane-dawn", "plane-sunrise", "plane-noon",
                                               "orbit-dawn", "orbit-sunrise", "orbit-noon", "space", "planet-shadow-ground", "planet-shadow-orbit",
                                               "terrain-12km", "terrain-400km", "terrain-dense", "terrain-noon-haze", "terrain-ridge-sunset",
                                               "terrain-valley-dawn"}));
}

TEST_F(Accuracy, errors_are_against_the_reference) {
    test::TemporaryFolder const folder;
    Stage& stage = this->stage();
    View const view = comparison_view("plane-noon");
    write_reference(stage, view, folder.path() / "plane-noon.exr", 1);
    ViewReference const same = load_reference(folder.path(), "views/plane-noon.json");
    EXPECT_EQ(same.noise_flip, 0.25);
    EXPECT_EQ(same.noise_rmse, 1.5e-3);
    ViewError const none = measure_error(stage, view, same);
    EXPECT_LT(none.flip, 1e-6);
    EXPECT_EQ(none.rmse, 0);
    EXPECT_EQ(none.bias, 0);

    write_reference(stage, view, folder.path() / "plane-noon.exr", 0.8f);
    ViewReference const darker = load_reference(folder.path(), "views/plane-noon.json");
    ViewError const brighter = measure_error(stage, view, darker);
    EXPECT_GT(brighter.flip, 0.02);
    EXPECT_NEAR(brighter.bias, 0.25, 1e-6); // 1 / 0.8 - 1, in floats
    double squares = 0;
    for (std::size_t i = 0; i < brighter.picture.rgba.size(); ++i) {
        double const difference = static_cast<double>(brighter.picture.rgba[i]) - static_cast<double>(darker.radiance.rgba[i]);
        if (i % 4 != 3) squares += difference * difference;
    }
    EXPECT_NEAR(brighter.rmse, std::sqrt(squares / (3.0 * static_cast<double>(SMALL.pixels()))), 1e-6 * brighter.rmse);
}

TEST_F(Accuracy, references_that_are_of_no_use_are_refused) {
    test::TemporaryFolder const folder;
    fs::path const file = folder.path() / "space.exr";
    auto const expect_refused = [&](std::vector<std::string> const& parts) {
        test::expect_error(ErrorKind::bad_input, parts, [&] { load_reference(folder.path(), "views/space.json"); });
    };
    expect_refused({"space has no reference", "space.exr", "alpenglow reference views/space.json --size 320x180 --out " + folder.path().string()});
    View const view = comparison_view("space");
    write_reference(stage(), view, file, 0);
    expect_refused({"is black"});
    write_reference(stage(), view, file, NAN);
    expect_refused({"not finite"});
    write_reference(stage(), view, file, 1, {{"noise_flip", "0.1"}});
    expect_refused({"has no noise_rmse"});
    write_reference(stage(), view, file, 1, {{"noise_flip", "low"}, {"noise_rmse", "1"}});
    expect_refused({"has no noise_flip"});
}

/// Two views; all: alpenglow evaluate --check docs/accuracy.md.
class RecordedAccuracy : public test::StageTest {
protected:
    /// What is wrong with a view's errors, as the program checks them; empty: nothing.
    std::string objection(View const& view) {
        std::vector<RecordedError> const record = recorded_errors(read_text_file(SOURCE / "docs/accuracy.md"));
        ViewReference const reference = load_reference(SOURCE / "assets/references", view.name + ".json");
        RecordTolerance const tolerance = record_tolerance(stage().device().is_software());
        return difference_from_record(evaluated(stage(), view, reference), record, tolerance).value_or("");
    }
};

TEST_F(RecordedAccuracy, holds_in_the_air_and_would_notice) {
    View const view = comparison_view("plane-sunrise");
    EXPECT_EQ(objection(view), "");
    View sun_moved = view;
    sun_moved.sun.elevation += glm::radians(0.5);
    EXPECT_NE(objection(sun_moved), "") << "with the sun moved by half a degree";
    View once = view;
    once.settings.multiple_scattering = false;
    EXPECT_NE(objection(once), "") << "without multiple scattering";
}

TEST_F(RecordedAccuracy, holds_over_terrain) { EXPECT_EQ(objection(comparison_view("terrain-12km")), ""); }
