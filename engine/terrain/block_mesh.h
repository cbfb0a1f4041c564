#pragma once

#include "terrain/gltf_writer.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace alpenglow {

/// One mesh of flat faces in the making, in a scene's frame: metres, +Y up, +X east, -Z north.
class BlockMesh {
public:
    /// A box without a floor.
    void add_box(glm::vec3 const& lowest, glm::vec3 const& highest);
    /// A level slab, its floor included.
    void add_slab(glm::vec3 const& lowest, glm::vec3 const& highest);
    /// A column over the corners (x, z), in order with the inside on the left as seen from above with north up; it has
    /// a top and no floor.
    void add_column(std::span<glm::vec2 const> corners, float bottom, float top);
    /// Rows of points, as long as each other, joined by two triangles for each square; fronts face up where the points
    /// of a row go east and the rows go north.
    void add_sheet(std::span<std::vector<glm::vec3> const> rows);

    /// A document whose one scene shows the mesh in one material without gloss. At most 65536 points.
    GltfWriter gltf(std::string const& name, glm::vec3 const& color) const;

private:
    std::uint16_t add(glm::vec3 const& point);
    void add_face(std::uint16_t a, std::uint16_t b, std::uint16_t c, std::uint16_t d);

    std::vector<glm::vec3> points_;
    std::vector<std::uint16_t> indices_;
};

} // namespace alpenglow
