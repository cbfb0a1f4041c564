#include "core/suggestion.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>
#include <vector>

namespace alpenglow {

namespace {

constexpr std::size_t LONGEST = 64; // names beyond it are nobody's slip

/// Levenshtein's distance: letters inserted, deleted or replaced.
std::size_t edits(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            std::size_t const replaced = diagonal + (a[i] != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
        }
    }
    return row.back();
}

} // namespace

std::string suggestion(std::string_view name, std::span<std::string_view const> known) {
    if (name.size() > LONGEST) return {};
    std::string_view nearest;
    std::size_t fewest = LONGEST;
    for (std::string_view const candidate : known) {
        std::size_t const distance = edits(name, candidate);
        std::size_t const allowed = 2 * std::max(name.size(), candidate.size()) / 5;
        if (distance <= allowed && distance < fewest) nearest = candidate, fewest = distance;
    }
    return nearest.empty() ? std::string{} : fmt::format("did you mean {}?", nearest);
}

} // namespace alpenglow
