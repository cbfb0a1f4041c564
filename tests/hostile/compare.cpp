#include "support/refusal.h"

#include "image/codec.h"
#include "image/exr.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

using namespace alpenglow;
using test::Refusal;

namespace {

std::string text(std::vector<std::byte> const& bytes) {
    return {reinterpret_cast<char const*>(bytes.data()), bytes.size()};
}

FloatImage radiance(Extent extent, float value) {
    FloatImage image(extent);
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        image.rgba[i] = i % 4 == 3 ? 1 : value * static_cast<float>(1 + i % 5);
    }
    return image;
}

std::string exr(Extent extent = {16, 9}, float value = 1) { return text(encode_exr(radiance(extent, value))); }

std::string png(Extent extent = {16, 9}, std::uint8_t value = 90) {
    ByteImage image(extent);
    std::fill(image.rgba.begin(), image.rgba.end(), value);
    return text(encode_png(image));
}

/// The channel list names each channel, then its type: 2 for float.
std::string exr_without_green() {
    std::string file = exr();
    file[file.find(std::string("G\0\2\0\0\0", 6))] = 'H';
    return file;
}

std::string half(std::string const& file) { return file.substr(0, file.size() / 2); }

Refusal refused(std::string name, std::map<std::string, std::string> files, std::vector<std::string> says) {
    return {std::move(name),
            {"compare", "test", "reference", "--heatmap", "map.png"},
            3,
            std::move(says),
            std::move(files)};
}

std::vector<Refusal> rows() {
    return {
        refused("sizes_of_radiance", {{"test", exr()}, {"reference", exr({16, 10})}}, {"16x9", "16x10", "one size"}),
        refused("sizes_of_pngs", {{"test", png({8, 8})}, {"reference", png()}}, {"8x8", "16x9", "one size"}),
        refused("channel_missing", {{"test", exr_without_green()}, {"reference", exr()}}, {"test", "no channel G"}),
        refused("exr_cut_short", {{"test", exr()}, {"reference", half(exr())}}, {"reference", "whole EXR"}),
        refused("exr_of_a_magic_number", {{"test", exr().substr(0, 4)}, {"reference", exr()}}, {"test", "whole EXR"}),
        refused("png_cut_short", {{"test", half(png())}, {"reference", png()}}, {"test", "whole PNG"}),
        refused("png_and_exr", {{"test", png()}, {"reference", exr()}}, {"test and reference", "two EXR or two PNG"}),
        refused("no_picture", {{"test", "a text"}, {"reference", exr()}}, {"test", "PNG or EXR"}),
        refused("empty_file", {{"test", ""}, {"reference", exr()}}, {"test", "PNG or EXR"}),
        refused("folder", {{"test/x", ""}, {"reference", exr()}}, {"test", "regular file"}),
        refused("missing_file", {{"test", exr()}}, {"reference", "No such file"}),
        {"heat_map_below_a_file",
         {"compare", "test", "reference", "--heatmap", "test/map.png"},
         3,
         {"test", "folder can't be made"},
         {{"test", exr()}, {"reference", exr()}}},
        {"exposure_of_pngs",
         {"compare", "test", "reference", "--exposure", "1"},
         2,
         {"--exposure", "EXR"},
         {{"test", png()}, {"reference", png()}}},
    };
}

class BadComparison : public testing::TestWithParam<Refusal> {};

/// What the program prints of two files, in a new folder.
test::ProcessResult compare_files(test::TemporaryFolder const& folder, std::string const& test,
                                  std::string const& reference, std::vector<std::string> const& options) {
    folder.write("test", test);
    folder.write("reference", reference);
    std::vector<std::string> arguments{"compare", "test", "reference"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    test::ProcessResult const result =
        test::run({.program = ALPENGLOW_PROGRAM, .arguments = arguments, .folder = folder.path()});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_EQ(result.errors, "");
    return result;
}

nlohmann::ordered_json json_of(std::string const& test, std::string const& reference,
                               std::vector<std::string> options = {}) {
    options.push_back("--json");
    return nlohmann::ordered_json::parse(compare_files(test::TemporaryFolder(), test, reference, options).output);
}

} // namespace

