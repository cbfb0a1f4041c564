#include "scene/scene_albedo.h"

#include "image/color.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace alpenglow {

namespace {

/// A picture's linear colours as means over a coarse grid, of every third texel of every third row.
class SmallPicture {
public:
    explicit SmallPicture(Picture const& picture) : colors_(std::size_t(SIDE * SIDE)) {
        auto const value = [&](std::size_t i) {
            return picture.deep() ? linear_from_srgb_word(picture.rgba16[i]) : linear_from_srgb_byte(picture.rgba[i]);
        };
        std::vector<double> counts(colors_.size());
        for (std::size_t y = 0; y < picture.height; y += stride(picture.height))
            for (std::size_t x = 0; x < picture.width; x += stride(picture.width)) {
                std::size_t const from = 4 * (y * picture.width + x);
                std::size_t const to = y * SIDE / picture.height * SIDE + x * SIDE / picture.width;
                colors_[to] += glm::dvec3(value(from), value(from + 1), value(from + 2));
                counts[to] += 1;
            }
        spread(counts, picture);
    }
    glm::dvec3 at(glm::dvec2 const& uv) const { return colors_[index(uv.y) * SIDE + index(uv.x)]; }

private:
    static constexpr std::size_t SIDE = 64;
    static std::size_t stride(std::size_t texels) { return texels >= 3 * SIDE ? 3 : 1; }
    static std::size_t index(double u) { return std::min(static_cast<std::size_t>(u * SIDE), SIDE - 1); }
    /// Sums become means; pictures of fewer texels than the grid has fill it.
    void spread(std::vector<double> const& counts, Picture const& picture) {
        std::vector<glm::dvec3> const sums = colors_;
        for (std::size_t y = 0; y < SIDE; ++y)
            for (std::size_t x = 0; x < SIDE; ++x) {
                std::size_t const row = y * picture.height / SIDE * SIDE / picture.height;
                std::size_t const column = x * picture.width / SIDE * SIDE / picture.width;
                std::size_t const from = counts[y * SIDE + x] > 0 ? y * SIDE + x : row * SIDE + column;
                colors_[y * SIDE + x] = sums[from] / std::max(counts[from], 1.0);
            }
    }
    std::vector<glm::dvec3> colors_;
};

double wrapped(double u, TextureWrap wrap) {
    if (!std::isfinite(u)) return 0;
    if (wrap == TextureWrap::clamp) return std::clamp(u, 0.0, 1.0);
    double const turn = std::floor(u), inside = u - turn;
    return wrap == TextureWrap::mirror && std::fmod(turn, 2) != 0 ? 1 - inside : inside;
}

/// A corner of a triangle, and a mean of corners.
struct Corner {
    glm::dvec3 position; ///< scene frame
    glm::dvec2 uv;       ///< in the picture
    glm::dvec3 color;
};

Corner middle(Corner const& a, Corner const& b) {
    return {0.5 * (a.position + b.position), 0.5 * (a.uv + b.uv), 0.5 * (a.color + b.color)};
}

/// What of the light that falls in from above leaves again where slopes stand before each other. `open`: the area of the opening over
/// the surface's. That is the share of the surface's light that goes out through it if all is as bright: the opening sees nothing but
/// surface, which by reciprocity sends it as much as its own area would.
glm::dvec3 albedo_of_slopes(glm::dvec3 const& color, double open) {
    return color * open / glm::max(1.0 - color * (1.0 - open), 1e-9); // white that never gets out is black
}

class Grid {
public:
    Grid(Scene const& scene, glm::dmat4 const& world_from_scene, double planet_radius)
        : scene_(scene), world_from_scene_(world_from_scene), planet_radius_(planet_radius),
          cells_(std::size_t(GROUND_PATCHES * GROUND_PATCHES)) {
        pictures_.resize(scene.pictures.size());
        for (Material const& material : scene.materials) {
            Texture const& texture = material.base_color_texture;
            if (texture && !pictures_[texture.picture]) pictures_[texture.picture].emplace(scene.pictures[texture.picture]);
        }
        glm::dvec3 const size = scene.bounds.highest - scene.bounds.lowest;
        spacing_ = glm::max(glm::dvec2(size.x, size.z) / double(GROUND_PATCHES), glm::dvec2(1e-9));
    }
    void add(Mesh const& mesh, MeshPart const& part, glm::dmat4 const& scene_from_mesh) {
        // A mirrored mesh shows its fronts the other way.
        bool const mirrored = glm::determinant(scene_from_mesh) < 0;
        for (std::size_t i = part.first_index; i + 2 < part.first_index + part.index_count; i += 3) {
            auto const at = [&](std::size_t k) {
                return corner(mesh.vertices[mesh.indices[i + k]], scene_.materials[part.material], scene_from_mesh);
            };
            add(part.material, at(0), at(mirrored ? 2 : 1), at(mirrored ? 1 : 2), SPLITS);
        }
    }
    std::vector<GroundPatch> patches() const {
        std::vector<GroundPatch> result;
        double const scale = glm::length(glm::dvec3(world_from_scene_[0]));
        glm::dvec3 upright(0);
        for (Cell const& cell : cells_) upright += cell.upright;
        for (Cell const& cell : cells_) {
            if (!(cell.area > 0)) continue;
            // A plane is no valley, however steep: what is open is seen along the scene's mean normal.
            double const open = std::clamp(glm::dot(cell.upright, glm::normalize(upright)) / cell.surface, 0.0, 1.0);
            glm::dvec3 const color = glm::clamp(cell.color / cell.area, 0.0, 1.0);
            double const area = std::min(cell.area, spacing_.x * spacing_.y);
            result.push_back({in_world(cell.position / cell.area), scale * scale * area,
                              glm::vec3(albedo_of_slopes(color, open))});
        }
        return result;
    }

private:
    static constexpr int SPLITS = 5; ///< of a triangle as large as the scene, down to a patch
    struct Cell {
        glm::dvec3 position{0}, color{0}; ///< times the area
        double area = 0, surface = 0; ///< of outlines, and of what stands over them
        glm::dvec3 upright{0};        ///< sum of the surface's normals times areas
    };

