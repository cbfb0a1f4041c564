#pragma once

#include <cstdint>

namespace alpenglow {

/// A well-mixed number for a lattice point.
std::uint32_t lattice_hash(std::uint32_t seed, std::int32_t x, std::int32_t y);
/// The same as a number in [0, 1).
double lattice_unit(std::uint32_t seed, std::int32_t x, std::int32_t y);

/// 2-D gradient noise (Perlin 2002), C2, about -1 to 1, one feature per unit. `period` > 0 makes it repeat after as
/// many units.
double gradient_noise(std::uint32_t seed, double x, double y, int period = 0);

/// Sum of octaves, each of twice the frequency and half the amplitude; about -1 to 1.
double fractal_noise(std::uint32_t seed, double x, double y, int octaves);

/// Octaves of 1 - |noise| squared: sharp crests, 0 to 1 (Musgrave's ridged multifractal: crests gather detail).
double ridged_noise(std::uint32_t seed, double x, double y, int octaves);

/// Hermite step from 0 at `from` to 1 at `to`; `from` may be the larger.
double smooth_step(double from, double to, double x);

} // namespace alpenglow
