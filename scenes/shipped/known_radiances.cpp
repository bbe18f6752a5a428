#include "scenes/shipped/known_radiances.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/file.h"

namespace plumb {

namespace {

using Json = nlohmann::json;

/// A value of the file and where it stands, as in `radiances[2].film`.
struct Field {
    const Json& json;
    const std::string& file;
    std::string path;

    [[nodiscard]] Error error(const std::string& message) const {
        return Error(path.empty() ? fmt::format("{}: {}", file, message)
                                  : fmt::format("{}: {}: {}", file, path, message));
    }
    [[nodiscard]] Error expected(const std::string& what) const {
        return error(
            fmt::format("{} where {} is expected", json.dump(-1, ' ', true, Json::error_handler_t::replace), what));
    }
    [[nodiscard]] Field at(const std::string& key) const {
        const auto found = json.find(key);
        if (found == json.end()) throw error(fmt::format("'{}' is missing", key));
        return {*found, file, path.empty() ? key : path + "." + key};
    }
    [[nodiscard]] Field at(std::size_t index) const { return {json[index], file, fmt::format("{}[{}]", path, index)}; }
};

void check_keys(const Field& field, const std::vector<std::string>& accepted) {
    if (!field.json.is_object()) throw field.expected("an object");
    for (const auto& [key, value] : field.json.items()) {
        if (std::ranges::find(accepted, key) == accepted.end())
            throw field.error(unknown_name("field", key, accepted).what());
    }
}

std::string text(const Field& field) {
    if (!field.json.is_string()) throw field.expected("text");
    return field.json.get<std::string>();
}

double number_between(const Field& field, double low, double high) {
    const double value = field.json.is_number() ? field.json.get<double>() : NAN;
    if (!(low <= value && value <= high)) throw field.expected(fmt::format("a number from {} to {}", low, high));
    return value;
}

int whole_number(const Field& field, int low, int high) {
    if (!field.json.is_number_integer()) throw field.expected("a whole number");
    return static_cast<int>(number_between(field, low, high));
}

void check_list(const Field& field, std::size_t size) {
    if (!field.json.is_array() || field.json.size() != size) throw field.expected(fmt::format("a list of {}", size));
}

constexpr double largest = 1e30;

KnownRadiance::Over over(const Field& field) {
    using enum KnownRadiance::Over;
    const std::map<std::string, KnownRadiance::Over> names{
        {"point", point}, {"pixel", pixel}, {"rectangle", rectangle}, {"film", film}};
    const auto found = names.find(text(field));
    if (found == names.end()) throw field.expected(R"("point", "pixel", "rectangle" or "film")");
    return found->second;
}

Point<2> film_point(const Field& field, FilmSize size) {
    check_list(field, 2);
    return {number_between(field.at(std::size_t{0}), 0, size.width),
            number_between(field.at(std::size_t{1}), 0, size.height)};
}

FilmBox box_of(const Field& field, FilmSize size) {
    check_list(field, 4);
    const auto number = [&](std::size_t i, double low, double high) { return number_between(field.at(i), low, high); };
    FilmBox box{number(0, 0, size.width), number(1, 0, size.height)};
    box.width = number(2, 0, size.width - box.x);
    box.height = number(3, 0, size.height - box.y);
    if (!(box.width > 0 && box.height > 0)) throw field.expected("a rectangle of some size");
    return box;
}

/// Where a radiance is known.
void find_place(KnownRadiance& known, const Field& field, FilmSize size) {
    using enum KnownRadiance::Over;
    known.over = over(field.at("over"));
    if (known.over == rectangle) {
        if (field.json.contains("film")) throw field.at("film").error("a rectangle lies where 'rectangle' says");
        known.box = box_of(field.at("rectangle"), size);
    } else if (field.json.contains("rectangle")) {
        throw field.at("rectangle").error("is only for what is known over a \"rectangle\"");
    }
    if (known.over == film) known.box = {0, 0, static_cast<double>(size.width), static_cast<double>(size.height)};
    const bool has_point = known.over == point || known.over == pixel || field.json.contains("film");
    known.film = has_point ? film_point(field.at("film"), size)
                           : Point<2>{known.box.x + known.box.width / 2, known.box.y + known.box.height / 2};
    if (known.over == pixel)
        known.box = {std::fmin(std::floor(known.film[0]), size.width - 1),
                     std::fmin(std::floor(known.film[1]), size.height - 1), 1, 1};
}

KnownRadiance radiance(const Field& field, FilmSize size) {
    check_keys(field, {"film", "over", "rectangle", "edges", "value", "error", "derivation"});
    KnownRadiance known;
    find_place(known, field, size);
    const Field value = field.at("value"), edges = field.at("edges");
    if (!edges.json.is_null()) known.edges = whole_number(edges, 1, 1'000'000);
    check_list(value, 3);
    for (std::size_t i = 0; i < 3; ++i) known.value[i] = number_between(value.at(i), 0, largest);
    known.error = number_between(field.at("error"), 0, largest);
    known.derivation = text(field.at("derivation"));
    return known;
}

Json parsed(const std::string& text, const std::filesystem::path& file) {
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        throw Error(fmt::format("{}:{}: malformed JSON", file.string(), 1 + std::count(text.begin(), end, '\n')));
    }
}

}  // namespace

KnownScene known_radiances(const std::filesystem::path& file) {
    const std::string name = file.string();
    const Json json = parsed(read_file(file), file);
    const Field root{json, name, ""};
    check_keys(root, {"question", "film", "radiances"});
    const Field film = root.at("film"), radiances = root.at("radiances");
    check_list(film, 2);
    KnownScene scene{
        .question = text(root.at("question")),
        .film = {whole_number(film.at(std::size_t{0}), 1, 65536), whole_number(film.at(std::size_t{1}), 1, 65536)},
        .radiances = {}};
    if (!radiances.json.is_array()) throw radiances.expected("a list");
    for (std::size_t i = 0; i < radiances.json.size(); ++i)
        scene.radiances.push_back(radiance(radiances.at(i), scene.film));
    return scene;
}

}  // namespace plumb
