#include "integrators/estimators/hybrid_shift.h"

#include <fmt/format.h>

#include <limits>

#include "core/error.h"
#include "integrators/paths/vertex.h"

namespace plumb {

std::unique_ptr<PathShift> PathTracer::shift() const {
    if (next_event.bsdf_count != 1)
        throw Error(fmt::format("the shift of `path` with {} samples of the BSDF a vertex; accepted is 1",
                                next_event.bsdf_count));
    return std::make_unique<HybridShift>(*this);
}

namespace {

// How many vertices a path reached, the environment among them.
std::size_t reached(const PathStory& story) {
    return 1 + static_cast<std::size_t>(std::ranges::count_if(story.scatterings, [](const auto& scattering) {
               return scattering.survived && !is_black(scattering.throughput);
           }));
}

// The part in which a strategy of `path` finds light: at its last vertex from the sensor.
std::size_t part_of(const Strategy& strategy) {
    return static_cast<std::size_t>(strategy.t) - 2;
}

// The first replay of the base: as far as the shifted path may go without being connected.
struct Replayed {
    Point<2> film{};
    PathState state;          // with which its last vertex was reached
    std::size_t reached = 0;  // vertices, the environment among them
    bool connects = false;    // behind the last of them
};

// What one shift is made of: the steps below share it.
struct Shifting {
    const HybridShift& mapping;
    const Scene& scene;
    const BasePath& base;
    PrimarySamples& samples;
    ShiftedPath& shifted;
    ConnectionLimits limits = connection_limits(scene);

