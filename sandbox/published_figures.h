#pragma once

#include <array>
#include <string_view>

namespace alpenglow {

/// Mean HDR FLIP of two known models against a path tracer, from Dimas Leenman, "A visual and performance comparison of
/// atmospheric scattering models", Utrecht University 2025, appendix A.
struct PublishedFigures {
    std::string_view view; ///< in the order of that table
    double bruneton, hillaire;
};

inline constexpr std::array PUBLISHED_FIGURES{
    PublishedFigures{"ground-dawn", 0.09809241, 0.11073484},
    PublishedFigures{"ground-sunrise", 0.03308802, 0.12071851},
    PublishedFigures{"ground-noon", 0.01935603, 0.07796405},
    PublishedFigures{"plane-dawn", 0.28129065, 0.30420122},
    PublishedFigures{"plane-sunrise", 0.05343369, 0.13399105},
    PublishedFigures{"plane-noon", 0.04459071, 0.10759243},
    PublishedFigures{"orbit-dawn", 0.41126001, 0.40727559},
    PublishedFigures{"orbit-sunrise", 0.06427314, 0.0641655},
    PublishedFigures{"orbit-noon", 0.05222957, 0.07187424},
    PublishedFigures{"space", 0.15413877, 0.08722282},
    PublishedFigures{"planet-shadow-ground", 0.05699512, 0.06620285},
    PublishedFigures{"planet-shadow-orbit", 0.14620577, 0.12997645},
};

inline constexpr std::string_view PUBLISHED_CAVEAT =
    "Bruneton and Hillaire: mean HDR FLIP that D. Leenman (2025, appendix A) published for the same suns, heights and "
    "air. They are context, not a ranking: his cameras are his own (field of view and pitch are not given), his "
    "pictures have 36 times the pixels, and his reference stops at four scattering events and has noise, which favours "
    "four orders of Bruneton's model, spoils the dark views and dominates orbit-dawn.";

} // namespace alpenglow
