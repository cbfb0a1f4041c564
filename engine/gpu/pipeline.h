#pragma once

#include "gpu/device.h"

#include <map>
#include <memory>
#include <span>
#include <string>
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
    ShaderCode vertex, fragment;             ///< no fragment words: depth only
    VertexLayout vertices;                   ///< stride 0: the vertex shader makes its own
    std::vector<VkFormat> colors;
    VkFormat depth = VK_FORMAT_UNDEFINED;
    bool shadow = false;                     ///< nearer is smaller, clamped instead of clipped, slope bias
    float slope_bias = 0;                    ///< with `shadow`
    bool blend = false;                      ///< over what is there, by the fragment's straight alpha
    VkDescriptorSetLayout set1 = VK_NULL_HANDLE;
};

/// Makes pipelines once and keeps them.
class PipelineCache {
public:
    explicit PipelineCache(Device const& device) : device_(device) {}

    /// `specialization`: the values of the shader's constants with the ids 0, 1, …; those it doesn't have are ignored.
    Pipeline const& compute(ShaderCode const& shader, std::vector<SlotLayout> const& slots,
                            std::vector<std::int32_t> const& specialization = {});
    Pipeline const& raster(RasterState const& state, std::vector<SlotLayout> const& slots);

private:
    Device const& device_;
    std::map<std::string, std::unique_ptr<Pipeline>> pipelines_;
};

constexpr std::uint32_t PUSH_CONSTANT_BYTES = 128;

} // namespace alpenglow
