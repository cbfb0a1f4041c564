#include "render/passes/air.h"

#include "interop/air.h"
#include "render/models/model.h"

namespace alpenglow {

namespace {

/// What interpolated light may be off by, as a share of the air's light or of what is behind it: docs/shafts.md.
constexpr float TOLERANCE = 0.01f, FAST_TOLERANCE = 0.05f;

AirLayer layer(FrameGraph& graph, std::string const& name, Extent extent, int sample) {
    if (sample > 0) return {graph.find(name + "inscattered"), graph.find(name + "transmittance")};
    ImageShape const shape{VK_FORMAT_R32G32B32A32_SFLOAT, extent};
    return {graph.add_image(name + "inscattered", shape, ShowScale::radiance),
            graph.add_image(name + "transmittance", shape, ShowScale::unit)};
}

/// Texels whose pixels reach to the picture's end or beyond.
std::uint32_t coarse_side(std::uint32_t side, int stride) {
    return stride == 1 ? side : (side - 1) / static_cast<std::uint32_t>(stride) + 2;
}

/// Of a layer without air. lavapipe compiles a shader anew for images whose sides are powers of two.
constexpr Extent NO_AIR{3, 3};

std::uint32_t repair_threads(std::uint32_t side) {
    return (side + AIR_REPAIR_TILE - 1) / AIR_REPAIR_TILE * WORKGROUP_SIZE;
}

} // namespace

AirLayer add_air(FrameGraph& graph, FrameInputs const& in, ConstantsId frame, AirObstacles const& obstacles,
                 AirTables const& tables, int sample) {
    bool const any = (in.constants.front().flags & FRAME_AIR) != 0;
    int const stride = any && in.model.air_stride ? in.model.air_stride(in.settings) : 1;
    Extent const extent = any ? in.extent : NO_AIR;
    Extent const coarse{coarse_side(extent.width, stride), coarse_side(extent.height, stride)};
    std::vector<Slot> slots{constants(FRAME_SLOT, frame), sampled(AIR_DEPTH_SLOT, obstacles.depth, NEAREST_CLAMP),
                            sampled_array(AIR_SHADOW_SLOT, obstacles.shadow.cascades, NEAREST_CLAMP),
                            sampled(AIR_CEILING_SLOT, obstacles.shadow.ceiling),
                            sampled(AIR_SHADOW_BOUNDS_SLOT, obstacles.shadow_bounds, NEAREST_CLAMP)};
    slots.insert(slots.end(), tables.slots.begin(), tables.slots.end());
    shader::AirPush const push{stride, in.settings.shafts == "fast" ? FAST_TOLERANCE : TOLERANCE};
    auto const add = [&](std::string name, ShaderCode const& shader, AirLayer const& made, Extent threads,
                         std::vector<Slot> more) {
        more.insert(more.end(), slots.begin(), slots.end());
        more.push_back(stored(AIR_INSCATTERED_SLOT, made.inscattered));
        more.push_back(stored(AIR_TRANSMITTANCE_SLOT, made.transmittance));
        int const variant = in.model.air_variant ? in.model.air_variant(in) : 0;
        graph.add(ComputePass{std::move(name), shader, std::move(more), threads, bytes_of(push), variant});
    };

    AirLayer const marched = layer(graph, stride == 1 ? "air_" : "air_coarse_", coarse, sample);
    add("air", in.model.air, marched, coarse, {});
    if (stride == 1) return marched;
    AirLayer const whole = layer(graph, "air_", extent, sample);
    add("air_repair", in.model.air_repair, whole, {repair_threads(extent.width), repair_threads(extent.height)},
        {sampled(AIR_COARSE_INSCATTERED_SLOT, marched.inscattered, NEAREST_CLAMP),
         sampled(AIR_COARSE_TRANSMITTANCE_SLOT, marched.transmittance, NEAREST_CLAMP)});
    return whole;
}

} // namespace alpenglow
