#include "scene/gltf_contents.h"
#include "scene/gltf_elements.h"
#include "scene/gltf_structure.h"

#include <optional>
#include <set>

namespace alpenglow::gltf {

namespace {

using Json = nlohmann::json;

void check_times(Document const& document, std::size_t input, std::string const& pointer, Report& report) {
    double previous = -std::numeric_limits<double>::infinity();
    bool negative = false, backwards = false;
    visit_elements(document, input, [&](std::size_t, ElementValues const& values) {
        negative = negative || values[0] < 0;
        backwards = backwards || values[0] <= previous;
        previous = values[0];
    });
    if (negative) report.say("ACCESSOR_ANIMATION_INPUT_NEGATIVE", pointer, "has a negative time");
    if (backwards) report.say("ACCESSOR_ANIMATION_INPUT_NON_INCREASING", pointer, "has times that don't increase");
}

/// Of the three elements of a cubic key the middle one is the rotation.
void check_rotations(Document const& document, std::size_t output, bool cubic, std::string const& pointer,
                     Report& report) {
    constexpr double tolerance = 0.00769; // the validator's, for quaternions
    if (document.accessors[output].type != Component::float32) return;
    std::optional<std::size_t> bad;
    visit_elements(document, output, [&](std::size_t i, ElementValues const& q) {
        bool const counts = !cubic || i % 3 == 1;
        double const length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        if (counts && !bad && std::abs(length - 1) > tolerance) bad = i;
    });
    if (bad)
        report.say("ACCESSOR_ANIMATION_SAMPLER_OUTPUT_NON_NORMALIZED_QUATERNION", pointer,
                   fmt::format("has a rotation at {} that is not of unit length", *bad));
}

void check_bind_matrices(Document const& document, std::size_t index, std::string const& pointer, Report& report) {
    Accessor const& accessor = document.accessors[index];
    if (accessor.columns != 4 || accessor.view == no_index) return;
    bool affine = true;
    visit_elements(document, index, [&](std::size_t, ElementValues const& m) {
        affine = affine && m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1;
    });
    if (!affine) report.say("ACCESSOR_INVALID_IBM", pointer, "has a matrix that doesn't end in the row 0 0 0 1");
}

} // namespace

void check_motion_values(Json const& json, Document const& document, Report& report) {
    std::set<std::size_t> seen;
    auto const is_new = [&](std::size_t accessor) { return seen.insert(accessor).second; };
    for_each(json, "animations", "", [&](Json const& animation, std::string const& of_animation) {
        for_each(animation, "samplers", of_animation, [&](Json const& sampler, std::string const& pointer) {
            auto const input = sampler["input"].get<std::size_t>();
            if (is_new(input)) check_times(document, input, pointer + "/input", report);
        });
        for_each(animation, "channels", of_animation, [&](Json const& channel, std::string const& pointer) {
            Json const& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
            auto const output = sampler["output"].get<std::size_t>();
            bool const cubic = sampler.value("interpolation", "") == "CUBICSPLINE";
            if (channel["target"]["path"] == "rotation" && is_new(output))
                check_rotations(document, output, cubic, pointer + "/sampler", report);
        });
    });
    for_each(json, "skins", "", [&](Json const& skin, std::string const& pointer) {
        Json const& matrices = member(skin, "inverseBindMatrices");
        if (!matrices.is_null() && is_new(matrices.get<std::size_t>()))
            check_bind_matrices(document, matrices.get<std::size_t>(), pointer + "/inverseBindMatrices", report);
    });
}

} // namespace alpenglow::gltf
