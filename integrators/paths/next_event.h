#pragma once

#include "estimators/mis/mis.h"
#include "integrators/paths/next_event/light_choices.h"
#include "integrators/paths/next_event/visibility.h"

namespace plumb {

// Direct light at a vertex,
//   L_direct(wo) = ∫ f(wo, wi) |cos θ| L_e(wi) dω,
// by techniques that share the work: choices of lights, each with a count of samples, and directions of the BSDF that
// happen to meet one. All densities are per steradian at the vertex, or probabilities where light comes from a point
// [Veach 1997, eq. 9.4].

/// The weight of a technique among all, from n_s p_s of each at a direction. The weights of one direction sum to 1.
using MisWeight = double (*)(std::span<const double> densities, std::size_t own);

/// The weight by a heuristic of estimators/mis/mis.h, with its default parameters.
template <class Heuristic>
double mis_weight(std::span<const double> densities, std::size_t own) {
    const Heuristic heuristic;
    const double most = *std::ranges::max_element(densities);
    double sum = 0;
    for (const double density : densities) sum += heuristic(density / most);
    return heuristic(densities[own] / most) / sum;
}

/// The numbers of samples that a vertex takes of lights and of its BSDF, where there is one choice of lights.
struct TechniqueCounts {
    int lights = 1, bsdf = 1;
    friend bool operator==(const TechniqueCounts&, const TechniqueCounts&) = default;
};
constexpr TechniqueCounts lights_alone{1, 0}, bsdf_alone{0, 1}, one_of_each{1, 1};

/// The parts of next-event estimation, which finds light for a vertex.
struct NextEvent {
    struct Lights {
        std::shared_ptr<const LightChoice> choice = choice_by_power();
        int count = 1;
    };
    std::vector<Lights> lights{{}};  ///< at most most_choices
    int bsdf_count = 1;
    std::shared_ptr<const Visibility> visibility = shadow_rays();  ///< of what a choice of lights found
    MisWeight weight = mis_weight<Power>;

    static constexpr std::size_t most_choices = 7;
};
/// The same with other counts. Throws Error for a negative one, or for more than one choice of lights.
NextEvent with_counts(NextEvent next_event, const TechniqueCounts& counts);

/// The weight of a sample, and n_s p_s of all other techniques together.
struct TechniqueWeight {
    double weight, rivals;
};
/// The weight of a sample of the choice of lights with this index, which found a point with density `pdf`.
TechniqueWeight weight_of_choice(const NextEvent& next_event, const Scene& scene, const PathVertex& vertex,
                                 const LightPoint& point, std::size_t choice, double pdf);
/// The weight of a direction of the BSDF that met light, with density `pdf` > 0.
TechniqueWeight weight_of_bsdf(const NextEvent& next_event, const Scene& scene, const PathVertex& vertex,
                               const LightPoint& point, double pdf);

/// The estimate by samples of all choices of lights, weighted, each divided by the density of its own numbers, which
/// branch off those of the vertex.
Spectrum gather_from_lights(const Scene& scene, const PathVertex& vertex, std::uint16_t number,
                            const NextEvent& next_event, const Draws& of_vertex, PathRecord& record);

/// The estimate by directions of the BSDF: of all bsdf_count, those from `first` on.
Spectrum gather_from_bsdf(const Scene& scene, const PathVertex& vertex, std::uint16_t number,
                          const NextEvent& next_event, const Draws& of_vertex, PathRecord& record, int first = 0);

}  // namespace plumb
