#include "sandbox/shaft_table.h"

#include "core/error.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace alpenglow;

namespace {

std::vector<ShaftRow> const ROWS{{"valley", "fast", 0.25, 0.0125, 0.0375, 0.005, 0.03, 120},
                                 {"open", "off", 0, 0.001, {}, 0.002, 0.01, 80}};

} // namespace

TEST(ShaftTable, says_the_same_in_each_form) {
    std::string const text = shaft_text(ROWS), page = shaft_markdown("How.\n", ROWS);
    for (char const* const figure : {"valley", "fast", "25 %", "0.0125", "0.0375", "0.50 %", "0.030", "120"}) {
        EXPECT_NE(text.find(figure), std::string::npos) << figure << " in " << text;
        EXPECT_NE(page.find(figure), std::string::npos) << figure << " in " << page;
    }
    EXPECT_EQ(page.find("How.\n"), 0u);
    auto const json = nlohmann::json::parse(shaft_json(ROWS));
    ASSERT_EQ(json.size(), 2u);
    EXPECT_EQ(json[0]["masked_flip"], 0.0375);
    EXPECT_EQ(json[0]["mask"], 0.25);
    EXPECT_EQ(json[0]["relative_rmse"], 0.005);
    EXPECT_TRUE(json[1]["masked_flip"].is_null()); // no pixel is in the mask
}

TEST(ShaftTable, replaces_its_section_only) {
    std::string const begin = SHAFT_SECTION_BEGIN, end = SHAFT_SECTION_END;
    std::string const page = "# Shafts\n" + begin + "old\n" + end + "after\n";
    std::string const once = with_shaft_section(page, "new\n", "shafts.md");
    EXPECT_EQ(once, "# Shafts\n" + begin + "new\n" + end + "after\n");
    EXPECT_EQ(with_shaft_section(once, "new\n", "shafts.md"), once);
    for (std::string const& wrong : {std::string("# Shafts\n"), begin, end + begin})
        EXPECT_THROW(with_shaft_section(wrong, "new\n", "shafts.md"), Error) << wrong;
}
