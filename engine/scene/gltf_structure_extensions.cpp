#include "scene/gltf_structure.h"

#include <set>

namespace alpenglow::gltf {

namespace {

using Json = nlohmann::json;

/// Where an extension's object may stand; "*" stands for any index.
struct Place {
    std::string_view extension, path;
};

constexpr auto places = std::to_array<Place>({
    {"EXT_mesh_gpu_instancing", "nodes/*"},
    {"EXT_meshopt_compression", "buffers/*"},
    {"EXT_meshopt_compression", "bufferViews/*"},
    {"EXT_texture_webp", "textures/*"},
    {"KHR_animation_pointer", "animations/*/channels/*/target"},
    {"KHR_draco_mesh_compression", "meshes/*/primitives/*"},
    {"KHR_lights_punctual", ""},
    {"KHR_lights_punctual", "nodes/*"},
    {"KHR_materials_anisotropy", "materials/*"},
    {"KHR_materials_clearcoat", "materials/*"},
    {"KHR_materials_dispersion", "materials/*"},
    {"KHR_materials_emissive_strength", "materials/*"},
    {"KHR_materials_ior", "materials/*"},
    {"KHR_materials_iridescence", "materials/*"},
    {"KHR_materials_pbrSpecularGlossiness", "materials/*"},
    {"KHR_materials_sheen", "materials/*"},
    {"KHR_materials_specular", "materials/*"},
    {"KHR_materials_transmission", "materials/*"},
    {"KHR_materials_unlit", "materials/*"},
    {"KHR_materials_variants", ""},
    {"KHR_materials_variants", "meshes/*/primitives/*"},
    {"KHR_materials_volume", "materials/*"},
    {"KHR_mesh_quantization", "nowhere"},
    {"KHR_node_visibility", "nodes/*"},
    {"KHR_texture_basisu", "textures/*"},
});

bool is_known(std::string_view extension) {
    return extension == "KHR_texture_transform" ||
           std::ranges::find(places, extension, &Place::extension) != places.end();
}

bool may_stand(std::string_view extension, std::string_view path) {
    if (!is_known(extension)) return true;
    if (extension == "KHR_texture_transform") return path.ends_with("Texture");
    return std::ranges::any_of(places,
                               [&](Place const& place) { return place.extension == extension && place.path == path; });
}

/// Walks over the whole document; its depth is bounded since check_json_shape. `path` has "*" for indices.
class ExtensionWalk {
public:
    ExtensionWalk(std::set<std::string> declared, Report& report) : declared_(std::move(declared)), report_(report) {}

    void visit(Json const& value, std::string const& path, std::string const& pointer) {
        if (value.is_array()) {
            for (std::size_t i = 0; i < value.size(); ++i)
                if (value[i].is_structured()) visit(value[i], path + "/*", fmt::format("{}/{}", pointer, i));
            return;
        }
        for (auto const& [key, child] : value.items()) {
            if (key == "extensions")
                check(child, path, pointer + "/extensions");
            else if (key != "extras" && child.is_structured())
                visit(child, path.empty() ? key : path + "/" + key, pointer + "/" + printable(key));
        }
    }

private:
    void check(Json const& extensions, std::string const& path, std::string const& pointer) {
        if (!extensions.is_object()) report_.refuse("TYPE_MISMATCH", pointer, "must be an object");
        for (auto const& [name, body] : extensions.items()) {
            std::string const place = pointer + "/" + printable(name);
            if (!body.is_object()) report_.refuse("TYPE_MISMATCH", place, "must be an object");
            if (!declared_.contains(name)) report_.say("UNDECLARED_EXTENSION", place, "is not named in extensionsUsed");
            if (!may_stand(name, path)) report_.say("UNEXPECTED_EXTENSION_OBJECT", place, "has no place here");
            visit(body, path + "/" + name, place);
        }
    }

