#include "analytic/enumeration.h"

#include "core/error.h"

namespace plumb {

std::size_t Choices::take(std::size_t options) {
    if (depth_ == path_.size()) path_.push_back({0, options});
    if (path_[depth_].options != options)
        throw Error(
            fmt::format("enumerate: choice {} offered {} options, and {} when replayed; the estimator must depend "
                        "on its choices alone",
                        depth_, path_[depth_].options, options));
    return path_[depth_++].taken;
}

std::uint64_t Choices::below(std::uint64_t n) {
    if (n == 0) throw Error("enumerate: below(0) has no outcome; n must be at least 1");
    const std::size_t taken = take(n);
    probability_ /= n;
    return taken;
}

std::size_t Choices::choose(std::span<const Rational> probabilities) {
    Rational sum = 0;
    std::vector<std::size_t> possible;
    for (std::size_t i = 0; i < probabilities.size(); ++i) {
        if (probabilities[i] < 0)
            throw Error(fmt::format("enumerate: probability {} is {}; it must be >= 0", i, probabilities[i].str()));
        sum += probabilities[i];
        if (probabilities[i] > 0) possible.push_back(i);
    }
    if (sum != 1) throw Error(fmt::format("enumerate: probabilities sum to {}; they must sum to 1", sum.str()));
    const std::size_t chosen = possible[take(possible.size())];
    probability_ *= probabilities[chosen];
    return chosen;
}

bool Choices::chance(const Rational& p) {
    const Rational probabilities[] = {1 - p, p};
    return choose(probabilities) == 1;
}

void Choices::rewind() {
    depth_ = 0;
    probability_ = 1;
}

bool Choices::advance() {
    while (!path_.empty() && ++path_.back().taken == path_.back().options) path_.pop_back();
    return !path_.empty();
}

ExactMoments enumerate(const std::function<Rational(Choices&)>& estimator, std::uint64_t most_outcomes) {
    ExactMoments moments;
    Rational total = 0, second = 0;
    Choices choices;
    do {
        if (moments.outcomes == most_outcomes)
            throw Error(fmt::format("enumerate: more than {} outcomes; make the case smaller", most_outcomes));
        choices.rewind();
        const Rational value = estimator(choices);
        const Rational weighted = choices.probability_ * value;
        total += choices.probability_;
        moments.mean += weighted;
        second += weighted * value;
        ++moments.outcomes;
    } while (choices.advance());
    if (total != 1)
        throw Error(
            fmt::format("enumerate: the outcomes' probabilities sum to {}, not 1; the estimator must depend on its "
                        "choices alone",
                        total.str()));
    moments.variance = second - moments.mean * moments.mean;
    return moments;
}

}  // namespace plumb
