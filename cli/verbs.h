#pragma once

#include <functional>
#include <stdexcept>

#include "cli/commands.h"

namespace plumb::cli {

/// What a program does with the options it was given: the verbs that need nothing but a catalogue. A program with more
/// verbs derives from it.
struct CatalogueVerbs {
    const Catalogue& catalogue;
    Lists lists;

    int operator()(const Answered& answered) const { return answered.exit_code; }
    int operator()(const VerifyOptions& options) const;  ///< of the catalogue, or of the sampler that is on trial
    int operator()(const ListOptions& options) const { return list(options, lists); }
    int operator()(const ReportOptions& options) const { return report(options); }
    int operator()(const MergeOptions& options) const { return merge(options); }
    template <class Other>
    int operator()(const Other&) const {
        throw std::logic_error("the parser offers a verb that this program does not have");
    }
};

/// The body of main(): an exception, or standard output that cannot be written, becomes one line on standard error,
/// after the program's name, and exit code 2.
int reporting_errors(char** argv, const std::function<int()>& body);

}  // namespace plumb::cli
