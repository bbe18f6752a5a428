// Numbers that are not uniform: every integrator divides each contribution by the density of the numbers that it
// depends on, so that any positive density, however wrong, leaves the expected picture as it is.
//
// A density that is divided out although a splat does not depend on its numbers is no mutant: E_q[f(u)/(q(u) q(v))] =
// ∫ f ∫ 1, so that it adds to the variance alone.

#include "integrators/estimators/aov.h"
#include "verification/evidence/mean.h"
#include "verification/suites/suites.h"
#include "verification/suites/transport/transport_subjects.h"

namespace plumb::suites {
namespace {

using Made = std::shared_ptr<const PathEstimator>;
/// The slots whose density is told; that of others is said to be 1.
using Told = bool (*)(const Slot&);

/// Numbers of the density 1 + a(2x − 1) along each axis, a = ±0.3 by slot and axis.
class GuidedSamples final : public PrimarySamples {
public:
    GuidedSamples(PrimarySamples& uniform, Told told) : uniform_(uniform), told_(told) {}

    Drawn at(Slot slot) override {
        Drawn drawn = uniform_.at(slot);
        double density = 1;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double a = slope(slot, axis);
            double& x = drawn.u[axis];
            x = std::min(2 * x / (1 - a + std::sqrt((1 - a) * (1 - a) + 4 * a * x)), std::nextafter(1.0, 0.0));
            density *= 1 + a * (2 * x - 1);
        }
        if (told_(slot)) drawn.density *= density;
        return drawn;
    }

private:
    static double slope(const Slot& slot, std::size_t axis) {
        const auto use = static_cast<unsigned>(slot.use);
        return (slot.vertex + use + axis) % 3 == 0 ? -0.3 : 0.3;
    }

