#include <nlohmann/json.hpp>

#include "cli/verbs/explain/explanation.h"
#include "cli/verbs/explain/scene_names.h"
#include "integrators/paths/light_start.h"
#include "reports/text/json_values.h"

namespace plumb::cli {
namespace {

using reports::json_values::Json, reports::json_values::number;

Json to(const Vec3& v) {
    return {number(v.x), number(v.y), number(v.z)};
}
Json to(const Point<2>& p) {
    return {number(p[0]), number(p[1])};
}
Json to(const Spectrum& s) {
    return {number(s[0]), number(s[1]), number(s[2])};
}
Json to(const SceneName& name) {
    return {{"index", name.index}, {"id", name.id}, {"file", name.place.file}, {"line", name.place.line}};
}
Json to(const Strategy& strategy) {
    return {{"s", strategy.s}, {"t", strategy.t}};
}

Json to(const PathStory::Scattering& s) {
    return {{"direction", to(s.direction)},
            {"pdf", number(s.pdf)},
            {"measure", s.measure == Measure::discrete ? "discrete" : "solid angle"},
            {"eta", s.eta},
            {"throughput", to(s.throughput)},
            {"survival", s.survival},
            {"survived", s.survived}};
}

Json vertices(const ExplainedSample& sample, const std::vector<PathVertex>& of, int first) {
    Json list = Json::array();
    for (std::size_t i = 0; i < of.size(); ++i) {
        const PathVertex& v = of[i];
        Json vertex{{"shape", to(name_of_shape(sample.scene.scene, v.hit.shape))},
                    {"material", to(name_of_material(sample.scene.scene, v.hit.shape))},
                    {"bsdf", name_of_bsdf(v.bsdf)},
                    {"position", to(v.hit.point.position)},
                    {"distance", v.hit.t},
                    {"normal", to(v.hit.point.normal)},
                    {"shading_normal", to(v.frame.z)},
                    {"wo", to(v.wo)},
                    {"scattering", nullptr}};
        for (const PathStory::Scattering& s : sample.told.story.scatterings)
            if (s.vertex == first + static_cast<int>(i) + 1) vertex["scattering"] = to(s);
        list.push_back(vertex);
    }
    return list;
}

Json light(const ExplainedSample& sample) {
    const auto& start = sample.told.story.light_ray;
    if (!start) return nullptr;
    const auto& [ray, index, chance] = *start;
    return {{"light", to(name_of_light(sample.scene.scene, index))},
            {"chance", chance},
            {"origin", to(ray.origin)},
            {"direction", to(ray.direction)},
            {"pdf_area", number(ray.pdf.area)},
            {"pdf_direction", number(ray.pdf.direction)},
            {"flux", to(ray.weight)}};
}

Json findings(const ExplainedSample& sample) {
    Json list = Json::array();
    for (const PathStory::Finding& f : sample.told.story.findings) {
        Json found = to(f.strategy);
        found["light"] = f.source ? to(name_of_light(sample.scene.scene, *f.source)) : Json(nullptr);
        found["throughput"] = to(f.throughput);
        found["value"] = to(f.light);
        found["weight"] = f.weight;
        found["pdf"] = f.pdf > 0 ? number(f.pdf) : Json(nullptr);
        found["rival_pdf"] = f.rival > 0 ? number(f.rival) : Json(nullptr);
        found["splat"] = is_black(f.value()) ? Json(nullptr) : Json(f.splat);
        list.push_back(found);
    }
    return list;
}

Json splats(const Explanation& told) {
    Json list = Json::array();
    for (std::size_t i = 0; i < told.record.splats.size(); ++i) {
        const Splat& s = told.record.splats[i];
        const auto strategy = told.strategy_of(i);
        list.push_back({{"film", to(s.film)},
                        {"value", to(s.value)},
                        {"edges", s.edges},
                        {"strategy", strategy ? to(*strategy) : Json(nullptr)},
                        {"anywhere", s.anywhere}});
    }
    return list;
}

}  // namespace

std::string explanation_json(const ExplainedSample& sample) {
    const Explanation& told = sample.told;
    Json splatted = Json::array();
    for (const auto& [x, y, value] : told.splatted) splatted.push_back({{"x", x}, {"y", y}, {"value", to(value)}});
    const Json json{{"scene", sample.scene.asked},
                    {"scene_hash", sample.scene.hash()},
                    {"integrator", sample.method.integrator},
                    {"driver", sample.method.driver},
                    {"sampler", sample.method.sampler},
                    {"parameters", sample.method.parameters},
                    {"seed", told.key.seed},
                    {"spp", sample.samples_per_pixel()},
                    {"x", sample.x},
                    {"y", sample.y},
                    {"sample", sample.index},
                    {"driver_weight", number(told.weight)},
                    {"film", to(told.start.film)},
                    {"origin", to(told.start.ray.origin)},
                    {"direction", to(told.start.ray.direction)},
                    {"vertices", vertices(sample, told.record.vertices, 0)},
                    {"light", light(sample)},
                    {"light_vertices", vertices(sample, told.record.light_vertices, first_light_vertex)},
                    {"found", findings(sample)},
                    {"splats", splats(told)},
                    {"splatted", splatted},
                    {"value", to(told.value)}};
    return json.dump(2) + '\n';
}

}  // namespace plumb::cli
