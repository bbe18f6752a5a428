#include "integrators/paths/shift.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>

namespace plumb {

std::string to_string(ShiftFailure failure) {
    switch (failure) {
        case ShiftFailure::none: return "shifted";
        case ShiftFailure::connects_earlier: return "connected earlier";
        case ShiftFailure::ended: return "ended before the connection";
        case ShiftFailure::too_smooth: return "too smooth to connect";
        case ShiftFailure::too_near: return "too near to connect";
        case ShiftFailure::occluded: return "occluded";
        case ShiftFailure::no_density: return "without density";
        case ShiftFailure::mirror: return "behind a mirror";
        case ShiftFailure::roulette: return "ended by roulette";
    }
    return {};
}

Spectrum light_of_part(const std::vector<PartSplat>& splats, std::size_t part) {
    Spectrum sum;
    for (const PartSplat& splat : splats)
        if (splat.part == part) sum += splat.splat.value;
    return sum;
}

ShiftCounts& ShiftCounts::operator+=(const ShiftCounts& other) {
    std::ranges::transform(parts, other.parts, parts.begin(), std::plus<>());
    return *this;
}

std::uint64_t ShiftCounts::total() const {
    return std::accumulate(parts.begin(), parts.end(), std::uint64_t{0});
}

std::string ShiftCounts::describe() const {
    const double all = static_cast<double>(std::max<std::uint64_t>(total(), 1));
    const auto percent = [&](std::size_t i) { return 100 * static_cast<double>(parts[i]) / all; };
    std::string text = fmt::format("{:.2f} % of {} parts shifted", percent(0), total());
    for (std::size_t i = 1; i < parts.size(); ++i)
        if (parts[i] > 0) text += fmt::format(", {:.2f} % {}", percent(i), to_string(static_cast<ShiftFailure>(i)));
    return text;
}

std::unique_ptr<PathShift> PathEstimator::shift() const {
    return std::make_unique<RandomReplay>(*this);
}

namespace {

void one_part(const PathRecord& record, std::vector<PartSplat>& splats) {
    splats.clear();
    for (const Splat& splat : record.splats) splats.push_back({splat, 0});
}

}  // namespace

void RandomReplay::trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, BasePath& base) const {
    estimator.trace(scene, region, samples, base.record);
    one_part(base.record, base.splats);
    base.parts = 1;
    base.connection = 0;
}

void RandomReplay::shift(const Scene& scene, const BasePath&, const FilmRegion& region, PrimarySamples& samples,
                         ShiftedPath& shifted) const {
    estimator.trace(scene, region, samples, shifted.record);
    one_part(shifted.record, shifted.splats);
    shifted.parts.assign(1, {});
}

}  // namespace plumb
