#include "scene/air_changes.h"
#include "support/components.h"
#include "support/render_test.h"

#include <algorithm>
#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{24, 16};

/// The sky around a low sun, and the ground below it, from 2 km.
class AirComponents : public RenderTest {
protected:
    FloatImage draw(Planet const& planet, std::string const& model = "naive", Renderer& with = renderer()) {
        Stand const stand = stand_on(planet);
        Camera const camera = stand.camera({0, 2000, 0}, {0, 2000, -1}, 1.5);
        Settings settings = plain_settings();
        settings.model = model;
        with.draw(stand.view(camera, sun_at(8, 10)), settings, EXTENT);
        return with.radiance();
    }
};

/// With what the settings say about its air.
Planet changed(Planet planet, std::string const& without, std::string const& phases) {
    planet.air = changed_air(planet.air, without, phases);
    return planet;
}

/// The same air, written from the other end, the mist as two halves.
Planet written_otherwise(Planet planet) {
    std::ranges::reverse(planet.air.components);
    AirComponent& mist = planet.air.at("mist");
    mist.scattering *= 0.5, mist.absorption *= 0.5;
    AirComponent half = mist;
    half.name = "mist_too";
    planet.air.components.push_back(half);
    return planet;
}

Planet without_shell_and_dust(Planet planet) {
    std::erase_if(planet.air.components, [](AirComponent const& c) { return c.name == "shell" || c.name == "dust"; });
    return planet;
}

/// The largest difference of two pictures, relative to the brighter one.
double difference(FloatImage const& a, FloatImage const& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        double const x = a.rgba[i], y = b.rgba[i];
        if (!std::isfinite(x) || !std::isfinite(y)) return INFINITY;
        largest = std::max(largest, std::abs(x - y) / std::max({x, y, 1e-9}));
    }
    return largest;
}

/// Sums of floats in another order, and the roots of the tables that hold them.
constexpr double SAME = 1e-4;

} // namespace

// One by one in the model that has no tables to make for each, and all at once in the default model.

TEST_F(AirComponents, may_be_written_in_any_order_and_as_two_halves) {
    EXPECT_LT(difference(draw(motley_planet()), draw(written_otherwise(motley_planet()))), SAME);
}

TEST_F(AirComponents, are_absent_when_they_are_switched_off) {
    Planet const planet = motley_planet();
    FloatImage const all = draw(planet);
    for (AirComponent const& component : planet.air.components)
        EXPECT_GT(difference(draw(changed(planet, component.name, "")), all), 0.01) << component.name << " makes no difference";
    EXPECT_LT(difference(draw(changed(planet, "shell,dust", "")), draw(without_shell_and_dust(planet))), SAME);
}

TEST_F(AirComponents, take_every_phase_while_it_runs) {
    Planet const planet = make_earth();
    FloatImage const before = draw(planet);
    for (std::string const phase : {"isotropic", "rayleigh", "henyey_greenstein:0.5", "cornette_shanks:0.7",
                                    "droplets:2e-05", "double_henyey_greenstein:0.8:-0.5:0.3"}) {
        FloatImage const with_phase = draw(changed(planet, "", "aerosol=" + phase));
        EXPECT_GT(difference(with_phase, before), 0.01) << phase;
        Planet written = planet;
        written.air.at("aerosol").phase = phase_from_text(phase);
        EXPECT_EQ(difference(with_phase, draw(written)), 0) << phase;
    }
    EXPECT_EQ(difference(draw(planet), before), 0);
}

TEST_F(AirComponents, changed_while_it_runs_are_those_of_a_fresh_start) {
    std::string const model = Settings{}.model;
    FloatImage const before = draw(motley_planet(), model);
    FloatImage const running = draw(changed(motley_planet(), "shell,dust", "aerosol=droplets:2e-05"), model);
    Planet written = written_otherwise(without_shell_and_dust(motley_planet()));
    written.air.at("aerosol").phase = phase_from_text("droplets:2e-05");
    Renderer fresh(device());
    EXPECT_LT(difference(running, draw(written, model, fresh)), SAME);
    EXPECT_GT(difference(running, before), 0.01);
}
