#include "core/error_target.h"

#include <charconv>
#include <cmath>

#include "core/error.h"

namespace plumb {

double ErrorTarget::absolute(double value) const {
    return relative ? error * std::abs(value) : error;
}

ErrorTarget parse_error_target(const std::string& text) {
    ErrorTarget target;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), target.error);
    std::string_view unit(end, text.data() + text.size());
    unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
    target.relative = unit == "%";
    if (failure != std::errc() || !(unit.empty() || target.relative) || !(target.error > 0) ||
        !std::isfinite(target.error))
        throw Error(fmt::format("'{}' is not an error; accepted: 1e-3, or 1% of the value", text));
    if (target.relative) target.error /= 100;
    return target;
}

}  // namespace plumb
