#include "reports/study/log_axis.h"

namespace plumb::reports {
namespace {

std::string superscript(int exponent) {
    static constexpr std::array digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "⁻" : "";
    for (const char c : std::to_string(std::abs(exponent))) text += digits.at(static_cast<std::size_t>(c - '0'));
    return text;
}

}  // namespace

LogAxis axis_over(const std::vector<double>& values, double from, double to) {
    double low = 0, high = 1;
    if (!values.empty()) {
        const auto [least, most] = std::ranges::minmax(values);
        low = std::log(least / 1.25);
        high = std::log(most * 1.25);
    }
    return {low, high, from, to};
}

std::vector<Tick> ticks(const LogAxis& axis, bool powers_of_two, int most) {
    const double base = powers_of_two ? 2 : 10, low = axis.low / std::log(base), high = axis.high / std::log(base);
    const int step = std::max(1, static_cast<int>(std::ceil((high - low) / most)));
    std::vector<Tick> list;
    for (int e = static_cast<int>(std::ceil(low / step)) * step; e <= high; e += step)
        list.push_back({std::pow(base, e), powers_of_two && e >= 0 ? fmt::format("{}", std::pow(2, e))
                                                                   : fmt::format("{}{}", base, superscript(e))});
    if (list.size() > 1) return list;
    list.clear();
    for (int e = static_cast<int>(std::floor(low)); e <= high; ++e)
        for (const double digit : {1, 2, 5})
            if (const double x = digit * std::pow(base, e); std::log(x) >= axis.low && std::log(x) <= axis.high)
                list.push_back({x, fmt::format("{:.2g}", x)});
    return list;
}

}  // namespace plumb::reports
