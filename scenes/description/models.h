#pragma once

#include <algorithm>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "scenes/description/properties.h"

// Closed families of models: a list of types is all that a loader, a renderer or a test knows of them. Each type says
//   static constexpr std::array plugins{Plugin{…}, …};   by which names scene files ask for it
//   static … load(Properties&, …);                       how it is read
// and what its family asks for. One more model is its own file and its name in one list: docs/adding.md.
namespace plumb::description {

/// A name by which scene files ask for a model, in Mitsuba's words, and one line that says what it is.
struct Plugin {
    std::string_view name, summary;
};

/// A list of types.
template <class... Models>
struct Types {};

/// Calls visit with std::type_identity of each type.
template <class... Models>
constexpr void for_each_type(Types<Models...>, const auto& visit) {
    (visit(std::type_identity<Models>{}), ...);
}

template <class... Lists>
struct JoinedTypes {
    using type = Types<>;
};
template <class... A>
struct JoinedTypes<Types<A...>> {
    using type = Types<A...>;
};
template <class... A, class... B, class... Rest>
struct JoinedTypes<Types<A...>, Types<B...>, Rest...> : JoinedTypes<Types<A..., B...>, Rest...> {};
/// The types of several lists, one after another.
template <class... Lists>
using Joined = typename JoinedTypes<Lists...>::type;

template <class Variant, class List>
struct DistinctTypes;
template <class... Known>
struct DistinctTypes<std::variant<Known...>, Types<>> {
    using type = std::variant<Known...>;
};
template <class... Known, class Next, class... Rest>
struct DistinctTypes<std::variant<Known...>, Types<Next, Rest...>>
    : DistinctTypes<std::conditional_t<(std::is_same_v<Known, Next> || ...), std::variant<Known...>,
                                       std::variant<Known..., Next>>,
                    Types<Rest...>> {};
/// A value of any of the list's types, each of which counts once.
template <class List>
using OneOf = typename DistinctTypes<std::variant<>, List>::type;

/// Whether scene files ask for the model by this name.
template <class Model>
bool serves(std::string_view name) {
    return std::ranges::any_of(Model::plugins, [&](const Plugin& plugin) { return plugin.name == name; });
}

/// The thing that the properties describe, loaded by the model of the list that serves their type; empty where none
/// does.
template <class Result, class... Models>
std::optional<Result> load_model(Types<Models...>, Properties& properties, const auto&... more) {
    std::optional<Result> loaded;
    const auto offer = [&]<class Model>(std::type_identity<Model>) {
        if (!loaded && serves<Model>(properties.type())) loaded.emplace(Model::load(properties, more...));
    };
    (offer(std::type_identity<Models>{}), ...);
    return loaded;
}

}  // namespace plumb::description
