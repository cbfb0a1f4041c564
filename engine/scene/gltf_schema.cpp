#include "scene/gltf_schema.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <span>

namespace alpenglow::gltf {

namespace {

using Json = nlohmann::json;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest_int = std::numeric_limits<int>::max();
constexpr double largest_size = 9007199254740992.0; // 2^53: exact in a double

enum class Kind { object, filled_object, array, filled_array, text, boolean, integer, number, numbers, index };

/// What may stand at a path. "*" stands for each element of an array, "%" for each member of an object.
struct Rule {
    std::string_view path;
    Kind kind;
    bool required = false;
    double lowest = -infinity, highest = infinity;
    std::size_t length = 0;        ///< of `numbers`
    std::string_view allowed = {}; ///< "|5120|5121|": the only values that a text or integer may take
    std::string_view target = {};  ///< the array that an `index` points into
};

constexpr bool needed = true;

constexpr Rule object_at(std::string_view path, bool required = false) { return {path, Kind::object, required}; }
constexpr Rule text_at(std::string_view path, bool required = false, std::string_view allowed = {}) {
    return {path, Kind::text, required, -infinity, infinity, 0, allowed};
}
constexpr Rule flag_at(std::string_view path) { return {path, Kind::boolean}; }
constexpr Rule integer_at(std::string_view path, double lowest, double highest, bool required = false) {
    return {path, Kind::integer, required, lowest, highest};
}
constexpr Rule choice_at(std::string_view path, std::string_view allowed, bool required = false) {
    return {path, Kind::integer, required, 0, largest_int, 0, allowed};
}
constexpr Rule number_at(std::string_view path, double lowest = -infinity, double highest = infinity) {
    return {path, Kind::number, false, lowest, highest};
}
constexpr Rule numbers_at(std::string_view path, std::size_t length, double lowest = -infinity,
                          double highest = infinity) {
    return {path, Kind::numbers, false, lowest, highest, length};
}
constexpr Rule index_at(std::string_view path, std::string_view target, bool required = false) {
    return {path, Kind::index, required, 0, largest_int, 0, {}, target};
}

constexpr double above_zero = std::numeric_limits<double>::denorm_min();
constexpr std::string_view component_types = "|5120|5121|5122|5123|5125|5126|";
constexpr std::string_view index_types = "|5121|5123|5125|";
constexpr std::string_view wraps = "|10497|33071|33648|";

// glTF 2.0 specification, section 5 (property reference). A parent stands before its members.
constexpr auto rules = std::to_array<Rule>({
    text_at("extensionsUsed/*"),
    text_at("extensionsRequired/*"),
    object_at("buffers/*"),
    integer_at("buffers/*/byteLength", 1, largest_size, needed),
    text_at("buffers/*/uri"),
    object_at("bufferViews/*"),
    index_at("bufferViews/*/buffer", "buffers", needed),
    integer_at("bufferViews/*/byteOffset", 0, largest_size),
    integer_at("bufferViews/*/byteLength", 1, largest_size, needed),
    integer_at("bufferViews/*/byteStride", 4, 252),
    choice_at("bufferViews/*/target", "|34962|34963|"),
    object_at("accessors/*"),
    index_at("accessors/*/bufferView", "bufferViews"),
    integer_at("accessors/*/byteOffset", 0, largest_size),
    choice_at("accessors/*/componentType", component_types, needed),
    flag_at("accessors/*/normalized"),
    integer_at("accessors/*/count", 1, largest_size, needed),
    number_at("accessors/*/min/*"),
    number_at("accessors/*/max/*"),
    text_at("accessors/*/type", needed, "|SCALAR|VEC2|VEC3|VEC4|MAT2|MAT3|MAT4|"),
    object_at("accessors/*/sparse"),
    integer_at("accessors/*/sparse/count", 1, largest_int, needed),
    object_at("accessors/*/sparse/indices", needed),
    index_at("accessors/*/sparse/indices/bufferView", "bufferViews", needed),
    integer_at("accessors/*/sparse/indices/byteOffset", 0, largest_int),
    choice_at("accessors/*/sparse/indices/componentType", index_types, needed),
    object_at("accessors/*/sparse/values", needed),
    index_at("accessors/*/sparse/values/bufferView", "bufferViews", needed),
    integer_at("accessors/*/sparse/values/byteOffset", 0, largest_int),
    object_at("images/*"),
    text_at("images/*/uri"),
    text_at("images/*/mimeType"),
    text_at("images/*/name"),
    index_at("images/*/bufferView", "bufferViews"),
    object_at("samplers/*"),
    choice_at("samplers/*/magFilter", "|9728|9729|"),
    choice_at("samplers/*/minFilter", "|9728|9729|9984|9985|9986|9987|"),
    choice_at("samplers/*/wrapS", wraps),
    choice_at("samplers/*/wrapT", wraps),
    object_at("textures/*"),
    index_at("textures/*/sampler", "samplers"),
    index_at("textures/*/source", "images"),
    object_at("materials/*"),
    text_at("materials/*/name"),
    object_at("materials/*/pbrMetallicRoughness"),
    numbers_at("materials/*/pbrMetallicRoughness/baseColorFactor", 4, 0, 1),
    number_at("materials/*/pbrMetallicRoughness/metallicFactor", 0, 1),
    number_at("materials/*/pbrMetallicRoughness/roughnessFactor", 0, 1),
    object_at("materials/*/pbrMetallicRoughness/baseColorTexture"),
    index_at("materials/*/pbrMetallicRoughness/baseColorTexture/index", "textures", needed),
    integer_at("materials/*/pbrMetallicRoughness/baseColorTexture/texCoord", 0, largest_int),
    object_at("materials/*/pbrMetallicRoughness/metallicRoughnessTexture"),
    index_at("materials/*/pbrMetallicRoughness/metallicRoughnessTexture/index", "textures", needed),
    integer_at("materials/*/pbrMetallicRoughness/metallicRoughnessTexture/texCoord", 0, largest_int),
    object_at("materials/*/normalTexture"),
    index_at("materials/*/normalTexture/index", "textures", needed),
    integer_at("materials/*/normalTexture/texCoord", 0, largest_int),
    number_at("materials/*/normalTexture/scale"),
    object_at("materials/*/occlusionTexture"),
    index_at("materials/*/occlusionTexture/index", "textures", needed),
    integer_at("materials/*/occlusionTexture/texCoord", 0, largest_int),
    number_at("materials/*/occlusionTexture/strength", 0, 1),
    object_at("materials/*/emissiveTexture"),
    index_at("materials/*/emissiveTexture/index", "textures", needed),
    integer_at("materials/*/emissiveTexture/texCoord", 0, largest_int),
    numbers_at("materials/*/emissiveFactor", 3, 0, 1),
    text_at("materials/*/alphaMode", false, "|OPAQUE|MASK|BLEND|"),
    number_at("materials/*/alphaCutoff", 0),
    flag_at("materials/*/doubleSided"),
    object_at("meshes/*"),
    text_at("meshes/*/name"),
    {"meshes/*/primitives", Kind::filled_array, needed},
    object_at("meshes/*/primitives/*"),
    {"meshes/*/primitives/*/attributes", Kind::filled_object, needed},
    index_at("meshes/*/primitives/*/attributes/%", "accessors"),
    index_at("meshes/*/primitives/*/indices", "accessors"),
    index_at("meshes/*/primitives/*/material", "materials"),
    integer_at("meshes/*/primitives/*/mode", 0, 6),
    object_at("meshes/*/primitives/*/targets/*"),
    index_at("meshes/*/primitives/*/targets/*/%", "accessors"),
    number_at("meshes/*/weights/*"),
    object_at("skins/*"),
    {"skins/*/joints", Kind::filled_array, needed},
    index_at("skins/*/joints/*", "nodes"),
    index_at("skins/*/skeleton", "nodes"),
    index_at("skins/*/inverseBindMatrices", "accessors"),
    object_at("cameras/*"),
    text_at("cameras/*/type", needed, "|perspective|orthographic|"),
    object_at("cameras/*/perspective"),
    {"cameras/*/perspective/yfov", Kind::number, needed, above_zero},
    {"cameras/*/perspective/znear", Kind::number, needed, above_zero},
    number_at("cameras/*/perspective/zfar", above_zero),
    number_at("cameras/*/perspective/aspectRatio", above_zero),
    object_at("cameras/*/orthographic"),
    {"cameras/*/orthographic/xmag", Kind::number, needed},
    {"cameras/*/orthographic/ymag", Kind::number, needed},
    {"cameras/*/orthographic/zfar", Kind::number, needed, above_zero},
    {"cameras/*/orthographic/znear", Kind::number, needed, 0},
    object_at("animations/*"),
    {"animations/*/channels", Kind::filled_array, needed},
    {"animations/*/samplers", Kind::filled_array, needed},
    object_at("animations/*/samplers/*"),
    index_at("animations/*/samplers/*/input", "accessors", needed),
    index_at("animations/*/samplers/*/output", "accessors", needed),
    text_at("animations/*/samplers/*/interpolation", false, "|LINEAR|STEP|CUBICSPLINE|"),
    object_at("animations/*/channels/*"),
    integer_at("animations/*/channels/*/sampler", 0, largest_int, needed),
    object_at("animations/*/channels/*/target", needed),
    index_at("animations/*/channels/*/target/node", "nodes"),
    text_at("animations/*/channels/*/target/path", needed),
    object_at("nodes/*"),
    text_at("nodes/*/name"),
    index_at("nodes/*/children/*", "nodes"),
    index_at("nodes/*/mesh", "meshes"),
    index_at("nodes/*/camera", "cameras"),
    index_at("nodes/*/skin", "skins"),
    numbers_at("nodes/*/matrix", 16),
    numbers_at("nodes/*/translation", 3),
    numbers_at("nodes/*/rotation", 4, -1, 1),
    numbers_at("nodes/*/scale", 3),
    number_at("nodes/*/weights/*"),
    object_at("scenes/*"),
    index_at("scenes/*/nodes/*", "nodes"),
    index_at("scene", "scenes"),
    // Extensions
    object_at("extensions"),
    object_at("extensions/%"),
    {"extensions/KHR_lights_punctual/lights", Kind::array, needed},
    object_at("extensions/KHR_lights_punctual/lights/*"),
    text_at("extensions/KHR_lights_punctual/lights/*/type", needed),
    object_at("extensions/KHR_lights_punctual/lights/*/spot"),
    number_at("extensions/KHR_lights_punctual/lights/*/spot/innerConeAngle", 0),
    number_at("extensions/KHR_lights_punctual/lights/*/spot/outerConeAngle", above_zero),
    object_at("nodes/*/extensions/KHR_lights_punctual"),
    index_at("nodes/*/extensions/KHR_lights_punctual/light", "extensions/KHR_lights_punctual/lights", needed),
    {"extensions/KHR_materials_variants/variants", Kind::array, needed},
    object_at("extensions/KHR_materials_variants/variants/*"),
    text_at("extensions/KHR_materials_variants/variants/*/name", needed),
    object_at("meshes/*/primitives/*/extensions/KHR_materials_variants"),
    {"meshes/*/primitives/*/extensions/KHR_materials_variants/mappings", Kind::array, needed},
    object_at("meshes/*/primitives/*/extensions/KHR_materials_variants/mappings/*"),
    index_at("meshes/*/primitives/*/extensions/KHR_materials_variants/mappings/*/material", "materials", needed),
    index_at("meshes/*/primitives/*/extensions/KHR_materials_variants/mappings/*/variants/*",
             "extensions/KHR_materials_variants/variants"),
    object_at("textures/*/extensions/EXT_texture_webp"),
    index_at("textures/*/extensions/EXT_texture_webp/source", "images"),
    object_at("animations/*/channels/*/target/extensions/KHR_animation_pointer"),
    text_at("animations/*/channels/*/target/extensions/KHR_animation_pointer/pointer", needed),
    number_at("materials/*/extensions/KHR_materials_anisotropy/anisotropyStrength", 0, 1),
    number_at("materials/*/extensions/KHR_materials_dispersion/dispersion", 0),
    number_at("materials/*/extensions/KHR_materials_emissive_strength/emissiveStrength", 0),
    number_at("materials/*/extensions/KHR_materials_ior/ior", 0),
    number_at("materials/*/extensions/KHR_materials_specular/specularFactor", 0, 1),
    numbers_at("materials/*/extensions/KHR_materials_volume/attenuationColor", 3, 0, 1),
});

class Checker {
public:
    Checker(Json& root, Rule const& rule, Report& report) : root_(root), rule_(rule), report_(report) {}

