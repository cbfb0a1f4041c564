#include "sandbox/accuracy_document.h"

#include "sandbox/published_figures.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <sstream>

namespace alpenglow {

namespace {

constexpr char const* INTRODUCTION = R"(# Accuracy

How far the real-time renderer is from the path tracer on the views of `assets/views/comparison`. This page is printed
by the program; it is a report and not a target: nothing in the renderer is fitted to it.

```
{}
```

{}, {}, {}.

- FLIP: mean HDR FLIP at 67 pixels a degree, 0 to 1. It chooses exposures by the reference; the view's plays no part.
- RMSE: over all pixels and channels, in radiance; the sun's irradiance is 6 where a published figure stands, else 1.
- bias: the mean of all pixels and channels over the reference's, less one; above 0 is too bright.
- ms: one frame at the picture's size with one ray for each pixel, from the start of its recording to the end of its
  work on the device; the median of several. The picture that is compared has {} rays for each pixel and otherwise the
  settings of its view.
- noise: FLIP and RMSE between two halves of the reference's samples. Errors at or below it say nothing.
- {}

| view | model | FLIP | RMSE | bias | ms | noise FLIP | noise RMSE | Bruneton | Hillaire |
|---|---|---|---|---|---|---|---|---|---|
)";

std::string published(std::string const& view) {
    auto const found = std::ranges::find(PUBLISHED_FIGURES, view, &PublishedFigures::view);
    return found == PUBLISHED_FIGURES.end() ? "| | |"
                                            : fmt::format("| {:.3f} | {:.3f} |", found->bruneton, found->hillaire);
}

std::string table_row(Evaluation const& row) {
    return fmt::format("| {} | {} | {:.5f} | {:.4e} | {:+.2f} % | {:.1f} | {:.5f} | {:.1e} {}\n", row.view, row.model,
                       row.flip, row.rmse, 100 * row.bias, row.frame_ms, row.noise_flip, row.noise_rmse,
                       published(row.view));
}

/// The cells of a row of a table, without the spaces around them.
std::vector<std::string> cells_of(std::string const& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, '|');) {
        std::size_t const first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
        cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    }
    return cells;
}

std::optional<double> number(std::string const& text) {
    double value = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

} // namespace

std::vector<std::size_t> worst_rows(std::span<Evaluation const> rows, std::size_t count) {
    std::vector<std::size_t> order(rows.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return rows[i].flip; });
    order.resize(std::min(count, order.size()));
    return order;
}

std::string accuracy_document(std::span<Evaluation const> rows, Circumstances const& circumstances,
                              std::span<std::string const> pictures) {
    std::string text = fmt::format(INTRODUCTION, circumstances.command, circumstances.date, circumstances.device,
                                   circumstances.size, EVALUATION_AA, PUBLISHED_CAVEAT);
    for (Evaluation const& row : rows) text += table_row(row);
    text += "\n## The worst\n\nFrom left to right: rendered, the reference, and FLIP. Each pair is displayed at one "
            "exposure.\n";
    std::vector<std::size_t> const worst = worst_rows(rows, pictures.size());
    for (std::size_t i = 0; i < worst.size(); ++i) {
        text +=
            fmt::format("\n![{0}]({1})\n{0}, FLIP {2:.5f}\n", rows[worst[i]].view, pictures[i], rows[worst[i]].flip);
    }
    return text;
}

std::vector<RecordedError> recorded_errors(std::string const& document) {
    std::vector<RecordedError> record;
    std::istringstream stream(document);
    for (std::string line; std::getline(stream, line);) {
        std::vector<std::string> const cells = cells_of(line);
        if (cells.size() < 5 || !cells[0].empty()) continue;
        auto const flip = number(cells[3]), rmse = number(cells[4]);
        if (flip && rmse) record.push_back({cells[1], cells[2], *flip, *rmse});
    }
    return record;
}

RecordTolerance record_tolerance(bool on_software) {
    return on_software ? RecordTolerance{0.0005, 0.01} : RecordTolerance{0.005, 0.05};
}

std::optional<std::string> difference_from_record(Evaluation const& row, std::span<RecordedError const> record,
                                                  RecordTolerance const& tolerance) {
    auto const found = std::ranges::find_if(
        record, [&](RecordedError const& r) { return r.view == row.view && r.model == row.model; });
    if (found == record.end()) return fmt::format("{} by {} is not recorded", row.view, row.model);
    bool const same_flip = std::abs(row.flip - found->flip) <= tolerance.flip;
    bool const same_rmse = std::abs(row.rmse - found->rmse) <= tolerance.rmse * found->rmse;
    if (same_flip && same_rmse) return {};
    return fmt::format("{} by {} has FLIP {:.5f} and RMSE {:.4e}, recorded are {:.5f} and {:.4e}", row.view, row.model,
                       row.flip, row.rmse, found->flip, found->rmse);
}

} // namespace alpenglow
