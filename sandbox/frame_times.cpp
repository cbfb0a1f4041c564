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

std::vector<std::pair<std::string, double>> medians(std::vector<PassSamples> const& passes) {
    std::vector<std::pair<std::string, double>> result;
    for (PassSamples const& pass : passes) result.emplace_back(pass.name, median(pass.gpu_ms));
    return result;
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
    std::vector<PassSamples> passes, tables;
    for (int i = 0; i < WARM_UP_FRAMES + TABLE_FRAMES + frames; ++i) {
        if (before_frame) before_frame();
        bool const warm = i >= WARM_UP_FRAMES, makes_tables = warm && i < WARM_UP_FRAMES + TABLE_FRAMES;
        if (makes_tables) stage.renderer().discard_air_tables(), stage.renderer().discard_scene_maps();
        auto const start = std::chrono::steady_clock::now();
        stage.draw(view, world, size);
        stage.renderer().wait();
        double const elapsed =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
        std::vector<PassTime> const& times = stage.renderer().timings();
        if (makes_tables) note_passes(tables, times);
        if (!warm || makes_tables) continue;
        frame.push_back(elapsed);
        cpu.push_back(sum(times, &PassTime::cpu_ms));
        note_passes(passes, times);
    }
    std::erase_if(tables, [&](PassSamples const& pass) {
        return std::ranges::find(passes, pass.name, &PassSamples::name) != passes.end();
    });
    return {median(frame), median(cpu), medians(passes), medians(tables)};
}

} // namespace alpenglow
