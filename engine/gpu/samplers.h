#pragma once

#include "gpu/device.h"

#include <map>

namespace alpenglow {

struct SamplerState {
    VkFilter magnify = VK_FILTER_LINEAR, minify = VK_FILTER_LINEAR;
    VkSamplerMipmapMode mips = VK_SAMPLER_MIPMAP_MODE_NEAREST;
    bool use_mips = false;
    VkSamplerAddressMode u = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE, v = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    bool compare = false; ///< lit (1) where the reference is not beyond the stored depth

    auto operator<=>(SamplerState const&) const = default;
};

inline constexpr SamplerState LINEAR_CLAMP{};
inline constexpr SamplerState NEAREST_CLAMP{VK_FILTER_NEAREST, VK_FILTER_NEAREST, VK_SAMPLER_MIPMAP_MODE_NEAREST};
inline constexpr SamplerState SHADOW_COMPARE{VK_FILTER_LINEAR,
                                             VK_FILTER_LINEAR,
                                             VK_SAMPLER_MIPMAP_MODE_NEAREST,
                                             false,
                                             VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                             VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                             true};

/// Makes samplers once and keeps them.
class SamplerCache {
public:
    explicit SamplerCache(Device const& device) : device_(device) {}
    ~SamplerCache();
    SamplerCache(SamplerCache const&) = delete;
    SamplerCache& operator=(SamplerCache const&) = delete;

    VkSampler get(SamplerState const& state);

private:
    Device const& device_;
    std::map<SamplerState, VkSampler> samplers_;
};

} // namespace alpenglow
