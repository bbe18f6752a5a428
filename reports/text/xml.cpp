#include "reports/text/xml.h"

#include <algorithm>

namespace plumb::reports {
namespace {

bool allowed_in_xml(unsigned code) {
    if (code < 0x20) return code == '\t' || code == '\n';
    const bool surrogate = code >= 0xD800 && code < 0xE000;
    return !surrogate && code != 0xFFFE && code != 0xFFFF && code < 0x110000;
}

/// The bytes of the UTF-8 code point that text begins with; 0 when it is not one that XML 1.0 allows.
std::size_t xml_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const unsigned first = byte(0);
    if (first < 0x80) return allowed_in_xml(first) ? 1 : 0;
    if (first < 0xC0) return 0;
    const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    unsigned code = first & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return 0;
        code = code << 6 | (byte(i) & 0x3F);
    }
    const bool shortest = code >= (length == 4 ? 0x10000U : length == 3 ? 0x800U : 0x80U);
    return shortest && first < 0xF8 && allowed_in_xml(code) ? length : 0;
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string safe;
    while (!text.empty()) {
        const std::size_t length = xml_character(text);
        switch (length == 1 ? text.front() : '\0') {
            case '&': safe += "&amp;"; break;
            case '<': safe += "&lt;"; break;
            case '>': safe += "&gt;"; break;
            case '"': safe += "&quot;"; break;
            case '\'': safe += "&apos;"; break;
            case '\n': safe += "&#10;"; break;
            case '\t': safe += "&#9;"; break;
            default: safe += length ? text.substr(0, length) : "\uFFFD";
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return safe;
}

}  // namespace plumb::reports
