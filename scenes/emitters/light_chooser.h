#pragma once

#include <algorithm>
#include <vector>

#include "estimators/densities/piecewise_constant.h"
#include "scenes/emitters/light.h"

namespace plumb {

/// A light, by its index among n, and its probability. Times the light's density per steradian it is the pair's
/// density.
struct ChosenLight {
    std::size_t index;
    double pmf;
};

/// A choice of lights with fixed probabilities, whatever the shading point.
class LightChooser {
public:
    /// The choice with equal probabilities; count > 0.
    static LightChooser uniform(std::size_t count) { return LightChooser(std::vector<double>(count, 1.0)); }
    /// The choice with probabilities in proportion to the luminance of the lights' power; equal ones when every light
    /// is black. Throws Error for power that is negative or not finite.
    static LightChooser by_power(const std::vector<Spectrum>& powers) {
        std::vector<double> weights;
        for (const Spectrum& power : powers) weights.push_back(luminance(power));
        if (std::ranges::all_of(weights, [](double w) { return w == 0; })) return uniform(powers.size());
        return LightChooser(weights);
    }

    /// The choice half in proportion to power, half alike among the lights that have any. Power is no measure of what
    /// a place sees of a light: a sky's grows with the scene's radius, however far away. So each of n lights keeps a
    /// share of 1/2n, and none costs more than twice the samples that the choice by power alone would take.
    static LightChooser half_by_power(const std::vector<Spectrum>& powers) {
        const LightChooser by_power = LightChooser::by_power(powers);
        std::vector<double> weights;
        for (std::size_t i = 0; i < powers.size(); ++i) weights.push_back(by_power.pmf(i));
        const auto shines = [](const Spectrum& power) { return luminance(power) > 0; };
        const auto shining = static_cast<double>(std::ranges::count_if(powers, shines));
        for (std::size_t i = 0; i < powers.size(); ++i)
            if (shines(powers[i])) weights[i] += 1 / shining;
        return LightChooser(weights);
    }

    [[nodiscard]] ChosenLight sample(double u) const {
        if (count_ == 1) return {0, 1};
        const auto i =
            std::min(static_cast<std::size_t>(choice_.sample(u) * count_), static_cast<std::size_t>(count_) - 1);
        return {i, pmf(i)};
    }
    [[nodiscard]] double pmf(std::size_t index) const {
        return choice_.pdf((static_cast<double>(index) + 0.5) / count_) / count_;
    }
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(count_); }

private:
    explicit LightChooser(const std::vector<double>& weights)
        : choice_(weights), count_(static_cast<double>(weights.size())) {}

    PiecewiseConstant choice_;
    double count_;
};

}  // namespace plumb
