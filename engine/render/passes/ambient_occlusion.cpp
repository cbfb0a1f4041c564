#include "render/passes/ambient_occlusion.h"

#include "interop/ambient_occlusion.h"
#include "interop/work_list.h"

#include <embedded_shaders.h>

namespace alpenglow {

ImageId add_ambient_occlusion(FrameGraph& graph, FrameInputs const& in, ConstantsId frame, GBuffer const& gbuffer,
                              WorkListId pixels, ImageId terrain_light, int sample) {
    ImageShape const shape{VK_FORMAT_R32_SFLOAT, in.extent};
    auto const image = [&](char const* name) {
        return sample == 0 ? graph.add_image(name, shape, ShowScale::unit) : graph.find(name);
    };
    ImageId const noisy = image("ambient_occlusion_noisy"), smooth = image("ambient_occlusion");
    graph.add(ComputePass{"ambient_occlusion",
                          shaders::ambient_occlusion_comp,
                          {constants(FRAME_SLOT, frame),
                           sampled(AMBIENT_OCCLUSION_NORMAL_SLOT, gbuffer.normal, NEAREST_CLAMP),
                           sampled(AMBIENT_OCCLUSION_DEPTH_SLOT, gbuffer.depth, NEAREST_CLAMP),
                           sampled(AMBIENT_OCCLUSION_TERRAIN_SLOT, terrain_light),
                           works_off(AMBIENT_OCCLUSION_WORK_SLOT, pixels, SURFACE_WORK),
                           cleared(AMBIENT_OCCLUSION_RESULT_SLOT, noisy, 1)},
                          {}});
    graph.add(ComputePass{"ambient_occlusion_smooth",
                          shaders::ambient_occlusion_smooth_comp,
                          {sampled(AMBIENT_OCCLUSION_NOISY_SLOT, noisy, NEAREST_CLAMP),
                           sampled(AMBIENT_OCCLUSION_NEAR_SLOT, gbuffer.depth, NEAREST_CLAMP),
                           works_off(AMBIENT_OCCLUSION_WORK_SLOT, pixels, SURFACE_WORK),
                           cleared(AMBIENT_OCCLUSION_SMOOTH_SLOT, smooth, 1)},
                          {}});
    return smooth;
}

} // namespace alpenglow
