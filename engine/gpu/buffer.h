#pragma once

#include "gpu/device.h"

#include <span>

namespace alpenglow {

enum class BufferHome {
    device, ///< fastest for the device; filled through `upload`
    host,   ///< mapped and coherent: written or read by the CPU
};

class GpuBuffer {
public:
    GpuBuffer(Device const& device, VkDeviceSize bytes, VkBufferUsageFlags usage, BufferHome home,
              std::string const& name);
    ~GpuBuffer();
    GpuBuffer(GpuBuffer const&) = delete;
    GpuBuffer& operator=(GpuBuffer const&) = delete;

    VkBuffer handle() const { return buffer_; }
    VkDeviceSize bytes() const { return bytes_; }
    /// The mapped bytes of a host buffer.
    std::span<std::byte> mapped() const { return {static_cast<std::byte*>(mapped_), static_cast<std::size_t>(bytes_)}; }

private:
    Device const& device_;
    VkDeviceSize bytes_, allocated_ = 0;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    void* mapped_ = nullptr;
};

} // namespace alpenglow
