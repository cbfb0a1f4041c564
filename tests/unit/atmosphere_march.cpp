#include "support/air.h"
#include "support/air_reference.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace alpenglow;
using namespace alpenglow::shader;

namespace {
constexpr float R = 6.36e6f;
Atmosphere const AIR = test::earth_air();

struct Case {
    float h0, mu, begin, end;
};

// Up, down, level, grazing on both sides of the closest approach; from centimetres to the whole limb.
std::vector<Case> cases() {
    std::vector<Case> all;
    for (float const h0 : {0.0f, 1.7f, 800.0f, 12000.0f, 99999.0f})
        for (float const mu : {-1.0f, -0.9f, -0.1f, -1e-3f, -1e-5f, 0.0f, 1e-5f, 1e-3f, 0.2f, 1.0f}) {
            float const end = air_segment(AIR, make_air_ray(R, h0, mu, 0, 0)).end;
            for (float const share : {1.0f, 0.3f, 1e-3f, 1e-6f}) {
                all.push_back({h0, mu, 0, end * share});
                all.push_back({h0, mu, end * (1 - share) * 0.7f, end * (0.7f + 0.3f * share)});
            }
        }
    return all;
}
} // namespace

TEST(MarchSamples, cells_tile_the_segment_in_order) {
    for (Case const& c : cases())
        for (int const n : {1, 4, 32}) {
            MarchCells const cells = make_march_cells(AIR, make_air_ray(R, c.h0, c.mu, 0, 0), c.begin, c.end);
            double sum = 0;
            float at = c.begin;
            for (int i = 0; i < n; ++i) {
                MarchCell const cell = march_cell(cells, i, n);
                ASSERT_EQ(cell.begin, at) << c.h0 << " " << c.mu << " " << c.begin << " " << c.end << " " << i;
                ASSERT_LE(cell.begin, cell.middle) << c.h0 << " " << c.mu << " " << c.begin << " " << c.end << " " << i;
                ASSERT_LE(cell.middle, cell.end) << c.h0 << " " << c.mu << " " << c.begin << " " << c.end << " " << i;
                sum += double(cell.end) - cell.begin;
                at = cell.end;
            }
            EXPECT_EQ(at, c.end);
            EXPECT_NEAR(sum, double(c.end) - c.begin, 1e-6 * (c.end - c.begin));
        }
}

// Fernández Arenas' loop takes N + 1 samples: 5 % too much at 20.
TEST(MarchSamples, a_constant_density_gives_the_exact_length) {
    for (int const n : {1, 20}) {
        MarchCells const cells = make_march_cells(AIR, make_air_ray(R, 100, 0.1f, 0, 0), 0, 4e5f);
        AirLight light = no_air_light();
        for (int i = 0; i < n; ++i) {
            MarchCell const cell = march_cell(cells, i, n);
            add_cell(light, vec3(1), vec3(0), cell.end - cell.begin);
        }
        EXPECT_NEAR(light.inscattered.x, 4e5f, 0.5f);
        EXPECT_EQ(light.transmittance.x, 1);
    }
}

// The rule as it reads, in double.
TEST(MarchSamples, edges_are_even_in_the_measure) {
    for (Case const& c : {Case{0, 0, 0, 1.1e6f}, Case{12000, -0.05f, 0, 1.5e6f}, Case{1e5f, -0.17f, 0, 1.9e6f},
                          Case{2, -1e-4f, 0, 30e3f}, Case{800, 0.01f, 0, 5e5f}}) {
        test::reference::Ray const exact{R, c.h0, c.mu};
        double const closest = exact.r0() * std::sqrt(1 - exact.mu0 * exact.mu0) - R;
        double const lowest_at = std::clamp<double>(-exact.r0() * exact.mu0, c.begin, c.end), lowest = exact.altitude(lowest_at);
        double const k = 0.25 * std::sqrt(-std::expm1(-std::max(0.0, lowest - closest) / 30e3));
        auto const measure = [&](double t) {
            double const p = -std::expm1(-std::max(0.0, exact.altitude(t) - lowest) / 30e3);
            double const d = (std::sqrt(k * k + (1 - k * k) * p) - k) / (1 - k * k);
            return t < lowest_at ? -d : d;
        };
        MarchCells const cells = make_march_cells(AIR, make_air_ray(R, c.h0, c.mu, 0, 0), c.begin, c.end);
        double const from = measure(c.begin), to = measure(c.end);
        for (int i = 0; i <= 16; ++i)
            EXPECT_NEAR(measure(march_distance(cells, float(i) / 16)), from + (to - from) * i / 16, 1e-4 * (to - from))
                << c.h0 << " " << c.mu << " " << i;
    }
}

// A few metres of air are homogeneous: nothing is gained by uneven cells, and rounding may not make them so. Close to a
// level ray's closest approach, where k is small, the rule bends them by a seventh of a cell.
TEST(MarchSamples, short_segments_are_even) {
    for (float const mu : {-1.0f, -0.1f, -1e-4f, 0.0f, 0.3f, 1.0f}) {
        MarchCells const cells = make_march_cells(AIR, make_air_ray(R, 1000, mu, 0, 0), 0, 8);
        for (int i = 0; i <= 8; ++i) EXPECT_NEAR(march_distance(cells, float(i) / 8), i, mu == -1e-4f ? 0.2 : 0.02) << mu;
    }
}

TEST(MarchSamples, an_empty_segment_has_empty_cells) {
    MarchCell const cell = march_cell(make_march_cells(AIR, make_air_ray(R, 10, -1, 0, 0), 0, 0), 2, 4);
    EXPECT_EQ(cell.begin, 0);
    EXPECT_EQ(cell.middle, 0);
    EXPECT_EQ(cell.end, 0);
}
