#include "sandbox/shaft_table.h"

#include "core/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alpenglow {

namespace {

std::string masked_text(ShaftRow const& row) {
    return row.masked_flip ? fmt::format("{:.4f}", *row.masked_flip) : std::string("-");
}

} // namespace

std::string shaft_text(std::span<ShaftRow const> rows) {
    std::string text = fmt::format("{:<16}{:<12}{:>8}{:>13}{:>8}{:>11}{:>9}{:>10}\n", "view", "shafts", "FLIP",
                                   "masked FLIP", "mask", "rel. RMSE", "99.9 %", "ms");
    for (ShaftRow const& row : rows) {
        text += fmt::format("{:<16}{:<12}{:>8.4f}{:>13}{:>6.0f} %{:>9.2f} %{:>9.3f}{:>10.1f}\n", row.view, row.level,
                            row.flip, masked_text(row), 100 * row.share, 100 * row.rmse, row.p999, row.ms);
    }
    return text;
}

std::string shaft_json(std::span<ShaftRow const> rows) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (ShaftRow const& row : rows) {
        json.push_back({{"view", row.view}, {"shafts", row.level}, {"flip", row.flip}});
        json.back()["masked_flip"] = row.masked_flip ? nlohmann::ordered_json(*row.masked_flip) : nullptr;
        json.back().update({{"mask", row.share}, {"relative_rmse", row.rmse}, {"p999", row.p999}, {"ms", row.ms}});
    }
    return json.dump(2) + "\n";
}

std::string shaft_markdown(std::string const& introduction, std::span<ShaftRow const> rows) {
    std::string text = introduction + "\n| view | shafts | FLIP | masked FLIP | mask | relative RMSE | 99.9 % | ms |\n"
                                      "|---|---|---|---|---|---|---|---|\n";
    for (ShaftRow const& row : rows) {
        text += fmt::format("| {} | {} | {:.4f} | {} | {:.0f} % | {:.2f} % | {:.3f} | {:.0f} |\n", row.view, row.level,
                            row.flip, masked_text(row), 100 * row.share, 100 * row.rmse, row.p999, row.ms);
    }
    return text;
}

std::string with_shaft_section(std::string const& page, std::string const& section, std::string const& file) {
    std::string const begin = SHAFT_SECTION_BEGIN, end = SHAFT_SECTION_END;
    std::size_t const from = page.find(begin), to = from == std::string::npos ? from : page.find(end, from);
    if (to == std::string::npos) {
        throw Error(ErrorKind::bad_input, "has no section for the table", file,
                    "put these two lines into it: " + begin.substr(0, begin.size() - 1) + " and " +
                        end.substr(0, end.size() - 1));
    }
    return page.substr(0, from + begin.size()) + section + page.substr(to);
}

} // namespace alpenglow
