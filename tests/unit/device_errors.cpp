#include "core/error.h"
#include "gpu/device.h"
#include "support/files.h"

#include <gtest/gtest.h>

using namespace alpenglow;

namespace {

DeviceAbilities able() {
    DeviceAbilities abilities;
    abilities.api_version = VK_API_VERSION_1_3;
    abilities.graphics_queue = abilities.subgroup_votes = true;
    abilities.vulkan13.dynamicRendering = abilities.vulkan13.synchronization2 = abilities.vulkan13.maintenance4 = VK_TRUE;
    abilities.vulkan12.scalarBlockLayout = VK_TRUE;
    abilities.features.features.depthClamp = abilities.features.features.shaderStorageImageExtendedFormats = VK_TRUE;
    abilities.extensions = {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME, VK_KHR_SWAPCHAIN_EXTENSION_NAME};
    return abilities;
}

using Words = std::vector<std::string>;

} // namespace

TEST(DeviceErrors, a_lost_device_is_one_line_with_exit_code_4) {
    test::expect_error(ErrorKind::device, {"waiting for a frame", "the device was lost", "start again", "alpenglow devices"},
                       [] { check(VK_ERROR_DEVICE_LOST, "waiting for a frame"); });
    EXPECT_EQ(static_cast<int>(ErrorKind::device), 4);
}

TEST(DeviceErrors, out_of_memory_says_what_to_make_smaller) {
    test::expect_error(ErrorKind::device, {"making the image shadow", "out of device memory", "--size", "cascade_size"},
                       [] { check(VK_ERROR_OUT_OF_DEVICE_MEMORY, "making the image shadow"); });
    test::expect_error(ErrorKind::device, {"out of host memory", "--size"}, [] { check(VK_ERROR_OUT_OF_HOST_MEMORY, "making the image shadow"); });
}

TEST(DeviceErrors, no_driver_says_what_to_install) {
    test::expect_error(ErrorKind::device, {"starting Vulkan", "no Vulkan driver", "mesa-vulkan-drivers"},
                       [] { check(VK_ERROR_INCOMPATIBLE_DRIVER, "starting Vulkan"); });
}

TEST(DeviceErrors, what_is_no_failure_passes) {
    for (VkResult const result : {VK_SUCCESS, VK_TIMEOUT, VK_SUBOPTIMAL_KHR, VK_INCOMPLETE}) EXPECT_NO_THROW(check(result, "anything"));
}

TEST(DeviceAbilities, an_able_device_lacks_nothing) {
    EXPECT_EQ(missing_abilities(able(), false), Words{});
    EXPECT_EQ(missing_abilities(able(), true), Words{});
}

TEST(DeviceAbilities, each_one_that_is_missing_is_named) {
    struct Case {
        char const* name;
        void (*remove)(DeviceAbilities&);
    };
    Case const cases[] = {
        {"Vulkan 1.3", [](DeviceAbilities& a) { a.api_version = VK_API_VERSION_1_2; }},
        {"queue", [](DeviceAbilities& a) { a.graphics_queue = false; }},
        {"dynamicRendering", [](DeviceAbilities& a) { a.vulkan13.dynamicRendering = VK_FALSE; }},
        {"synchronization2", [](DeviceAbilities& a) { a.vulkan13.synchronization2 = VK_FALSE; }},
        {"maintenance4", [](DeviceAbilities& a) { a.vulkan13.maintenance4 = VK_FALSE; }},
        {"scalarBlockLayout", [](DeviceAbilities& a) { a.vulkan12.scalarBlockLayout = VK_FALSE; }},
        {"depthClamp", [](DeviceAbilities& a) { a.features.features.depthClamp = VK_FALSE; }},
        {"shaderStorageImageExtendedFormats",
         [](DeviceAbilities& a) { a.features.features.shaderStorageImageExtendedFormats = VK_FALSE; }},
        {"subgroup votes", [](DeviceAbilities& a) { a.subgroup_votes = false; }},
        {"VK_KHR_push_descriptor", [](DeviceAbilities& a) { a.extensions = {VK_KHR_SWAPCHAIN_EXTENSION_NAME}; }},
        {"VK_KHR_swapchain", [](DeviceAbilities& a) { a.extensions = {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME}; }},
        {"presentation", [](DeviceAbilities& a) { a.presents = false; }},
        {"32-bit float depth", [](DeviceAbilities& a) { a.missing_formats = {"32-bit float depth"}; }},
    };
    for (Case const& one : cases) {
        DeviceAbilities abilities = able();
        one.remove(abilities);
        Words const lacks = missing_abilities(abilities, true);
        ASSERT_EQ(lacks.size(), 1u) << one.name;
        EXPECT_NE(lacks[0].find(one.name), std::string::npos) << lacks[0];
    }
}

TEST(DeviceAbilities, what_only_a_window_needs_is_not_asked_of_a_headless_device) {
    DeviceAbilities abilities = able();
    abilities.extensions = {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME};
    abilities.presents = false;
    EXPECT_EQ(missing_abilities(abilities, false), Words{});
    EXPECT_EQ(missing_abilities(abilities, true).size(), 2u);
}
