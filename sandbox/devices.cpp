#include "core/error.h"
#include "gpu/device.h"
#include "sandbox/commands.h"

#include <fmt/format.h>

namespace alpenglow {

int devices(DevicesOptions const&) {
    std::vector<DeviceReport> const reports = list_devices();
    DeviceReport const* chosen = nullptr;
    for (DeviceReport const& report : reports) {
        if (report.lacks.empty() && (!chosen || report.preference > chosen->preference)) chosen = &report;
    }
    for (DeviceReport const& report : reports) {
        std::string const verdict = !report.lacks.empty()
                                        ? fmt::format("refused: lacks {}", fmt::join(report.lacks, ", "))
                                    : &report == chosen ? "chosen: the fastest kind of those that can be used"
                                                        : fmt::format("can be used: --device {}", report.index);
        fmt::print("{}  {} ({}, {}, {} MiB)\n   {}\n", report.index, report.name, report.type, report.driver,
                   report.memory_bytes >> 20, verdict);
    }
    if (!chosen)
        throw Error(ErrorKind::device, "no Vulkan device can be used", {},
                    "install a Vulkan 1.3 driver; mesa-vulkan-drivers has one that needs no GPU");
    return 0;
}

} // namespace alpenglow
