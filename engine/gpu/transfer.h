#pragma once

#include "gpu/buffer.h"
#include "gpu/image.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace alpenglow {

/// Memory that uploads go through. It grows with the largest and is kept until the end: fresh memory costs a system more
/// time than what is copied into it.
class Staging {
public:
    explicit Staging(Device const& device) : device_(device) {}
    Device const& device() const { return device_; }
    /// One of at least so many bytes. What it held may be lost.
    GpuBuffer const& buffer(VkDeviceSize bytes);

private:
    Device const& device_;
    std::unique_ptr<GpuBuffer> buffer_;
};

/// Copies bytes to a device buffer and waits.
void upload(Staging& staging, GpuBuffer const& target, std::span<std::byte const> bytes);

/// Fills the mips of a one-layer image, from the finest on, a span for each, and leaves it ready to be sampled. Waits.
void upload(Staging& staging, GpuImage& target, std::span<std::span<std::byte const> const> mips);
/// The same for an image of one mip, with memory of its own.
void upload(Device const& device, GpuImage& target, std::span<std::byte const> bytes);

/// Texels of mip 0, layer by layer, row by row, and waits.
std::vector<std::byte> read_back(Device const& device, GpuImage& source);

/// Mips down to one texel.
std::uint32_t full_mip_count(Extent extent);

} // namespace alpenglow
