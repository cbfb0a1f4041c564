#pragma once

#include "gpu/device.h"

#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace alpenglow {

/// SPIR-V embedded in the program.
struct ShaderCode {
    char const* name = nullptr;
    std::span<std::uint32_t const> words;
};

/// What a slot of set 0 holds.
struct SlotLayout {
    std::uint32_t slot = 0;
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;

    auto operator<=>(SlotLayout const&) const = default;
};

/// A pipeline, its layout, and the push-descriptor layout of its set 0.
class Pipeline {
public:
    Pipeline(Device const& device, VkDescriptorSetLayout set0, VkPipelineLayout layout, VkPipeline pipeline)
        : device_(device), set0_(set0), layout_(layout), pipeline_(pipeline) {}
    ~Pipeline();
    Pipeline(Pipeline const&) = delete;
    Pipeline& operator=(Pipeline const&) = delete;

    VkPipeline handle() const { return pipeline_; }
    VkPipelineLayout layout() const { return layout_; }

private:
    Device const& device_;
    VkDescriptorSetLayout set0_;
    VkPipelineLayout layout_;
    VkPipeline pipeline_;
};

struct VertexLayout {
    std::uint32_t stride = 0;
    std::vector<VkVertexInputAttributeDescription> attributes;
};

/// Everything a raster pipeline is made of. Depth is reversed unless `shadow`.
struct RasterState {
    ShaderCode vertex{}, fragment{};         ///< no fragment words: depth only
    VertexLayout vertices{};                 ///< stride 0: the vertex shader makes its own
    std::vector<VkFormat> colors{};
    VkFormat depth = VK_FORMAT_UNDEFINED;
    bool shadow = false;                     ///< nearer is smaller, clamped instead of clipped, slope bias
    float slope_bias = 0;                    ///< with `shadow`
    bool blend = false;                      ///< over what is there, by the fragment's straight alpha
    VkDescriptorSetLayout set1 = VK_NULL_HANDLE;
};

struct ComputeState {
    ShaderCode shader;
    std::vector<std::int32_t> specialization; ///< of the shader's constants 0, 1, …; those it doesn't have are ignored
};

/// Everything a pipeline is made of.
struct PipelineRecipe {
    std::variant<ComputeState, RasterState> state;
    std::vector<SlotLayout> slots; ///< of set 0

    /// The same text is the same pipeline. It says nothing of `set1`: those of all scenes are alike.
    std::string key() const;
};

/// On any thread. Throws Error(device).
std::unique_ptr<Pipeline> make_pipeline(Device const& device, PipelineRecipe const& recipe);

constexpr std::uint32_t PUSH_CONSTANT_BYTES = 128;

} // namespace alpenglow
