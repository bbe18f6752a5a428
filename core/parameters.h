#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace plumb {

/// A setting that a method takes by name, with its default and what is accepted (both ends count).
struct Parameter {
    struct Integer {
        std::int64_t usual, least, most;
    };
    struct Real {
        double usual, least, most;
    };
    struct Flag {
        bool usual;
    };
    struct Choice {
        std::string usual;
        std::vector<std::string> of;
    };
    std::string name, summary;
    std::variant<Integer, Real, Flag, Choice> kind;
};

/// The accepted values as text: "0 to 30000", "0.01 to 1", "yes or no", "a, b or c".
std::string accepted_by(const Parameter& parameter);
/// The default, as a user would type it.
std::string usual_of(const Parameter& parameter);

/// The parameters that a user typed: name=value.
using ParameterTexts = std::map<std::string, std::string>;

/// The name and the value of name=value. Throws Error for another text.
std::pair<std::string, std::string> parse_parameter(const std::string& text);

/// Throws Error naming the nearest where a name is none of these parameters'.
void require_known(const ParameterTexts& given, const std::vector<Parameter>& known);

/// The values of a method's parameters: given, or the defaults. Names that are none of its parameters' are for others.
class Parameters {
public:
    /// Throws Error for a text that is no value of its parameter, saying what is accepted.
    explicit Parameters(const std::vector<Parameter>& accepted, const ParameterTexts& given = {});

    /// The value of a parameter that is declared, as of this kind: anything else is a mistake in the program
    /// (std::logic_error).
    [[nodiscard]] std::int64_t integer(std::string_view name) const { return get<std::int64_t>(name); }
    [[nodiscard]] double real(std::string_view name) const { return get<double>(name); }
    [[nodiscard]] bool flag(std::string_view name) const { return get<bool>(name); }
    [[nodiscard]] const std::string& choice(std::string_view name) const { return get<std::string>(name); }
    /// Whether the user gave it.
    [[nodiscard]] bool given(std::string_view name) const;

    /// All values as text in one form, by name: what a picture's metadata record.
    [[nodiscard]] ParameterTexts texts() const;

private:
    using Value = std::variant<std::int64_t, double, bool, std::string>;
    struct Entry {
        Value value;
        bool given = false;
    };
    template <class T>
    [[nodiscard]] const T& get(std::string_view name) const;

    std::map<std::string, Entry, std::less<>> values_;
};

}  // namespace plumb
