#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "core/interval.h"

// Values as all our JSON writes them: see json.h. For the sources of this folder.
namespace plumb::json_values {

using Json = nlohmann::ordered_json;

inline Json number(double x) {
    if (std::isnan(x)) return nullptr;
    if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
    return x;
}

inline Json interval(const Interval& i) {
    return {{"low", number(i.low)}, {"high", number(i.high)}};
}

/// On one line; '<' occurs in strings only, so that no "</script" or "<!--" can end the element.
inline std::string for_script(const Json& json) {
    std::string text;
    for (const char c : json.dump()) {
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    }
    return text;
}

}  // namespace plumb::json_values