    [[nodiscard]] const PathTracer& tracer() const { return mapping.tracer; }
    void add(const Point<2>& film, const PathState& state, const Spectrum& light, int edges, std::size_t part) const {
        if (!is_black(light)) shifted.splats.push_back({{film, state.throughput * light, edges}, part});
    }
    void fail(std::size_t first_part, ShiftFailure why) const {
        for (std::size_t part = first_part; part < shifted.parts.size(); ++part) shifted.parts[part] = {0, why};
    }
    [[nodiscard]] Replayed replay(const FilmRegion& region, std::size_t last) const;
    [[nodiscard]] Connection edge(const PathVertex& from) const;
    [[nodiscard]] ShiftFailure carry(PathState& state, const Spectrum& weight, double eta) const;
    void connect(const Replayed& replayed) const;
    void gather_at_connection(const Replayed& replayed, const Connection& edge, const PathState& state) const;
    void gather_beyond(const Replayed& replayed, const Connection& x, const Connection& y, PathState state) const;
};

Replayed Shifting::replay(const FilmRegion& region, std::size_t last) const {
    PathRecord& record = shifted.record;
    record.clear();
    Draws draws(samples);
    const CameraStart start = start_at_camera(scene, region, draws);
    PathState state{.ray = start.ray, .direction = start.ray.direction};
    Replayed replayed{.film = start.film, .state = state};
    for (bool goes_on = true; goes_on && replayed.reached < last;) {
        replayed.state = state;
        const std::size_t first = record.splats.size();
        goes_on = tracer().step(scene, start.film, state, draws, record);
        const bool escaped = record.vertices.size() == replayed.reached;
        if (replayed.state.pdf > 0 &&
            mapping.earlier(limits, record.vertices[replayed.reached - 1],
                            escaped ? nullptr : &record.vertices.back()) == ShiftFailure::none) {
            replayed.connects = true;
            return replayed;
        }
        for (std::size_t i = first; i < record.splats.size(); ++i)
            shifted.splats.push_back({record.splats[i], replayed.reached});
        ++replayed.reached;
    }
    return replayed;
}

// From a vertex k of the base, or of the shifted path, to the base's next.
Connection Shifting::edge(const PathVertex& from) const {
    const std::size_t k = base.connection;
    const auto& scatterings = base.story.scatterings;
    if (base.record.vertices.size() <= k) return connection_to_environment(from, scatterings[k - 1].direction);
    Connection edge = connection_to(scene, from, base.record.vertices[k].hit);
    if (scatterings.size() > k && scatterings[k].measure == Measure::solid_angle)
        edge.pdf_beyond = smooth_pdf(*edge.end, scatterings[k].direction);
    return edge;
}

// Behind a scattering, as PathTracer goes on there: why the path ends, if it does.
ShiftFailure Shifting::carry(PathState& state, const Spectrum& weight, double eta) const {
    const std::uint16_t number = state.vertex++;
    state.throughput *= weight;
    state.eta_squared *= eta * eta;
    if (is_black(state.throughput)) return ShiftFailure::no_density;
    if (state.vertex <= tracer().limits.roulette_edges) return ShiftFailure::none;
    const double survives = tracer().survival(state.throughput, state.eta_squared);
    Draws draws(samples);
    if (!survives_roulette(survives, number, draws, shifted.record)) return ShiftFailure::roulette;
    state.throughput = state.throughput / survives;
    return ShiftFailure::none;
}

void Shifting::connect(const Replayed& replayed) const {
    const std::size_t k = base.connection;
    if (shifted.record.vertices.size() < k) return fail(k, ShiftFailure::ended);
    const PathVertex& from = shifted.record.vertices[k - 1];
    const Connection x = edge(base.record.vertices[k - 1]), y = edge(from);
    if (const ShiftFailure why = mapping.failure(limits, from, y.end ? &*y.end : nullptr); why != ShiftFailure::none)
        return fail(k, why);
    if (!(x.pdf > 0 && y.pdf > 0)) return fail(k, ShiftFailure::no_density);
    PathState state = replayed.state;
    const double eta = eta_between(from.bsdf, from.to_local(from.wo), from.to_local(y.direction));
    const Spectrum f = eval_bsdf(from, y.direction, Transport::radiance);
    if (const ShiftFailure why = carry(state, f / y.pdf, eta); why != ShiftFailure::none) return fail(k, why);
    const double u = scene.has_masks() ? samples.at({static_cast<std::uint16_t>(k + 1), Use::shadow}).u[0] : 0;
    if (!reaches(scene, from, y, u, shifted.record.rays)) return fail(k, ShiftFailure::occluded);
    state.ray = leave(from.hit.point, y.direction);
    state.direction = y.direction;
    state.pdf = y.pdf;
    shifted.parts[k] = {mapping.density(y) / mapping.density(x)};
    gather_at_connection(replayed, y, state);
    gather_beyond(replayed, x, y, state);
}

void Shifting::gather_at_connection(const Replayed& replayed, const Connection& edge, const PathState& state) const {
    const std::size_t k = base.connection;
    const int edges = state.vertex;
    const std::optional<Hit> hit = edge.end ? std::optional(edge.end->hit) : std::nullopt;
    add(replayed.film, state, met_light(scene, tracer().next_event, state, hit, 1, shifted.record), edges, k);
    if (!edge.end || !tracer().limits.allow(edges + 1)) return;
    add(replayed.film, state,
        gather_from_lights(scene, *edge.end, state.vertex, tracer().next_event, Draws(samples), shifted.record),
        edges + 1, k);
}

void Shifting::gather_beyond(const Replayed& replayed, const Connection& x, const Connection& y,
                             PathState state) const {
    const std::size_t first = base.connection + 1;
    if (base.parts <= first) return;
    const PathStory::Scattering& onwards = base.story.scatterings[base.connection];
    if (onwards.measure != Measure::solid_angle) return fail(first, ShiftFailure::mirror);
    if (!(x.pdf_beyond > 0 && y.pdf_beyond > 0)) return fail(first, ShiftFailure::no_density);
    const Spectrum f = eval_bsdf(*y.end, onwards.direction, Transport::radiance);
    ShiftFailure why = carry(state, f / y.pdf_beyond, mapping.eta_beyond(onwards, *y.end));
    const double jacobian = shifted.parts[base.connection].jacobian * (mapping.beyond(y) / mapping.beyond(x));
    const auto weight_of_met = [&] {  // by the BSDF of the far end, which scatters to another side now
        const auto& vertices = base.record.vertices;
        const std::optional<Hit> hit = vertices.size() > first ? std::optional(vertices[first].hit) : std::nullopt;
        return weight_of_bsdf(tracer().next_event, scene, *y.end, light_point(scene, hit, onwards.direction),
                              y.pdf_beyond)
            .weight;
    };
    for (std::size_t part = first; part < base.parts; ++part) {
        if (why != ShiftFailure::none) return fail(part, why);
        shifted.parts[part] = {jacobian};
        for (const PathStory::Finding& finding : base.story.findings) {
            if (part_of(finding.strategy) != part) continue;
            const bool reweighted = part == first && finding.strategy.s == 0;
            const double weight = reweighted ? weight_of_met() : finding.weight;
            add(replayed.film, state, finding.light * weight, finding.strategy.edges(), part);
        }
        if (part + 1 == base.parts) return;
        Draws draws(samples);
        const auto sample = sample_bsdf(base.record.vertices[part], {state.vertex}, draws, Transport::radiance);
        why = carry(state, sample->weight, sample->eta);
    }
}

}  // namespace

double eta_of_shifted(const PathStory::Scattering& onwards, const PathVertex& end) {
    return eta_between(end.bsdf, end.to_local(end.wo), end.to_local(onwards.direction));
}

void HybridShift::trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, BasePath& base) const {
    base.record.story = &base.story;
    tracer.trace(scene, region, samples, base.record);
    base.record.story = nullptr;  // which moves with the base
    const auto& vertices = base.record.vertices;
    const auto& scatterings = base.story.scatterings;
    base.splats.clear();
    for (const Splat& splat : base.record.splats) base.splats.push_back({splat, 0});
    for (const PathStory::Finding& finding : base.story.findings)  // a dark one's splat is that of the next
        if (!is_black(finding.light * finding.weight)) base.splats[finding.splat].part = part_of(finding.strategy);
    base.parts = reached(base.story);
    base.connection = 0;
    const ConnectionLimits limits = connection_limits(scene);
    for (std::size_t k = 1; k < base.parts && base.connection == 0; ++k)
        if (scatterings[k - 1].measure == Measure::solid_angle &&
            failure(limits, vertices[k - 1], k < vertices.size() ? &vertices[k] : nullptr) == ShiftFailure::none)
            base.connection = k;
}

void HybridShift::shift(const Scene& scene, const BasePath& base, const FilmRegion& region, PrimarySamples& samples,
                        ShiftedPath& shifted) const {
    shifted.clear();
    const std::size_t k = base.connection;
    const Shifting shifting{*this, scene, base, samples, shifted};
    const Replayed replayed = shifting.replay(region, k > 0 ? k : std::numeric_limits<std::size_t>::max());
    shifted.parts.assign(std::max(base.parts, replayed.reached), {});
    if (replayed.connects) return shifting.fail(replayed.reached, ShiftFailure::connects_earlier);
    if (k > 0) shifting.connect(replayed);
}

}  // namespace plumb