TEST_P(BadComparison, is_refused_in_one_line) { test::expect_refusal(GetParam(), test::TemporaryFolder().path()); }

INSTANTIATE_TEST_SUITE_P(Compare, BadComparison, testing::ValuesIn(rows()), test::name_of);

TEST(Compare, json_has_its_keys_in_order) {
    nlohmann::ordered_json const json = json_of(exr({16, 9}, 1.25f), exr());
    std::vector<std::string> keys;
    for (auto const& [key, value] : json.items()) keys.push_back(key);
    EXPECT_EQ(keys, (std::vector<std::string>{"flip", "flip_ldr", "mse", "rmse", "rel_rmse", "psnr", "bias", "p999",
                                              "non_finite"}));
    for (auto const& bias : json["bias"]) EXPECT_NEAR(bias.get<double>(), 0.25, 1e-12); // a power of two apart
    EXPECT_DOUBLE_EQ(json["rmse"].get<double>() * json["rmse"].get<double>(), json["mse"].get<double>());
    EXPECT_GT(json["flip"].get<double>(), 0);
    EXPECT_EQ(json["non_finite"], 0);
}

TEST(Compare, what_is_not_defined_is_null) {
    nlohmann::ordered_json const displayed = json_of(png({16, 9}, 90), png({16, 9}, 100));
    EXPECT_TRUE(displayed["flip"].is_null()) << "a displayed picture has no exposures to choose from";
    EXPECT_GT(displayed["flip_ldr"].get<double>(), 0);
    nlohmann::ordered_json const black = json_of(exr(), exr({16, 9}, 0));
    for (char const* key : {"rel_rmse", "psnr"}) EXPECT_TRUE(black[key].is_null()) << key;
    EXPECT_EQ(black["bias"], nlohmann::ordered_json::parse("[null, null, null]"));
    EXPECT_TRUE(json_of(exr(), exr())["psnr"].is_null()) << "infinite";
}

TEST(Compare, exposure_changes_only_what_is_displayed) {
    std::string const test = exr({16, 9}, 1.25f), reference = exr();
    nlohmann::ordered_json const plain = json_of(test, reference),
                                 dark = json_of(test, reference, {"--exposure", "-8"});
    EXPECT_NE(plain["flip_ldr"], dark["flip_ldr"]);
    for (char const* key : {"flip", "mse", "psnr", "p999"}) EXPECT_EQ(plain[key], dark[key]) << key;
}

TEST(Compare, pixels_that_are_not_finite_are_reported) {
    FloatImage broken = radiance({16, 9}, 1);
    broken.at(3, 4)[1] = std::nanf("");
    nlohmann::ordered_json const json = json_of(text(encode_exr(broken)), text(encode_exr(broken)));
    EXPECT_NEAR(json["non_finite"].get<double>(), 1.0 / (16 * 9), 1e-12);
    for (char const* key : {"flip", "flip_ldr"}) EXPECT_NEAR(json[key].get<double>(), 1.0 / (16 * 9), 1e-9) << key;
    EXPECT_EQ(json["mse"], 0) << "of the others";
}

TEST(Compare, table_and_heat_map) {
    test::TemporaryFolder const folder;
    test::ProcessResult const result =
        compare_files(folder, exr({64, 36}, 1.25f), exr({64, 36}), {"--heatmap", "maps/map.png"});
    for (char const* word : {"flip", "HDR FLIP", "exposures", "rmse", "psnr", "bias", "p999", "non_finite"}) {
        EXPECT_NE(result.output.find(word), std::string::npos) << word << " is not in\n" << result.output;
    }
    EXPECT_EQ(read_picture(folder.path() / "maps/map.png").extent.width, 64u);
}
