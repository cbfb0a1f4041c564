#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace alpenglow::gltf {

/// Indices into the document's arrays are -1 where there is none. They are checked before a Document is made.
constexpr int no_index = -1;

struct BufferView {
    int buffer = no_index;
    std::uint64_t offset = 0, length = 0; ///< [bytes]
    std::uint64_t stride = 0;             ///< [bytes]; 0: elements stand close together
};

/// Component types, as glTF numbers them.
enum class Component { int8 = 5120, uint8 = 5121, int16 = 5122, uint16 = 5123, uint32 = 5125, float32 = 5126 };

struct Accessor {
    /// Elements `indices[i]` are replaced by value i.
    struct Sparse {
        std::uint64_t count = 0;
        int index_view = no_index, value_view = no_index;
        std::uint64_t index_offset = 0, value_offset = 0; ///< [bytes]
        Component index_type = Component::uint32;
    };
    int view = no_index; ///< none: all zero
    std::uint64_t offset = 0; ///< [bytes] in the view
    Component type = Component::float32;
    int columns = 1, rows = 1; ///< a vector has one column; matrices are stored by columns
    bool normalized = false;
    std::uint64_t count = 0;
    std::optional<Sparse> sparse;
};

/// Where a primitive's compressed bytes are, and which Draco attribute stands for each of its own.
struct DracoSource {
    int view = no_index;
    std::map<std::string, int> attributes;
};

struct Primitive {
    std::map<std::string, int> attributes; ///< accessor of each
    int indices = no_index, material = no_index;
    int mode = 4; ///< as glTF numbers them: 4 list, 5 strip, 6 fan
    std::vector<std::map<std::string, int>> targets = {}; ///< accessors of what each morph target adds
    std::optional<DracoSource> draco = {};
};

struct MeshSource {
    std::string name;
    std::vector<Primitive> primitives;
    std::vector<double> weights = {}; ///< of the morph targets
};

struct Node {
    std::string name;
    std::vector<int> children;
    int mesh = no_index;
    glm::dmat4 parent_from_node{1};
    int skin = no_index, camera = no_index;
    std::vector<double> weights = {}; ///< of its mesh's morph targets; none: the mesh's own
};

struct Skin {
    std::vector<int> joints;             ///< nodes
    int inverse_bind_matrices = no_index; ///< accessor; none: all identity
};

struct CameraSource {
    std::string name;
    double vertical_fov = 1; ///< [rad]
    bool perspective = true;
};

/// Where a picture's encoded bytes are: in a view of a buffer, or at a URI.
struct Image {
    std::string name, uri;
    int view = no_index;
};

/// A glTF file as plain data. `Texture::picture` of its materials is an index into `images`.
struct Document {
    std::vector<std::vector<std::byte>> buffers;
    std::vector<BufferView> views;
    std::vector<Accessor> accessors;
    std::vector<Material> materials;
    std::vector<Image> images;
    std::vector<MeshSource> meshes;
    std::vector<Node> nodes;
    std::vector<Skin> skins;
    std::vector<CameraSource> cameras;
    std::vector<int> roots; ///< nodes of the scene that is shown
    bool quantized = false; ///< KHR_mesh_quantization: attributes may be integers
};

} // namespace alpenglow::gltf
