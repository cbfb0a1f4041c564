#include "terrain/terrain.h"

#include "core/error.h"
#include "core/files.h"
#include "core/progress.h"
#include "terrain/erosion.h"
#include "terrain/far_maps.h"
#include "terrain/sites.h"
#include "terrain/terrain_gltf.h"

#include <cmath>
#include <fmt/format.h>

namespace alpenglow {

namespace {

/// Goes up whenever the same options give another file, so that cached scenes are made anew.
constexpr int GENERATOR_VERSION = 5;
constexpr int DETAIL_SIZE = 1024; // [texels]

void check(bool good, std::string const& what, std::string const& advice) {
    if (!good) throw Error(ErrorKind::wrong_use, what, "terrain", advice);
}

void check_options(TerrainOptions const& o) {
    check(o.side_km >= 4 && o.side_km <= 400, fmt::format("side of {} km", o.side_km), "from 4 to 400");
    check(o.resolution >= 64 && o.resolution <= 4096, fmt::format("resolution of {}", o.resolution), "from 64 to 4096");
    check(o.erosion >= 0 && o.erosion <= 4, fmt::format("erosion of {}", o.erosion), "from 0 to 4");
    check(o.map_size >= 64 && o.map_size <= 8192, fmt::format("maps of {} texels", o.map_size), "from 64 to 8192");
    check(o.planet_radius >= 1000 * o.side_km && o.planet_radius <= 1e9,
          fmt::format("planet radius of {} m", o.planet_radius), "from the terrain's side to 1e9 m");
    for (FinePlace const& place : o.fine) {
        double const farthest = std::max(std::abs(place.east), std::abs(place.north));
        check(farthest <= 500 * o.side_km && place.radius > 0 && place.radius <= 5000, "a fine place",
              "inside the terrain, radius to 5000 m");
    }
}

std::vector<FinePlace> places_of(std::vector<TerrainSite> const& sites) {
    std::vector<FinePlace> places;
    for (TerrainSite const& site : sites)
        places.push_back({site.east, site.north, site.name == "noon" ? 400.0 : 550.0});
    return places;
}

/// FNV-1a: the same on every machine.
std::uint64_t hash_of(std::string const& text) {
    std::uint64_t hash = 0xCBF29CE484222325u;
    for (char const c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
    return hash;
}

} // namespace

std::vector<TerrainSite> write_terrain(TerrainOptions const& options, std::filesystem::path const& file) {
    check_options(options);
    GltfWriter::require_known_ending(file);
    constexpr int steps = 1000, eroded = 300, tiled = 400, clad = 900; // by the time that each takes
    Progress progress("Terrain", steps);
    double const side = 1000 * options.side_km;
    HeightField const field =
        make_eroded_field({options.seed, side, options.resolution, options.erosion, options.threads},
                          [&](int done, int all) { progress.update(eroded * done / all, "rivers"); });
    std::vector<TerrainSite> sites = find_sites(field, options.planet_radius, options.threads);
    Fineness const fineness(options.fine.empty() ? places_of(sites) : options.fine);
    Relief const relief(field, fineness, options.seed, options.planet_radius);
    auto const ground = [&](double east, double north) { return relief.altitude(east, north); };
    for (TerrainSite& site : sites) {
        // The finer relief has other summits than the field.
        if (site.name == "ridge") move_to_highest(ground, 250, 8, site.east, site.north);
        site.altitude = ground(site.east, site.north);
    }
    std::vector<Tile> tiles = make_tiles(relief, options.seed, options.threads, [&](int done, int all) {
        progress.update(eroded + (tiled - eroded) * done / all, "tiles");
    });
    std::vector<FarMap> maps = plan_far_maps(relief, options.map_size);
    clad_far_tiles(tiles, maps, relief, options.seed, options.threads, [&](int done, int all) {
        progress.update(tiled + (clad - tiled) * done / all, "far maps");
    });
    terrain_gltf(tiles, maps, make_detail_pictures(options.seed, DETAIL_SIZE, options.threads), sites,
                 options.threads)
        .write(file);
    progress.update(steps);
    return sites;
}

std::filesystem::path default_terrain(double planet_radius) {
    TerrainOptions options;
    options.planet_radius = planet_radius;
    std::string const key = fmt::format("{} {} {} {} {} {} {}", GENERATOR_VERSION, options.seed, options.side_km,
                                        options.planet_radius, options.resolution, options.erosion,
                                        options.map_size);
    std::filesystem::path const file = cache_folder() / fmt::format("terrain-{:016x}.glb", hash_of(key));
    if (std::filesystem::is_regular_file(file)) return file;
    require_writable_folder(file.parent_path(), "set ALPENGLOW_CACHE to a folder for the generated scene");
    write_terrain(options, file);
    return file;
}

} // namespace alpenglow
