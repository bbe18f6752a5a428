#include "reports/images/comparison.h"

#include <bit>
#include <cstring>

#include "reports/page/page_files.h"
#include "reports/page/page_template.h"
#include "reports/text/json_values.h"
#include "reports/text/xml.h"

namespace plumb::reports {
namespace {

using json_values::Json, json_values::number, json_values::interval, json_values::for_script;

// ---- what was found

Json to(const MeanDifference& d) {
    return {{"a", number(d.a)},
            {"b", number(d.b)},
            {"difference", number(d.difference)},
            {"standard_error", number(d.standard_error)},
            {"degrees", number(d.degrees)},
            {"skewness", number(d.skewness)},
            {"z", number(d.z)},
            {"p_value", number(d.p_value)},
            {"delta", number(d.delta)},
            {"more_samples", number(d.more_samples)},
            {"low", number(d.interval.low)},
            {"high", number(d.interval.high)}};
}

Json to(const TileTest& tile, const ImageComparison& found) {
    Json json = {{"x", tile.box.x},
                 {"y", tile.box.y},
                 {"width", tile.box.width},
                 {"height", tile.box.height},
                 {"channel", found.channels[tile.channel].channel},
                 {"pixels", tile.pixels},
                 {"state", to_string(tile.state)}};
    json.update(to(tile.found));
    return json;
}

Json to(const ChannelTest& channel) {
    return {{"channel", channel.channel},        {"state", to_string(channel.state)},
            {"mean", to(channel.mean)},          {"chi_square", number(channel.chi_square)},
            {"degrees", channel.degrees},        {"upper_p", number(channel.upper_p)},
            {"lower_p", number(channel.lower_p)}};
}

Json to(const SquaresTest& test) {
    return {{"ratio", number(test.ratio)}, {"p_value", number(test.p_value)}};
}

Json to(const ErrorMeasure& error) {
    Json json = {{"name", error.name}, {"value", number(error.value)}};
    json.update(interval(error.interval));
    return json;
}

template <class T>
Json list(const std::vector<T>& things) {
    Json json = Json::array();
    for (const T& thing : things) json.push_back(to(thing));
    return json;
}

Json side(const std::vector<std::string>& files, const Picture& picture) {
    return {{"files", files}, {"degrees", number(picture.degrees)}, {"bad_pixels", picture.bad_pixels}};
}

Json document(const ComparisonReport& report) {
    const ImageComparison& found = report.found;
    const ComparisonSettings& s = report.settings;
    Json tiles = Json::array();
    for (const TileTest& tile : found.tiles) tiles.push_back(to(tile, found));
    return {{"outcome", to_string(found.verdict.outcome)},
            {"reason", found.verdict.reason},
            {"error_known", found.error_known},
            {"a", side(report.files_a, report.a)},
            {"b", side(report.files_b, report.b)},
            {"width", report.a.width},
            {"height", report.a.height},
            {"settings",
             {{"alpha", s.alpha},
              {"beta", s.beta},
              {"delta", s.delta},
              {"tile_delta", s.tile_delta},
              {"tile_floor", s.tile_floor},
              {"epsilon", s.epsilon},
              {"tile", found.tile}}},
            {"channels", list(found.channels)},
            {"alike", to(found.alike)},
            {"unlike", to(found.unlike)},
            {"copies", found.copies},
            {"correlation",
             {{"reach", found.correlation.reach},
              {"inflation", number(found.correlation.inflation)},
              {"resolution", number(found.correlation.resolution)}}},
            {"errors", list(found.errors)},
            {"differing", found.differing},
            {"undecided", found.undecided},
            {"tiles", std::move(tiles)}};
}

// ---- pixels

std::string base64(const std::vector<unsigned char>& bytes) {
    constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve(bytes.size() / 3 * 4 + 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
        const unsigned block = unsigned{bytes[i]} << 16 | (left > 1 ? unsigned{bytes[i + 1]} << 8 : 0u) |
                               (left > 2 ? unsigned{bytes[i + 2]} : 0u);
        for (unsigned k = 0; k < 4; ++k) text += k <= left ? digits[block >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

static_assert(std::endian::native == std::endian::little);

std::string floats(const std::vector<double>& values) {
    std::vector<unsigned char> bytes(4 * values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto value = static_cast<float>(values[i]);
        std::memcpy(&bytes[4 * i], &value, 4);
    }
    return base64(bytes);
}

// Standard deviations of a − b, 0 where they are unknown, as the upper halves of floats: relative error below 2^-8,
// enough for a map.
std::string deviations(const Picture& a, const Picture& b) {
    std::vector<unsigned char> bytes(2 * a.variance.size());
    for (std::size_t i = 0; i < a.variance.size(); ++i) {
        const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(std::sqrt(a.variance[i] + b.variance[i])));
        const auto upper = static_cast<std::uint16_t>(bits >> 16);
        std::memcpy(&bytes[2 * i], &upper, 2);
    }
    return base64(bytes);
}

}  // namespace

std::string comparison_json(const ComparisonReport& report) {
    return document(report).dump(2) + "\n";
}

std::string comparison_html(const ComparisonReport& report) {
    Json data = document(report);
    data["pixels"] = {{"channels", report.a.channels},
                      {"a", floats(report.a.mean)},
                      {"b", floats(report.b.mean)},
                      {"deviation", deviations(report.a, report.b)}};
    const std::string title = escaped("Plumb: comparison " + to_string(report.found.verdict.outcome)),
                      text = for_script(data);
    return filled(
        page::comparison_document(),
        {{"title", title}, {"style", page::comparison_style()}, {"data", text}, {"script", page::comparison_script()}});
}

}  // namespace plumb::reports
