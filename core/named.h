#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace plumb {

/// The name that most of our lists go by.
struct IdOf {
    std::string_view operator()(const auto& element) const { return element.id; }
};

/// The first element of the list whose name, `name_of(element)`, is the one typed. Throws Error by unknown_name(), with
/// `what` for the kind of thing, where there is none.
template <class List, class NameOf = IdOf>
const auto& find_named(const List& list, std::string_view typed, std::string_view what, const NameOf& name_of = {}) {
    const auto found =
        std::ranges::find_if(list, [&](const auto& element) { return std::invoke(name_of, element) == typed; });
    if (found != std::ranges::end(list)) return *found;
    std::vector<std::string> known;
    for (const auto& element : list) known.emplace_back(std::invoke(name_of, element));
    throw unknown_name(what, typed, known);
}

}  // namespace plumb
