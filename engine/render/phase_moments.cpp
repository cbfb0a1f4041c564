#include "render/phase_moments.h"

#include <algorithm>

namespace alpenglow {

double straight_on_share(PhaseLobes const& lobes) {
    return std::clamp(phase_legendre(lobes, 9), 0.0, std::max(phase_legendre(lobes, 10), 0.0));
}

shader::PhaseMoments phase_moments(PhaseLobes const& lobes) {
    double const straight_on = straight_on_share(lobes);
    shader::PhaseMoments moments{};
    for (int l = 0; l < PHASE_DEGREES; ++l)
        moments.degree[l] = static_cast<float>(phase_legendre(lobes, l) - straight_on);
    return moments;
}

} // namespace alpenglow
