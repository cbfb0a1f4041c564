/// Nothing is ever unloaded. The Vulkan loader unloads its driver before the leak sanitizer prints its stacks, which would
/// then name nothing.
extern "C" int dlclose(void*) { return 0; }

/// What a software driver, its compiler and the validation layer keep for themselves until the end.
extern "C" char const* __lsan_default_suppressions() { return "leak:libvulkan_lvp.so\nleak:libLLVM\nleak:libvulkan.so\nleak:libVkLayer_khronos_validation.so\n"; }
