#include "scene/gltf_structure.h"

#include <set>

namespace alpenglow::gltf {

namespace {

using Json = nlohmann::json;

void check_sampler(Json const& json, Json const& sampler, std::string const& pointer, Report& report) {
    Json const& input = referred(json, "accessors", sampler["input"]);
    for (char const* const key : {"input", "output"}) {
        if (has_stride(json, referred(json, "accessors", sampler[key])))
            report.say("ANIMATION_SAMPLER_ACCESSOR_WITH_BYTESTRIDE", pointer + "/" + key, "has a view with a stride");
    }
    if (format_of(input) != "SCALAR 5126")
        report.say("ANIMATION_SAMPLER_INPUT_ACCESSOR_INVALID_FORMAT", pointer + "/input", "is not scalars of floats");
    if (!(input.contains("min") && input.contains("max")))
        report.say("ANIMATION_SAMPLER_INPUT_ACCESSOR_WITHOUT_BOUNDS", pointer + "/input", "has no min and max");
    if (sampler.value("interpolation", "") == "CUBICSPLINE" && input["count"] < 2)
        report.say("ANIMATION_SAMPLER_INPUT_ACCESSOR_TOO_FEW_ELEMENTS", pointer + "/input",
                   "has fewer than two elements");
}

/// Morph targets of the mesh that a node shows.
std::size_t targets_of(Json const& json, Json const& node) {
    Json const& mesh = member(node, "mesh");
    return mesh.is_null() ? 0 : member(referred(json, "meshes", mesh)["primitives"][0], "targets").size();
}

bool fits_path(Json const& output, std::string_view path) {
    std::string const format = format_of(output);
    std::string const type = output["type"];
    if (path == "translation" || path == "scale") return format == "VEC3 5126";
    if (path == "rotation" && type != "VEC4") return false;
    if (path == "weights" && type != "SCALAR") return false;
    int const component = output["componentType"].get<int>();
    return component == 5126 || (component <= 5123 && output.value("normalized", false));
}

void check_target(Json const& json, Json const& target, std::string const& pointer, Report& report) {
    Json const& index = member(target, "node");
    if (index.is_null()) return;
    Json const& node = referred(json, "nodes", index);
    if (target["path"] != "weights" && node.contains("matrix"))
        report.say("ANIMATION_CHANNEL_TARGET_NODE_MATRIX", pointer, "moves a node that has a matrix");
    if (target["path"] == "weights" && targets_of(json, node) == 0)
        report.say("ANIMATION_CHANNEL_TARGET_NODE_WEIGHTS_NO_MORPHS", pointer, "moves weights of no morph targets");
}

void check_output(Json const& json, Json const& sampler, Json const& target, std::string const& pointer,
                  Report& report) {
    std::string const path = target["path"];
    if (path == "pointer") return;
    Json const& output = referred(json, "accessors", sampler["output"]);
    if (!fits_path(output, path))
        return report.say("ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_FORMAT", pointer,
                          "has an output unfit for " + printable(path));
    Json const& node = member(target, "node");
    std::size_t const each = path == "weights" && !node.is_null() ? targets_of(json, referred(json, "nodes", node)) : 1;
    std::size_t const three = sampler.value("interpolation", "") == "CUBICSPLINE" ? 3 : 1;
    std::size_t const keys = referred(json, "accessors", sampler["input"])["count"].get<std::size_t>();
    if (each > 0 && output["count"].get<std::size_t>() != keys * three * each)
        report.say("ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_COUNT", pointer, "has an output of the wrong count");
}

} // namespace

void check_animations(Json const& json, Report& report) {
    for_each(json, "animations", "", [&](Json const& animation, std::string const& of_animation) {
        for_each(animation, "samplers", of_animation, [&](Json const& sampler, std::string const& pointer) {
            check_sampler(json, sampler, pointer, report);
        });
        std::set<std::pair<std::string, std::string>> targets;
        for_each(animation, "channels", of_animation, [&](Json const& channel, std::string const& pointer) {
            Json const& target = channel["target"];
            std::size_t const sampler = channel["sampler"].get<std::size_t>();
            if (sampler >= animation["samplers"].size())
                report.say("UNRESOLVED_REFERENCE", pointer + "/sampler",
                           fmt::format("is {}, but there are {} samplers", sampler, animation["samplers"].size()));
            check_target(json, target, pointer + "/target", report);
            check_output(json, animation["samplers"][sampler], target, pointer + "/sampler", report);
            if (target.contains("node") && !targets.insert({target["node"].dump(), target["path"].dump()}).second)
                report.say("ANIMATION_DUPLICATE_TARGETS", pointer + "/target", "is moved by two channels");
        });
    });
}

} // namespace alpenglow::gltf