    PrimarySamples& uniform_;
    Told told_;
};

struct Guided final : PathEstimator {
    Made estimator;
    Told told;
    Guided(Made of, Told t) : estimator(std::move(of)), told(t) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override {
        GuidedSamples guided(samples, told);
        estimator->trace(scene, region, guided, record);
    }
};

bool of_all(const Slot&) {
    return true;
}
bool of_none(const Slot&) {
    return false;
}
template <Use use>
bool of_all_but(const Slot& slot) {
    return slot.use != use;
}

/// A floor behind a veil, half of it dark, under a lamp and a dim sky, through a lens.
const Scene& veiled_scene() {
    static const Scene scene([] {
        description::Scene veiled;
        const auto white = add_material(veiled, description::Diffuse{Spectrum::grey(0.8)});
        const auto dark = add_material(veiled, description::Diffuse{Spectrum::grey(0.2)});
        const auto veil = add_material(veiled, description::Mask{Spectrum::grey(0.4), white});
        add_polygon(veiled, {{-1, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-1, 1, 0}}, white);
        add_polygon(veiled, {{0, -1, 0}, {1, -1, 0}, {1, 1, 0}, {0, 1, 0}}, dark);
        add_polygon(veiled, {{-0.6, -1, 0.5}, {0.8, -1, 0.5}, {0.8, 1, 0.8}, {-0.6, 1, 0.8}}, veil);
        add_polygon(veiled, {{1.5, -1, 0}, {1.5, 1, 0}, {1.5, 1, 2}, {1.5, -1, 2}}, white);
        add_polygon(veiled, {{-0.8, -0.6, 2}, {-0.8, 0.6, 2}, {0.9, 0.6, 2}, {0.9, -0.6, 2}}, dark, Spectrum::grey(2));
        veiled.emitters.emplace_back().kind = description::ConstantSky{Spectrum::grey(0.3)};
        veiled.sensor = camera({-0.2, -2.5, 1.7}, {0, -0.1, 0.3}, 35, 8, 8);
        veiled.sensor->kind = description::ThinLens{.fov_x = 35, .aperture_radius = 0.1, .focus_distance = 3};
        return veiled;
    }());
    return scene;
}

/// The depth of what is seen first, as a driver averages it.
struct Depth final : PathEstimator {
    Made estimator;
    bool weighted;
    Depth(Made of, bool by_weight) : estimator(std::move(of)), weighted(by_weight) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override {
        estimator->trace(scene, region, samples, record);
        record.splats.clear();
        if (record.vertices.empty()) return;
        const double weight = weighted ? record.first_hit_weight : 1;
        record.splats.push_back({{}, Spectrum::grey(weight * record.vertices.front().hit.t), 1});
    }
};

struct Subject {
    std::string name;
    Made estimator;
    int length = 0;       ///< of the paths that count, as RegionMean has it
    double mean;          ///< of what is measured
    double delta = 0.02;  ///< relative to it
};

Verdict as_unguided(const Subject& subject, const PathEstimator& guided, const Run& run) {
    const Scene& scene = veiled_scene();
    const RegionMean plain{scene, *subject.estimator, whole_film(scene), 16, subject.length};
    const RegionMean other{scene, guided, whole_film(scene), 16, subject.length};
    return same_mean(plain, other,
                     {.delta = run.pick(1.0, 0.25) * subject.delta * subject.mean,
                      .epsilon = 1e-6 * subject.mean,
                      .why_fewer = "sixteen paths in every pixel, drawn with densities bounded away from 0",
                      .cap = run.pick(std::uint64_t{1} << 17, std::uint64_t{1} << 21)},
                     run);
}

constexpr PathLimits limits{.max_edges = 4, .roulette_edges = 2};

void add_guided(Catalogue& catalogue, const Subject& subject, std::vector<Wrong<Told>> wrong) {
    const auto check = [subject](Told told, const Run& run) {
        return as_unguided(subject, Guided(subject.estimator, told), run);
    };
    wrong.insert(wrong.begin(), {"density-ignored", "Numbers are taken for uniform ones.", of_none});
    catalogue.add({.id = fmt::format("render/{}/guided/veil", subject.name),
                   .statement = fmt::format("Numbers of any positive density leave the mean of `{}` as it is, of a "
                                            "floor behind a veil.",
                                            subject.name),
                   .source = "ours, integrators/paths/path_estimator.h",
                   .kind = Kind::mean,
                   .trial = {check, of_all, std::move(wrong)}});
}

void add_first_hit(Catalogue& catalogue, const std::vector<Subject>& subjects) {
    const auto check = [subjects](bool weighted, const Run& run) {
        std::vector<Verdict> parts;
        for (const Subject& subject : subjects) {
            const Made depth = std::make_shared<Depth>(subject.estimator, weighted);
            const Subject seen{subject.name, depth, 1, 2.3};
            parts.push_back(as_unguided(seen, Guided(depth, of_all),
                                        run.part(subject.name, 1 / static_cast<double>(subjects.size()))));
        }
        return all_of(std::move(parts));
    };
    catalogue.add(
        {.id = "render/layers/guided/veil",
         .statement = "Numbers of any positive density leave the mean depth of what is seen first as it is, by every "
                      "integrator.",
         .source = "ours, integrators/paths/path_estimator.h",
         .kind = Kind::mean,
         .trial = {check, true, {{"unweighted", "The density of the first hit's numbers is ignored.", false}}}});
}

}  // namespace

void add_transport_guided_samples(Catalogue& catalogue) {
    const Wrong<Told> no_film{"film-left-out", "The density of film points is ignored.", of_all_but<Use::film>};
    const Wrong<Told> no_mask{"mask-left-out", "The density of what decides about masks is ignored.",
                              of_all_but<Use::shadow>};
    const Wrong<Told> no_light{"light-left-out", "The density of the choice of lights is ignored.",
                               of_all_but<Use::light>};
    const Wrong<Told> no_direction{"direction-left-out", "The density of directions is ignored.",
                                   of_all_but<Use::direction>};
    const Subject aov{"aov", std::make_shared<Aov>(), 1, 0.52};
    const Subject direct{"direct", std::make_shared<Direct>(), 0, 0.3};
    const Subject path{"path", std::make_shared<PathTracer>(limits), 0, 0.3};
    const Subject light{"light", std::make_shared<LightTracer>(limits), 0, 0.3, 0.04};
    const Subject bdpt{"bdpt", std::make_shared<Bdpt>(limits), 0, 0.3};
    add_guided(catalogue, aov, {no_film, no_mask});
    add_guided(catalogue, direct, {no_film, no_light});
    add_guided(catalogue, path, {no_film, no_light});
    add_guided(catalogue, light, {no_direction});
    add_guided(catalogue, bdpt, {no_film, no_light});
    add_first_hit(catalogue, {aov, direct, path, light, bdpt});
}

}  // namespace plumb::suites
