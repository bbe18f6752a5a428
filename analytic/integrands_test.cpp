#include "analytic/integrand.h"

#include <set>

#include "analytic/closed_forms.h"
#include "analytic/quadrature.h"
#include "core/error.h"
#include "core/random.h"

namespace plumb {
namespace {

using testing::HasSubstr;

TEST(Integrands, there_are_enough_and_no_two_share_an_id) {
    EXPECT_GE(integrands_1d().size(), 20u);
    EXPECT_GE(integrands_2d().size(), 16u);
    std::set<std::string> ids;
    for (const auto& f : integrands_1d()) EXPECT_TRUE(ids.insert(f.id).second) << f.id;
    for (const auto& f : integrands_2d()) EXPECT_TRUE(ids.insert(f.id).second) << f.id;
}

TEST(Integrands, the_pinned_answers_are_the_closed_forms) {
    std::vector<Answers> pinned;
    for (const auto& f : integrands_1d()) pinned.push_back({f.id, f.integral, f.variance});
    for (const auto& f : integrands_2d()) pinned.push_back({f.id, f.integral, f.variance});
    EXPECT_EQ(pinned, evaluate_closed_forms()) << "after a change of a closed form: run pin_answers";
}

TEST(Integrands, answers_that_others_have_published) {
    EXPECT_NEAR(find_integrand<1>("thesis-1d").integral_value(), 2.666127, 5e-7);             // [thesis, section 4.5.1]
    EXPECT_NEAR(find_integrand<1>("keister").integral_value(), 1.380388447043143, 1e-15);     // QMCPy
    EXPECT_NEAR(find_integrand<2>("keister-2d").integral_value(), 1.808186429263620, 1e-15);  // QMCPy
    EXPECT_NEAR(find_integrand<2>("gaussian-2d").integral_value(), 0.557746285351034, 1e-15);    // (√π/2 erf 1)²
    EXPECT_NEAR(find_integrand<1>("periodic-exp").integral_value(), 1.2660658777520084, 1e-15);  // I₀(1), DLMF 10.25
}

template <int D>
Point<D> somewhere(std::uint64_t index) {
    RandomStream random(2018, 6, index);
    Point<D> x;
    for (double& axis : x) {
        const std::uint64_t kind = random.below(4);  // now and then a corner, so that the boundary is seen too
        axis = kind == 0 ? 0 : kind == 1 ? 1 : random.uniform();
    }
    return x;
}

template <int D>
void expect_within_bounds() {
    for (const auto& f : integrands<D>())
        for (std::uint64_t i = 0; i < 200; ++i)
            EXPECT_TRUE(f.bounds.contains(f(somewhere<D>(i)))) << f.id << " is " << f(somewhere<D>(i));
}
TEST(Integrands, values_lie_within_the_bounds_on_the_closed_cube) {
    expect_within_bounds<1>();
    expect_within_bounds<2>();
}

TEST(Integrands, a_jump_on_the_torus_is_a_difference_of_the_end_values) {
    for (const auto& f : integrands_1d()) {
        if (f.smoothness == Smoothness::jump || f.smoothness == Smoothness::singular) {
            EXPECT_EQ(f.periodic_smoothness, f.smoothness) << f.id;
            continue;
        }
        const double difference = std::abs(f({0}) - f({1})) / f.root_mean_square();
        EXPECT_EQ(difference > 1e-12, f.periodic_smoothness == Smoothness::jump) << f.id << ": " << difference;
    }
}

TEST(Integrands, nothing_is_smoother_on_the_torus_than_in_the_cube) {
    for (const auto& f : integrands_1d()) EXPECT_GE(f.periodic_smoothness, f.smoothness) << f.id;
    for (const auto& f : integrands_2d()) EXPECT_GE(f.periodic_smoothness, f.smoothness) << f.id;
}

TEST(Integrands, infinite_is_written_inf_and_read_as_infinity) {
    for (const char* id : {"inverse-sqrt", "inverse-power-0.9"}) {
        EXPECT_EQ(find_integrand<1>(id).variance, "inf");
        EXPECT_TRUE(std::isinf(find_integrand<1>(id).variance_value()));
        EXPECT_TRUE(std::isinf(find_integrand<1>(id).root_mean_square()));
    }
}

TEST(Integrands, an_unknown_name_gets_the_nearest_one) {
    try {
        (void)find_integrand<2>("quarter-dsk");
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("did you mean 'quarter-disk'"));
    }
}

TEST(Integrands, every_integrand_says_where_it_comes_from_and_how_it_was_derived) {
    const auto expect_told = [](const auto& f) {
        EXPECT_FALSE(f.formula.empty() || f.source.empty() || f.derivation.empty()) << f.id;
        EXPECT_GE(f.integral.size(), 55u) << f.id;
    };
    for (const auto& f : integrands_1d()) expect_told(f);
    for (const auto& f : integrands_2d()) expect_told(f);
}

}  // namespace
}  // namespace plumb