    void visit(Json& value, std::string_view path) {
        if (path.empty()) return check(value);
        std::size_t const slash = path.find('/');
        std::string_view const token = path.substr(0, slash);
        std::string_view const rest = slash == std::string_view::npos ? std::string_view{} : path.substr(slash + 1);
        if (token == "*") {
            require(value.is_array(), "TYPE_MISMATCH", "must be an array");
            if (value.empty() && rest.empty()) report_.say("EMPTY_ENTITY", pointer_, "must not be empty");
            for (std::size_t i = 0; i < value.size(); ++i) descend(std::to_string(i), value[i], rest);
        } else if (token == "%") {
            require(value.is_object(), "TYPE_MISMATCH", "must be an object");
            for (auto& [name, member] : value.items()) descend(printable(name), member, rest);
        } else if (auto const member = value.find(token); member != value.end()) {
            descend(token, *member, rest);
        } else if (rest.empty() && rule_.required) {
            pointer_.append("/").append(token);
            fail("UNDEFINED_PROPERTY", "is missing");
        }
    }

private:
    void descend(std::string_view name, Json& value, std::string_view rest) {
        std::size_t const length = pointer_.size();
        pointer_.append("/").append(name);
        visit(value, rest);
        pointer_.resize(length);
    }

    [[noreturn]] void fail(Code code, std::string const& reason) const { report_.refuse(code, pointer_, reason); }
    void require(bool holds, Code code, char const* reason) const {
        if (!holds) fail(code, reason);
    }

