#pragma once

#include <cstdint>

namespace alpenglow {

/// A well-mixed 64-bit hash of two numbers (the finalizer of SplitMix64: Steele, Lea, Flood 2014).
std::uint64_t hash(std::uint64_t a, std::uint64_t b);

/// The random numbers of one path. The first SOBOL_NUMBERS come from sets of four Sobol dimensions, each set shuffled
/// and Owen-scrambled by itself (Burley, "Practical Hash-based Owen Scrambling", JCGT 2020): any 2^n
/// indices of one key from a multiple of 2^n on cover the unit cube evenly. Further numbers are independent.
class PathNumbers {
public:
    static constexpr int SOBOL_NUMBERS = 16;

    /// `key` names the set of paths that are spread evenly together; `index` is the path's place in it.
    PathNumbers(std::uint64_t key, std::uint32_t index) : key_(key), index_(index), state_(hash(key, index)) {}

    /// In (0, 1).
    double next();
    /// The same dimensions for every path of an index: skips what is left of a set of four.
    void next_set() { used_ = (used_ + 3) / 4 * 4; }
    /// In (0, 1), from nothing but the key and the index.
    double independent();

private:
    std::uint64_t key_;
    std::uint32_t index_;
    std::uint64_t state_;
    int used_ = 0;
    std::uint64_t seeds_ = 0;  ///< of the present set of four
    std::uint32_t place_ = 0;  ///< the index as this set shuffles it
};

} // namespace alpenglow
