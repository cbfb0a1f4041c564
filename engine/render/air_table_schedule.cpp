#include "render/air_table_schedule.h"

#include <algorithm>
#include <cmath>

namespace alpenglow {

void TablePace::note(std::vector<PassTime> const& times, std::set<std::string> const& table_passes) {
    double frame = 0;
    for (PassTime const& time : times) {
        if (!table_passes.contains(time.name)) {
            frame += time.gpu_ms;
        } else if (time.groups > 0) {
            group_ms_[time.name] = time.gpu_ms / static_cast<double>(time.groups);
        }
    }
    if (frame <= 0) return;
    frames_ms_.push_back(frame);
    if (frames_ms_.size() > FRAMES) frames_ms_.pop_front();
}

double TablePace::frame_ms() const { return frames_ms_.empty() ? 0 : *std::ranges::min_element(frames_ms_); }

std::optional<double> TablePace::group_ms(std::string const& pass) const {
    auto const found = group_ms_.find(pass);
    return found == group_ms_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<StepSlice> remaining_slices(std::span<AirTableStep const> steps, TableProgress progress) {
    std::vector<StepSlice> slices;
    for (; progress.step < steps.size(); progress = {progress.step + 1, 0})
        slices.push_back({progress.step, progress.group, steps[progress.step].groups - progress.group});
    return slices;
}

std::vector<StepSlice> next_slices(std::span<AirTableStep const> steps, TableProgress progress, TablePace const& pace) {
    double left = TABLES_SHARE * pace.frame_ms(); // [ms]
    std::vector<StepSlice> slices;
    for (StepSlice slice : remaining_slices(steps, progress)) {
        std::optional<double> const cost = pace.group_ms(steps[slice.step].pass);
        double const fit = cost ? std::floor(left / std::max(*cost, 1e-9)) : 0.0;
        if (fit < 1 && !slices.empty()) break;
        std::uint32_t const wanted = slice.count;
        slice.count = fit < 1 ? 1 : static_cast<std::uint32_t>(std::min<double>(fit, wanted));
        slices.push_back(slice);
        if (slice.count < wanted || !cost) break;
        left -= *cost * slice.count;
    }
    return slices;
}

TableProgress advanced(std::span<AirTableStep const> steps, TableProgress progress,
                       std::span<StepSlice const> slices) {
    for (StepSlice const& slice : slices) {
        bool const done = slice.first + slice.count == steps[slice.step].groups;
        progress = done ? TableProgress{slice.step + 1, 0} : TableProgress{slice.step, slice.first + slice.count};
    }
    return progress;
}

} // namespace alpenglow
