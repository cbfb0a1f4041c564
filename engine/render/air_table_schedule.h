#pragma once

#include "render/executor.h"
#include "render/models/model.h"

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <span>

namespace alpenglow {

/// Workgroups of one step that run in one frame.
struct StepSlice {
    std::size_t step = 0;
    std::uint32_t first = 0, count = 0;

    bool operator==(StepSlice const&) const = default;
};

/// How far the making of a model's tables has come: all before this group of this step is done.
struct TableProgress {
    std::size_t step = 0;
    std::uint32_t group = 0;
};

/// What a workgroup of each pass costs on this device, and a frame without tables, as measured. The usual frame is the
/// fastest of the last few: one that was held up must not let the next take longer.
class TablePace {
public:
    /// Times of a finished frame. Those of `table_passes` make tables, the rest is the usual frame.
    void note(std::vector<PassTime> const& times, std::set<std::string> const& table_passes);
    double frame_ms() const; ///< 0: not known
    /// Of a workgroup; nothing where the pass has not run yet.
    std::optional<double> group_ms(std::string const& pass) const;

private:
    static constexpr std::size_t FRAMES = 8;
    std::deque<double> frames_ms_; ///< of the last
    std::map<std::string, double> group_ms_; ///< by pass
};

/// Share of the usual frame that tables may take. A frame is to take at most a quarter longer; the rest is for what a
/// measured time is off by.
inline constexpr double TABLES_SHARE = 0.2;

/// All that is left to do.
std::vector<StepSlice> remaining_slices(std::span<AirTableStep const> steps, TableProgress progress);

/// What of it fits into the tables' share of a frame; one workgroup at least, and that alone of a pass whose cost is not
/// known yet. The same for the same times.
std::vector<StepSlice> next_slices(std::span<AirTableStep const> steps, TableProgress progress, TablePace const& pace);

/// How far the making has come behind the slices.
TableProgress advanced(std::span<AirTableStep const> steps, TableProgress progress, std::span<StepSlice const> slices);

} // namespace alpenglow
