#pragma once

#include "terrain/heightfield.h"
#include "terrain/terrain.h"

#include <functional>
#include <vector>

namespace alpenglow {

/// [rad] Elevation of the skyline over the horizontal at `azimuth` [rad, clockwise from north] from `eye` [m] altitude,
/// out to the field's border, the planet's curvature included.
double skyline_elevation(HeightField const& field, double east, double north, double eye, double azimuth,
                         double planet_radius);

/// Moves a place to the highest ground within `reach` [m] of it, seen on a lattice of `step` [m].
void move_to_highest(std::function<double(double east, double north)> const& ground, double reach, double step,
                     double& east, double& north);

/// Finds where the default views stand, by looking: "valley" on the floor of a broad valley under a saw-toothed eastern
/// skyline, "ridge" on a crest that looks far over mountains to the west, "noon" on a gentle shoulder over a valley. A
/// terrain that has no such place gets the best it has.
std::vector<TerrainSite> find_sites(HeightField const& field, double planet_radius, int threads);

} // namespace alpenglow
