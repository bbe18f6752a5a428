#include "core/parameters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "core/error.h"
#include "core/numbers.h"

namespace plumb {

namespace {

using Value = std::variant<std::int64_t, double, bool, std::string>;

template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};

template <class Number>
std::optional<Number> number_in(const std::string& text, Number least, Number most) {
    const auto value = number_of<Number>(text);
    return value && *value >= least && *value <= most ? value : std::nullopt;
}

// The value that the text says; empty for what is not accepted.
std::optional<Value> parsed(const Parameter& parameter, const std::string& text) {
    const auto as_value = [](const auto& found) { return found ? std::optional<Value>(*found) : std::nullopt; };
    return std::visit(
        Overloaded{[&](const Parameter::Integer& kind) { return as_value(number_in(text, kind.least, kind.most)); },
                   [&](const Parameter::Real& kind) { return as_value(number_in(text, kind.least, kind.most)); },
                   [&](const Parameter::Flag&) {
                       return text == "yes" || text == "no" ? std::optional<Value>(text == "yes") : std::nullopt;
                   },
                   [&](const Parameter::Choice& kind) {
                       return std::ranges::count(kind.of, text) > 0 ? std::optional<Value>(text) : std::nullopt;
                   }},
        parameter.kind);
}

std::string text_of(const Value& value) {
    return std::visit(Overloaded{[](bool flag) { return std::string(flag ? "yes" : "no"); },
                                 [](const auto& other) { return fmt::format("{}", other); }},
                      value);
}

Value usual_value(const Parameter& parameter) {
    return std::visit([](const auto& kind) { return Value(kind.usual); }, parameter.kind);
}

}  // namespace

std::string accepted_by(const Parameter& parameter) {
    const auto range = [](const auto& kind) { return fmt::format("{} to {}", kind.least, kind.most); };
    return std::visit(Overloaded{[](const Parameter::Flag&) { return std::string("yes or no"); },
                                 [](const Parameter::Choice& kind) {
                                     const std::vector<std::string> first(kind.of.begin(), kind.of.end() - 1);
                                     return first.empty()
                                                ? kind.of.back()
                                                : fmt::format("{} or {}", fmt::join(first, ", "), kind.of.back());
                                 },
                                 range},
                      parameter.kind);
}

std::string usual_of(const Parameter& parameter) {
    return text_of(usual_value(parameter));
}

std::pair<std::string, std::string> parse_parameter(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        throw Error(fmt::format("parameter '{}': accepted is name=value", text));
    return {text.substr(0, equals), text.substr(equals + 1)};
}

void require_known(const ParameterTexts& given, const std::vector<Parameter>& known) {
    std::vector<std::string> names;
    for (const Parameter& parameter : known) names.push_back(parameter.name);
    for (const auto& [name, text] : given) {
        if (std::ranges::count(names, name) > 0) continue;
        if (names.empty()) throw Error(fmt::format("parameter '{}': none is accepted here", name));
        throw unknown_name("parameter", name, names);
    }
}

Parameters::Parameters(const std::vector<Parameter>& accepted, const ParameterTexts& given) {
    for (const Parameter& parameter : accepted) {
        const auto text = given.find(parameter.name);
        if (text == given.end()) {
            values_[parameter.name] = {usual_value(parameter)};
            continue;
        }
        const auto value = parsed(parameter, text->second);
        if (!value)
            throw Error(fmt::format("parameter {} is '{}'; accepted are {}", parameter.name, text->second,
                                    accepted_by(parameter)));
        values_[parameter.name] = {*value, true};
    }
}

bool Parameters::given(std::string_view name) const {
    const auto found = values_.find(name);
    return found != values_.end() && found->second.given;
}

ParameterTexts Parameters::texts() const {
    ParameterTexts texts;
    for (const auto& [name, entry] : values_) texts[name] = text_of(entry.value);
    return texts;
}

template <class T>
const T& Parameters::get(std::string_view name) const {
    const auto found = values_.find(name);
    const T* value = found == values_.end() ? nullptr : std::get_if<T>(&found->second.value);
    if (!value) throw std::logic_error(fmt::format("parameter {} is not declared, or of another kind", name));
    return *value;
}
template const std::int64_t& Parameters::get(std::string_view) const;
template const double& Parameters::get(std::string_view) const;
template const bool& Parameters::get(std::string_view) const;
template const std::string& Parameters::get(std::string_view) const;

}  // namespace plumb
