// Does the verdict on an order see a single pair that is out of it?

#include "verification/evidence/order.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "verification/claim.h"
#include "verification/evidence/deterministic.h"

namespace plumb::suites {
namespace {

using Judge = std::function<Verdict(std::span<const double>)>;

Verdict sees_disorder(const Judge& judge, const Run& run) {
    constexpr int trials = 100;
    int wrong = 0;
    for (int i = 0; i < trials; ++i) {
        RandomStream random = run.random(static_cast<std::uint64_t>(i));
        std::vector<double> values(20);
        for (double& value : values) value = random.uniform();
        std::ranges::sort(values);
        wrong += judge(values).outcome != Outcome::holds;
        const std::size_t at = 1 + random.below(17);
        std::swap(values[at], values[at + 1]);
        wrong += judge(values).outcome != Outcome::refuted;
        values[at] = NAN;
        wrong += judge(values).outcome != Outcome::refuted;
    }
    return exactly(wrong == 0, 3 * trials, fmt::format("{} of {} orders are misjudged", wrong, 3 * trials));
}

Verdict by_ends(std::span<const double> values) {
    return exactly(values.front() <= values.back(), values.size(), "by the first and the last");
}

}  // namespace

void add_calibration_order(Catalogue& catalogue) {
    catalogue.add(
        {.id = "calibration/order/pairs",
         .statement = "What is in order holds; one pair out of order, or one value that is no number, refutes.",
         .source = "ours, verification/evidence/order.h",
         .kind = Kind::exact,
         .trial = {sees_disorder, never_falls, {{"ends", "only the first and the last are compared", by_ends}}}});
}

}  // namespace plumb::suites
