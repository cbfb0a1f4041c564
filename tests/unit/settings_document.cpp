#include "core/settings_document.h"

#include "core/settings.h"
#include "support/documents.h"

using namespace alpenglow;

TEST(SettingsDocument, is_what_the_program_prints) { test::expect_document("settings.md", settings_document()); }

TEST(SettingsDocument, has_a_row_of_four_cells_for_every_setting) {
    std::string const text = settings_document();
    for (SettingInfo const& info : setting_table()) {
        std::size_t const start = text.find("\n| `" + std::string(info.name) + "` |");
        ASSERT_NE(start, std::string::npos) << info.name;
        std::string const row = text.substr(start + 1, text.find('\n', start + 1) - start - 1);
        EXPECT_EQ(std::count(row.begin(), row.end(), '|'), 5) << row;
    }
}
