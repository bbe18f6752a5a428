#include "integrators/paths/next_event.h"

#include <fmt/format.h>

#include "core/error.h"
#include "integrators/paths/vertex.h"

namespace plumb {

namespace {

// n_s p_s of every technique: of choices of lights in their order, of the BSDF behind them.
struct Densities {
    std::array<double, NextEvent::most_choices + 1> values{};
    std::size_t count;

    explicit Densities(const NextEvent& next_event) : count(next_event.lights.size() + 1) {
        if (count > values.size())
            throw Error(fmt::format("{} choices of lights; accepted are at most {}", count - 1, values.size() - 1));
    }
    [[nodiscard]] std::span<const double> all() const { return {values.data(), count}; }
    [[nodiscard]] TechniqueWeight weight(MisWeight weight, std::size_t own) const {
        double rivals = 0;
        for (std::size_t i = 0; i < count; ++i) rivals += i == own ? 0 : values[i];
        return {weight(all(), own), rivals};
    }
};

// Fills in the densities of all choices but one, which is known.
void ask_choices(const NextEvent& next_event, const Scene& scene, const PathVertex& vertex, const LightPoint& point,
                 std::size_t known, Densities& densities) {
    for (std::size_t k = 0; k < next_event.lights.size(); ++k) {
        const auto& [choice, count] = next_event.lights[k];
        if (k != known && count > 0) densities.values[k] = count * choice->pdf(scene, vertex.hit.point, point);
    }
}

// n p of the BSDF for a direction in which a light was found. No direction of a BSDF meets a point.
double density_of_bsdf(const NextEvent& next_event, const Scene& scene, const PathVertex& vertex, std::size_t light,
                       Vec3 direction) {
    if (next_event.bsdf_count == 0 || kind_of(scene.lights()[light]) == LightKind::point) return 0;
    return next_event.bsdf_count * vertex.bsdf.pdf(vertex.to_local(vertex.wo), vertex.to_local(direction));
}

// The weight of what a choice of lights found. Where it is the only choice, as it mostly is, no other need be asked.
TechniqueWeight weight_of_found(const NextEvent& next_event, const Scene& scene, const PathVertex& vertex,
                                const SceneLightSample& found, std::size_t choice) {
    if (next_event.lights.size() > 1)
        return weight_of_choice(next_event, scene, vertex, light_point(found), choice, found.pdf);
    const double bsdf = density_of_bsdf(next_event, scene, vertex, found.light, found.sample.direction);
    return {next_event.weight(std::array{next_event.lights[0].count * found.pdf, bsdf}, 0), bsdf};
}

// A sample of a choice of lights: which of a vertex's, of which choice.
struct LightTurn {
    SampleIndex index;
    std::size_t choice;
};

// Adds what the sample found to the sum.
void gather_from_light(const Scene& scene, const PathVertex& vertex, const LightTurn& turn, const NextEvent& next_event,
                       const Draws& of_vertex, PathRecord& record, Spectrum& sum) {
    const auto& [choice, count] = next_event.lights[turn.choice];
    Draws draws = of_vertex.branch();
    const auto light = choice->sample(scene, vertex.hit.point, turn.index, draws);
    if (!light) return;
    const Spectrum f = eval_bsdf(vertex, light->sample.direction, Transport::radiance);
    if (is_black(f)) return;
    const double visible =
        next_event.visibility->sample(scene, vertex.hit.point, light->sample, turn.index, draws, record.rays);
    const Strategy strategy{1, turn.index.vertex + 1};
    if (visible == 0) {
        if (record.story) record.tell({.strategy = strategy, .light = {}, .pdf = light->pdf, .source = light->light});
        return;
    }
    const auto [weight, rivals] = weight_of_found(next_event, scene, vertex, *light, turn.choice);
    if (record.story)
        record.tell({.strategy = strategy,
                     .light = f * light->sample.radiance * (visible / (count * light->pdf)),
                     .weight = weight,
                     .pdf = light->pdf,
                     .rival = rivals,
                     .source = light->light,
                     .density = of_vertex.density() * draws.density()});
    sum += f * light->sample.radiance * (weight * visible / (count * light->pdf * draws.density()));
}

Spectrum light_from_direction(const Scene& scene, const PathVertex& vertex, SampleIndex index,
                              const NextEvent& next_event, const Draws& of_vertex, PathRecord& record) {
    Draws draws = of_vertex.branch();
    const auto sample = sample_bsdf(vertex, index, draws, Transport::radiance);
    if (!sample) return {};
    if (index.sample == 0) tell_scattering(record, index.vertex, *sample, sample->weight);
    const Vec3 wi = sample->direction;
    const Ray ray = leave(vertex.hit.point, wi);
    const SampleIndex arrival{static_cast<std::uint16_t>(index.vertex + 1), index.sample};
    const auto next = trace_to_hit(scene, ray, arrival, draws, record);
    const Spectrum radiance = next ? scene.emitted(*next, -wi) : scene.environment(ray);
    if (is_black(radiance)) return {};
    const LightPoint point = light_point(scene, next, wi);
    const bool mirrored = sample->measure == Measure::discrete;
    const auto [weight, rivals] =
        mirrored ? TechniqueWeight{1, 0} : weight_of_bsdf(next_event, scene, vertex, point, sample->pdf);
    const double share = weight / next_event.bsdf_count;
    if (record.story)
        record.tell({.strategy = {0, index.vertex + 2},
                     .light = sample->weight * radiance / next_event.bsdf_count,
                     .weight = weight,
                     .pdf = rivals > 0 ? sample->pdf : 0,
                     .rival = rivals,
                     .source = point.light,
                     .density = of_vertex.density() * draws.density()});
    return sample->weight * radiance * (share / draws.density());
}

}  // namespace

NextEvent with_counts(NextEvent next_event, const TechniqueCounts& counts) {
    if (next_event.lights.size() != 1)
        throw Error(fmt::format("a count for {} choices of lights; accepted is one", next_event.lights.size()));
    constexpr int most = 255;  // a slot's sample is a byte
    const auto accepted = [](int count) { return count >= 0 && count <= most; };
    if (!accepted(counts.lights) || !accepted(counts.bsdf))
        throw Error(fmt::format("{} samples of lights and {} of the BSDF; accepted are 0 to {}", counts.lights,
                                counts.bsdf, most));
    next_event.lights.front().count = counts.lights;
    next_event.bsdf_count = counts.bsdf;
    return next_event;
}

TechniqueWeight weight_of_choice(const NextEvent& next_event, const Scene& scene, const PathVertex& vertex,
                                 const LightPoint& point, std::size_t choice, double pdf) {
    Densities densities(next_event);
    densities.values[choice] = next_event.lights[choice].count * pdf;
    ask_choices(next_event, scene, vertex, point, choice, densities);
    densities.values[densities.count - 1] = density_of_bsdf(next_event, scene, vertex, point.light, point.direction);
    return densities.weight(next_event.weight, choice);
}

TechniqueWeight weight_of_bsdf(const NextEvent& next_event, const Scene& scene, const PathVertex& vertex,
                               const LightPoint& point, double pdf) {
    Densities densities(next_event);
    const std::size_t own = densities.count - 1;
    densities.values[own] = next_event.bsdf_count * pdf;
    ask_choices(next_event, scene, vertex, point, own, densities);
    return densities.weight(next_event.weight, own);
}

Spectrum gather_from_lights(const Scene& scene, const PathVertex& vertex, std::uint16_t number,
                            const NextEvent& next_event, const Draws& of_vertex, PathRecord& record) {
    if (!vertex.bsdf.smooth()) return {};
    Spectrum sum;
    std::uint8_t taken = 0;
    for (std::size_t k = 0; k < next_event.lights.size(); ++k)
        for (int i = 0; i < next_event.lights[k].count; ++i, ++taken)
            gather_from_light(scene, vertex, {{number, taken}, k}, next_event, of_vertex, record, sum);
    return sum;
}

Spectrum gather_from_bsdf(const Scene& scene, const PathVertex& vertex, std::uint16_t number,
                          const NextEvent& next_event, const Draws& of_vertex, PathRecord& record, int first) {
    Spectrum sum;
    for (int i = first; i < next_event.bsdf_count; ++i)
        sum +=
            light_from_direction(scene, vertex, {number, static_cast<std::uint8_t>(i)}, next_event, of_vertex, record);
    return sum;
}

}  // namespace plumb
