#include "render/frame_graph.h"

#include <gtest/gtest.h>

using namespace alpenglow;

namespace {

std::vector<PlannedImage> const TWO_IMAGES = {{"first", false, {}}, {"second", false, {}}};

ImageId id(std::uint32_t index) { return {index}; }

/// `action` must throw a GraphError whose text holds all of `parts`.
template <typename Action>
void expect_graph_error(std::vector<std::string> const& parts, Action const& action) {
    try {
        action();
        ADD_FAILURE() << "nothing was refused; expected " << ::testing::PrintToString(parts);
    } catch (GraphError const& error) {
        for (std::string const& part : parts) EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << part << " is not in: " << error.what();
    }
}

PlannedBarrier from_nothing(std::uint32_t image, ImageUse use) { return {id(image), ImageState{}, state_of(use)}; }
PlannedBarrier between(std::uint32_t image, ImageUse before, ImageUse after) { return {id(image), state_of(before), state_of(after)}; }

} // namespace

TEST(Plan, the_first_write_starts_from_an_undefined_layout) {
    Plan const result = plan(TWO_IMAGES, std::vector<PlannedPass>{{"make", {{id(0), ImageUse::storage_write}}}});
    ASSERT_EQ(result.barriers.size(), 1u);
    EXPECT_EQ(result.barriers[0], std::vector{from_nothing(0, ImageUse::storage_write)});
    EXPECT_EQ(result.barriers[0][0].before.layout, VK_IMAGE_LAYOUT_UNDEFINED);
}

TEST(Plan, what_was_written_is_waited_for_before_it_is_read) {
    for (ImageUse const write : {ImageUse::storage_write, ImageUse::storage_clear, ImageUse::color_clear, ImageUse::depth_clear}) {
        Plan const result = plan(TWO_IMAGES, std::vector<PlannedPass>{{"make", {{id(0), write}}}, {"use", {{id(0), ImageUse::sample}}}});
        EXPECT_EQ(result.barriers[1], std::vector{between(0, write, ImageUse::sample)});
    }
}

TEST(Plan, reading_again_needs_no_barrier) {
    Plan const result = plan(TWO_IMAGES, std::vector<PlannedPass>{{"make", {{id(0), ImageUse::storage_write}}},
                                                                  {"use", {{id(0), ImageUse::sample}}},
                                                                  {"use again", {{id(0), ImageUse::sample}}}});
    EXPECT_EQ(result.barriers[1].size(), 1u);
    EXPECT_TRUE(result.barriers[2].empty());
}

TEST(Plan, a_write_waits_for_those_who_read) {
    Plan const result = plan(TWO_IMAGES, std::vector<PlannedPass>{{"make", {{id(0), ImageUse::storage_write}}},
                                                                  {"use", {{id(0), ImageUse::sample}}},
                                                                  {"change", {{id(0), ImageUse::storage_update}}}});
    EXPECT_EQ(result.barriers[2], std::vector{between(0, ImageUse::sample, ImageUse::storage_update)});
}

TEST(Plan, two_writes_in_a_row_are_ordered) {
    for (ImageUse const update : {ImageUse::storage_update, ImageUse::depth_update, ImageUse::color_update}) {
        Plan const result = plan(TWO_IMAGES, std::vector<PlannedPass>{{"make", {{id(0), ImageUse::storage_write}}},
                                                                      {"change", {{id(0), update}}},
                                                                      {"change again", {{id(0), update}}}});
        EXPECT_EQ(result.barriers[2], std::vector{between(0, update, update)});
    }
}

TEST(Plan, one_layer_after_another_keeps_what_the_first_pass_cleared) {
    // Each layer of the shadow array is cleared by a pass of its own; a second UNDEFINED would throw the first away.
    Plan const result = plan(TWO_IMAGES, std::vector<PlannedPass>{{"layer", {{id(0), ImageUse::depth_clear}}}, {"layer", {{id(0), ImageUse::depth_clear}}}});
    EXPECT_EQ(result.barriers[0][0].before.layout, VK_IMAGE_LAYOUT_UNDEFINED);
    EXPECT_EQ(result.barriers[1], std::vector{between(0, ImageUse::depth_clear, ImageUse::depth_clear)});
}

TEST(Plan, an_image_of_the_frame_before_is_waited_for_though_its_content_is_dropped) {
    std::vector<PlannedImage> const images = {{"kept", false, state_of(ImageUse::sample)}};
    Plan const result = plan(images, std::vector<PlannedPass>{{"make", {{id(0), ImageUse::storage_write}}}});
    PlannedBarrier const& barrier = result.barriers[0].at(0);
    EXPECT_EQ(barrier.before.layout, VK_IMAGE_LAYOUT_UNDEFINED);
    EXPECT_EQ(barrier.before.stages, state_of(ImageUse::sample).stages);
    EXPECT_EQ(barrier.after, state_of(ImageUse::storage_write));
}

