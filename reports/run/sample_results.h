#pragma once

#include "reports/run/results.h"

namespace plumb::reports {

/// An invented run with everything that a report has to show: all kinds and outcomes, a living mutant, unknown and
/// infinite numbers, text that HTML and JSON must escape, a confidence bound at or below zero, an error of exactly 0.
Results sample_results();

/// An earlier run: one outcome differs, one claim is missing, and one is there that is gone later.
Results earlier_sample_results();

}  // namespace plumb::reports
