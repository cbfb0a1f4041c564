#pragma once

#include "gpu/pipeline.h"
#include "gpu/samplers.h"
#include "render/plan.h"

#include <cstddef>
#include <cstring>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace alpenglow {

/// How `--show NAME` maps an image to colours.
enum class ShowScale {
    encoded,  ///< display-ready
    radiance, ///< linear: exposure and curve
    unit,     ///< 0 to 1
    normal,   ///< octahedral in the first two channels
    depth,    ///< reversed, infinite: logarithm of the distance
    shadow,   ///< 0 to 1, layers side by side
    optical_depth, ///< as transmittance
    logarithm,     ///< of 32nd roots, 1e-6 to 1
    number,        ///< no picture; not shown
};

/// Bytes that the CPU writes for a frame, bound as a uniform buffer in scalar layout.
struct ConstantsId {
    std::uint32_t index = ~0u;
};

/// A list of work of two kinds that one pass fills and later ones do, an invocation for each entry: interop/work_list.h.
struct WorkListId {
    std::uint32_t index = ~0u;
    explicit operator bool() const { return index != ~0u; }
};

/// What a pass binds to a slot of set 0. Made by `sampled`, `stored`, `cleared`, `updated`, `constants`, `fills` and `works_off`.
struct Slot {
    std::uint32_t slot = 0;
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    ImageId image;
    ImageUse use = ImageUse::sample;
    SamplerState sampler;
    ConstantsId constants;
    bool as_array = false;
    WorkListId list = {};
    std::uint32_t kind = 0; ///< of the list's work
    float clear = 0;        ///< of each channel, with ImageUse::storage_clear
};

inline Slot sampled(std::uint32_t slot, ImageId image, SamplerState const& sampler = LINEAR_CLAMP) {
    return {slot, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, image, ImageUse::sample, sampler, {}, false};
}
/// For a shader's sampler2DArray, whatever the number of layers.
inline Slot sampled_array(std::uint32_t slot, ImageId image, SamplerState const& sampler = LINEAR_CLAMP) {
    return {slot, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, image, ImageUse::sample, sampler, {}, true};
}
/// Every texel is written.
inline Slot stored(std::uint32_t slot, ImageId image) {
    return {slot, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, image, ImageUse::storage_write, {}, {}, false};
}
/// Every texel is written by the pass or holds `value` in all channels.
inline Slot cleared(std::uint32_t slot, ImageId image, float value) {
    return {slot, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, image, ImageUse::storage_clear, {}, {}, false, {}, 0, value};
}
inline Slot updated(std::uint32_t slot, ImageId image) {
    return {slot, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, image, ImageUse::storage_update, {}, {}, false};
}
inline Slot constants(std::uint32_t slot, ConstantsId id) {
    return {slot, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, {}, ImageUse::sample, {}, id, false};
}
/// The list is emptied before the pass.
inline Slot fills(std::uint32_t slot, WorkListId list) {
    return {slot, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, {}, ImageUse::storage_write, {}, {}, false, list};
}
/// The work of one kind.
inline Slot works_off(std::uint32_t slot, WorkListId list, std::uint32_t kind) {
    return {slot, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, {}, ImageUse::sample, {}, {}, false, list, kind};
}

template <typename T>
std::vector<std::byte> bytes_of(T const& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<std::byte> bytes(sizeof(T));
    std::memcpy(bytes.data(), &value, sizeof(T));
    return bytes;
}

struct ComputePass {
    std::string name;
    ShaderCode shader;
    std::vector<Slot> slots;
    Extent threads;                   ///< of no meaning where a slot `works_off` a list: that says how many
    std::vector<std::byte> push = {}; ///< push constants, at most PUSH_CONSTANT_BYTES
    int variant = 0;                  ///< specialization constant 0, where the shader has one
};

/// The slot with the list that a pass works off; nullptr where there is none.
Slot const* worked_off(ComputePass const& pass);

/// What a raster pass draws with.
class DrawContext {
public:
    virtual ~DrawContext() = default;
    virtual VkCommandBuffer commands() const = 0;
    /// Binds one of the pass's pipelines, by its place in their list, and the pass's slots.
    virtual void use(std::size_t pipeline) = 0;
    virtual void push(std::span<std::byte const> bytes) = 0;
    virtual void bind_set1(VkDescriptorSet set) = 0;
};

struct RasterPass {
    std::string name;
    std::vector<ImageId> colors;
    bool clear_colors = false;           ///< to zero
    ImageId depth;                       ///< none: no depth test
    std::optional<float> clear_depth;
    std::uint32_t depth_layer = 0;
    std::vector<Slot> slots;
    std::vector<RasterState> pipelines; ///< their `colors` and `depth` are the pass's attachments
    std::function<void(DrawContext&)> draw;
};

/// One frame as a list of passes that run in the order written. Made anew for every frame; owns nothing on the device.
class FrameGraph {
public:
    struct Image {
        std::string name;
        ImageShape shape;
        ShowScale scale;
        GpuImage* imported = nullptr;
        bool has_content = false;
    };
    struct WorkList {
        std::string name;
        std::size_t capacity; ///< entries
        bool filled = false;
    };
    struct Pass {
        std::string name;
        std::variant<ComputePass, RasterPass> work;
    };

    /// Lives for this frame.
    ImageId add_image(std::string name, ImageShape const& shape, ShowScale scale);
    /// Outlives the frame. `has_content`: somebody filled it before.
    ImageId import(GpuImage& image, std::string name, ShowScale scale, bool has_content);
    /// Lives for this frame.
    WorkListId add_work_list(std::string name, std::size_t capacity);
    template <typename T>
    ConstantsId add_constants(T const& value) { return add_constant_bytes(bytes_of(value)); }
    ConstantsId add_constant_bytes(std::vector<std::byte> bytes);

    /// Values of the specialization constants 1, 2, … of every compute shader: another value is another pipeline.
    void specialize(std::vector<std::int32_t> values) { specialization_ = std::move(values); }

    void add(ComputePass pass);
    void add(RasterPass pass);
    /// The last use of the frame: the window shows the image.
    void present(ImageId image) { presented_ = image; }

    ImageShape const& shape(ImageId image) const { return images_.at(image.index).shape; }
    /// Nothing where there is no such image.
    ImageId find(std::string_view name) const;

    std::vector<Image> const& images() const { return images_; }
    std::vector<WorkList> const& work_lists() const { return work_lists_; }
    std::vector<Pass> const& passes() const { return passes_; }
    std::vector<std::vector<std::byte>> const& constant_blocks() const { return constants_; }
    std::vector<std::int32_t> const& specialization() const { return specialization_; }
    ImageId presented() const { return presented_; }

    /// The passes as `plan` takes them; the present comes last as a pass of its own.
    std::vector<PlannedPass> planned_passes() const;
    PipelineRecipe recipe(ComputePass const& pass) const;
    PipelineRecipe recipe(RasterPass const& pass, std::size_t pipeline) const;
    /// Of all pipelines that the frame uses; some may be there more than once.
    std::vector<PipelineRecipe> recipes() const;

private:
    void note_work(ComputePass const& pass);

    std::vector<Image> images_;
    std::vector<WorkList> work_lists_;
    std::vector<Pass> passes_;
    std::vector<std::vector<std::byte>> constants_;
    std::vector<std::int32_t> specialization_;
    ImageId presented_;
};

} // namespace alpenglow
