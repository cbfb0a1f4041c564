#include "scene/gltf_structure.h"

#include <map>
#include <set>

namespace alpenglow::gltf {

namespace {

using Json = nlohmann::json;

/// Remembers what each buffer view is used for: vertices, indices and the rest don't mix.
class ViewUses {
public:
    ViewUses(Json const& json, Report& report) : json_(json), report_(report) {
        for_each(json, "bufferViews", "", [&](Json const& view, std::string const&) {
            Json const& target = member(view, "target");
            uses_.push_back(target == 34962 ? "vertices" : target == 34963 ? "indices" : "");
        });
    }

    void use(Json const& view, char const* what, std::string const& pointer) {
        if (view.is_null()) return;
        std::string& known = uses_[view.get<std::size_t>()];
        if (known.empty())
            known = what;
        else if (known != what)
            report_.say(
                "BUFFER_VIEW_TARGET_OVERRIDE", pointer,
                fmt::format("uses buffer view {} for {}, but it is for {}", view.get<std::size_t>(), what, known));
    }
    void use_accessor(Json const& accessor, char const* what, std::string const& pointer) {
        use(member(referred(json_, "accessors", accessor), "bufferView"), what, pointer);
    }

private:
    Json const& json_;
    Report& report_;
    std::vector<std::string> uses_;
};

void check_view_uses(Json const& json, Report& report) {
    ViewUses uses(json, report);
    for_each(json, "images", "", [&](Json const& image, std::string const& pointer) {
        uses.use(member(image, "bufferView"), "a picture", pointer + "/bufferView");
    });
    for_each(json, "meshes", "", [&](Json const& mesh, std::string const& of_mesh) {
        for_each(mesh, "primitives", of_mesh, [&](Json const& primitive, std::string const& pointer) {
            if (Json const& indices = member(primitive, "indices"); !indices.is_null())
                uses.use_accessor(indices, "indices", pointer + "/indices");
            for (auto const& [name, accessor] : primitive["attributes"].items())
                uses.use_accessor(accessor, "vertices", pointer + "/attributes/" + printable(name));
            for_each(primitive, "targets", pointer, [&](Json const& target, std::string const& of_target) {
                for (auto const& [name, accessor] : target.items())
                    uses.use_accessor(accessor, "vertices", of_target + "/" + printable(name));
            });
        });
    });
}

void check_view(Json const& view, std::string const& pointer, Report& report) {
    Json const& stride = member(view, "byteStride");
    if (stride.is_null()) return;
    if (stride.get<std::uint64_t>() % 4 != 0)
        report.say("VALUE_MULTIPLE_OF", pointer + "/byteStride", "is not a multiple of 4");
    if (stride > view["byteLength"])
        report.say("BUFFER_VIEW_TOO_BIG_BYTE_STRIDE", pointer + "/byteStride", "is above the view's length");
    if (member(view, "target") == 34963)
        report.say("BUFFER_VIEW_INVALID_BYTE_STRIDE", pointer + "/byteStride", "stands in a view for indices");
}

void check_accessor_members(Json const& json, Json const& accessor, std::string const& pointer, Report& report) {
    if (accessor.contains("byteOffset") && !accessor.contains("bufferView"))
        report.say("UNSATISFIED_DEPENDENCY", pointer + "/byteOffset", "needs a bufferView");
    Json const& sparse = member(accessor, "sparse");
    for (char const* const part : {"indices", "values"}) {
        if (!sparse.is_null() && referred(json, "bufferViews", sparse[part]["bufferView"]).contains("byteStride"))
            report.say("BUFFER_VIEW_INVALID_BYTE_STRIDE", pointer + "/sparse/" + part, "has a view with a stride");
    }
}

void check_image(Json const& json, Json const& image, std::string const& pointer, Report& report) {
    Json const& view = member(image, "bufferView");
    if (view.is_null() != image.contains("uri"))
        report.say("ONE_OF_MISMATCH", pointer, "must have either a uri or a bufferView");
    if (view.is_null()) return;
    if (!image.contains("mimeType")) report.say("UNSATISFIED_DEPENDENCY", pointer + "/bufferView", "needs a mimeType");
    if (referred(json, "bufferViews", view).contains("byteStride"))
        report.say("IMAGE_BUFFER_VIEW_WITH_BYTESTRIDE", pointer + "/bufferView", "has a view with a stride");
}

} // namespace

bool has_stride(Json const& json, Json const& accessor) {
    Json const& view = member(accessor, "bufferView");
    return !view.is_null() && referred(json, "bufferViews", view).contains("byteStride");
}

std::string format_of(Json const& accessor) {
    return fmt::format("{} {}{}", accessor["type"].get_ref<std::string const&>(), accessor["componentType"].get<int>(),
                       accessor.value("normalized", false) ? " normalized" : "");
}

void check_views_and_images(Json const& json, Report& report) {
    for_each(json, "bufferViews", "",
             [&](Json const& view, std::string const& pointer) { check_view(view, pointer, report); });
    for_each(json, "accessors", "", [&](Json const& accessor, std::string const& pointer) {
        check_accessor_members(json, accessor, pointer, report);
    });
    for_each(json, "images", "",
             [&](Json const& image, std::string const& pointer) { check_image(json, image, pointer, report); });
    check_view_uses(json, report);
}

void check_structure(Json const& json, Report& report) {
    check_extension_objects(json, report);
    check_extension_values(json, report);
    check_views_and_images(json, report);
    check_meshes(json, report);
    check_nodes_and_cameras(json, report);
    check_skins(json, report);
    check_animations(json, report);
}

} // namespace alpenglow::gltf
