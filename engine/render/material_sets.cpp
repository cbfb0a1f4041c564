#include "render/material_sets.h"

#include "gpu/transfer.h"
#include "image/color.h"
#include "image/mipmaps.h"
#include "interop/gbuffer.h"
#include "surface/brdf.glsl"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <span>

namespace alpenglow {

namespace {

// The scene's numbers are the shaders'.
static_assert(Material::usual_reflectance == shader::USUAL_REFLECTANCE);
static_assert(Material::largest_reflectance == LARGEST_REFLECTANCE);

/// The textures of a material in the order of their slots.
std::array<Texture const*, MATERIAL_TEXTURES> textures_of(Material const& material) {
    return {&material.base_color_texture, &material.metallic_roughness_texture, &material.normal_texture,
            &material.occlusion_texture,  &material.emission_texture,           &material.specular_texture,
            &material.reflectance_texture};
}

constexpr bool is_color(int slot) {
    return slot == MATERIAL_BASE_COLOR_SLOT || slot == MATERIAL_EMISSION_SLOT || slot == MATERIAL_REFLECTANCE_SLOT;
}

shader::MaterialConstants constants_of(Material const& material) {
    shader::MaterialConstants constants{};
    constants.base_color = material.base_color;
    constants.emission = material.emission;
    constants.metallic = material.metallic;
    constants.roughness = material.roughness;
    constants.normal_scale = material.normal_scale;
    constants.occlusion_strength = material.occlusion_strength;
    constants.alpha_cutoff = material.alpha_cutoff;
    constants.flags = (material.alpha_mask ? MATERIAL_ALPHA_MASK : 0) |
                      (material.double_sided ? MATERIAL_DOUBLE_SIDED : 0) |
                      (material.normal_texture ? MATERIAL_NORMAL_MAP : 0) | (material.unlit ? MATERIAL_UNLIT : 0) |
                      (material.specular_texture || material.reflectance_texture ? MATERIAL_SPECULAR_MAPS : 0);
    constants.specular = material.specular;
    constants.reflectance = material.reflectance;
    constants.reflectance_shares = material.reflectance_shares;
    auto const textures = textures_of(material);
    for (std::size_t i = 0; i < textures.size(); ++i) {
        constants.uv_sets |= textures[i]->uv_set << i;
        constants.uv_from_vertex[i] = textures[i]->uv_from_vertex;
    }
    return constants;
}

VkSamplerAddressMode address_mode(TextureWrap wrap) {
    switch (wrap) {
    case TextureWrap::mirror:
        return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
    case TextureWrap::clamp:
        return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    default:
        return VK_SAMPLER_ADDRESS_MODE_REPEAT;
    }
}

SamplerState sampler_state(Texture const& texture) {
    auto const filter = [](TextureFilter f) {
        return f == TextureFilter::linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
    };
    SamplerState state{filter(texture.magnify), filter(texture.minify)};
    state.use_mips = texture.mipmaps;
    state.mips = VK_SAMPLER_MIPMAP_MODE_LINEAR;
    state.u = address_mode(texture.wrap_u);
    state.v = address_mode(texture.wrap_v);
    return state;
}

/// Mips are made here and not by the device: the same texels everywhere, and on a software device in a third of the time.
template <class Value>
std::unique_ptr<GpuImage> make_image(Staging& staging, Extent extent, VkFormat format, std::span<Value const> rgba,
                                     bool srgb, std::string const& name) {
    auto image = std::make_unique<GpuImage>(staging.device(), ImageShape{format, extent, 1, full_mip_count(extent)},
                                            VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT, name);
    auto const levels = mip_levels(extent, rgba, srgb);
    std::vector<std::span<std::byte const>> mips{std::as_bytes(rgba)};
    for (auto const& level : levels) mips.push_back(std::as_bytes(std::span(level.rgba)));
    upload(staging, *image, mips);
    return image;
}

/// Vulkan has no sRGB format of 16 bits, so that such colours are stored as light: steps of 1/65535 are a twentieth of
/// the smallest step of 8-bit sRGB. Half floats would have steps of 1/2048 near white.
std::vector<std::uint16_t> linear_words(std::span<std::uint16_t const> rgba) {
    std::vector<std::uint16_t> linear(rgba.begin(), rgba.end());
    for (std::size_t i = 0; i < linear.size(); ++i)
        if (i % 4 != 3) linear[i] = static_cast<std::uint16_t>(std::lround(65535 * linear_from_srgb_word(rgba[i])));
    return linear;
}

std::unique_ptr<GpuImage> make_picture(Staging& staging, Picture const& source, bool srgb) {
    Extent const extent{source.width, source.height};
    if (!source.deep())
        return make_image(staging, extent, srgb ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM,
                          std::span(source.rgba), srgb, source.name);
    std::vector<std::uint16_t> const linear = srgb ? linear_words(source.rgba16) : std::vector<std::uint16_t>{};
    return make_image(staging, extent, VK_FORMAT_R16G16B16A16_UNORM, std::span(srgb ? linear : source.rgba16), false,
                      source.name);
}

} // namespace

MaterialSets::MaterialSets(Staging& staging, Scene const& scene)
    : device_(staging.device()), samplers_(staging.device()) {
    white_ = make_picture(staging, {"white", 1, 1, {255, 255, 255, 255}}, false);
    make_layout();
    make_pool(static_cast<std::uint32_t>(scene.materials.size()));
    upload_constants(scene);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) write_set(staging, scene, i);
}

