#include "gpu/samplers.h"

namespace alpenglow {

SamplerCache::~SamplerCache() {
    for (auto const& [state, sampler] : samplers_) vkDestroySampler(device_.handle(), sampler, nullptr);
}

VkSampler SamplerCache::get(SamplerState const& state) {
    VkSampler& sampler = samplers_[state];
    if (sampler) return sampler;
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.magFilter = state.magnify;
    info.minFilter = state.minify;
    info.mipmapMode = state.mips;
    info.addressModeU = state.u;
    info.addressModeV = state.v;
    info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.compareEnable = state.compare;
    info.compareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
    info.maxLod = state.use_mips ? VK_LOD_CLAMP_NONE : 0.0f;
    check(vkCreateSampler(device_.handle(), &info, nullptr, &sampler), "making a sampler");
    return sampler;
}

} // namespace alpenglow
