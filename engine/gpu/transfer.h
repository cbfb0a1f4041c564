#pragma once

#include "gpu/buffer.h"
#include "gpu/image.h"

#include <cstddef>
#include <span>
#include <vector>

namespace alpenglow {

/// Copies bytes to a device buffer and waits.
void upload(Device const& device, GpuBuffer const& target, std::span<std::byte const> bytes);

/// Fills mip 0 of a one-layer image, makes the other mips by linear filtering (in linear light for sRGB formats), and
/// leaves it ready to be sampled. Waits.
void upload(Device const& device, GpuImage& target, std::span<std::byte const> bytes);

/// Texels of mip 0, layer by layer, row by row, and waits.
std::vector<std::byte> read_back(Device const& device, GpuImage& source);

/// Mips down to one texel.
std::uint32_t full_mip_count(Extent extent);

} // namespace alpenglow
