#pragma once

#include <functional>

#include "integrators/paths/next_event/light_choices.h"
#include "integrators/paths/next_event/visibility.h"
#include "integrators/paths/path_chain.h"

namespace plumb {

/// The weight of strategy t for a path.
using StrategyWeight = std::function<double(const PathChain& chain, int t)>;

/// Bidirectional path tracing: every vertex of a subpath from the sensor is connected to every vertex of one from a
/// light, and all ways to make a path share it by multiple importance sampling [Veach & Guibas 1994; Lafortune &
/// Willems 1993; Veach 1997, chapter 10]. Strategy (s, t) has s vertices from the light and t from the sensor:
///   (0, t) meets a light, (1, t) samples one from its last vertex, (s, 1) connects the light's subpath to the lens.
struct Bdpt final : PathEstimator {
    SubpathRules rules;
    SensorConnection connection = connect_to_lens;
    std::shared_ptr<const LightChoice> choice = choice_by_power();
    std::shared_ptr<const Visibility> visibility = shadow_rays();  ///< of all connections
    StrategyWeight weight = strategy_weight;

    Bdpt() = default;
    explicit Bdpt(const PathLimits& limits);
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override;
};

/// The weights of one strategy alone, 1 for it and 0 for others: they give the paths of s + t − 1 edges as it makes
/// them.
StrategyWeight strategy_alone(const Strategy& strategy);

}  // namespace plumb