    void check(Json& value) const {
        switch (rule_.kind) {
        case Kind::object:
            return require(value.is_object(), "TYPE_MISMATCH", "must be an object");
        case Kind::filled_object:
            require(value.is_object(), "TYPE_MISMATCH", "must be an object");
            return require(!value.empty(), "EMPTY_ENTITY", "must be an object that is not empty");
        case Kind::array:
            return require(value.is_array(), "TYPE_MISMATCH", "must be an array");
        case Kind::filled_array:
            require(value.is_array(), "TYPE_MISMATCH", "must be an array");
            return require(!value.empty(), "EMPTY_ENTITY", "must be an array that is not empty");
        case Kind::boolean:
            return require(value.is_boolean(), "TYPE_MISMATCH", "must be true or false");
        case Kind::text:
            require(value.is_string(), "TYPE_MISMATCH", "must be a text");
            return check_allowed(value.get_ref<std::string const&>());
        case Kind::number:
            return check_number(value);
        case Kind::numbers:
            require(value.is_array(), "TYPE_MISMATCH", "must be an array");
            if (value.size() != rule_.length) {
                fail("ARRAY_LENGTH_NOT_IN_LIST", fmt::format("must be an array of {} numbers", rule_.length));
            }
            for (Json const& number : value) check_number(number);
            return;
        case Kind::integer:
            return check_integer(value);
        case Kind::index:
            return check_index(value);
        }
    }

