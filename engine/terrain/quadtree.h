#pragma once

#include <compare>
#include <functional>
#include <set>
#include <vector>

namespace alpenglow {

/// A square of a quadtree: at level l the terrain's side holds 2^l of them; x counts from the west, y from the south.
struct TileKey {
    int level = 0, x = 0, y = 0;

    auto operator<=>(TileKey const&) const = default;
    TileKey parent() const { return {level - 1, x / 2, y / 2}; }
};

/// Sides of a tile, as bits.
enum TileSide : unsigned { SOUTH = 1, EAST = 2, NORTH = 4, WEST = 8 };

/// A quadtree whose neighbours differ by one level at most.
class Quadtree {
public:
    /// Splits from the root down wherever `wants_split` says so, and neighbours where the rule needs it.
    explicit Quadtree(std::function<bool(TileKey const&)> const& wants_split);

    /// Squares that are not split, in an order that depends on nothing else.
    std::vector<TileKey> leaves() const;
    /// TileSide bits of the sides where the neighbour is coarser.
    unsigned coarser_sides(TileKey const& leaf) const;

private:
    void split(TileKey const& key);

    std::set<TileKey> split_;
};

} // namespace alpenglow
