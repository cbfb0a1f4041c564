#include "scene/planet.h"

#include "core/error.h"
#include "core/files.h"
#include "scene/file_keys.h"

namespace alpenglow {

namespace {

using json::NumberKey;
using json::Object;
using json::Value;

void require_shares(Value const& medium, ExponentialMedium const& read) {
    if (glm::any(glm::lessThan(read.extinction, read.scattering))) {
        medium.refuse("extinction is less than scattering", "extinction is scattering plus absorption");
    }
}

ExponentialMedium read_rayleigh(Value const& value) {
    Object const medium = value.object({"scattering", "scale_height"});
    glm::dvec3 const scattering = medium.at("scattering").triple(json::COEFFICIENT);
    return {scattering, scattering, medium.number(json::SCALE_HEIGHT)};
}

void read_aerosol(Value const& value, Air& air) {
    Object const medium = value.object({"scattering", "extinction", "scale_height", "g"});
    air.aerosol = {medium.at("scattering").triple(json::COEFFICIENT), medium.at("extinction").triple(json::COEFFICIENT),
                   medium.number(json::SCALE_HEIGHT)};
    air.aerosol_g = medium.number(json::ASYMMETRY);
    require_shares(value, air.aerosol);
}

void read_ozone(Value const& value, Air& air) {
    Object const ozone = value.object({"absorption", "centre", "half_width"});
    air.ozone_absorption = ozone.at("absorption").triple(json::COEFFICIENT);
    air.ozone_centre = ozone.number(json::OZONE_CENTRE);
    air.ozone_half_width = ozone.number(json::OZONE_HALF_WIDTH);
}

Air read_air(Value const& value) {
    Object const object = value.object({"top_altitude", "rayleigh", "aerosol", "ozone"});
    Air air;
    air.top_altitude = object.number(json::TOP_ALTITUDE);
    air.rayleigh = read_rayleigh(object.at("rayleigh"));
    if (object.has("aerosol")) read_aerosol(object.at("aerosol"), air);
    if (object.has("ozone")) read_ozone(object.at("ozone"), air);
    return air;
}

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
    Air& air = earth.air;
    air.rayleigh.scattering = air.rayleigh.extinction = {5.802e-6, 13.558e-6, 33.100e-6};
    air.rayleigh.scale_height = 8000;
    air.aerosol = {.scattering = glm::dvec3(3.996e-6), .extinction = glm::dvec3(4.440e-6), .scale_height = 1200};
    air.ozone_absorption = {0.650e-6, 1.881e-6, 0.085e-6};
    return earth;
}

Planet load_planet(std::filesystem::path const& file_or_name) {
    json::File const file(planet_file(file_or_name));
    return read_planet(file.root());
}

} // namespace alpenglow
