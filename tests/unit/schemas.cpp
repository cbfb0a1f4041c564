#include "core/settings.h"
#include "scene/schema.h"
#include "scene/view.h"
#include "support/files.h"
#include "support/json_schema.h"

using namespace alpenglow;
namespace fs = std::filesystem;

namespace {

struct SchemaFile {
    char const* name;
    std::string text;
    char const* folder;
};

std::vector<SchemaFile> schema_files() {
    return {{"planet.schema.json", planet_schema_text(), "planets"}, {"view.schema.json", view_schema_text(), "views"},
            {"flight.schema.json", flight_schema_text(), "flights"}};
}

std::vector<fs::path> json_files(fs::path const& folder) {
    std::vector<fs::path> files;
    for (fs::directory_entry const& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) files.push_back(entry.path());
    }
    return files;
}

} // namespace

TEST(Schemas, the_stored_files_are_what_the_program_makes) {
    for (SchemaFile const& schema : schema_files()) {
        fs::path const file = test::assets() / schema.name;
        if (std::getenv("ALPENGLOW_WRITE_SCHEMAS")) write_text_file(file, schema.text);
        EXPECT_EQ(read_text_file(file), schema.text) << "run this test with ALPENGLOW_WRITE_SCHEMAS=1 to store the new text";
    }
}

TEST(Schemas, accept_every_asset) {
    for (SchemaFile const& schema : schema_files()) {
        std::vector<fs::path> const files = json_files(test::assets() / schema.folder);
        EXPECT_FALSE(files.empty());
        for (fs::path const& file : files) {
            EXPECT_EQ(test::schema_objection(test::Json::parse(schema.text), test::Json::parse(read_text_file(file))), "") << file;
        }
    }
}

TEST(Schemas, know_every_setting_with_its_default) {
    test::Json const properties = test::Json::parse(view_schema_text())["properties"];
    for (SettingInfo const& info : setting_table()) {
        ASSERT_TRUE(properties.contains(std::string(info.name))) << info.name;
        EXPECT_EQ(test::schema_objection(properties[std::string(info.name)], properties[std::string(info.name)]["default"]), "") << info.name;
    }
}

TEST(Schemas, refuse_what_the_reader_refuses) {
    test::Json const schema = test::Json::parse(view_schema_text());
    test::Json const good = test::Json::parse(view_text(View{.camera = {.place = {0, 0, 10}}}));
    EXPECT_EQ(test::schema_objection(schema, good), "");
    test::Json const changes = test::Json::parse(R"([
        {"extra": 1}, {"camera": {}}, {"camera": null}, {"samples": 3}, {"samples": 4.5}, {"aa": 2}, {"curve": "film"},
        {"camera": {"latitude": 0, "longitude": 0, "altitude": 0}}, {"camera": {"latitude": 91, "longitude": 0, "altitude": 1}},
        {"sun": {"elevation": 1}}, {"sun": {"elevation": 1, "azimuth": 2, "utc": "x"}}, {"scene": {"file": "a", "latitude": 1}},
        {"scene": {"file": "a", "yaw": 1}}, {"scene": 7}
    ])");
    test::TemporaryFolder const folder;
    for (test::Json const& change : changes) {
        test::Json bad = good;
        bad.update(change);
        EXPECT_NE(test::schema_objection(schema, bad), "") << change;
        EXPECT_THROW(load_view(folder.write("bad.json", bad.dump())), Error) << change;
    }
}
