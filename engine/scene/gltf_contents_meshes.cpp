#include "scene/gltf_contents.h"
#include "scene/gltf_elements.h"
#include "scene/gltf_structure.h"

#include <map>
#include <set>

namespace alpenglow::gltf {

namespace {

using Json = nlohmann::json;

// The validator's tolerance for vectors of unit length.
constexpr double unit_tolerance = 0.00674;

bool is_unit(ElementValues const& v) {
    return std::abs(std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 1) <= unit_tolerance;
}

/// The largest whole number of an accessor and where it stands.
struct Largest {
    std::size_t place = 0;
    double value = -1;
};

class AttributeCheck {
public:
    AttributeCheck(Document const& document, Report& report) : document_(document), report_(report) {}

    void check_indices(Json const& primitive) {
        Json const& indices = member(primitive, "indices");
        Json const& position = member(primitive["attributes"], "POSITION");
        if (indices.is_null() || position.is_null()) return;
        auto const index = indices.get<std::size_t>();
        std::uint64_t const vertices = document_.accessors[position.get<std::size_t>()].count;
        std::string const pointer = fmt::format("/accessors/{}", index);
        Largest const largest = largest_of(index);
        auto const bits = static_cast<int>(8 * component_size(document_.accessors[index].type));
        double const restart = std::ldexp(1.0, bits) - 1;
        if (largest.value == restart)
            report_.say("ACCESSOR_INDEX_PRIMITIVE_RESTART", pointer,
                        fmt::format("index {} is the restart value {}", largest.place, restart));
        if (largest.value >= static_cast<double>(vertices))
            report_.say(
                "ACCESSOR_INDEX_OOB", pointer,
                fmt::format("index {} is {}, but there are {} vertices", largest.place, largest.value, vertices));
    }

    /// Each accessor once for each kind of attribute.
    void check_attribute(std::string const& name, std::size_t index, std::string const& pointer) {
        std::string const kind = name.substr(0, name.find('_'));
        Accessor const& accessor = document_.accessors[index];
        if (accessor.type != Component::float32 || accessor.view == no_index || !seen_.insert({kind, index}).second)
            return;
        auto const warn_of_first = [&](Code code, auto const& is_good, char const* what) {
            std::size_t bad = 0, first = 0;
            visit_elements(document_, index, [&](std::size_t i, ElementValues const& v) {
                if (!is_good(v) && bad++ == 0) first = i;
            });
            if (bad > 0) report_.say(code, pointer, fmt::format("{} of element {}{}", what, first,
                                                     bad == 1 ? "" : fmt::format(" and {} more", bad - 1)));
        };
        if (kind == "NORMAL" || kind == "TANGENT")
            warn_of_first("ACCESSOR_VECTOR3_NON_UNIT", is_unit, "no unit length");
        if (kind == "TANGENT")
            warn_of_first(
                "ACCESSOR_INVALID_SIGN", [](auto const& v) { return std::abs(v[3]) == 1; }, "sign not 1 or -1");
        if (kind == "COLOR")
            warn_of_first(
                "ACCESSOR_NON_CLAMPED",
                [](auto const& v) { return std::ranges::all_of(v, [](double c) { return c >= 0 && c <= 1; }); },
                "colour not in 0 to 1");
        if (kind == "WEIGHTS")
            warn_of_first(
                "ACCESSOR_WEIGHTS_NEGATIVE", [](auto const& v) { return std::ranges::min(v) >= 0; }, "negative weight");
    }

    void check_joints(Json const& mesh, std::size_t joints, std::string const& of_mesh) {
        for_each(mesh, "primitives", of_mesh, [&](Json const& primitive, std::string const& pointer) {
            for (auto const& [name, accessor] : primitive["attributes"].items()) {
                if (!name.starts_with("JOINTS_")) continue;
                Largest const largest = largest_of(accessor.get<std::size_t>());
                if (largest.value >= static_cast<double>(joints))
                    report_.say("ACCESSOR_JOINTS_INDEX_OOB", pointer + "/attributes/" + printable(name),
                                fmt::format("element {} names joint {}, but there are {}", largest.place, largest.value,
                                            joints));
            }
        });
    }

private:
    Largest largest_of(std::size_t accessor) {
        auto const [known, added] = largest_.try_emplace(accessor);
        if (!added) return known->second;
        Largest largest;
        visit_elements(document_, accessor, [&](std::size_t i, ElementValues const& values) {
            double const value = std::ranges::max(values);
            if (value > largest.value) largest = {i, value};
        });
        return known->second = largest;
    }

    Document const& document_;
    Report& report_;
    std::map<std::size_t, Largest> largest_;
    std::set<std::pair<std::string, std::size_t>> seen_;
};

} // namespace

void check_attribute_values(Json const& json, Document const& document, Report& report) {
    AttributeCheck check(document, report);
    for_each(json, "meshes", "", [&](Json const& mesh, std::string const& of_mesh) {
        for_each(mesh, "primitives", of_mesh, [&](Json const& primitive, std::string const& pointer) {
            check.check_indices(primitive);
            for (auto const& [name, accessor] : primitive["attributes"].items())
                check.check_attribute(name, accessor.get<std::size_t>(), pointer + "/attributes/" + printable(name));
        });
    });
    std::set<std::pair<std::size_t, std::size_t>> skinned; // mesh and skin, each pair once
    for_each(json, "nodes", "", [&](Json const& node, std::string const&) {
        Json const& skin = member(node, "skin");
        Json const& mesh = member(node, "mesh");
        if (skin.is_null() || mesh.is_null()) return;
        if (skinned.insert({mesh.get<std::size_t>(), skin.get<std::size_t>()}).second)
            check.check_joints(referred(json, "meshes", mesh), referred(json, "skins", skin)["joints"].size(),
                               "/meshes/" + mesh.dump());
    });
}

} // namespace alpenglow::gltf
