#include "estimators/replicates/integration.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.h"
#include "core/moments.h"
#include "core/parallel.h"

namespace plumb {
namespace {

// The mean of n uniform numbers: expectation 1/2, variance 1/(12 n).
Estimate mean_of_uniforms(std::uint64_t n, RandomStream& random) {
    Estimate estimate{.evaluations = n};
    for (std::uint64_t i = 0; i < n; ++i) estimate.value += random.uniform() / static_cast<double>(n);
    return estimate;
}

TEST(IndependentRuns, AreTheSameOnAnyNumberOfThreads) {
    const auto values = [](int threads) {
        std::vector<double> all;
        with_threads(threads, [&] {
            for (const Estimate& e : independent_runs(mean_of_uniforms, 8, 20, 7, "look").estimates)
                all.push_back(e.value);
        });
        return all;
    };
    EXPECT_EQ(values(1), values(2));
}

TEST(IndependentRuns, DifferByPurposeAndN) {
    const auto first = [](std::uint64_t n, std::string_view purpose) {
        return independent_runs([](std::uint64_t, RandomStream& random) { return Estimate{random.uniform()}; }, n, 1, 7,
                                purpose)
            .estimates[0]
            .value;
    };
    EXPECT_NE(first(8, "look"), first(8, "answer"));
    EXPECT_NE(first(8, "look"), first(16, "look"));
    EXPECT_EQ(first(8, "look"), first(8, "look"));
}

TEST(MeanOf, KnowsItsErrorOnlyFromASpread) {
    const Estimate mean = mean_of({.n = 4, .estimates = {{1, 0, 4}, {3, 0, 4}}});
    EXPECT_EQ(mean.value, 2);
    EXPECT_EQ(mean.standard_error, 1);  // variance 2 over 2 runs
    EXPECT_EQ(mean.evaluations, 8u);
    EXPECT_TRUE(std::isinf(mean_of({.n = 4, .estimates = {{1, 0, 4}}}).standard_error));
    EXPECT_TRUE(std::isinf(mean_of({.n = 4, .estimates = {{1, 0, 4}, {1, 0, 4}}}).standard_error));
}

// Batches that are all the same have shown no spread, as replicates have: their error is unknown, not 0.
TEST(MeanOfBatches, KnowsItsErrorOnlyFromASpread) {
    RandomStream random(1);
    const auto size = [](std::uint64_t n, RandomStream&) { return Estimate{static_cast<double>(n), 0, n}; };
    const Estimate unequal = mean_of_batches(size, 7, 2, random);  // batches of 4 and 3: variance 1/2 over 2 batches
    EXPECT_EQ(unequal.value, 3.5);
    EXPECT_EQ(unequal.standard_error, 0.5);
    EXPECT_EQ(unequal.evaluations, 7u);
    EXPECT_TRUE(std::isinf(mean_of_batches(size, 8, 2, random).standard_error));
    EXPECT_TRUE(std::isinf(mean_of_batches(size, 8, 1, random).standard_error));
    EXPECT_THROW((void)mean_of_batches(size, 2, 3, random), Error);
}

TEST(Skewed, SeesAnOutlierAndNothingInNormalRuns) {
    Runs runs{.n = 1, .estimates = std::vector<Estimate>(32, Estimate{1})};
    EXPECT_FALSE(skewed(runs));  // no spread, no skewness
    for (std::size_t i = 0; i < 32; i += 2) runs.estimates[i].value = 2;
    EXPECT_FALSE(skewed(runs));
    runs.estimates[0].value = 100;  // skewness near √32 = 5.7, the limit is 2.25
    EXPECT_TRUE(skewed(runs));
}

TEST(SearchSampleCount, StopsWhereTheTargetNeedsIt) {
    // 32 runs of n: standard error sqrt(1/(384 n)); below 2/3 of 1e-3 at n ≈ 5859, so 8192, or half or twice that.
    const Search search = search_sample_count(mean_of_uniforms, {1e-3, false}, 32, 100'000'000, 3);
    EXPECT_TRUE(search.met);
    EXPECT_GE(search.looks.back().n, 4096u);
    EXPECT_LE(search.looks.back().n, 16384u);
    EXPECT_EQ(search.looks.front().n, 16u);
    const Search relative = search_sample_count(mean_of_uniforms, {2e-3, true}, 32, 100'000'000, 3);
    EXPECT_TRUE(relative.met);
    EXPECT_LE(mean_of(relative.looks.back()).standard_error, 1e-3);
}

// Half of the integral lies in a needle of 1e-4, which most looks of few evaluations miss.
TEST(SearchSampleCount, DoesNotStopBeforeItMetANeedle) {
    const auto needle = [](std::uint64_t n, RandomStream& random) {
        Estimate estimate{.evaluations = n};
        for (std::uint64_t i = 0; i < n; ++i) {
            const double x = random.uniform();
            estimate.value += (x + (std::abs(x - 0.7) < 5e-5 ? 5000 : 0)) / static_cast<double>(n);
        }
        return estimate;
    };
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Search search = search_sample_count(needle, {0.01, true}, 32, 2'000'000, seed);
        EXPECT_FALSE(search.met) << search.looks.back().n;
    }
}

TEST(SearchSampleCount, KeepsToItsBudgetWithTheAnswer) {
    const Search search = search_sample_count(mean_of_uniforms, {1e-9, false}, 16, 100'000, 3);
    EXPECT_FALSE(search.met);
    std::uint64_t spent = mean_of(search.looks.back()).evaluations;  // what the answer will need
    for (const Runs& look : search.looks) spent += mean_of(look).evaluations;
    EXPECT_LE(spent, 100'000u);
    EXPECT_GE(spent, 40'000u);
    const auto constant = [](std::uint64_t n, RandomStream&) { return Estimate{1, 0, n}; };
    EXPECT_FALSE(search_sample_count(constant, {1, false}, 16, 10'000, 3).met);
}

TEST(SearchSampleCount, FreshRunsAreUnbiasedAndMeetTheTarget) {
    Moments answers, squares;
    int met = 0;
    constexpr int repetitions = 300;
    for (std::uint64_t seed = 0; seed < repetitions; ++seed) {
        const ErrorTarget target{0.01, false};
        const Search search = search_sample_count(mean_of_uniforms, target, 32, 1'000'000, seed);
        const Estimate answer = mean_of(independent_runs(mean_of_uniforms, search.looks.back().n, 32, seed, "answer"));
        met += target.met_by(answer);
        answers.add(answer.value);
        squares.add(std::pow((answer.value - 0.5) / answer.standard_error, 2));
    }
    EXPECT_LT(std::abs(answers.mean() - 0.5), 5 * answers.standard_error());
    EXPECT_NEAR(squares.mean(), 31.0 / 29, 5 * squares.standard_error());  // E t² with 31 degrees of freedom
    EXPECT_GE(met, repetitions * 95 / 100);
}

}  // namespace
}  // namespace plumb
