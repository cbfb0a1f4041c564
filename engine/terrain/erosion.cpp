#include "terrain/erosion.h"

#include "terrain/flow.h"
#include "terrain/noise.h"
#include "core/parallel.h"

#include <algorithm>
#include <cmath>

namespace alpenglow {

namespace {

constexpr double AREA_EXPONENT = 0.45; // m/n of stream power, Whipple and Tucker 1999 give 0.35 to 0.6
constexpr double UPLIFT = 1e-3;        // [m/a] as in the Alps
constexpr double ERODIBILITY = 1.9e-6; // [m^(1 - 2 * 0.45) / a] tuned: peaks of 3500 to 4200 m on the default island
constexpr float SEA = 0;

/// What a grid of one size needs at each node and step.
struct Rock {
    std::vector<float> uplift;   ///< [m/a]
    std::vector<float> steepest; ///< slope beyond which it falls
    std::vector<float> softness; ///< factor of the erodibility
};

struct Level {
    int cells;
    int steps;
    double years; ///< of one step
};

std::vector<Level> levels_of(ErosionOptions const& options) {
    std::vector<Level> levels;
    for (int cells = options.resolution, fine = 1; cells >= 64; cells /= 2, ++fine) {
        bool const coarsest = cells < 192 || cells < 128;
        int const steps = coarsest ? 90 : fine == 1 ? 12 : fine == 2 ? 16 : 30;
        levels.insert(levels.begin(),
                      {cells, static_cast<int>(std::lround(steps * options.strength)), coarsest ? 1e5 : 4e4});
        if (coarsest) break;
    }
    return levels;
}

/// To another grid, bent by about a cell: valleys that followed one of the grid's eight directions begin to wind.
HeightField resample(HeightField const& from, int cells, ErosionOptions const& options) {
    HeightField to(cells, from.side());
    double const bend = 1.6 * from.cell(), wave = 7 * from.cell();
    auto const seed = options.seed + static_cast<std::uint32_t>(131 + cells);
    parallel_for(to.nodes(), options.threads, [&](int j) {
        for (int i = 0; i < to.nodes(); ++i) {
            double const e = to.position(i), n = to.position(j);
            double const de = bend * fractal_noise(seed, e / wave, n / wave, 2);
            double const dn = bend * fractal_noise(seed + 7, e / wave, n / wave, 2);
            to.at(i, j) = static_cast<float>(from.sample(e + de, n + dn).altitude);
        }
    });
    return to;
}

Rock make_rock(HeightField const& field, Island const& island, ErosionOptions const& options) {
    std::size_t const count = field.altitudes().size();
    Rock rock{std::vector<float>(count), std::vector<float>(count), std::vector<float>(count)};
    parallel_for(field.nodes(), options.threads, [&](int j) {
        for (int i = 0; i < field.nodes(); ++i) {
            double const e = field.position(i), n = field.position(j), x = e / options.side, y = n / options.side;
            std::size_t const node = field.index(i, j);
            rock.uplift[node] = static_cast<float>(UPLIFT * island.uplift(e, n));
            double const strong = fractal_noise(options.seed + 71, 70 * x, 70 * y, 5);
            rock.steepest[node] = static_cast<float>(std::clamp(0.85 + 0.9 * strong, 0.45, 1.7));
            rock.softness[node] =
                static_cast<float>(std::exp(-0.8 * fractal_noise(options.seed + 83, 22 * x, 22 * y, 6)));
        }
    });
    return rock;
}

/// The sea's bed, fixed; land never at or under the sea.
void set_sea(HeightField& field, Island const& island, int threads) {
    parallel_for(field.nodes(), threads, [&](int j) {
        for (int i = 0; i < field.nodes(); ++i) {
            double const inland = island.inland(field.position(i), field.position(j));
            float& h = field.at(i, j);
            h = inland <= 0 ? static_cast<float>(island.seabed(inland))
                            : std::max(h, static_cast<float>(0.5 + 0.004 * inland));
        }
    });
}

/// One implicit step of dh/dt = U - K A^m dh/dx, from the outlets up, with the slope limited.
void erode(HeightField& field, Flow const& flow, Rock const& rock, double years) {
    auto& h = field.altitudes();
    for (std::int32_t const n : flow.upstream) {
        std::int32_t const r = flow.receiver[n];
        if (h[n] <= SEA) continue;
        double const raised = h[n] + years * rock.uplift[n];
        if (r == n) {
            h[n] = static_cast<float>(raised);
            continue;
        }
        double const below = std::max(h[r], SEA);
        double const f =
            years * ERODIBILITY * rock.softness[n] * std::pow(flow.area[n], AREA_EXPONENT) / flow.distance[n];
        h[n] =
            static_cast<float>(std::min((raised + f * below) / (1 + f), below + rock.steepest[n] * flow.distance[n]));
    }
}

/// Gravel in the valleys: depth by drainage area, surface at least as steep as a fan towards the river.
void fill_valleys(HeightField& field, Flow const& flow, double side) {
    double const scale = side / 96'000;
    auto& h = field.altitudes();
    for (std::int32_t const n : flow.upstream) {
        std::int32_t const r = flow.receiver[n];
        if (h[n] <= SEA || r == n) continue;
        double const depth =
            260 * scale *
            smooth_step(std::log(2e6 * scale * scale), std::log(4e8 * scale * scale), std::log(flow.area[n]));
        double const floor = h[n] + std::min(depth, 0.35 * h[n]);
        double const fan = std::max(h[r], SEA) + 0.012 * flow.distance[n];
        bool const river = flow.area[n] > 2e6 * scale * scale;
        h[n] = static_cast<float>(std::max(river ? floor : double(h[n]), river ? h[r] + 1e-3 * flow.distance[n] : fan));
    }
}

/// Smooths what is flat (gravel has no steps, and the foot of a slope is hollow), and a little everywhere: the water's
/// way from node to node is not a gully; those are made by the relief.
void smooth(HeightField& field, int rounds, int threads) {
    for (int round = 0; round < rounds; ++round) {
        HeightField const before = field;
        parallel_for(field.nodes() - 2, threads, [&](int row) {
            int const j = row + 1;
            for (int i = 1; i + 1 < field.nodes(); ++i) {
                if (before.at(i, j) <= SEA) continue;
                // The steepest way to a neighbour: central differences take a crest for flat ground.
                double mean = 0, step = 0;
                for (int b = -1; b <= 1; ++b) {
                    for (int a = -1; a <= 1; ++a) {
                        mean += before.at(i + a, j + b) / 9.0;
                        step = std::max(step, std::abs(double(before.at(i + a, j + b)) - before.at(i, j)));
                    }
                }
                double const slope = step / (1.2 * field.cell());
                double const share = std::lerp(0.2, 1.0, smooth_step(0.45, 0.08, slope));
                field.at(i, j) = static_cast<float>(std::max(std::lerp(double(before.at(i, j)), mean, share), 0.2));
            }
        });
    }
}

/// Frost breaks notches into crests and leaves towers between them.
void notch_crests(HeightField& field, std::uint32_t seed, int threads) {
    constexpr int reach = 3;
    HeightField const before = field;
    double const cell = field.cell();
    parallel_for(field.nodes() - 2 * reach, threads, [&](int row) {
        int const j = row + reach;
        for (int i = reach; i + reach < field.nodes(); ++i) {
            double const h = before.at(i, j);
            double around = 0;
            for (int b = -reach; b <= reach; b += reach) {
                for (int a = -reach; a <= reach; a += reach) around += before.at(i + a, j + b) / 9.0;
            }
            double const crest = smooth_step(0.3, 1.5, (h - around) / cell) * smooth_step(5, 15, h / cell);
            if (crest <= 0) continue;
            double const towers = 0.30 - std::abs(gradient_noise(seed + 151, i / 8.3, j / 8.3));
            double const teeth = 0.30 - std::abs(gradient_noise(seed + 157, i / 3.7, j / 3.7));
            field.at(i, j) = static_cast<float>(h + crest * cell * (3.0 * towers + 1.3 * teeth));
        }
    });
}

} // namespace

HeightField make_eroded_field(ErosionOptions const& options, std::function<void(int, int)> const& step_done) {
    Island const island(options.seed, options.side);
    std::vector<Level> const levels = levels_of(options);
    // A step costs by its number of nodes; counted in units of 128² cells.
    auto const cost = [](Level const& level) { return std::max(1, level.cells * level.cells / (128 * 128)); };
    int all = 0, done = 0;
    for (Level const& level : levels) all += level.steps * cost(level);

    HeightField field(levels.front().cells, options.side);
    parallel_for(field.nodes(), options.threads, [&](int j) {
        for (int i = 0; i < field.nodes(); ++i) {
            field.at(i, j) = static_cast<float>(island.raw_altitude(field.position(i), field.position(j)));
        }
    });
    for (Level const& level : levels) {
        if (level.cells + 1 != field.nodes()) field = resample(field, level.cells, options);
        set_sea(field, island, options.threads);
        Rock const rock = make_rock(field, island, options);
        for (int step = 0; step < level.steps; ++step) {
            if (level.cells < 512 || step % 8 == 0) fill_pits(field, SEA);
            auto const seed = options.seed + static_cast<std::uint32_t>(97 + level.cells);
            erode(field, route_water(field, SEA, seed, options.threads), rock, level.years);
            step_done(done += cost(level), all);
        }
    }
    fill_pits(field, SEA);
    if (options.strength > 0) fill_valleys(field, route_water(field, SEA, options.seed, options.threads), options.side);
    smooth(field, 4, options.threads);
    notch_crests(field, options.seed, options.threads);
    return field;
}

} // namespace alpenglow
