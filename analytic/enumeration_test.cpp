#include "analytic/enumeration.h"

#include "core/error.h"

namespace plumb {
namespace {

TEST(Enumerate, two_dice) {
    const ExactMoments dice =
        enumerate([](Choices& random) { return Rational(2 + random.below(6) + random.below(6)); });
    EXPECT_EQ(dice.mean, 7);
    EXPECT_EQ(dice.variance, Rational(35, 6));
    EXPECT_EQ(dice.outcomes, 36u);
}

TEST(Enumerate, no_choice_is_one_outcome) {
    const ExactMoments constant = enumerate([](Choices&) { return Rational(3, 7); });
    EXPECT_EQ(constant.mean, Rational(3, 7));
    EXPECT_EQ(constant.variance, 0);
    EXPECT_EQ(constant.outcomes, 1u);
}

TEST(Enumerate, russian_roulette_keeps_the_mean_and_pays_in_variance) {
    // Surviving with probability p, divided by p: mean v, variance v² (1−p)/p.
    const Rational v(5, 3), p(1, 4);
    const ExactMoments roulette =
        enumerate([&](Choices& random) { return random.chance(p) ? Rational(v / p) : Rational(0); });
    EXPECT_EQ(roulette.mean, v);
    EXPECT_EQ(roulette.variance, v * v * (1 - p) / p);
}

TEST(Enumerate, a_telescoping_sum_reaches_its_last_term) {
    // Choose k with probability p_k, return I_0 + (I_k − I_{k−1}) / p_k: mean I_3 [Misso et al. 2022].
    const std::vector<Rational> sequence{{1, 2}, {3, 4}, {5, 6}, {9, 10}};
    const std::vector<Rational> p{0, {1, 2}, {1, 3}, {1, 6}};
    const ExactMoments single_term = enumerate([&](Choices& random) {
        const std::size_t k = random.choose(p);
        return Rational(sequence[0] + (sequence[k] - sequence[k - 1]) / p[k]);
    });
    EXPECT_EQ(single_term.mean, sequence[3]);
    EXPECT_EQ(single_term.outcomes, 3u);  // the impossible k = 0 is not visited
}

TEST(Enumerate, later_choices_may_depend_on_earlier_ones) {
    // A uniform permutation by Fisher–Yates: each of the 24 once, fixed points 1 on average with variance 1.
    const ExactMoments fixed_points = enumerate([](Choices& random) {
        std::array<std::uint64_t, 4> cards{0, 1, 2, 3};
        for (std::size_t i = cards.size(); i > 1; --i) std::swap(cards[i - 1], cards[random.below(i)]);
        int fixed = 0;
        for (std::size_t i = 0; i < cards.size(); ++i) fixed += cards[i] == i;
        return Rational(fixed);
    });
    EXPECT_EQ(fixed_points.mean, 1);
    EXPECT_EQ(fixed_points.variance, 1);
    EXPECT_EQ(fixed_points.outcomes, 24u);

    const ExactMoments uneven = enumerate([](Choices& random) {
        return random.chance({1, 3}) ? Rational(1 + random.below(2)) : Rational(0);
    });
    EXPECT_EQ(uneven.mean, Rational(1, 2));
    EXPECT_EQ(uneven.outcomes, 3u);
}

TEST(Enumerate, refuses_what_is_no_distribution_and_what_does_not_end) {
    EXPECT_THROW(enumerate([](Choices& random) { return Rational(random.below(0)); }), Error);
    EXPECT_THROW(enumerate([](Choices& random) { return Rational(int(random.chance({3, 2}))); }), Error);
    EXPECT_THROW(enumerate([](Choices& random) { return Rational(random.below(11)); }, 10), Error);
}

TEST(Enumerate, refuses_an_estimator_with_randomness_of_its_own) {
    int calls = 0;
    EXPECT_THROW(
        enumerate([&](Choices& random) { return Rational(random.below(static_cast<std::uint64_t>(2 + calls++))); }),
        Error);
}

}  // namespace
}  // namespace plumb
