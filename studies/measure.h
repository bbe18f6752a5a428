#pragma once

#include <functional>
#include <string>
#include <vector>

#include "studies/study.h"
#include "verification/run.h"

namespace plumb {

/// Measures error against work for one estimator on one integrand at these counts. The random numbers are a function of
/// the run's seed, the two names and n alone.
template <int D>
Series measure_series(const Estimator<D>& estimator, const Integrand<D>& integrand, const std::vector<std::uint64_t>& n,
                      std::uint64_t replicates, const Run& run);

/// The largest n up to `evaluations` at which a trial run of the estimator calls the integrand at most `evaluations`
/// times; 1 where no n does.
template <int D>
std::uint64_t samples_within(std::uint64_t evaluations, const Estimator<D>& estimator, const Integrand<D>& integrand,
                             const Run& run);

/// One of the study's figures, measured; `progress` is told what comes next.
reports::FigureResult measure_figure(const Study& study, const FigurePlan& plan, const Run& run,
                                     const std::function<void(const std::string& what)>& progress);

/// How many steps a figure and a study have, each of which `progress` is told of.
std::size_t steps_of(const FigurePlan& plan);
std::size_t steps_of(const Study& study);

/// Every figure of a study, measured; `progress` is told what comes next.
std::vector<reports::FigureResult> measure_study(const Study& study, const Run& run,
                                                 const std::function<void(const std::string& what)>& progress);

}  // namespace plumb