TEST(Plan, an_imported_image_with_content_keeps_it) {
    std::vector<PlannedImage> const images = {{"table", true, state_of(ImageUse::storage_write)}};
    Plan const result = plan(images, std::vector<PlannedPass>{{"use", {{id(0), ImageUse::sample}}}});
    EXPECT_EQ(result.barriers[0], std::vector{between(0, ImageUse::storage_write, ImageUse::sample)});
    Plan const updated = plan(images, std::vector<PlannedPass>{{"change", {{id(0), ImageUse::storage_update}}}});
    EXPECT_EQ(updated.barriers[0][0].before.layout, VK_IMAGE_LAYOUT_GENERAL);
}

TEST(Plan, says_in_which_state_it_leaves_each_image) {
    Plan const result = plan(TWO_IMAGES, std::vector<PlannedPass>{{"make", {{id(0), ImageUse::storage_write}}}, {"show", {{id(0), ImageUse::present}}}});
    EXPECT_EQ(result.after[0], state_of(ImageUse::present));
    EXPECT_EQ(result.after[1], ImageState{});
}

TEST(Plan, reading_what_nobody_made_is_refused_by_name) {
    for (ImageUse const use : {ImageUse::sample, ImageUse::storage_update, ImageUse::color_update, ImageUse::depth_update, ImageUse::present}) {
        expect_graph_error({"lighting", "second", "nobody made"},
                           [&] { plan(TWO_IMAGES, std::vector<PlannedPass>{{"lighting", {{id(1), use}}}}); });
    }
}

TEST(Plan, one_image_twice_in_a_pass_is_refused_by_name) {
    expect_graph_error({"display", "first", "twice"}, [&] {
        plan(TWO_IMAGES, std::vector<PlannedPass>{{"make", {{id(0), ImageUse::storage_write}}},
                                                  {"display", {{id(0), ImageUse::sample}, {id(0), ImageUse::storage_update}}}});
    });
}

TEST(Plan, an_image_that_nobody_declared_is_refused_with_the_pass) {
    expect_graph_error({"display", "nobody declared"}, [&] { plan(TWO_IMAGES, std::vector<PlannedPass>{{"display", {{id(2), ImageUse::storage_write}}}}); });
    expect_graph_error({"display", "nobody declared"}, [&] { plan(TWO_IMAGES, std::vector<PlannedPass>{{"display", {{ImageId{}, ImageUse::sample}}}}); });
}

TEST(FrameGraph, a_slot_bound_twice_is_refused_by_number) {
    FrameGraph graph;
    ImageId const a = graph.add_image("a", {VK_FORMAT_R8G8B8A8_UNORM, {8, 8}}, ShowScale::unit);
    ImageId const b = graph.add_image("b", {VK_FORMAT_R8G8B8A8_UNORM, {8, 8}}, ShowScale::unit);
    expect_graph_error({"copy", "slot 3", "twice"}, [&] { graph.add(ComputePass{"copy", {}, {sampled(3, a), stored(3, b)}, {8, 8}}); });
    expect_graph_error({"draw", "slot 1", "twice"}, [&] {
        RasterPass pass;
        pass.name = "draw";
        pass.slots = {sampled(1, a), sampled(1, b)};
        graph.add(std::move(pass));
    });
}

TEST(FrameGraph, a_list_of_work_that_nobody_filled_is_refused_by_name) {
    FrameGraph graph;
    WorkListId const list = graph.add_work_list("chores", 16);
    ComputePass const fill{"find", {}, {fills(3, list)}, {1, 1}}, work{"do", {}, {works_off(3, list, 1)}, {1, 1}};
    expect_graph_error({"do", "chores"}, [&] { graph.add(work); });
    graph.add(fill);
    graph.add(work);
    ASSERT_TRUE(worked_off(work));
    EXPECT_EQ(worked_off(work)->list.index, list.index);
    EXPECT_FALSE(worked_off(fill));
}

TEST(FrameGraph, two_images_of_one_name_are_refused_by_name) {
    FrameGraph graph;
    graph.add_image("depth", {VK_FORMAT_D32_SFLOAT, {8, 8}}, ShowScale::depth);
    expect_graph_error({"depth"}, [&] { graph.add_image("depth", {VK_FORMAT_D32_SFLOAT, {8, 8}}, ShowScale::depth); });
}

TEST(FrameGraph, tells_the_planner_all_that_a_raster_pass_touches_and_the_present_last) {
    FrameGraph graph;
    ImageId const color = graph.add_image("color", {VK_FORMAT_R8G8B8A8_UNORM, {8, 8}}, ShowScale::unit);
    ImageId const depth = graph.add_image("depth", {VK_FORMAT_D32_SFLOAT, {8, 8}}, ShowScale::depth);
    RasterPass pass;
    pass.name = "draw";
    pass.colors = {color};
    pass.depth = depth;
    pass.clear_depth = 0.0f;
    graph.add(std::move(pass));
    graph.present(color);
    std::vector<PlannedPass> const passes = graph.planned_passes();
    ASSERT_EQ(passes.size(), 2u);
    ASSERT_EQ(passes[0].accesses.size(), 2u);
    EXPECT_EQ(passes[0].accesses[0].use, ImageUse::color_update); // not cleared, so its old content counts
    EXPECT_EQ(passes[0].accesses[1].use, ImageUse::depth_clear);
    EXPECT_EQ(passes[1].accesses[0].image, color);
    EXPECT_EQ(passes[1].accesses[0].use, ImageUse::present);
}
