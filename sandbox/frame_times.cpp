#include "sandbox/frame_times.h"

#include "sandbox/median.h"

#include <algorithm>
#include <chrono>

namespace alpenglow {

namespace {

struct PassSamples {
    std::string name;
    std::vector<double> gpu_ms;
};

void note_passes(std::vector<PassSamples>& passes, std::vector<PassTime> const& times) {
    for (PassTime const& time : times) {
        auto entry = std::ranges::find(passes, time.name, &PassSamples::name);
        if (entry == passes.end()) entry = passes.insert(passes.end(), {time.name, {}});
        entry->gpu_ms.push_back(time.gpu_ms);
    }
}

double sum(std::vector<PassTime> const& times, double PassTime::*member) {
    double total = 0;
    for (PassTime const& time : times) total += time.*member;
    return total;
}

} // namespace

FrameTimes time_frames(Stage& stage, View const& view, World const& world, Extent size, int frames,
                       std::function<void()> const& before_frame) {
    std::vector<double> frame, cpu;
    std::vector<PassSamples> passes;
    for (int i = 0; i < WARM_UP_FRAMES + frames; ++i) {
        if (before_frame) before_frame();
        auto const start = std::chrono::steady_clock::now();
        stage.draw(view, world, size);
        stage.renderer().wait();
        double const elapsed =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
        if (i < WARM_UP_FRAMES) continue;
        std::vector<PassTime> const& times = stage.renderer().timings();
        frame.push_back(elapsed);
        cpu.push_back(sum(times, &PassTime::cpu_ms));
        note_passes(passes, times);
    }
    FrameTimes result{median(frame), median(cpu)};
    for (PassSamples const& pass : passes) result.passes.emplace_back(pass.name, median(pass.gpu_ms));
    return result;
}

} // namespace alpenglow
