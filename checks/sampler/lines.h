#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "checks/sampler/sampler.h"

namespace plumb::checks {

/// The command with its places filled in: {n}, and {seed} with a positive int of every language, a function of the
/// seed.
std::string command_for(const SamplerTrial& trial, std::uint64_t seed, std::uint64_t n);

/// Hands over the numbers of each of the first n lines that the command prints, between `least` and `most` of them;
/// `accepted` says in words what a line holds. Infinities and NaN are numbers: a sampler that returns them is wrong,
/// not unreadable. Throws Error.
void for_lines(const std::string& command, const SamplerTrial& trial, std::uint64_t n, std::size_t least,
               std::size_t most, const std::string& accepted,
               const std::function<void(std::span<const double>, std::string_view line, std::uint64_t number)>& use);

}  // namespace plumb::checks
