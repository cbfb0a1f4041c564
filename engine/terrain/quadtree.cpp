#include "terrain/quadtree.h"

#include <array>

namespace alpenglow {

namespace {

struct Neighbour {
    TileKey key;
    TileSide side;
    bool exists;
};

std::array<Neighbour, 4> neighbours(TileKey const& k) {
    int const last = (1 << k.level) - 1;
    return {{{{k.level, k.x, k.y - 1}, SOUTH, k.y > 0},
             {{k.level, k.x + 1, k.y}, EAST, k.x < last},
             {{k.level, k.x, k.y + 1}, NORTH, k.y < last},
             {{k.level, k.x - 1, k.y}, WEST, k.x > 0}}};
}

std::array<TileKey, 4> children(TileKey const& k) {
    int const l = k.level + 1, x = 2 * k.x, y = 2 * k.y;
    return {{{l, x, y}, {l, x + 1, y}, {l, x, y + 1}, {l, x + 1, y + 1}}};
}

} // namespace

Quadtree::Quadtree(std::function<bool(TileKey const&)> const& wants_split) {
    std::vector<TileKey> open{TileKey{}};
    while (!open.empty()) {
        TileKey const key = open.back();
        open.pop_back();
        if (!wants_split(key)) continue;
        split(key);
        for (TileKey const& child : children(key)) open.push_back(child);
    }
}

void Quadtree::split(TileKey const& key) {
    if (!split_.insert(key).second || key.level == 0) return;
    split(key.parent());
    for (Neighbour const& n : neighbours(key)) {
        if (n.exists) split(n.key.parent());
    }
}

std::vector<TileKey> Quadtree::leaves() const {
    if (split_.empty()) return {TileKey{}};
    std::vector<TileKey> result;
    for (TileKey const& key : split_) {
        for (TileKey const& child : children(key)) {
            if (!split_.contains(child)) result.push_back(child);
        }
    }
    return result;
}

unsigned Quadtree::coarser_sides(TileKey const& leaf) const {
    unsigned sides = 0;
    if (leaf.level == 0) return sides;
    for (Neighbour const& n : neighbours(leaf)) {
        if (n.exists && !split_.contains(n.key.parent())) sides |= n.side;
    }
    return sides;
}

} // namespace alpenglow
