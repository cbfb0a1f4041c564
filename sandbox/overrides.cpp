#include "sandbox/commands.h"

namespace alpenglow {

void apply_overrides(Settings& settings, std::span<Override const> overrides) {
    for (Override const& o : overrides) set_setting(settings, o.name, o.value);
}

} // namespace alpenglow