    void check_number(Json const& value) const {
        require(value.is_number(), "TYPE_MISMATCH", "must be a number");
        double const number = value.get<double>();
        if (std::abs(number) > std::numeric_limits<float>::max())
            fail("VALUE_NOT_IN_RANGE", "is too large for a float");
        check_range(number);
    }

    void check_range(double number) const {
        if (number < rule_.lowest) fail("VALUE_NOT_IN_RANGE", fmt::format("is below {}", rule_.lowest));
        if (number > rule_.highest) fail("VALUE_NOT_IN_RANGE", fmt::format("is above {}", rule_.highest));
    }

    void check_integer(Json& value) const {
        require(value.is_number(), "TYPE_MISMATCH", "must be an integer");
        double const number = value.get<double>();
        require(number == std::floor(number), "TYPE_MISMATCH", "must be an integer");
        check_range(number);
        value = static_cast<std::uint64_t>(number);
        check_allowed(std::to_string(static_cast<std::uint64_t>(number)));
    }

    void check_allowed(std::string const& value) const {
        if (rule_.allowed.empty()) return;
        if (value.find('|') == std::string::npos && rule_.allowed.find("|" + value + "|") != std::string_view::npos)
            return;
        fail("VALUE_NOT_IN_LIST", fmt::format("\"{}\" is not one of {}", printable(value),
                                              rule_.allowed.substr(1, rule_.allowed.size() - 2)));
    }

