#include "checks/sampler/lines.h"

#include <fmt/format.h>

#include "core/csv.h"
#include "core/error.h"
#include "core/process.h"
#include "core/random.h"

namespace plumb::checks {
namespace {

std::string filled_in(std::string command, std::string_view place, std::uint64_t value) {
    for (std::size_t at = 0; (at = command.find(place, at)) != std::string::npos;)
        command.replace(at, place.size(), std::to_string(value));
    return command;
}

// The numbers of a line; false where it is something else.
bool read_numbers(std::string_view line, std::vector<double>& numbers) {
    numbers.clear();
    for (const std::string_view field : csv_fields(line, csv_separator(line))) {
        const std::optional<double> x = csv_number(field);
        if (!x) return false;
        numbers.push_back(*x);
    }
    return true;
}

}  // namespace

std::string command_for(const SamplerTrial& trial, std::uint64_t seed, std::uint64_t n) {
    const std::uint64_t bits = RandomStream(seed, stream_id("sampler/density"), 0).bits() >> 33;  // below 2^31
    return filled_in(filled_in(trial.command, "{seed}", bits), "{n}", n);
}

void for_lines(const std::string& command, const SamplerTrial& trial, std::uint64_t n, std::size_t least,
               std::size_t most, const std::string& accepted,
               const std::function<void(std::span<const double>, std::string_view, std::uint64_t)>& use) {
    std::uint64_t lines = 0;
    std::vector<double> numbers;
    const bool enough = read_lines(command, trial.timeout, [&](std::string_view line) {
        ++lines;
        if (!read_numbers(line, numbers) || numbers.size() < least || numbers.size() > most)
            throw Error(
                fmt::format("line {} of the sampler is '{}'; accepted: {}", lines, line.substr(0, 60), accepted));
        use(numbers, line, lines);
        return lines < n;
    });
    if (!enough) throw Error(fmt::format("'{}' ended after {} of {} lines", command, lines, n));
}

}  // namespace plumb::checks
