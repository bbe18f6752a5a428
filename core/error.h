#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// Bad input: the message names the thing, what was found and what is accepted, in one line. The program ends with 2.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The known name nearest to what was typed (edit distance); empty when none is close enough to be meant.
std::string nearest_name(std::string_view typed, const std::vector<std::string>& known);

/// `unknown WHAT 'typed'; did you mean 'nearest'?`, or the known names when none is near.
Error unknown_name(std::string_view what, std::string_view typed, const std::vector<std::string>& known);

}  // namespace plumb