    void check_index(Json& value) const {
        check_integer(value);
        Json::json_pointer const target(fmt::format("/{}", rule_.target));
        std::size_t const size = root_.contains(target) && root_[target].is_array() ? root_[target].size() : 0;
        if (std::size_t const index = value.get<std::size_t>(); index >= size) {
            fail("UNRESOLVED_REFERENCE", fmt::format("is {}, but there are {} {}", index, size,
                                                     rule_.target.substr(rule_.target.rfind('/') + 1)));
        }
    }

    Json& root_;
    Rule const& rule_;
    Report& report_;
    std::string pointer_;
};

/// "2.1" to {2, 1}.
std::pair<int, int> parse_version(std::string const& text, char const* pointer, Report const& report) {
    std::size_t const dot = text.find('.');
    auto const is_number = [](std::string_view part) {
        return !part.empty() && part.size() < 6 &&
               std::ranges::all_of(part, [](char c) { return c >= '0' && c <= '9'; });
    };
    if (dot == std::string::npos || !is_number(text.substr(0, dot)) || !is_number(text.substr(dot + 1))) {
        report.refuse("PATTERN_MISMATCH", pointer, fmt::format("\"{}\" is not a version", printable(text)));
    }
    return {std::stoi(text.substr(0, dot)), std::stoi(text.substr(dot + 1))};
}

constexpr auto supported_extensions = std::to_array<std::string_view>({
    "EXT_meshopt_compression",
    "EXT_texture_webp",
    "KHR_draco_mesh_compression",
    "KHR_lights_punctual", // read and reported; the sun is the only light
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_specular",
    "KHR_materials_unlit",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
});

bool is_supported(std::string const& extension) {
    return std::ranges::find(supported_extensions, extension) != supported_extensions.end();
}

} // namespace

void check_schema(Json& json, Report& report) {
    for (Rule const& rule : rules) Checker(json, rule, report).visit(json, rule.path);
}

void check_version(Json const& json, Report const& report) {
    auto const asset = json.find("asset");
    if (asset == json.end()) report.refuse("UNDEFINED_PROPERTY", "/asset", "is missing");
    if (!asset->is_object()) report.refuse("TYPE_MISMATCH", "/asset", "must be an object");
    auto const text_at = [&](char const* key) -> std::string {
        auto const text = asset->find(key);
        if (text == asset->end()) return {};
        if (!text->is_string()) report.refuse("TYPE_MISMATCH", fmt::format("/asset/{}", key), "must be a text");
        return *text;
    };
    std::string const version = text_at("version"), needs = text_at("minVersion");
    if (version.empty()) report.refuse("UNDEFINED_PROPERTY", "/asset/version", "is missing");
    auto const given = parse_version(version, "/asset/version", report);
    if (given.first != 2) {
        report.refuse("UNKNOWN_ASSET_MAJOR_VERSION", "/asset/version", fmt::format("glTF {} is not supported", version),
                      "only glTF 2 is");
    }
    if (needs.empty()) return;
    auto const needed_version = parse_version(needs, "/asset/minVersion", report);
    if (needed_version > std::pair(2, 0)) {
        report.refuse(needed_version > given ? Code("ASSET_MIN_VERSION_GREATER_THAN_VERSION") : "UNSUPPORTED_VERSION",
                      "/asset/minVersion", fmt::format("needs a reader of glTF {}", needs), "this one reads 2.0");
    }
}

void check_extensions(Json const& json, Report& report) {
    if (auto const names = json.find("extensionsRequired"); names != json.end()) {
        for (std::size_t i = 0; i < names->size(); ++i) {
            std::string const name = (*names)[i];
            if (!is_supported(name)) {
                report.refuse("UNSUPPORTED_EXTENSION", "/extensionsRequired/" + std::to_string(i),
                              printable(name) + " is required and not supported", "export the scene without it");
            }
        }
    }
    std::set<std::string> unknown;
    for (std::string const name : json.value("extensionsUsed", Json::array()))
        if (!is_supported(name)) unknown.insert(printable(name));
    if (!unknown.empty())
        report.warn("UNSUPPORTED_EXTENSION", "/extensionsUsed",
                    fmt::format("loaded without {}, which {} not supported", fmt::join(unknown, ", "),
                                unknown.size() == 1 ? "is" : "are"));
}

} // namespace alpenglow::gltf
