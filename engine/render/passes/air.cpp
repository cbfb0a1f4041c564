#include "render/passes/air.h"

#include "interop/air.h"
#include "interop/work_list.h"
#include "render/models/model.h"

#include <embedded_shaders.h>

#include <algorithm>

namespace alpenglow {

namespace {

/// What interpolated light may be off by, as a share of the air's light or of what is behind it: docs/shafts.md. With fewer samples than
/// these the marched light is itself farther off, by the square, and repairing what lies between its rays buys nothing.
constexpr float TOLERANCE = 0.006f, FAST_TOLERANCE = 0.1f, FEW_SAMPLES = 16;

float tolerance(Settings const& settings) {
    float const few = std::max(1.0f, FEW_SAMPLES / static_cast<float>(settings.samples));
    return std::max(settings.shafts == "fast" ? FAST_TOLERANCE : 0.0f, few * few * TOLERANCE);
}

/// Texels whose pixels reach to the picture's end or beyond.
std::uint32_t side_of(std::uint32_t pixels, int stride) {
    return stride == 1 ? pixels : (pixels - 1) / static_cast<std::uint32_t>(stride) + 2;
}

/// Of a layer without air. lavapipe compiles a shader anew for images whose sides are powers of two.
constexpr Extent NO_AIR{3, 3};

constexpr Extent ONE_WORKGROUP{WORKGROUP_SIZE, WORKGROUP_SIZE};

/// An invocation fills cells of 2 x 2 texels, one below the other.
Extent fill_threads(Extent texels) {
    constexpr std::uint32_t ROWS = 2 * AIR_FILL_ROWS;
    return {(texels.width + 1) / 2, (texels.height + ROWS - 1) / ROWS};
}

class AirPasses {
public:
    AirPasses(FrameGraph& graph, FrameInputs const& in, ConstantsId frame, AirTables const& tables, int sample)
        : graph_(graph), in_(in), sample_(sample),
          any_((in.constants.front().flags & FRAME_AIR) != 0), slots_{constants(FRAME_SLOT, frame)} {
        slots_.insert(slots_.end(), tables.slots.begin(), tables.slots.end());
    }

    AirLayer add(AirObstacles const& obstacles) {
        int stride = any_ && in_.air.model.air_stride ? in_.air.model.air_stride(in_.settings) : 1;
        std::vector<Slot> const shades{sampled(AIR_DEPTH_SLOT, obstacles.depth, NEAREST_CLAMP),
                                       sampled_array(AIR_SHADOW_SLOT, obstacles.shadow.cascades, NEAREST_CLAMP),
                                       sampled(AIR_CEILING_SLOT, obstacles.shadow.ceiling),
                                       sampled(AIR_TERRAIN_SLOT, obstacles.terrain_air),
                                       sampled(AIR_SHADOW_BOUNDS_SLOT, obstacles.shadow_bounds, NEAREST_CLAMP)};
        AirLayer layer = add_layer(stride);
        march("air", in_.air.model.air, layer, shades, stored, push(stride), extent(stride));
        if (stride == 1) return layer;
        ImageId const mean = add_mean(layer);
        for (; stride > 1; stride /= 2) layer = add_between(layer, mean, obstacles.depth, shades, stride / 2);
        return layer;
    }

private:
    Extent extent(int stride) const {
        return any_ ? Extent{side_of(in_.extent.width, stride), side_of(in_.extent.height, stride)} : NO_AIR;
    }

    AirLayer add_layer(int stride) {
        std::string const name = stride == 1 ? "air_" : "air_coarse_" + std::to_string(stride) + "_";
        if (sample_ > 0) return {graph_.find(name + "inscattered"), graph_.find(name + "transmittance")};
        ImageShape const shape{VK_FORMAT_R32G32B32A32_SFLOAT, extent(stride)};
        return {graph_.add_image(name + "inscattered", shape, ShowScale::radiance),
                graph_.add_image(name + "transmittance", shape, ShowScale::unit)};
    }

    ImageId add_mean(AirLayer const& coarse) {
        ImageShape const shape{VK_FORMAT_R32G32B32A32_SFLOAT, {1, 1}};
        ImageId const mean =
            sample_ > 0 ? graph_.find("air_mean") : graph_.add_image("air_mean", shape, ShowScale::radiance);
        graph_.add(ComputePass{
            "air_mean",
            shaders::air_mean_comp,
            {sampled(AIR_COARSE_INSCATTERED_SLOT, coarse.inscattered, NEAREST_CLAMP), stored(AIR_MEAN_SLOT, mean)},
            ONE_WORKGROUP});
        return mean;
    }

    AirLayer add_between(AirLayer const& coarse, ImageId mean, ImageId depth, std::vector<Slot> const& shades, int stride) {
        AirLayer const made = add_layer(stride);
        WorkListId const list = graph_.add_work_list("air_work_" + std::to_string(stride), extent(stride).pixels());
        graph_.add(
            ComputePass{"air_fill",
                        shaders::air_fill_comp,
                        {sampled(AIR_DEPTH_SLOT, depth, NEAREST_CLAMP), sampled(AIR_MEAN_SLOT, mean, NEAREST_CLAMP),
                         sampled(AIR_COARSE_INSCATTERED_SLOT, coarse.inscattered, NEAREST_CLAMP),
                         sampled(AIR_COARSE_TRANSMITTANCE_SLOT, coarse.transmittance, NEAREST_CLAMP),
                         stored(AIR_INSCATTERED_SLOT, made.inscattered),
                         stored(AIR_TRANSMITTANCE_SLOT, made.transmittance), fills(AIR_WORK_SLOT, list)},
                        fill_threads(extent(stride)),
                        bytes_of(push(stride))});
        for (int const kind : {SURFACE_WORK, SKY_WORK}) {
            std::vector<Slot> slots = shades;
            slots.push_back(works_off(AIR_WORK_SLOT, list, static_cast<std::uint32_t>(kind)));
            march("air_repair", in_.air.model.air_repair, made, std::move(slots), updated, push(stride, kind), {});
        }
        return made;
    }

    shader::AirPush push(int stride, int kind = 0) const { return {stride, tolerance(in_.settings), kind}; }

    void march(std::string name, ShaderCode const& shader, AirLayer const& made, std::vector<Slot> slots,
               Slot (*out)(std::uint32_t, ImageId), shader::AirPush const& push, Extent threads) {
        slots.insert(slots.end(), slots_.begin(), slots_.end());
        slots.push_back(out(AIR_INSCATTERED_SLOT, made.inscattered));
        slots.push_back(out(AIR_TRANSMITTANCE_SLOT, made.transmittance));
        int const variant = in_.air.model.air_variant ? in_.air.model.air_variant(in_) : 0;
        graph_.add(ComputePass{std::move(name), shader, std::move(slots), threads, bytes_of(push), variant});
    }

    FrameGraph& graph_;
    FrameInputs const& in_;
    int sample_;
    bool any_;
    std::vector<Slot> slots_; ///< of the passes that march
};

} // namespace

AirLayer add_air(FrameGraph& graph, FrameInputs const& in, ConstantsId frame, AirObstacles const& obstacles,
                 AirTables const& tables, int sample) {
    return AirPasses(graph, in, frame, tables, sample).add(obstacles);
}

} // namespace alpenglow
