#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "core/interval.h"

// Values as all our JSON writes them: see json.h. For the sources of this folder.
namespace plumb::reports::json_values {

using Json = nlohmann::ordered_json;

inline Json number(double x) {
    if (std::isnan(x)) return nullptr;
    if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
    return x;
}

inline Json interval(const Interval& i) {
    return {{"low", number(i.low)}, {"high", number(i.high)}};
}

/// The text of a value; a byte that is not UTF-8 (a name from outside, say) is replaced: writing must not fail on it.
inline std::string text_of(const Json& json, int indent = -1) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// JSON on one line; '<' occurs in strings only, so that no "</script" or "<!--" can end the element.
inline std::string for_script(const Json& json) {
    std::string text;
    for (const char c : text_of(json)) {
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    }
    return text;
}

}  // namespace plumb::reports::json_values
