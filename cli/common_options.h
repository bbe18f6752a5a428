#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "cli/values.h"
#include "core/error.h"

// Several verbs have these options.
namespace plumb::cli {

/// Turns the Error of a parser (values.h) into CLI11's, which names the option.
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

/// An option whose text `parse` reads into `value`, which outlives the parsing.
template <class Value, class Parse>
CLI::Option* add_parsed(CLI::App& verb, const std::string& name, Value& value, Parse parse, const std::string& about) {
    return verb
        .add_option_function<std::string>(
            name, [&value, parse](const std::string& text) { value = parse(text); }, about)
        ->check(checked(parse));
}

/// Accepts a number in (0, 1).
const CLI::Validator& probability();

/// An option for a whole number from `least` to `most`, as "1000" or "1e3"; help shows the value that it has without.
template <class Count>
CLI::Option* add_count(CLI::App& verb, const std::string& name, Count& count, std::uint64_t least, std::uint64_t most,
                       const std::string& about) {
    const auto parse = [least, most](const std::string& text) { return parse_count(text, least, most); };
    const auto read = [&count, parse](const std::string& text) {
        if constexpr (std::is_integral_v<Count>)
            count = static_cast<Count>(parse(text));
        else
            count = parse(text);  // where it is optional
    };
    CLI::Option* option = verb.add_option_function<std::string>(name, read, about);
    option->check(checked(parse))->type_name(fmt::format("{}..{}", least, most));
    if constexpr (std::is_integral_v<Count>) option->default_str(std::to_string(count));
    return option;
}

void add_seed(CLI::App& verb, std::optional<std::uint64_t>& seed);
void add_seed_and_threads(CLI::App& verb, std::optional<std::uint64_t>& seed, int& threads);

/// Adds --cache, the folder of references.
void add_cache(CLI::App& verb, std::string& cache);

/// Adds --domain, both ends of each axis; without it, the unit cube.
void add_domain(CLI::App& verb, std::vector<double>& domain);

/// Adds an option for a share of something, as "1%" or 0.01.
void add_share(CLI::App& verb, const std::string& name, double& share, const std::string& about);

}  // namespace plumb::cli
