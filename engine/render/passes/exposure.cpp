#include "render/passes/exposure.h"

#include "interop/exposure.h"

#include <embedded_shaders.h>
#include <cmath>

namespace alpenglow {

namespace {

constexpr Extent ONE_WORKGROUP{WORKGROUP_SIZE, WORKGROUP_SIZE};

void add_fixed_exposure(FrameGraph& graph, ImageId state, double stops) {
    auto const exact = static_cast<float>(stops);
    shader::ExposureState const push{static_cast<float>(std::exp2(stops)), exact, exact, -exact};
    graph.add(ComputePass{"exposure",
                          shaders::exposure_fixed_comp,
                          {stored(EXPOSURE_STATE_SLOT, state)},
                          ONE_WORKGROUP,
                          bytes_of(push)});
}

ImageId add_luminance_histogram(FrameGraph& graph, ImageId lit) {
    ImageId const counts =
        graph.add_image("luminance_histogram",
                        {VK_FORMAT_R32G32B32A32_SFLOAT, {HISTOGRAM_BINS / 4, HISTOGRAM_SIDE * HISTOGRAM_SIDE}},
                        ShowScale::unit);
    constexpr std::uint32_t side = HISTOGRAM_SIDE * WORKGROUP_SIZE;
    graph.add(ComputePass{"luminance_histogram",
                          shaders::luminance_histogram_comp,
                          {sampled(HISTOGRAM_LIT_SLOT, lit, NEAREST_CLAMP), stored(HISTOGRAM_COUNTS_SLOT, counts)},
                          {side, side}});
    return counts;
}

shader::ExposurePush exposure_push(Settings const& settings, double seconds) {
    return {static_cast<float>(settings.exposure_compensation), static_cast<float>(settings.exposure_least),
            static_cast<float>(std::max(settings.exposure_least, settings.exposure_most)),
            static_cast<float>(settings.light_adaptation),      static_cast<float>(settings.dark_adaptation),
            static_cast<float>(seconds)};
}

} // namespace

void add_exposure(FrameGraph& graph, ImageId lit, ImageId state, Settings const& settings, double seconds) {
    if (!settings.auto_exposure) return add_fixed_exposure(graph, state, settings.exposure);
    ImageId const counts = add_luminance_histogram(graph, lit);
    graph.add(ComputePass{"exposure",
                          shaders::exposure_comp,
                          {sampled(EXPOSURE_COUNTS_SLOT, counts, NEAREST_CLAMP), updated(EXPOSURE_STATE_SLOT, state)},
                          ONE_WORKGROUP,
                          bytes_of(exposure_push(settings, seconds))});
}

} // namespace alpenglow
