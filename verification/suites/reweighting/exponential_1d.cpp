#include "verification/suites/reweighting/exponential_1d.h"

#include <cmath>

#include "verification/evidence/mean.h"

namespace plumb::reweighting_1d {

double exponential(const Point<1>& x) {
    return std::exp(x[0]);
}

Value weighted(SampleSet draw, Weigh weigh, Function<1> f) {
    return [draw, weigh = std::move(weigh), f = std::move(f)](std::uint64_t n, RandomStream& random) {
        const Samples samples = draw(n, random), weights = weigh(samples);
        double sum = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) sum += weights[i] * f({samples[i]});
        return sum;
    };
}

Verdict means_are(const Value& value, const std::function<double(std::uint64_t)>& truth, const std::vector<At>& places,
                  const Interval& bounds, const Run& run, double epsilon) {
    std::vector<Verdict> parts;
    for (const auto& [n, delta] : places)
        parts.push_back(mean_is([&value, n](RandomStream& random) { return value(n, random); },
                                {.reference = truth(n),
                                 .delta = delta * integral_of_exp,
                                 .epsilon = epsilon,
                                 .bounds = bounds,
                                 .cap = std::uint64_t{1} << 23},
                                run.part(fmt::format("N={}", n), 1.0 / static_cast<double>(places.size()))));
    return all_of(std::move(parts));
}

Verdict unbiased(const Value& value, const std::vector<At>& places, const Interval& bounds, const Run& run,
                 double epsilon) {
    return means_are(
        value, [](std::uint64_t) { return integral_of_exp; }, places, bounds, run, epsilon);
}

}  // namespace plumb::reweighting_1d
