#include "core/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

namespace plumb {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row.back();
}

}  // namespace

std::string nearest_name(std::string_view typed, const std::vector<std::string>& known) {
    std::string best;
    std::size_t best_distance = std::max<std::size_t>(2, typed.size() / 3) + 1;
    for (const std::string& name : known)
        if (const std::size_t distance = edit_distance(typed, name); distance < best_distance) {
            best = name;
            best_distance = distance;
        }
    return best;
}

Error unknown_name(std::string_view what, std::string_view typed, const std::vector<std::string>& known) {
    if (const std::string near = nearest_name(typed, known); !near.empty())
        return Error(fmt::format("unknown {} '{}'; did you mean '{}'?", what, typed, near));
    return Error(fmt::format("unknown {} '{}'; known: {}", what, typed, fmt::join(known, ", ")));
}

}  // namespace plumb
