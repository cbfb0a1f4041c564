#include "scene/planet.h"

#include "core/error.h"
#include "core/files.h"
#include "scene/air_reader.h"
#include "scene/file_keys.h"
#include "scene/spectrum.h"

namespace alpenglow {

namespace {

using json::Object;
using json::Value;

GroundLook read_look(Value const& value) {
    std::string const look = value.text();
    if (look == "uniform") return GroundLook::uniform;
    if (look == "procedural") return GroundLook::procedural;
    value.refuse("there is no ground look \"" + look + "\"", "give uniform or procedural");
}

void read_ground(Value const& value, Planet& planet) {
    Object const ground = value.object({"look", "albedo"});
    planet.look = read_look(ground.at("look"));
    planet.ground_albedo = ground.at("albedo").triple(json::ALBEDO);
}

void read_sun(Value const& value, Planet& planet) {
    Object const sun = value.object({"irradiance", "angular_radius"});
    planet.solar_irradiance = sun.at("irradiance").triple(json::IRRADIANCE);
    planet.sun_angular_radius = glm::radians(sun.number(json::SUN_RADIUS));
}

Planet read_planet(Value const& root) {
    Object const object = root.object({"$schema", "name", "source", "radius", "air", "ground", "sun"});
    Planet planet;
    planet.name = object.at("name").text();
    object.at("source").text(); // for people; a planet without one is a guess
    planet.radius = object.number(json::RADIUS);
    planet.has_air = object.has("air");
    if (planet.has_air) planet.air = read_air(object.at("air"));
    read_ground(object.at("ground"), planet);
    read_sun(object.at("sun"), planet);
    return planet;
}

bool is_path(std::filesystem::path const& file_or_name) {
    return file_or_name.has_parent_path() || file_or_name.extension() == ".json";
}

std::filesystem::path planet_file(std::filesystem::path const& file_or_name) {
    if (is_path(file_or_name)) return file_or_name;
    std::filesystem::path const folder = assets_folder() / "planets";
    std::filesystem::path file = folder / file_or_name;
    file += ".json";
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
        throw Error(ErrorKind::bad_input, "there is no planet of this name in " + folder.string(),
                    "planet " + file_or_name.string(), "give one of its names, or the path of a planet file");
    }
    return file;
}

} // namespace

Planet make_earth() {
    Planet earth{.name = "earth"};
    Profile const ozone = tent_profile(25000, 15000);
    earth.air.components = {
        {.name = "rayleigh",
         .scattering = rayleigh_scattering(CANONICAL_WAVELENGTHS),
         .phase = {.kind = Phase::Kind::rayleigh},
         .profile = ExponentialProfile{8000}},
        {.name = "aerosol",
         .scattering = glm::dvec3(3.996e-6),
         .absorption = glm::dvec3(0.444e-6),
         .phase = {.kind = Phase::Kind::cornette_shanks, .g = 0.8},
         .profile = ExponentialProfile{1200}},
        {.name = "ozone",
         .absorption = ozone_absorption(300, profile_column(ozone, earth.air.top_altitude), CANONICAL_WAVELENGTHS),
         .profile = ozone}};
    return earth;
}

Planet load_planet(std::filesystem::path const& file_or_name) {
    json::File const file(planet_file(file_or_name));
    return read_planet(file.root());
}

} // namespace alpenglow
