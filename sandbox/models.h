#pragma once

#include <array>
#include <string_view>

namespace alpenglow {

/// A way to light the air that `evaluate` measures.
struct Model {
    std::string_view name, help;
};

inline constexpr std::array MODELS{
    Model{"default", "what render and fly draw: single scattering marched, further orders from a table of moments"},
};

} // namespace alpenglow
