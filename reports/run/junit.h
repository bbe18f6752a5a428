#pragma once

#include <string>

#include "reports/run/results.h"

namespace plumb::reports {

/// The run as JUnit XML, which CI servers read: a test suite for each group of claims (the first part of the id), a
/// test case for each claim and each mutant. A claim that is refuted and a mutant that its claim lets live are
/// failures; undecided is an error, because the program's exit code is not 0 then.
std::string junit_xml(const Results& results);

}  // namespace plumb::reports
