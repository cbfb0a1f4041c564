#pragma once

#include "scene/geodesy.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace alpenglow {

/// Axis-aligned box; empty while lowest > highest.
struct Box {
    glm::dvec3 lowest{std::numeric_limits<double>::infinity()};
    glm::dvec3 highest{-std::numeric_limits<double>::infinity()};

    bool empty() const { return !(lowest.x <= highest.x); }
    void include(glm::dvec3 const& p) { lowest = glm::min(lowest, p), highest = glm::max(highest, p); }
    glm::dvec3 centre() const { return 0.5 * (lowest + highest); }
};

struct Vertex {
    glm::vec3 position{0};              ///< [m] in the mesh's own frame
    glm::vec3 normal{0, 1, 0};          ///< unit
    glm::vec4 tangent{0};               ///< unit, w is the bitangent's sign; w = 0: none given, made from derivatives
    glm::vec2 uv0{0};
    glm::vec2 uv1{0};
    glm::vec4 color{1};                 ///< linear RGBA, multiplies the base colour
};

/// A run of a mesh's indices with one material; its own box, so that it is culled by itself.
struct MeshPart {
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
    std::uint32_t material = 0;         ///< into Scene::materials
    Box bounds;                         ///< mesh frame
};

/// Triangles; three indices each, counter-clockwise from the front.
struct Mesh {
    std::string name;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<MeshPart> parts;
};

enum class TextureWrap : std::uint8_t { repeat, mirror, clamp };
enum class TextureFilter : std::uint8_t { nearest, linear };

struct Picture {
    std::string name;
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgba;     ///< as stored in the file; empty where the file has 16 bits a channel
    std::vector<std::uint16_t> rgba16 = {}; ///< such a file's, as stored

    bool deep() const { return !rgba16.empty(); }
    std::size_t bytes() const { return rgba.size() + rgba16.size() * sizeof(std::uint16_t); }
};

struct Texture {
    static constexpr std::uint32_t none = ~0u;
    std::uint32_t picture = none;       ///< into Scene::pictures
    std::uint8_t uv_set = 0;
    TextureWrap wrap_u = TextureWrap::repeat, wrap_v = TextureWrap::repeat;
    TextureFilter magnify = TextureFilter::linear, minify = TextureFilter::linear;
    bool mipmaps = true;
    glm::mat3x2 uv_from_vertex{1};      ///< where the vertex's coordinates lie in the picture (KHR_texture_transform)

    explicit operator bool() const { return picture != none; }
};

/// glTF metallic-roughness. Pictures of base colour, emission and reflectance are sRGB, the others linear.
struct Material {
    std::string name;
    glm::vec4 base_color{1};
    float metallic = 1, roughness = 1;
    glm::vec3 emission{0};
    float normal_scale = 1, occlusion_strength = 1;
    Texture base_color_texture, metallic_roughness_texture, normal_texture, occlusion_texture, emission_texture;
    bool alpha_mask = false;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    float specular = 1;                 ///< weight of a dielectric's specular part, 0 to 1
    /// Of a dielectric at normal incidence, the mean of its colours; drawn as largest_reflectance where it is above.
    float reflectance = usual_reflectance;
    glm::vec3 reflectance_shares{1 / 3.0f}; ///< of the colours in `reflectance`; their sum is 1
    Texture specular_texture;           ///< its alpha multiplies `specular`
    Texture reflectance_texture;        ///< its colours multiply those of `reflectance`
    bool unlit = false;                 ///< shows its base colour as a white surface that faces the sun shows white

    static constexpr float usual_reflectance = 0.04f; ///< an index of refraction of 1.5
    static constexpr float largest_reflectance = 0.2f; ///< an index of refraction of 2.6: what the G-buffer holds
};

struct Instance {
    std::uint32_t mesh = 0;             ///< into Scene::meshes; many instances may share one
    glm::dmat4 scene_from_mesh{1};
};

/// A perspective camera of the file: looks along -Z, +Y up.
struct SceneCamera {
    std::string name;
    glm::dmat4 scene_from_camera{1};
    double vertical_fov = 1;            ///< [rad]
};

/// A loaded scene in its own frame: glTF axes (+Y up), metres.
struct Scene {
    std::string name;
    std::vector<Mesh> meshes;
    std::vector<Picture> pictures;
    std::vector<Material> materials;    ///< never empty where meshes are not
    std::vector<Instance> instances;
    std::vector<SceneCamera> cameras;
    Box bounds;                         ///< scene frame
};

/// Where a scene stands on the planet.
struct Placement {
    Geodetic anchor{};                  ///< of the scene's origin
    double yaw = 0;                     ///< [rad] clockwise seen from above
    double scale = 1;
    bool curve = false;                 ///< bend a flat map plane to the planet at import

    bool operator==(Placement const& o) const {
        return anchor.latitude == o.anchor.latitude && anchor.longitude == o.anchor.longitude &&
               anchor.altitude == o.anchor.altitude && yaw == o.yaw && scale == o.scale && curve == o.curve;
    }
};

glm::dmat4 world_from_scene(Placement const& placement, double planet_radius);
/// Triangles that are drawn: those of a mesh count once for each instance.
std::size_t triangle_count(Scene const& scene);
/// The box around every instance's part boxes, in the scene frame; it may be larger than the tightest one.
Box scene_bounds(Scene const& scene);

} // namespace alpenglow
