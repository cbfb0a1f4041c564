#pragma once

#include "gpu/buffer.h"
#include "gpu/image.h"
#include "gpu/samplers.h"
#include "gpu/transfer.h"
#include "scene/scene.h"

#include <map>
#include <memory>

namespace alpenglow {

/// The materials of a scene on the device: textures, constants, and a descriptor set (set 1 of mesh draws) for each.
class MaterialSets {
public:
    /// `staging` is used while this is made.
    MaterialSets(Staging& staging, Scene const& scene);
    ~MaterialSets();
    MaterialSets(MaterialSets const&) = delete;
    MaterialSets& operator=(MaterialSets const&) = delete;

    struct Entry {
        VkDescriptorSet set = VK_NULL_HANDLE;
        bool double_sided = false, masked = false;
    };
    Entry const& operator[](std::size_t material) const { return entries_[material]; }
    VkDescriptorSetLayout layout() const { return layout_; }

private:
    void make_layout();
    void make_pool(std::uint32_t materials);
    void upload_constants(Scene const& scene);
    void write_set(Staging& staging, Scene const& scene, std::size_t material);
    GpuImage& picture(Staging& staging, Scene const& scene, std::uint32_t index, bool srgb);
    VkDescriptorImageInfo texture(Staging& staging, Scene const& scene, Texture const& texture, bool srgb);

    Device const& device_;
    SamplerCache samplers_;
    VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
    VkDescriptorPool pool_ = VK_NULL_HANDLE;
    std::unique_ptr<GpuBuffer> constants_;
    VkDeviceSize stride_ = 0;
    std::unique_ptr<GpuImage> white_;
    std::map<std::pair<std::uint32_t, bool>, std::unique_ptr<GpuImage>> pictures_; ///< by index and whether sRGB
    std::vector<Entry> entries_;
};

} // namespace alpenglow