MaterialSets::~MaterialSets() {
    vkDestroyDescriptorPool(device_.handle(), pool_, nullptr);
    vkDestroyDescriptorSetLayout(device_.handle(), layout_, nullptr);
}

void MaterialSets::make_layout() {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    bindings.push_back(
        {MATERIAL_CONSTANTS_SLOT, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr});
    for (std::uint32_t i = 0; i < MATERIAL_TEXTURES; ++i) {
        bindings.push_back({MATERIAL_BASE_COLOR_SLOT + i, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1,
                            VK_SHADER_STAGE_FRAGMENT_BIT, nullptr});
    }
    VkDescriptorSetLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    info.bindingCount = static_cast<std::uint32_t>(bindings.size());
    info.pBindings = bindings.data();
    check(vkCreateDescriptorSetLayout(device_.handle(), &info, nullptr, &layout_), "making the materials' layout");
}

void MaterialSets::make_pool(std::uint32_t materials) {
    std::uint32_t const sets = std::max(materials, 1u);
    std::array const sizes = {
        VkDescriptorPoolSize{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, sets},
        VkDescriptorPoolSize{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, sets * MATERIAL_TEXTURES}};
    VkDescriptorPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    info.maxSets = sets;
    info.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
    info.pPoolSizes = sizes.data();
    check(vkCreateDescriptorPool(device_.handle(), &info, nullptr, &pool_), "making the materials' pool");
}

void MaterialSets::upload_constants(Scene const& scene) {
    VkDeviceSize const alignment = std::max<VkDeviceSize>(device_.limits().minUniformBufferOffsetAlignment, 16);
    stride_ = (sizeof(shader::MaterialConstants) + alignment - 1) / alignment * alignment;
    VkDeviceSize const bytes = stride_ * std::max<std::size_t>(scene.materials.size(), 1);
    constants_ =
        std::make_unique<GpuBuffer>(device_, bytes, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, BufferHome::host, "materials");
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        shader::MaterialConstants const constants = constants_of(scene.materials[i]);
        std::memcpy(constants_->mapped().data() + i * stride_, &constants, sizeof constants);
    }
}

GpuImage& MaterialSets::picture(Staging& staging, Scene const& scene, std::uint32_t index, bool srgb) {
    std::unique_ptr<GpuImage>& image = pictures_[{index, srgb}];
    if (!image) image = make_picture(staging, scene.pictures[index], srgb);
    return *image;
}

VkDescriptorImageInfo MaterialSets::texture(Staging& staging, Scene const& scene, Texture const& texture,
                                            bool srgb) {
    GpuImage const& image = texture ? picture(staging, scene, texture.picture, srgb) : *white_;
    return {samplers_.get(texture ? sampler_state(texture) : LINEAR_CLAMP), image.view(),
            VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
}

void MaterialSets::write_set(Staging& staging, Scene const& scene, std::size_t index) {
    Material const& material = scene.materials[index];
    Entry& entry = entries_.emplace_back();
    entry.double_sided = material.double_sided;
    entry.masked = material.alpha_mask;
    VkDescriptorSetAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    allocate.descriptorPool = pool_;
    allocate.descriptorSetCount = 1;
    allocate.pSetLayouts = &layout_;
    check(vkAllocateDescriptorSets(device_.handle(), &allocate, &entry.set), "making a material");

    VkDescriptorBufferInfo const buffer{constants_->handle(), index * stride_, sizeof(shader::MaterialConstants)};
    std::array<VkDescriptorImageInfo, MATERIAL_TEXTURES> images{};
    std::vector<VkWriteDescriptorSet> writes;
    VkWriteDescriptorSet write{};
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstSet = entry.set;
    write.descriptorCount = 1;
    write.dstBinding = MATERIAL_CONSTANTS_SLOT;
    write.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    write.pBufferInfo = &buffer;
    writes.push_back(write);
    auto const textures = textures_of(material);
    for (std::uint32_t i = 0; i < MATERIAL_TEXTURES; ++i) {
        images[i] = texture(staging, scene, *textures[i], is_color(static_cast<int>(MATERIAL_BASE_COLOR_SLOT + i)));
        write.dstBinding = MATERIAL_BASE_COLOR_SLOT + i;
        write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        write.pImageInfo = &images[i];
        writes.push_back(write);
    }
    vkUpdateDescriptorSets(device_.handle(), static_cast<std::uint32_t>(writes.size()), writes.data(), 0, nullptr);
}

} // namespace alpenglow
