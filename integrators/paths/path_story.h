#pragma once

#include <optional>
#include <vector>

#include "scenes/scene.h"

namespace plumb {

/// A way to make a path from two ends: s vertices from the light and t from the sensor, of s + t − 1 edges.
struct Strategy {
    int s = 0, t = 2;

    [[nodiscard]] int edges() const { return s + t - 1; }
    friend bool operator==(const Strategy&, const Strategy&) = default;
};

/// The story of a sample: how it came about, as far as its vertices and splats do not say it. Estimators tell it, as
/// they go, to whoever listens (PathRecord::story).
struct PathStory {
    /// A direction that the BSDF of a vertex chose.
    struct Scattering {
        std::uint16_t vertex;  ///< as its slots are numbered: from the sensor, or from first_light_vertex on
        Vec3 direction;
        double pdf;
        Measure measure;
        double eta;
        Spectrum throughput;  ///< of the subpath behind it, before roulette; a light's own weight is not in it
        double survival = 1;  ///< probability with which roulette lets the path go on; 1 where it is not played
        bool survived = true;
    };
    /// Light that a strategy found. It adds throughput · light · weight / density to a splat, or nothing where that is
    /// black.
    struct Finding {
        Strategy strategy;
        Spectrum light;     ///< f L_e / p of what comes behind the throughput
        double weight = 1;  ///< of multiple importance sampling
        double pdf = 0;     ///< per steradian, of the technique that found it, where it has a rival
        double rival = 0;   ///< of the technique that it is weighted against; 0: there is none
        std::optional<std::size_t> source =
            {};              ///< index into Scene::lights(); empty: where the light's subpath starts
        double density = 1;  ///< of the numbers that it depends on: 1 unless guided
        Spectrum throughput = {};
        std::size_t splat = 0;  ///< index into PathRecord::splats, where it adds to one

        [[nodiscard]] Spectrum value() const { return throughput * light * weight / density; }
    };

    std::optional<SceneLightRay> light_ray;  ///< with which the light's subpath starts
    std::vector<Scattering> scatterings;
    std::vector<Finding> findings;
    Spectrum throughput = Spectrum::grey(1);  ///< of what is found next

    void clear() { *this = {}; }
    // Out of line, because nobody listens to most paths: inlined, telling costs `path` a tenth of its speed.
    /// Tells of light that is to be the splat of this index, or a part of it, behind `throughput`.
    void found(Finding finding, std::size_t splat);
    void scattered(const Scattering& scattering);
    /// Tells whether roulette let the path go on in the direction told last.
    void played(double survival, bool survived);
};

}  // namespace plumb
