#include "verification/evidence/rare_values.h"

namespace plumb {

std::string with_commas(std::uint64_t number) {
    const std::string digits = std::to_string(number);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
        text += digits[i];
    }
    return text;
}

std::string what_could_hide(std::uint64_t draws) {
    const std::uint64_t rarest = draws / draws_that_meet;
    if (rarest < 2) return "any value that was not drawn could hide";
    return fmt::format("values rarer than 1 in {} could hide", with_commas(rarest));
}

}  // namespace plumb
