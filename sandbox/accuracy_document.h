#pragma once

#include "sandbox/evaluation.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace alpenglow {

/// How and where a table was measured, in words.
struct Circumstances {
    std::string command, device, date, size;
};

/// The rows with the largest FLIP, worst first; at most `count`.
std::vector<std::size_t> worst_rows(std::span<Evaluation const> rows, std::size_t count);

/// The table as Markdown. `pictures` are the worst rows' pictures, worst first, as paths from the document's folder.
std::string accuracy_document(std::span<Evaluation const> rows, Circumstances const& circumstances,
                              std::span<std::string const> pictures);

/// What a document's table says of a view.
struct RecordedError {
    std::string view, model;
    double flip = 0, rmse = 0;
};

/// The rows of the table in `document`, which accuracy_document wrote.
std::vector<RecordedError> recorded_errors(std::string const& document);

/// How far a measurement may be from its record.
struct RecordTolerance {
    double flip; ///< absolute
    double rmse; ///< relative
};

/// On a software device, which gives the same pictures to a few parts in a hundred thousand on every processor; the
/// table's last digit is the rest. Other devices round, filter and interpolate in other ways.
RecordTolerance record_tolerance(bool on_software);

/// In words what is wrong: the record lacks the row, or its FLIP or RMSE is not the row's. Times are never compared.
std::optional<std::string> difference_from_record(Evaluation const& row, std::span<RecordedError const> record,
                                                  RecordTolerance const& tolerance);

} // namespace alpenglow
