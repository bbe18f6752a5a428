#include "integrators/references/provenance.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "core/error.h"
#include "integrators/integrators.h"

namespace plumb {
namespace {

// Numbers with marks between them, as in 128x96 or 0,0,128,96.
class Attributes {
public:
    Attributes(const Image& image, const std::string& file) : image_(image), file_(file) {}

    [[nodiscard]] std::string text(const std::string& key) const {
        const auto found = image_.metadata.find(key);
        return found == image_.metadata.end() ? "" : found->second;
    }
    template <class Number, std::size_t N>
    [[nodiscard]] std::array<Number, N> numbers(const std::string& key) const {
        std::array<Number, N> values{};
        const std::string all = text(key);
        const char *at = all.data(), *const end = at + all.size();
        for (std::size_t i = 0; i < N; ++i) {
            const auto [next, failure] = std::from_chars(at, end, values[i]);
            if (failure != std::errc() || (next == end) != (i + 1 == N))
                throw Error(fmt::format("{}: attribute {} is '{}' where {} number{} expected", file_, key, all, N,
                                        N == 1 ? " is" : "s are"));
            at = next + (i + 1 < N ? 1 : 0);
        }
        return values;
    }
    template <class Number>
    void read(const std::string& key, Number& value) const {
        if (!text(key).empty()) value = numbers<Number, 1>(key)[0];
    }

private:
    const Image& image_;
    const std::string& file_;
};

constexpr const char* program = "Plumb ";

// name=value,name=value: no value has a comma.
std::string text_of(const ParameterTexts& parameters) {
    std::string all;
    for (const auto& [name, value] : parameters) all += fmt::format("{}{}={}", all.empty() ? "" : ",", name, value);
    return all;
}

ParameterTexts parameters_in(std::string_view text) {
    ParameterTexts parameters;
    while (!text.empty()) {
        const std::string_view one = text.substr(0, text.find(','));
        parameters.insert(parse_parameter(std::string(one)));
        text.remove_prefix(std::min(text.size(), one.size() + 1));
    }
    return parameters;
}

// One that this program does not know is taken for an integrator of all light.
Makes makes_of(const std::string& integrator) {
    const NamedIntegrator* known = known_integrator(integrator);
    return known ? known->makes : Makes{};
}

}  // namespace

bool Provenance::is_radiance() const {
    return makes_of(integrator).radiance && limits.length == 0 && !limits.strategy;
}

std::optional<int> Provenance::longest_path() const {
    if (const std::optional<int> longest = makes_of(integrator).longest) return longest;
    return limits.max_edges < 0 ? std::nullopt : std::optional(limits.max_edges);
}

std::optional<int> longest_path_of(const Provenance& provenance, const std::string& file) {
    if (!provenance.is_radiance())
        throw Error(fmt::format("{}: an image of `{}`, or of one strategy or length, is not all light of a scene", file,
                                provenance.integrator));
    return provenance.longest_path();
}

void require_same_scene(const Provenance& said, const Provenance& scene, const std::string& file) {
    if (said.scene_hash != scene.scene_hash)
        throw Error(fmt::format("{}: is of another scene than {}, or of another version of it: hash {}, not {}", file,
                                scene.scene, said.scene_hash, scene.scene_hash));
}

std::map<std::string, std::string> metadata_of(const Provenance& p) {
    std::map<std::string, std::string> metadata{
        {"plumb:scene", p.scene},
        {"plumb:scene_hash", p.scene_hash},
        {"plumb:integrator", p.integrator},
        {"plumb:driver", p.driver},
        {"plumb:sampler", p.sampler},
        {"plumb:max_depth", fmt::format("{}", p.limits.max_edges)},
        {"plumb:rr_depth", fmt::format("{}", p.limits.roulette_edges)},
        {"plumb:seed", fmt::format("{}", p.seed)},
        {"plumb:spp", fmt::format("{}", p.samples_per_pixel)},
        {"plumb:replicates", fmt::format("{}", p.replicates)},
        {"plumb:film", fmt::format("{}x{}", p.film.width, p.film.height)},
        {"plumb:crop", fmt::format("{},{},{},{}", p.crop.x, p.crop.y, p.crop.width, p.crop.height)},
        {"Software", program + p.version}};
    if (!p.parameters.empty()) metadata["plumb:parameters"] = text_of(p.parameters);
    if (p.limits.length > 0) metadata["plumb:length"] = fmt::format("{}", p.limits.length);
    if (p.limits.strategy)
        metadata["plumb:strategy"] = fmt::format("{},{}", p.limits.strategy->s, p.limits.strategy->t);
    return metadata;
}

std::map<std::string, std::string> metadata_of(const FilmError& error) {
    return {{"plumb:error", fmt::format("{}", error.relative)},
            {"plumb:rmse", fmt::format("{}", error.rmse)},
            {"plumb:error_of_means", fmt::format("{}", fmt::join(error.of_means, " "))}};
}

std::optional<Provenance> provenance_of(const Image& image, const std::string& file) {
    const Attributes from(image, file);
    if (from.text("plumb:scene_hash").empty()) return {};
    Provenance p{.scene = from.text("plumb:scene"),
                 .scene_hash = from.text("plumb:scene_hash"),
                 .integrator = from.text("plumb:integrator"),
                 .sampler = from.text("plumb:sampler"),
                 .version = from.text("Software")};
    if (p.version.starts_with(program)) p.version.erase(0, std::string(program).size());
    if (const std::string driver = from.text("plumb:driver"); !driver.empty()) p.driver = driver;
    p.parameters = parameters_in(from.text("plumb:parameters"));
    from.read("plumb:max_depth", p.limits.max_edges);
    from.read("plumb:rr_depth", p.limits.roulette_edges);
    from.read("plumb:length", p.limits.length);
    from.read("plumb:seed", p.seed);
    from.read("plumb:spp", p.samples_per_pixel);
    from.read("plumb:replicates", p.replicates);
    from.read("plumb:error", p.error.relative);
    from.read("plumb:rmse", p.error.rmse);
    if (!from.text("plumb:strategy").empty()) {
        const auto [s, t] = from.numbers<int, 2>("plumb:strategy");
        p.limits.strategy = Strategy{s, t};
    }
    const auto [width, height] = from.numbers<int, 2>("plumb:film");
    p.film = {width, height};
    const auto [x, y, crop_width, crop_height] = from.numbers<int, 4>("plumb:crop");
    p.crop = {x, y, crop_width, crop_height};
    return p;
}

}  // namespace plumb
