#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"

#include <toml++/toml.h>

// These functions read TOML with complaints that name file, line, key, what was found and what is accepted. This header
// is for the sources of this folder.
namespace plumb {

/// A value as a complaint quotes it.
inline std::string found(const toml::node& node) {
    if (const auto text = node.value_exact<std::string>()) return fmt::format("'{}'", *text);
    if (const auto number = node.value_exact<std::int64_t>()) return fmt::format("{}", *number);
    if (const auto number = node.value_exact<double>()) return fmt::format("{}", *number);
    if (node.is_array()) return node.as_array()->empty() ? "an empty list" : "a list";
    if (node.is_table()) return "a table";
    return node.is_boolean() ? "true or false" : "a date or time";
}

/// One table of the file. Every complaint names file, line and key.
class Section {
public:
    /// Keys other than the accepted ones are errors.
    Section(const toml::table& table, std::string name, const std::string& file, std::vector<std::string> accepted)
        : table_(table), name_(std::move(name)), file_(file) {
        for (const auto& [key, node] : table_)
            if (std::ranges::find(accepted, key.str()) == accepted.end())
                throw Error(fmt::format("{}:{}: {}", file_, key.source().begin.line,
                                        unknown_name("key", path(key.str()), paths(accepted)).what()));
    }

    [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }

    [[noreturn]] void fail(std::string_view key, std::string_view message) const {
        const toml::node* const node = table_.get(key);
        const auto line = (node ? node->source() : table_.source()).begin.line;
        throw Error(fmt::format("{}:{}: {}: {}", file_, line, path(key), message));
    }

    /// The value that `read` makes of the key's node; its own Errors get the place.
    template <class Read>
    auto read(std::string_view key, const Read& read) const {
        const toml::node* const node = table_.get(key);
        if (!node) fail(key, "is missing");
        try {
            return read(*node);
        } catch (const Error& error) {
            fail(key, error.what());
        }
    }

    [[nodiscard]] std::string text(std::string_view key) const {
        return read(key, [](const toml::node& node) { return value<std::string>(node, "a string"); });
    }
    [[nodiscard]] std::string text(std::string_view key, std::string_view fallback) const {
        return has(key) ? text(key) : std::string(fallback);
    }

    [[nodiscard]] std::uint64_t count(std::string_view key, std::uint64_t least, std::uint64_t most) const {
        return read(key, [&](const toml::node& node) {
            const std::string accepted = fmt::format("an integer from {} to {}", least, most);
            const auto number = value<std::int64_t>(node, accepted);
            if (number < 0 || static_cast<std::uint64_t>(number) < least || static_cast<std::uint64_t>(number) > most)
                throw Error(fmt::format("{} found; {} is accepted", number, accepted));
            return static_cast<std::uint64_t>(number);
        });
    }

    /// The values of a key, one or a list of them, at least one; `convert` may throw Error.
    template <class T, class Convert>
    auto list(std::string_view key, const char* accepted, const Convert& convert) const {
        return read(key, [&](const toml::node& node) {
            std::vector<std::remove_cvref_t<decltype(convert(T{}))>> values;
            if (const toml::array* array = node.as_array())
                for (const toml::node& item : *array) values.push_back(convert(value<T>(item, accepted)));
            else
                values.push_back(convert(value<T>(node, accepted)));
            if (values.empty()) throw Error(fmt::format("an empty list found; at least one is needed"));
            return values;
        });
    }
    [[nodiscard]] std::vector<std::string> names(std::string_view key) const {
        return list<std::string>(key, "a name", std::identity{});
    }
    [[nodiscard]] std::vector<double> numbers(std::string_view key) const {
        return list<double>(key, "a number", std::identity{});
    }

    /// The tables [[key]], in order; none when there is no such key.
    [[nodiscard]] std::vector<const toml::table*> tables(std::string_view key) const {
        std::vector<const toml::table*> list;
        if (!has(key)) return list;
        const toml::array* array = table_.get(key)->as_array();
        if (!array || !array->is_homogeneous<toml::table>())
            fail(key, fmt::format("{} found; tables are accepted, each headed [[{}]]", found(*table_.get(key)), key));
        for (const toml::node& node : *array) list.push_back(node.as_table());
        return list;
    }

private:
    template <class T>
    static T value(const toml::node& node, std::string_view accepted) {
        if (const auto value = node.value<T>(); value && node.is_boolean() == false) return *value;
        throw Error(fmt::format("{} found; {} is accepted", found(node), accepted));
    }

    [[nodiscard]] std::string path(std::string_view key) const {
        return name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
    }
    [[nodiscard]] std::vector<std::string> paths(const std::vector<std::string>& keys) const {
        std::vector<std::string> list;
        for (const std::string& key : keys) list.push_back(path(key));
        return list;
    }

    const toml::table& table_;
    std::string name_, file_;
};

}  // namespace plumb
