#include "terrain/flow.h"

#include "terrain/noise.h"
#include "core/parallel.h"

#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace alpenglow {

namespace {

constexpr std::array<std::array<int, 2>, 8> NEIGHBOURS{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

bool inside(HeightField const& field, int i, int j) {
    return i >= 0 && j >= 0 && i < field.nodes() && j < field.nodes();
}

/// The same seen from both ends: directions 4 to 7 look the stretch up at the other node.
double stretch(std::uint32_t seed, int i, int j, std::size_t direction) {
    if (direction >= 4) {
        i += NEIGHBOURS[direction][0], j += NEIGHBOURS[direction][1];
        direction -= 4;
    }
    return 0.8 + 0.6 * lattice_unit(seed + static_cast<std::uint32_t>(direction), i, j);
}

void choose_receiver(HeightField const& field, float sea, std::uint32_t seed, int i, int j, Flow& flow) {
    std::size_t const node = field.index(i, j);
    float const altitude = field.at(i, j);
    flow.receiver[node] = static_cast<std::int32_t>(node);
    flow.distance[node] = static_cast<float>(field.cell());
    if (altitude <= sea) return;
    double steepest = 0;
    for (std::size_t d = 0; d < 8; ++d) {
        int const ni = i + NEIGHBOURS[d][0], nj = j + NEIGHBOURS[d][1];
        if (!inside(field, ni, nj) || field.at(ni, nj) >= altitude) continue;
        double const length = field.cell() * (d % 2 ? std::sqrt(2.0) : 1.0) * stretch(seed, i, j, d);
        double const slope = (altitude - field.at(ni, nj)) / length;
        if (slope <= steepest) continue;
        steepest = slope;
        flow.receiver[node] = static_cast<std::int32_t>(field.index(ni, nj));
        flow.distance[node] = static_cast<float>(length);
    }
}

/// Breadth first from the outlets up (the "stack" of Braun and Willett 2013).
void order_upstream(Flow& flow) {
    std::size_t const count = flow.receiver.size();
    std::vector<std::int32_t> first(count + 1), donors(count);
    for (std::size_t n = 0; n < count; ++n) {
        if (flow.receiver[n] != static_cast<std::int32_t>(n)) ++first[flow.receiver[n] + 1];
    }
    for (std::size_t n = 0; n < count; ++n) first[n + 1] += first[n];
    std::vector<std::int32_t> next(first.begin(), first.end() - 1);
    flow.upstream.clear();
    flow.upstream.reserve(count);
    for (std::size_t n = 0; n < count; ++n) {
        std::int32_t const r = flow.receiver[n];
        if (r == static_cast<std::int32_t>(n))
            flow.upstream.push_back(r);
        else
            donors[next[r]++] = static_cast<std::int32_t>(n);
    }
    for (std::size_t k = 0; k < flow.upstream.size(); ++k) {
        std::int32_t const n = flow.upstream[k];
        flow.upstream.insert(flow.upstream.end(), donors.begin() + first[n], donors.begin() + first[n + 1]);
    }
}

} // namespace

Flow route_water(HeightField const& field, float sea, std::uint32_t seed, int threads) {
    std::size_t const count = field.altitudes().size();
    Flow flow{std::vector<std::int32_t>(count),
              std::vector<float>(count),
              {},
              std::vector<float>(count, static_cast<float>(field.cell() * field.cell()))};
    parallel_for(field.nodes(), threads, [&](int j) {
        for (int i = 0; i < field.nodes(); ++i) choose_receiver(field, sea, seed, i, j, flow);
    });
    order_upstream(flow);
    for (std::size_t k = count; k-- > 0;) {
        std::int32_t const n = flow.upstream[k];
        if (flow.receiver[n] != n) flow.area[flow.receiver[n]] += flow.area[n];
    }
    return flow;
}

void fill_pits(HeightField& field, float sea) {
    using Entry = std::pair<float, std::int32_t>; // equal altitudes go by index: the result does not depend on the heap
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    std::vector<char> seen(field.altitudes().size());
    for (std::size_t n = 0; n < seen.size(); ++n) {
        if (field.altitudes()[n] > sea) continue;
        seen[n] = 1;
        open.emplace(field.altitudes()[n], static_cast<std::int32_t>(n));
    }
    float const step = static_cast<float>(1e-4 * field.cell());
    while (!open.empty()) {
        auto const [altitude, node] = open.top();
        open.pop();
        int const i = node % field.nodes(), j = node / field.nodes();
        for (auto const& [di, dj] : NEIGHBOURS) {
            if (!inside(field, i + di, j + dj)) continue;
            std::size_t const other = field.index(i + di, j + dj);
            if (std::exchange(seen[other], 1)) continue;
            float& h = field.altitudes()[other];
            h = std::max(h, std::max(altitude, sea) + step);
            open.emplace(h, static_cast<std::int32_t>(other));
        }
    }
}

} // namespace alpenglow
