#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace alpenglow {

/// One quality of shafts in one view, as in ShaftError.
struct ShaftRow {
    std::string view, level;
    double share = 0; ///< of pixels that shafts change, 0 to 1
    double flip = 0;
    std::optional<double> masked_flip;
    double rmse = 0, p999 = 0;
    double ms = 0; ///< of a frame's passes, without those that draw surfaces and the display's
};

std::string shaft_text(std::span<ShaftRow const> rows);
std::string shaft_json(std::span<ShaftRow const> rows);
/// `introduction` says how the figures were made; the table follows.
std::string shaft_markdown(std::string const& introduction, std::span<ShaftRow const> rows);

inline constexpr char const* SHAFT_SECTION_BEGIN = "<!-- alpenglow shafts: begin -->\n";
inline constexpr char const* SHAFT_SECTION_END = "<!-- alpenglow shafts: end -->\n";

/// `page` with `section` between those two lines. Throws Error(bad_input), which names `file`, where they are missing.
std::string with_shaft_section(std::string const& page, std::string const& section, std::string const& file);

} // namespace alpenglow
