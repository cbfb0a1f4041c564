#include "sandbox/commands.h"

namespace alpenglow {

void apply_overrides(Settings& settings, std::span<Override const> overrides) {
    for (Override const& o : overrides) set_setting(settings, o.name, o.value);
}

void PlacementOptions::apply_to(std::optional<Placement>& placement) const {
    if (!at && !yaw && !scale && !curve) return;
    Placement result = placement.value_or(Placement{});
    result.anchor = at.value_or(result.anchor);
    result.yaw = yaw.value_or(result.yaw);
    result.scale = scale.value_or(result.scale);
    result.curve = result.curve || curve;
    placement = result;
}

} // namespace alpenglow
