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
    FloatImage draw(Planet const& planet, Renderer& with = renderer()) {
        Stand const stand = stand_on(planet);
        Camera const camera = stand.camera({0, 2000, 0}, {0, 2000, -1}, 1.5);
        Settings settings = plain_settings();
        settings.sun_disc = false;
        with.draw(stand.view(camera, sun_at(8, 10)), settings, EXTENT);
        return with.radiance();
    }
    FloatImage draw(Planet planet, std::string const& without, std::string const& phases) {
        planet.air = changed_air(planet.air, without, phases);
        return draw(planet);
    }
};

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

TEST_F(AirComponents, may_be_written_in_any_order_and_as_two_halves) {
    Planet const planet = motley_planet();
    FloatImage const picture = draw(planet);
    Planet other = planet;
    std::ranges::reverse(other.air.components);
    AirComponent& mist = other.air.at("mist");
    mist.scattering *= 0.5, mist.absorption *= 0.5;
    AirComponent half = mist;
    half.name = "mist_too";
    other.air.components.push_back(half);
    EXPECT_LT(difference(picture, draw(other)), SAME);
}

TEST_F(AirComponents, are_absent_when_they_are_switched_off) {
    Planet const planet = motley_planet();
    FloatImage const all = draw(planet);
    for (AirComponent const& component : planet.air.components)
        EXPECT_GT(difference(draw(planet, component.name, ""), all), 0.01) << component.name << " makes no difference";
    Planet without = planet;
    std::erase_if(without.air.components, [](AirComponent const& c) { return c.name == "shell" || c.name == "dust"; });
    EXPECT_LT(difference(draw(planet, "shell,dust", ""), draw(without)), SAME);
}

TEST_F(AirComponents, take_every_phase_while_it_runs) {
    Planet const planet = make_earth();
    FloatImage const before = draw(planet);
    for (std::string const phase : {"isotropic", "rayleigh", "henyey_greenstein:0.5", "cornette_shanks:0.7",
                                    "droplets:2e-05", "double_henyey_greenstein:0.8:-0.5:0.3"}) {
        FloatImage const changed = draw(planet, "", "aerosol=" + phase);
        EXPECT_GT(difference(changed, before), 0.01) << phase;
        Planet written = planet;
        written.air.at("aerosol").phase = phase_from_text(phase);
        EXPECT_EQ(difference(changed, draw(written)), 0) << phase;
    }
    Renderer fresh(device());
    EXPECT_EQ(difference(draw(planet, fresh), before), 0);
    EXPECT_EQ(difference(draw(planet), before), 0);
}