    Corner corner(Vertex const& vertex, Material const& material, glm::dmat4 const& scene_from_mesh) const {
        Texture const& texture = material.base_color_texture;
        glm::vec2 const uv = texture.uv_from_vertex * glm::vec3(texture.uv_set == 0 ? vertex.uv0 : vertex.uv1, 1);
        return {glm::dvec3(scene_from_mesh * glm::dvec4(vertex.position, 1)), glm::dvec2(uv),
                glm::dvec3(vertex.color) * glm::dvec3(material.base_color)};
    }
    /// A triangle wider than a patch in four, as long as there are splits left.
    void add(std::uint32_t material, Corner const& a, Corner const& b, Corner const& c, int splits) {
        glm::dvec3 const size = glm::max(glm::max(a.position, b.position), c.position) -
                                glm::min(glm::min(a.position, b.position), c.position);
        if (splits == 0 || splits_left_ == 0 || (size.x <= spacing_.x && size.z <= spacing_.y))
            return add_whole(material, a, b, c);
        --splits_left_;
        Corner const ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        add(material, a, ab, ca, splits - 1);
        add(material, ab, b, bc, splits - 1);
        add(material, ca, bc, c, splits - 1);
        add(material, ab, bc, ca, splits - 1);
    }
    void add_whole(std::uint32_t material, Corner const& a, Corner const& b, Corner const& c) {
        glm::dvec3 const upright = 0.5 * glm::cross(b.position - a.position, c.position - a.position);
        double const area = upright.y;
        glm::dvec3 const position = (a.position + b.position + c.position) / 3.0;
        bool const seen = area > 0 && glm::length(in_world(position)) >= planet_radius_; // not what is no number
        Cell* const cell = seen ? cell_at(position) : nullptr;
        if (!cell) return;
        cell->position += area * position;
        cell->color += area * (a.color + b.color + c.color) / 3.0 * picture_at(material, (a.uv + b.uv + c.uv) / 3.0);
        cell->area += area;
        cell->upright += upright;
        cell->surface += glm::length(upright);
    }
    glm::dvec3 in_world(glm::dvec3 const& p) const { return glm::dvec3(world_from_scene_ * glm::dvec4(p, 1)); }
    Cell* cell_at(glm::dvec3 const& position) {
        glm::dvec2 const place = glm::dvec2(position.x - scene_.bounds.lowest.x, position.z - scene_.bounds.lowest.z) / spacing_;
        if (!(place.x >= 0 && place.y >= 0 && place.x <= GROUND_PATCHES && place.y <= GROUND_PATCHES)) return nullptr;
        glm::ivec2 const cell = glm::min(glm::ivec2(place), glm::ivec2(GROUND_PATCHES - 1));
        return &cells_[std::size_t(cell.y * GROUND_PATCHES + cell.x)];
    }
    glm::dvec3 picture_at(std::uint32_t material, glm::dvec2 const& uv) const {
        Texture const& texture = scene_.materials[material].base_color_texture;
        if (!texture) return glm::dvec3(1);
        return pictures_[texture.picture]->at({wrapped(uv.x, texture.wrap_u), wrapped(uv.y, texture.wrap_v)});
    }

    Scene const& scene_;
    glm::dmat4 world_from_scene_;
    double planet_radius_; ///< [m]
    int splits_left_ = 1 << 20; ///< of all triangles: a scene may hold millions as wide as itself
    std::vector<std::optional<SmallPicture>> pictures_; ///< the scene's that base colours use
    glm::dvec2 spacing_{0};                             ///< [m]
    std::vector<Cell> cells_;
};

} // namespace

std::vector<GroundPatch> ground_patches(Scene const& scene, glm::dmat4 const& world_from_scene, double planet_radius) {
    if (scene.bounds.empty()) return {};
    Grid grid(scene, world_from_scene, planet_radius);
    for (Instance const& instance : scene.instances) {
        Mesh const& mesh = scene.meshes[instance.mesh];
        for (MeshPart const& part : mesh.parts) grid.add(mesh, part, instance.scene_from_mesh);
    }
    return grid.patches();
}

} // namespace alpenglow
