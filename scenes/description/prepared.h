#pragma once

#include <variant>

namespace plumb::description {

/// The thing that a renderer asks in place of a model: what the model makes of itself once a scene (a picture read, a
/// table computed), or the model as it stands.
template <class Model>
auto prepared(const Model& model) {
    if constexpr (requires { model.prepared(); })
        return model.prepared();
    else
        return model;
}

template <class... Models>
auto prepared(const std::variant<Models...>& model) {
    using Result = std::variant<decltype(prepared(std::declval<const Models&>()))...>;
    return std::visit([](const auto& one) { return Result(prepared(one)); }, model);
}
template <class Variant>
using Prepared = decltype(prepared(std::declval<const Variant&>()));

}  // namespace plumb::description
