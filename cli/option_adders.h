#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cli/options.h"
#include "core/error.h"

// What the sources that describe the verbs' options to CLI11 have in common.
namespace plumb::cli {

// Turns an Error of one of our parsers into CLI11's, which names the option.
template <class Parse>
auto checked(Parse parse) {
    return [parse](const std::string& text) -> std::string {
        try {
            parse(text);
            return {};
        } catch (const Error& error) {
            return error.what();
        }
    };
}

/// Accepts a number in (0, 1).
const CLI::Validator& probability();

void add_seed(CLI::App* verb, std::optional<std::uint64_t>& seed);
void add_seed_and_threads(CLI::App* verb, std::optional<std::uint64_t>& seed, int& threads);
void add_cache(CLI::App* verb, std::string& cache);

void add_render(CLI::App& app, RenderOptions& options);
void add_explain(CLI::App& app, ExplainOptions& options);
void add_reference(CLI::App& app, ReferenceOptions& options);
void add_compare(CLI::App& app, CompareOptions& options);
void add_check(CLI::App& app, CheckOptions& options);

}  // namespace plumb::cli
