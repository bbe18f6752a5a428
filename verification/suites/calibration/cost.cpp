// What a mean verdict costs, in samples, against the fixed-size design with the same risks.

#include "verification/claim.h"
#include "verification/evidence/cost_of_a_verdict.h"
#include "verification/evidence/mean.h"

namespace plumb::suites {
namespace {

Verdict costs_at_most(double fraction, double bias, const Run& run) {
    const CostSetting setting;
    const auto draw = [&](RandomStream& random) {
        return simulate_verdict(setting, bias, random).samples / fixed_design(setting);
    };
    const Interval bounds{0, longest_verdict() / fixed_design(setting)};
    return mean_at_most(draw, {.bound = fraction, .margin = fraction / 4, .bounds = bounds}, run);
}

}  // namespace

void add_calibration_cost(Catalogue& catalogue) {
    struct Aim {
        double bias, fraction;
        std::string end;
        double easier;  // the mutant's bias: a test that needs as many samples as this one does
        Sizes sizes;
    };
    for (const Aim& each :
         {Aim{0, 0.4, "holds", 0.75, Sizes::full_only}, Aim{1, 0.65, "refuted", 0.75, Sizes::full_only},
          Aim{2, 0.2, "refuted", 1.3, Sizes::full_only}, Aim{5, 1.0 / 30, "refuted", 3, Sizes::full_only},
          Aim{10, 0.01, "refuted", 6, Sizes::both}})
        catalogue.add(
            {.id = fmt::format("calibration/cost/bias-{:g}", each.bias),
             .statement = fmt::format("At a bias of {:g} delta a mean is {} after at most {:.3g} of the samples of the "
                                      "fixed-size design with the same risks.",
                                      each.bias, each.end == "holds" ? "held" : each.end, each.fraction),
             .source = "docs/statistics.md, Cost of a verdict",
             .kind = Kind::mean,
             .trial = {[=](double bias, const Run& run) { return costs_at_most(each.fraction, bias, run); },
                       each.bias,
                       {{"smaller-bias", fmt::format("a bias of {:g} delta counted as {:g}", each.easier, each.bias),
                         each.easier}}},
             .sizes = each.sizes});
}

}  // namespace plumb::suites
