#include "studies/image_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "core/error.h"
#include "core/numbers.h"

namespace plumb {

namespace fs = std::filesystem;

namespace {

struct Pattern {
    std::regex name;
    std::size_t samples = 0, seconds = 0;  // which of the groups; 0: none
};

Error not_a_pattern(const std::string& pattern, const std::string& what) {
    return Error(
        fmt::format("'{}' {}; accepted: a file name with {{spp}}, and where there is more {{seed}} and "
                    "{{seconds}}, as out_{{spp}}_{{seed}}.exr",
                    pattern, what));
}

Pattern parse(const std::string& name, const std::string& whole) {
    Pattern pattern;
    std::string expression;
    std::size_t groups = 0;
    for (std::size_t i = 0; i < name.size(); ++i) {
        if (name[i] != '{') {
            if (!std::isalnum(static_cast<unsigned char>(name[i]))) expression += '\\';
            expression += name[i];
            continue;
        }
        const std::size_t end = std::min(name.find('}', i), name.size());
        const std::string key = name.substr(i + 1, end - i - 1);
        ++groups;
        if (key == "spp" && pattern.samples == 0)
            pattern.samples = groups;
        else if (key == "seconds" && pattern.seconds == 0)
            pattern.seconds = groups;
        else if (key != "seed")
            throw not_a_pattern(whole, fmt::format("has a {{{}}}", key));
        expression += key == "spp" ? "([0-9]+)" : key == "seconds" ? "([0-9.]+)" : "([A-Za-z0-9]+)";
        i = end;
    }
    if (pattern.samples == 0) throw not_a_pattern(whole, "has no {spp}");
    pattern.name = std::regex(expression);
    return pattern;
}

template <class Number>
Number number(const std::string& text, const std::string& file) {
    const auto value = number_of<Number>(text);
    if (!value || !(*value > 0)) throw Error(fmt::format("{}: '{}' in its name is no number above 0", file, text));
    return *value;
}

}  // namespace

std::vector<NamedImage> images_matching(const std::string& pattern) {
    const fs::path path(pattern), folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    const Pattern wanted = parse(path.filename().string(), pattern);
    if (!fs::is_directory(folder)) throw Error(fmt::format("{}: there is no folder {}", pattern, folder.string()));
    std::vector<NamedImage> images;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        std::smatch match;
        if (!entry.is_regular_file() || !std::regex_match(name, match, wanted.name)) continue;
        NamedImage& image = images.emplace_back();
        image.file = path.has_parent_path() ? entry.path() : fs::path(name);
        image.samples = number<std::uint64_t>(match[wanted.samples], name);
        if (wanted.seconds > 0) image.seconds = number<double>(match[wanted.seconds], name);
    }
    if (images.empty()) throw Error(fmt::format("{}: no file matches", pattern));
    std::ranges::sort(images, [](const NamedImage& a, const NamedImage& b) {
        return std::tie(a.samples, a.file) < std::tie(b.samples, b.file);
    });
    return images;
}

}  // namespace plumb
