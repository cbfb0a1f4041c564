#include "scene/gltf_structure.h"

#include <map>
#include <set>

namespace alpenglow::gltf {

namespace {

using Json = nlohmann::json;

/// The number behind "TEXCOORD_" and the like, 1 more than it says; 0 where `name` is not of that set.
int set_number(std::string_view name, std::string_view set) {
    if (!name.starts_with(set)) return 0;
    name.remove_prefix(set.size());
    bool const digits =
        !name.empty() && name.size() < 4 && std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; });
    if (!digits || (name.size() > 1 && name[0] == '0')) return 0;
    return std::stoi(std::string(name)) + 1;
}

int count_sets(Json const& attributes, std::string_view set) {
    int count = 0;
    for (auto const& [name, accessor] : attributes.items()) count += set_number(name, set) > 0;
    return count;
}

bool is_attribute(std::string_view name) {
    if (name.starts_with('_') || name == "POSITION" || name == "NORMAL" || name == "TANGENT") return true;
    return set_number(name, "TEXCOORD_") || set_number(name, "COLOR_") || set_number(name, "JOINTS_") ||
           set_number(name, "WEIGHTS_");
}

/// How many sets of texture coordinates a material uses. Its textures stand at any depth; KHR_texture_transform may
/// choose another set.
int texture_sets(Json const& value) {
    int sets = 0;
    for (auto const& [key, child] : value.items()) {
        if (!child.is_object() || key == "extras") continue;
        sets = std::max(sets, texture_sets(child));
        if (!key.ends_with("Texture")) continue;
        Json const& moved = member(member(member(child, "extensions"), "KHR_texture_transform"), "texCoord");
        Json const& set = moved.is_number_integer() ? moved : member(child, "texCoord");
        constexpr std::int64_t most = 1000;
        sets = std::max(
            sets, 1 + (set.is_number_integer() ? int(std::clamp(set.get<std::int64_t>(), std::int64_t{0}, most)) : 0));
    }
    return sets;
}

class PrimitiveCheck {
public:
    /// `needed_sets`: of texture coordinates, by each material.
    PrimitiveCheck(Json const& json, std::vector<int> const& needed_sets, Json const& primitive,
                   std::string const& pointer, Report& report)
        : json_(json), needed_sets_(needed_sets), primitive_(primitive), attributes_(primitive["attributes"]),
          pointer_(pointer), report_(report) {}

    void check() {
        for (auto const& [name, accessor] : attributes_.items())
            check_attribute(name, accessor_at(accessor), pointer_ + "/attributes/" + printable(name));
        check_counts();
        check_shared_views();
        if (count_sets(attributes_, "JOINTS_") != count_sets(attributes_, "WEIGHTS_"))
            report_.say("MESH_PRIMITIVE_JOINTS_WEIGHTS_MISMATCH", pointer_ + "/attributes",
                        "has not as many JOINTS as WEIGHTS");
        check_indices();
        for_each(primitive_, "targets", pointer_,
                 [&](Json const& target, std::string const& pointer) { check_target(target, pointer); });
        check_texture_sets();
    }

private:
    Json const& accessor_at(Json const& index) const { return referred(json_, "accessors", index); }

    void check_attribute(std::string const& name, Json const& accessor, std::string const& pointer) {
        if (!is_attribute(name)) report_.say("MESH_PRIMITIVE_INVALID_ATTRIBUTE", pointer, "is no name of an attribute");
        std::string_view const type = name == "POSITION" || name == "NORMAL" ? "VEC3" : name == "TANGENT" ? "VEC4" : "";
        if (!type.empty() && accessor["type"] != type)
            report_.say("MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_INVALID_FORMAT", pointer,
                        name + " has the wrong number of components");
        if (accessor["componentType"] == 5125)
            report_.say("MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_UNSIGNED_INT", pointer, "is made of 32-bit integers");
        if (name == "POSITION" && !(accessor.contains("min") && accessor.contains("max")))
            report_.say("MESH_PRIMITIVE_POSITION_ACCESSOR_WITHOUT_BOUNDS", pointer, "has no min and max");
        Json const& view = member(accessor, "bufferView");
        if (view.is_null()) return;
        auto const stride = referred(json_, "bufferViews", view).value("byteStride", std::uint64_t{0});
        if (accessor.value("byteOffset", std::uint64_t{0}) % 4 != 0 || stride % 4 != 0)
            report_.say("MESH_PRIMITIVE_ACCESSOR_UNALIGNED", pointer, "is not aligned to 4 bytes");
    }

