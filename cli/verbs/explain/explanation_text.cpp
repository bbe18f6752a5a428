#include "cli/verbs/explain/explanation.h"
#include "cli/verbs/explain/scene_names.h"
#include "integrators/paths/light_start.h"
#include "reports/text/text.h"

namespace plumb::cli {
namespace {

std::string text(const Vec3& v) {
    return fmt::format("({:.5g}, {:.5g}, {:.5g})", v.x, v.y, v.z);
}
std::string text(const Spectrum& s) {
    return fmt::format("{:.6g} {:.6g} {:.6g}", s[0], s[1], s[2]);
}
std::string text(const Strategy& strategy) {
    return fmt::format("({}, {})", strategy.s, strategy.t);
}

std::string text(const PathStory::Scattering& s) {
    std::string said = fmt::format("    leaves along {}, {} {:.5g}, eta {:.5g}, throughput {}\n", text(s.direction),
                                   s.measure == Measure::discrete ? "probability" : "pdf per steradian", s.pdf, s.eta,
                                   text(s.throughput));
    if (s.survival != 1 || !s.survived)
        said += fmt::format("    roulette: survives with {:.5g}, {}\n", s.survival,
                            s.survived ? "and does; throughput " + text(s.throughput / s.survival) : "and does not");
    return said;
}

// The vertices of a subpath, numbered from `first` on as their slots are.
std::string vertices_text(const ExplainedSample& sample, const std::vector<PathVertex>& vertices, int first) {
    std::string said;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const PathVertex& v = vertices[i];
        said += fmt::format("{:>3} {}, {} {}\n", i + 1, name_of_shape(sample.scene.scene, v.hit.shape).text(),
                            name_of_bsdf(v.bsdf), name_of_material(sample.scene.scene, v.hit.shape).text());
        said += fmt::format("    at {}, distance {:.6g}, wo {}\n", text(v.hit.point.position), v.hit.t, text(v.wo));
        said += fmt::format("    normal {}, shading normal {}\n", text(v.hit.point.normal), text(v.frame.z));
        for (const PathStory::Scattering& s : sample.told.story.scatterings)
            if (s.vertex == first + static_cast<int>(i) + 1) said += text(s);
    }
    return said;
}

std::string light_text(const ExplainedSample& sample) {
    const auto& start = sample.told.story.light_ray;
    if (!start) return "";
    const auto& [ray, light, chance] = *start;
    return fmt::format(
        "{}: chosen with {:.5g}, from {} along {}\n    pdf per area {:.5g}, per steradian {:.5g}, flux {}\n",
        name_of_light(sample.scene.scene, light).text(), chance, text(ray.origin), text(ray.direction), ray.pdf.area,
        ray.pdf.direction, text(ray.weight));
}

// Light that was found, or looked for in vain; its factors multiply up to the splats.
std::string findings_text(const ExplainedSample& sample) {
    std::vector<std::vector<std::string>> rows;
    for (const PathStory::Finding& f : sample.told.story.findings) {
        const auto density = [](double pdf) { return pdf > 0 ? reports::readable(pdf) : ""; };
        rows.push_back({text(f.strategy), is_black(f.value()) ? "hidden" : fmt::format("{}", f.splat + 1),
                        density(f.pdf), density(f.rival), fmt::format("{:.6g}", f.weight), text(f.throughput),
                        text(f.light), f.source ? name_of_light(sample.scene.scene, *f.source).text() : ""});
    }
    if (rows.empty()) return "no light was found\n";
    return reports::table({{"(s, t)"},
                           {"splat", reports::Align::right},
                           {"pdf", reports::Align::right},
                           {"rival's", reports::Align::right},
                           {"weight", reports::Align::right},
                           {"throughput"},
                           {"light"},
                           {"of"}},
                          rows, 160);
}

std::string splats_text(const ExplainedSample& sample) {
    std::string said;
    const std::vector<Splat>& splats = sample.told.record.splats;
    for (std::size_t i = 0; i < splats.size(); ++i) {
        const Splat& s = splats[i];
        const auto strategy = sample.told.strategy_of(i);
        said += fmt::format("splat {} at film ({:.6g}, {:.6g}): {} {}{}, {}{}\n", i + 1, s.film[0], s.film[1], s.edges,
                            s.edges == 1 ? "edge" : "edges", strategy ? ", " + text(*strategy) : "", text(s.value),
                            s.anywhere ? " for every pixel whose filter reaches it" : "");
    }
    return said;
}

std::string weight_text(double weight) {
    if (weight == 0) return "does not take the sample; what follows counts nothing";
    return weight == 1 ? "takes the sample as it is" : fmt::format("takes the sample with the weight {:.6g}", weight);
}

}  // namespace

std::string explanation_text(const ExplainedSample& sample) {
    const auto& [scene, method, settings, x, y, index, told] = sample;
    std::string said =
        fmt::format("{}, {}: pixel {},{}, sample {} of {}, {}, seed {}\n", scene.asked, method.integrator, x, y, index,
                    sample.samples_per_pixel(), method.sampler, told.key.seed);
    said += fmt::format("driver {}: {}\n", method.driver, weight_text(told.weight));
    said += fmt::format("sensor: film ({:.6g}, {:.6g}), from {} along {}\n", told.start.film[0], told.start.film[1],
                        text(told.start.ray.origin), text(told.start.ray.direction));
    said += vertices_text(sample, told.record.vertices, 0);
    said += light_text(sample);
    said += vertices_text(sample, told.record.light_vertices, first_light_vertex);
    said += findings_text(sample) + splats_text(sample);
    said += fmt::format("adds to the pixel: {:.9g} {:.9g} {:.9g}\n", told.value[0], told.value[1], told.value[2]);
    if (!told.splatted.empty())
        said += fmt::format("splats add to {} pixels: {}\n", told.splatted.size(), text(told.sum() - told.value));
    return said;
}

}  // namespace plumb::cli