    std::set<std::string> declared_;
    Report& report_;
};

/// Each name once; returns them.
std::set<std::string> check_names(Json const& json, char const* key, Report& report) {
    std::set<std::string> names;
    for_each(json, key, "", [&](Json const& name, std::string const& pointer) {
        if (!names.insert(name).second) report.say("DUPLICATE_ELEMENTS", pointer, "stands twice");
    });
    return names;
}

void check_spot(Json const& light, std::string const& pointer, Report& report) {
    if (light["type"] != "spot") return;
    Json const& spot = member(light, "spot");
    if (spot.is_null()) report.refuse("UNDEFINED_PROPERTY", pointer + "/spot", "is missing");
    constexpr double quarter_pi = 0.7853981633974483; // the outer angle's default
    if (spot.value("outerConeAngle", quarter_pi) <= spot.value("innerConeAngle", 0.0))
        report.say("KHR_LIGHTS_PUNCTUAL_LIGHT_SPOT_ANGLES", pointer + "/spot",
                   "has an outer angle that is not the larger");
}

void check_variants(Json const& mesh, bool declared, std::string const& of_mesh, Report& report) {
    for_each(mesh, "primitives", of_mesh, [&](Json const& primitive, std::string const& of_primitive) {
        Json const& body = member(member(primitive, "extensions"), "KHR_materials_variants");
        std::set<std::size_t> used;
        for_each(body, "mappings", of_primitive + "/extensions/KHR_materials_variants",
                 [&](Json const& mapping, std::string const& pointer) {
                     if (!declared)
                         report.say("UNSATISFIED_DEPENDENCY", pointer, "needs the document's list of variants");
                     for_each(mapping, "variants", pointer, [&](Json const& variant, std::string const& at) {
                         if (!used.insert(variant.get<std::size_t>()).second)
                             report.say("KHR_MATERIALS_VARIANTS_NON_UNIQUE_VARIANT", at, "is mapped twice");
                     });
                 });
    });
}

void check_animation_pointer(Json const& target, std::string const& pointer, Report& report) {
    Json const& body = member(member(target, "extensions"), "KHR_animation_pointer");
    if (body.is_null()) return;
    std::string const place = pointer + "/extensions/KHR_animation_pointer";
    if (target.contains("node"))
        report.say("KHR_ANIMATION_POINTER_ANIMATION_CHANNEL_TARGET_NODE", place, "stands beside a node");
    if (target["path"] != "pointer")
        report.say("KHR_ANIMATION_POINTER_ANIMATION_CHANNEL_TARGET_PATH", place, "needs the path \"pointer\"");
    if (!body["pointer"].get_ref<std::string const&>().starts_with('/'))
        report.say("PATTERN_MISMATCH", place + "/pointer", "is no JSON pointer");
}

} // namespace

void check_extension_objects(Json const& json, Report& report) {
    std::set<std::string> const used = check_names(json, "extensionsUsed", report);
    std::set<std::string> const required = check_names(json, "extensionsRequired", report);
    if (!required.empty() && used.empty())
        report.say("UNSATISFIED_DEPENDENCY", "/extensionsRequired", "needs extensionsUsed");
    for (std::string const& name : required) {
        if (!used.contains(name))
            report.say("UNUSED_EXTENSION_REQUIRED", "/extensionsRequired",
                       printable(name) + " is not named in extensionsUsed");
    }
    if (used.contains("KHR_mesh_quantization") && !required.contains("KHR_mesh_quantization"))
        report.say("NON_REQUIRED_EXTENSION", "/extensionsUsed", "KHR_mesh_quantization must be required");
    ExtensionWalk(used, report).visit(json, "", "");
}

void check_extension_values(Json const& json, Report& report) {
    Json const& extensions = member(json, "extensions");
    for_each(member(extensions, "KHR_lights_punctual"), "lights", "/extensions/KHR_lights_punctual",
             [&](Json const& light, std::string const& pointer) { check_spot(light, pointer, report); });
    for (auto const& [extension, list] :
         {std::pair{"KHR_lights_punctual", "lights"}, {"KHR_materials_variants", "variants"}}) {
        if (Json const& array = member(member(extensions, extension), list); array.is_array() && array.empty())
            report.say("EMPTY_ENTITY", fmt::format("/extensions/{}/{}", extension, list), "must not be empty");
    }
    for_each(json, "meshes", "", [&](Json const& mesh, std::string const& pointer) {
        check_variants(mesh, extensions.contains("KHR_materials_variants"), pointer, report);
    });
    for_each(json, "animations", "", [&](Json const& animation, std::string const& of_animation) {
        for_each(animation, "channels", of_animation, [&](Json const& channel, std::string const& pointer) {
            check_animation_pointer(channel["target"], pointer + "/target", report);
        });
    });
}

} // namespace alpenglow::gltf