    void check_counts() {
        Json const& position = member(attributes_, "POSITION");
        if (position.is_null()) return;
        Json const& count = accessor_at(position)["count"];
        for (auto const& [name, accessor] : attributes_.items()) {
            Json const& other = accessor_at(accessor)["count"];
            if (other != count)
                report_.say("MESH_PRIMITIVE_UNEQUAL_ACCESSOR_COUNT", pointer_ + "/attributes/" + printable(name),
                            fmt::format("has {} elements, POSITION {}", other.dump(), count.dump()));
        }
    }

    void check_shared_views() {
        std::map<std::size_t, std::size_t> first_accessors;
        for (auto const& [name, accessor] : attributes_.items()) {
            Json const& view = member(accessor_at(accessor), "bufferView");
            if (view.is_null() || has_stride(json_, accessor_at(accessor))) continue;
            auto const [first, added] =
                first_accessors.try_emplace(view.get<std::size_t>(), accessor.get<std::size_t>());
            if (!added && first->second != accessor.get<std::size_t>())
                report_.say("MESH_PRIMITIVE_ACCESSOR_WITHOUT_BYTESTRIDE", pointer_ + "/attributes/" + printable(name),
                            "shares its view, which then needs a byteStride");
        }
    }

    void check_indices() {
        Json const& indices = member(primitive_, "indices");
        if (indices.is_null()) return;
        Json const& accessor = accessor_at(indices);
        if (has_stride(json_, accessor))
            report_.say("MESH_PRIMITIVE_INDICES_ACCESSOR_WITH_BYTESTRIDE", pointer_ + "/indices",
                        "has a view with a stride");
        std::string const format = format_of(accessor);
        if (format != "SCALAR 5121" && format != "SCALAR 5123" && format != "SCALAR 5125")
            report_.say("MESH_PRIMITIVE_INDICES_ACCESSOR_INVALID_FORMAT", pointer_ + "/indices",
                        "can't be indices: these are unsigned scalars, not normalized");
    }

    void check_target(Json const& target, std::string const& pointer) {
        for (auto const& [name, accessor] : target.items()) {
            std::string const at = pointer + "/" + printable(name);
            Json const& moved = accessor_at(accessor);
            if (name == "POSITION" && !(moved.contains("min") && moved.contains("max")))
                report_.say("MESH_PRIMITIVE_POSITION_ACCESSOR_WITHOUT_BOUNDS", at, "has no min and max");
            Json const& base = member(attributes_, name.c_str());
            if (base.is_null())
                report_.say("MESH_PRIMITIVE_MORPH_TARGET_NO_BASE_ACCESSOR", at, "moves an attribute that is not there");
            else if (moved["count"] != accessor_at(base)["count"])
                report_.say("MESH_PRIMITIVE_MORPH_TARGET_INVALID_ATTRIBUTE_COUNT", at,
                            "has another count than what it moves");
        }
    }

    void check_texture_sets() {
        Json const& material = member(primitive_, "material");
        if (material.is_null()) return;
        int const needed = needed_sets_[material.get<std::size_t>()], given = count_sets(attributes_, "TEXCOORD_");
        if (given < needed)
            report_.say("MESH_PRIMITIVE_TOO_FEW_TEXCOORDS", pointer_ + "/material",
                        fmt::format("uses {} sets of texture coordinates, the primitive has {}", needed, given));
    }

    Json const& json_;
    std::vector<int> const& needed_sets_;
    Json const& primitive_;
    Json const& attributes_;
    std::string const& pointer_;
    Report& report_;
};

void check_morphs(Json const& mesh, std::string const& pointer, Report& report) {
    std::size_t const targets = member(mesh["primitives"][0], "targets").size();
    for_each(mesh, "primitives", pointer, [&](Json const& primitive, std::string const& at) {
        if (member(primitive, "targets").size() != targets)
            report.say("MESH_PRIMITIVES_UNEQUAL_TARGETS_COUNT", at + "/targets", "are not as many as in the first one");
    });
    if (mesh.contains("weights") && mesh["weights"].size() != targets)
        report.say("MESH_INVALID_WEIGHTS_COUNT", pointer + "/weights", "are not as many as there are morph targets");
}

} // namespace

void check_meshes(Json const& json, Report& report) {
    std::vector<int> needed_sets;
    for_each(json, "materials", "",
             [&](Json const& material, std::string const&) { needed_sets.push_back(texture_sets(material)); });
    for_each(json, "meshes", "", [&](Json const& mesh, std::string const& of_mesh) {
        for_each(mesh, "primitives", of_mesh, [&](Json const& primitive, std::string const& pointer) {
            PrimitiveCheck(json, needed_sets, primitive, pointer, report).check();
        });
        check_morphs(mesh, of_mesh, report);
    });
}

} // namespace alpenglow::gltf
