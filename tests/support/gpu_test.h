#pragma once

#include "gpu/device.h"
#include "gpu/image.h"
#include "gpu/pipeline.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <cstring>
#include <span>
#include <vector>

namespace alpenglow::test {

/// A test that needs a device. All tests of a program share one, with core and synchronization validation; what validation
/// says while a test runs fails that test.
class GpuTest : public ::testing::Test {
public:
    static Device const& device();

protected:
    void SetUp() override { forget_messages(); }
    void TearDown() override;
    /// For a test that provokes messages on purpose.
    void forget_messages() { seen_ = device().messages().size(); }
    std::size_t new_messages() const { return device().messages().size() - seen_; }

private:
    std::size_t seen_ = 0;
};

/// Calls `last` before the shared device goes, when all tests have run.
void at_end_of_tests(void (*last)());

template <typename T>
std::vector<T> values_of(std::span<std::byte const> bytes) {
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

/// What one compute pass makes of a picture of floats: the shader reads slot 0 and writes slot 1, rgba32f both, one texel a thread.
std::vector<glm::vec4> run_compute(Device const& device, ShaderCode const& shader, std::vector<glm::vec4> const& input, Extent extent,
                                   std::vector<std::byte> const& push = {});

/// An image that passes can read, write and hand back, filled with `texels`.
std::unique_ptr<GpuImage> make_float_image(Device const& device, std::vector<glm::vec4> const& texels, Extent extent);

} // namespace alpenglow::test
