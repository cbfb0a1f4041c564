#include "render/models/models.h"
#include "support/render_test.h"
#include "support/traced_world.h"

#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{32, 18};

/// A camera over an even planet: from inside the air it looks a little above where the ground meets the sky, from outside
/// a little below.
struct Place {
    double altitude, sun; ///< [m], [degrees]

    friend void PrintTo(Place const& place, std::ostream* out) {
        *out << place.altitude << " m, sun at " << place.sun;
    }
};

struct Sight {
    World world;
    Stand stand;
};

Sight sight_from(Place const& place) {
    Planet planet = load_planet("earth");
    planet.look = GroundLook::uniform;
    Stand const stand = stand_on(planet, 0);
    double const dip = std::acos(planet.radius / (planet.radius + place.altitude)) + glm::radians(place.altitude > 1e5 ? 12.0 : -8.0);
    glm::dvec3 const eye(0, place.altitude, 0), ahead(0, -std::sin(dip), -std::cos(dip));
    return {stand.view(stand.camera(eye, eye + ahead, glm::radians(50.0)), sun_at(place.sun, 25)), stand};
}

Settings settings_of(std::string_view model) {
    Settings settings = plain_settings();
    settings.model = model;
    return settings;
}

} // namespace

TEST(Models, are_those_that_the_setting_takes) {
    std::vector<std::string> names;
    for (AirModel const& model : air_models()) names.emplace_back(model.name);
    EXPECT_EQ(names, choices_of(*find_setting("model")));
    EXPECT_EQ(Settings{}.model, names.front());
}

TEST(Models, say_where_they_do_not_apply) {
    World world = sight_from({2, 30}).world;
    Settings settings;
    EXPECT_EQ(model_limits(world, settings, true), "");
    settings.model = "naive";
    std::string const by_day = model_limits(world, settings, true);
    EXPECT_TRUE(by_day.starts_with("model naive: ")) << by_day;
    EXPECT_NE(model_limits(sight_from({2, -5}).world, settings, true), by_day);
    settings.model = "tables";
    EXPECT_EQ(model_limits(world, settings, false), "");
    EXPECT_NE(model_limits(world, settings, true), "");
    World const orbit = sight_from({4e5, 30}).world;
    EXPECT_NE(model_limits(orbit, settings, false), "");
    EXPECT_NE(model_limits(orbit, settings, true), model_limits(world, settings, true));
    world.planet.has_air = false;
    EXPECT_EQ(model_limits(world, settings, true), "");
}

class ModelsOnDevice : public RenderTest {};

TEST_F(ModelsOnDevice, give_way_to_each_other_and_leave_nothing_behind) {
    World const world = sight_from({3000, 10}).world;
    std::vector<FloatImage> first;
    for (AirModel const& model : air_models()) first.push_back(radiance(world, settings_of(model.name), EXTENT));
    for (std::size_t i = first.size(); i-- > 0;) {
        EXPECT_EQ(radiance(world, settings_of(air_models()[i].name), EXTENT).rgba, first[i].rgba) << air_models()[i].name;
        EXPECT_NE(first[i].rgba, first[(i + 1) % first.size()].rgba) << "one model draws what another does";
    }
}

/// Model `naive` is what the path tracer gives with one event between sun and camera.
class NaiveModel : public RenderTest, public ::testing::WithParamInterface<Place> {};

TEST_P(NaiveModel, is_the_path_tracers_first_order) {
    constexpr int PATHS = 128; // of a batch
    auto const [world, stand] = sight_from(GetParam());
    FloatImage const picture = radiance(world, settings_of("naive"), EXTENT);
    LightSource const light{.to_sun = world.to_sun, .angular_radius = world.planet.sun_angular_radius};
    TracedWorld const traced(world.planet, light, 1);
    double brightest = 0;
    for (float const value : picture.rgba) brightest = std::max(brightest, static_cast<double>(value));
    int lit = 0, sharp = 0;
    std::uint64_t seed = 0;
    for (std::uint32_t y = 1; y < EXTENT.height; y += 4) {
        for (std::uint32_t x = 2; x < EXTENT.width; x += 9) {
            glm::dvec3 const direction = pixel_direction(world.camera, EXTENT, x, y);
            Measured const exact = measure(traced.tracer, world.camera.position, direction, PATHS, ++seed);
            for (int c = 0; c < 3; ++c) {
                double const noise = BOUND * exact.deviation[c], found = pixel(picture, x, y)[c];
                // What is ten thousand times darker than the picture's brightest is black to any eye.
                double const floor = 1e-4 * brightest;
                EXPECT_NEAR(found, exact.mean[c], 0.01 * exact.mean[c] + noise + floor) << x << ", " << y << ", channel " << c;
                lit += exact.mean[c] > floor;
                sharp += noise < 0.01 * exact.mean[c];
            }
        }
    }
    EXPECT_GT(4 * sharp, lit) << "the tracer's noise would hide what is looked for";
    EXPECT_GE(lit, 9);
}

INSTANTIATE_TEST_SUITE_P(Places, NaiveModel,
                         ::testing::Values(Place{2, 50}, Place{2, 4}, Place{1e4, 15}, Place{4e5, 20}, Place{4e5, -12}));
