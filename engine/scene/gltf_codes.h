#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace alpenglow::gltf {

/// What a diagnostic is about. Names are the official glTF validator's (KhronosGroup/glTF-Validator, ISSUES.md) where
/// one fits. A file is refused where an index, range, count, reference or number is wrong; what can be drawn as it
/// stands, or is not drawn at all, is warned of.
struct CodeInfo {
    std::string_view name;
    bool refuses;
};

constexpr bool refused = true, warned = false;

inline constexpr auto CODES = std::to_array<CodeInfo>({
    // Ours: what the validator has no code for
    {"LIMIT_EXCEEDED", refused},
    {"NOT_LOADABLE", refused},
    {"URI_NOT_ALLOWED", refused},
    {"ACCESSORS_OVERLAP", refused},
    {"UNSUPPORTED_VERSION", refused},
    {"SIMPLIFIED", warned},
    // The container and the JSON
    {"GLB_CHUNK_LENGTH_UNALIGNED", warned},
    {"GLB_CHUNK_TOO_BIG", refused},
    {"GLB_DUPLICATE_CHUNK", warned},
    {"GLB_EMPTY_CHUNK", refused},
    {"GLB_EXTRA_DATA", warned},
    {"GLB_INVALID_MAGIC", refused},
    {"GLB_INVALID_VERSION", refused},
    {"GLB_LENGTH_MISMATCH", refused},
    {"GLB_LENGTH_TOO_SMALL", refused},
    {"GLB_UNEXPECTED_BIN_CHUNK", warned},
    {"GLB_UNEXPECTED_END_OF_CHUNK_DATA", refused},
    {"GLB_UNEXPECTED_END_OF_CHUNK_HEADER", refused},
    {"GLB_UNEXPECTED_END_OF_HEADER", refused},
    {"GLB_UNEXPECTED_FIRST_CHUNK", refused},
    {"INVALID_JSON", refused},
    // Any value
    {"ARRAY_LENGTH_NOT_IN_LIST", refused},
    {"DUPLICATE_ELEMENTS", warned},
    {"EMPTY_ENTITY", warned},
    {"ONE_OF_MISMATCH", refused},
    {"PATTERN_MISMATCH", refused},
    {"TYPE_MISMATCH", refused},
    {"UNDEFINED_PROPERTY", refused},
    {"UNRESOLVED_REFERENCE", refused},
    {"UNSATISFIED_DEPENDENCY", warned},
    {"VALUE_MULTIPLE_OF", refused},
    {"VALUE_NOT_IN_LIST", refused},
    {"VALUE_NOT_IN_RANGE", refused},
    // Version and extensions
    {"ASSET_MIN_VERSION_GREATER_THAN_VERSION", refused},
    {"UNKNOWN_ASSET_MAJOR_VERSION", refused},
    {"KHR_ANIMATION_POINTER_ANIMATION_CHANNEL_TARGET_NODE", warned},
    {"KHR_ANIMATION_POINTER_ANIMATION_CHANNEL_TARGET_PATH", warned},
    {"KHR_LIGHTS_PUNCTUAL_LIGHT_SPOT_ANGLES", refused},
    {"KHR_MATERIALS_VARIANTS_NON_UNIQUE_VARIANT", warned},
    {"NON_REQUIRED_EXTENSION", warned},
    {"UNDECLARED_EXTENSION", warned},
    {"UNEXPECTED_EXTENSION_OBJECT", warned},
    {"UNSUPPORTED_EXTENSION", warned},
    {"UNUSED_EXTENSION_REQUIRED", warned},
    // Buffers, views and accessors
    {"ACCESSOR_ELEMENT_OUT_OF_MAX_BOUND", warned},
    {"ACCESSOR_ELEMENT_OUT_OF_MIN_BOUND", warned},
    {"ACCESSOR_INVALID_FLOAT", refused},
    {"ACCESSOR_MATRIX_ALIGNMENT", refused},
    {"ACCESSOR_MAX_MISMATCH", warned},
    {"ACCESSOR_MIN_MISMATCH", warned},
    {"ACCESSOR_NORMALIZED_INVALID", refused},
    {"ACCESSOR_OFFSET_ALIGNMENT", refused},
    {"ACCESSOR_SMALL_BYTESTRIDE", refused},
    {"ACCESSOR_SPARSE_COUNT_OUT_OF_RANGE", refused},
    {"ACCESSOR_SPARSE_INDEX_OOB", refused},
    {"ACCESSOR_SPARSE_INDICES_NON_INCREASING", refused},
    {"ACCESSOR_TOO_LONG", refused},
    {"ACCESSOR_TOTAL_OFFSET_ALIGNMENT", refused},
    {"BUFFER_BYTE_LENGTH_MISMATCH", refused},
    {"BUFFER_DATA_URI_MIME_TYPE_INVALID", warned},
    {"BUFFER_MISSING_GLB_DATA", refused},
    {"BUFFER_VIEW_INVALID_BYTE_STRIDE", warned},
    {"BUFFER_VIEW_TARGET_OVERRIDE", warned},
    {"BUFFER_VIEW_TOO_BIG_BYTE_STRIDE", warned},
    {"BUFFER_VIEW_TOO_LONG", refused},
    {"INVALID_URI", refused},
    {"IO_ERROR", refused},
    // Pictures
    {"IMAGE_BUFFER_VIEW_WITH_BYTESTRIDE", warned},
    {"IMAGE_DATA_INVALID", refused},
    {"IMAGE_MIME_TYPE_INVALID", warned},
    {"IMAGE_NON_ENABLED_MIME_TYPE", warned},
    {"IMAGE_UNEXPECTED_EOS", refused},
    {"IMAGE_UNRECOGNIZED_FORMAT", warned},
    {"TEXTURE_INVALID_IMAGE_MIME_TYPE", warned},
    // Meshes
    {"ACCESSOR_INDEX_OOB", refused},
    {"ACCESSOR_INDEX_PRIMITIVE_RESTART", refused},
    {"ACCESSOR_INVALID_SIGN", warned},
    {"ACCESSOR_JOINTS_INDEX_OOB", refused},
    {"ACCESSOR_NON_CLAMPED", warned},
    {"ACCESSOR_VECTOR3_NON_UNIT", warned},
    {"ACCESSOR_WEIGHTS_NEGATIVE", warned},
    {"MESH_INVALID_WEIGHTS_COUNT", refused},
    {"MESH_PRIMITIVES_UNEQUAL_TARGETS_COUNT", refused},
    {"MESH_PRIMITIVE_ACCESSOR_UNALIGNED", warned},
    {"MESH_PRIMITIVE_ACCESSOR_WITHOUT_BYTESTRIDE", warned},
    {"MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_INVALID_FORMAT", refused},
    {"MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_UNSIGNED_INT", warned},
    {"MESH_PRIMITIVE_INDICES_ACCESSOR_INVALID_FORMAT", refused},
    {"MESH_PRIMITIVE_INDICES_ACCESSOR_WITH_BYTESTRIDE", warned},
    {"MESH_PRIMITIVE_INVALID_ATTRIBUTE", warned},
    {"MESH_PRIMITIVE_JOINTS_WEIGHTS_MISMATCH", warned},
    {"MESH_PRIMITIVE_MORPH_TARGET_INVALID_ATTRIBUTE_COUNT", refused},
    {"MESH_PRIMITIVE_MORPH_TARGET_NO_BASE_ACCESSOR", warned},
    {"MESH_PRIMITIVE_NO_POSITION", warned},
    {"MESH_PRIMITIVE_POSITION_ACCESSOR_WITHOUT_BOUNDS", warned},
    {"MESH_PRIMITIVE_TOO_FEW_TEXCOORDS", warned},
    {"MESH_PRIMITIVE_UNEQUAL_ACCESSOR_COUNT", refused},
    // Nodes, scenes, cameras and skins
    {"ACCESSOR_INVALID_IBM", warned},
    {"CAMERA_XMAG_YMAG_ZERO", refused},
    {"CAMERA_ZFAR_LEQUAL_ZNEAR", refused},
    {"INVALID_IBM_ACCESSOR_COUNT", refused},
    {"NODE_LOOP", refused},
    {"NODE_MATRIX_NON_TRS", warned},
    {"NODE_MATRIX_TRS", warned},
    {"NODE_PARENT_OVERRIDE", refused},
    {"NODE_SKIN_NO_SCENE", warned},
    {"NODE_SKIN_WITH_NON_SKINNED_MESH", warned},
    {"NODE_WEIGHTS_INVALID", refused},
    {"ROTATION_NON_UNIT", refused},
    {"SCENE_NON_ROOT_NODE", refused},
    {"SKIN_IBM_ACCESSOR_WITH_BYTESTRIDE", warned},
    {"SKIN_IBM_INVALID_FORMAT", refused},
    {"SKIN_NO_COMMON_ROOT", warned},
    {"SKIN_SKELETON_INVALID", warned},
    // Animations, which are not played
    {"ACCESSOR_ANIMATION_INPUT_NEGATIVE", warned},
    {"ACCESSOR_ANIMATION_INPUT_NON_INCREASING", warned},
    {"ACCESSOR_ANIMATION_SAMPLER_OUTPUT_NON_NORMALIZED_QUATERNION", warned},
    {"ANIMATION_CHANNEL_TARGET_NODE_MATRIX", warned},
    {"ANIMATION_CHANNEL_TARGET_NODE_WEIGHTS_NO_MORPHS", warned},
    {"ANIMATION_DUPLICATE_TARGETS", warned},
    {"ANIMATION_SAMPLER_ACCESSOR_WITH_BYTESTRIDE", warned},
    {"ANIMATION_SAMPLER_INPUT_ACCESSOR_INVALID_FORMAT", warned},
    {"ANIMATION_SAMPLER_INPUT_ACCESSOR_TOO_FEW_ELEMENTS", refused},
    {"ANIMATION_SAMPLER_INPUT_ACCESSOR_WITHOUT_BOUNDS", warned},
    {"ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_COUNT", refused},
    {"ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_FORMAT", warned},
});

/// One of CODES, written as its name; any other name does not compile.
class Code {
public:
    consteval Code(char const* name) : info_(&find(name)) {}

    std::string_view name() const { return info_->name; }
    bool refuses() const { return info_->refuses; }

private:
    static consteval CodeInfo const& find(std::string_view name) {
        auto const found = std::ranges::find(CODES, name, &CodeInfo::name);
        if (found == CODES.end()) throw "there is no such code";
        return *found;
    }

    CodeInfo const* info_;
};

} // namespace alpenglow::gltf
