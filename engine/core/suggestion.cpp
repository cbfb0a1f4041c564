#include "core/suggestion.h"

#include <algorithm>
#include <fmt/format.h>
#include <vector>

namespace alpenglow {

namespace {

constexpr std::size_t LONGEST = 64; // names beyond it are nobody's slip

/// Letters inserted, deleted, replaced, or swapped with their neighbour (optimal string alignment).
std::size_t edits(std::string_view a, std::string_view b) {
    std::size_t const columns = b.size() + 1;
    std::vector<std::size_t> table((a.size() + 1) * columns);
    auto const at = [&](std::size_t i, std::size_t j) -> std::size_t& { return table[i * columns + j]; };
    for (std::size_t i = 0; i <= a.size(); ++i) at(i, 0) = i;
    for (std::size_t j = 0; j <= b.size(); ++j) at(0, j) = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            std::size_t const replaced = at(i - 1, j - 1) + (a[i - 1] != b[j - 1]);
            at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, replaced});
            bool const swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
        }
    }
    return at(a.size(), b.size());
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
