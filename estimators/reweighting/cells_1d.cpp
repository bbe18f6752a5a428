#include "estimators/reweighting/cells_1d.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/error.h"

namespace plumb {
namespace {

struct Ranked {
    double position;
    std::uint32_t index;
};

std::vector<Ranked> ranked(std::span<const double> samples) {
    if (samples.empty()) throw Error("cells of 0 samples; at least 1 is needed");
    if (samples.size() > std::numeric_limits<std::uint32_t>::max())
        throw Error(fmt::format("cells of {} samples; fewer than 2^32 are accepted", samples.size()));
    std::vector<Ranked> order(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!(samples[i] >= 0 && samples[i] <= 1))
            throw Error(fmt::format("sample {} is {}; samples must lie in [0, 1]", i, samples[i]));
        order[i] = {samples[i], static_cast<std::uint32_t>(i)};
    }
    const auto by_position = [](const Ranked& a, const Ranked& b) { return a.position < b.position; };
    if (!std::is_sorted(order.begin(), order.end(), by_position)) std::sort(order.begin(), order.end(), by_position);
    return order;
}

// Gives each group of coincident samples the length of its one cell in equal shares. `cell(before, here, after)` takes
// the neighbouring places, NaN where there is none.
template <class CellLength>
std::vector<double> shared_cells(const std::vector<Ranked>& order, CellLength cell) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> weights(order.size());
    double before = none;
    for (auto group = order.begin(); group != order.end();) {
        const double here = group->position;
        auto end = group + 1;
        while (end != order.end() && end->position == here) ++end;
        const double share =
            cell(before, here, end != order.end() ? end->position : none) / static_cast<double>(end - group);
        for (; group != end; ++group) weights[group->index] = share;
        before = here;
    }
    return weights;
}

}  // namespace

std::vector<double> voronoi_weights_1d(std::span<const double> samples) {
    return shared_cells(ranked(samples), [](double before, double here, double after) {
        if (std::isnan(before) && std::isnan(after)) return 1.0;
        if (std::isnan(before)) return (here + after) / 2;
        if (std::isnan(after)) return ((1 - before) + (1 - here)) / 2;
        return (after - before) / 2;
    });
}

std::vector<double> torus_weights_1d(std::span<const double> samples) {
    std::vector<Ranked> order = ranked(samples);
    // A sample at 1 lies at 0: those at 1 move to the front.
    const auto at_one = std::find_if(order.begin(), order.end(), [](const Ranked& r) { return r.position == 1; });
    for (auto i = at_one; i != order.end(); ++i) i->position = 0;
    std::rotate(order.begin(), at_one, order.end());

    const double first = order.front().position, last = order.back().position;
    return shared_cells(order, [first, last](double before, double, double after) {
        if (std::isnan(before) && std::isnan(after)) return 1.0;
        if (std::isnan(before)) return (after + (1 - last)) / 2;
        if (std::isnan(after)) return ((1 - before) + first) / 2;
        return (after - before) / 2;
    });
}

}  // namespace plumb
