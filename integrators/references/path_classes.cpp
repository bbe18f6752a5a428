#include "integrators/references/path_classes.h"

#include <algorithm>

namespace plumb {

using Source = PathClass::Source;

namespace {

// Whether the light can be hit, and whether it can be sampled from the last vertex.
bool met(const PathClass& path) {
    return path.source != Source::point;
}
bool sampled(const PathClass& path) {
    return !path.mirrors.empty() && !path.mirrors.back();
}

}  // namespace

std::string to_string(const PathClass& path) {
    std::string name = "E";
    for (const bool mirror : path.mirrors) name += mirror ? 'S' : 'D';
    return name + (path.source == Source::surface ? 'L' : path.source == Source::point ? 'P' : 'V');
}

std::vector<PathClass> path_classes(const Scene& scene, int edges) {
    Scatters some;
    for (const description::Material& material : scene.description().materials) {
        const Scatters one = std::visit([](const auto& kind) { return kind.scatters(); }, material.kind);
        some = {some.smoothly || one.smoothly, some.by_mirror || one.by_mirror};
    }
    std::vector<Source> sources;
    for (const Light& light : scene.lights())
        if (!std::ranges::count(sources, kind_of(light))) sources.push_back(kind_of(light));
    std::vector<PathClass> classes;
    for (unsigned bits = 0; bits < 1u << (edges - 1); ++bits) {
        std::vector<bool> mirrors;
        for (int i = 0; i < edges - 1; ++i) mirrors.push_back(bits >> i & 1);
        if (!some.smoothly && std::ranges::count(mirrors, false)) continue;
        if (!some.by_mirror && std::ranges::count(mirrors, true)) continue;
        for (const Source source : sources) classes.push_back({mirrors, source});
    }
    return classes;
}

bool path_makes(const PathClass& path) {
    return met(path) || sampled(path);
}

bool light_makes(const PathClass& path) {
    return path.mirrors.empty() ? met(path) : !path.mirrors.front();
}

bool bdpt_makes(const PathClass& path) {
    const auto two = std::ranges::adjacent_find(path.mirrors, [](bool a, bool b) { return !a && !b; });
    return path_makes(path) || light_makes(path) || two != path.mirrors.end();
}

bool direct_makes(const PathClass& path) {
    return path.edges() <= 2 && path_makes(path);
}

bool direct_bsdf_makes(const PathClass& path) {
    return path.edges() <= 2 && met(path);
}

bool direct_emitters_makes(const PathClass& path) {
    return path.edges() <= 2 && (path.mirrors.empty() ? met(path) : sampled(path));
}

std::vector<PathClass> left_out(MakesPath makes, const Scene& scene, int most_edges) {
    std::vector<PathClass> classes;
    for (int edges = 1; edges <= most_edges; ++edges)
        std::ranges::copy_if(path_classes(scene, edges), std::back_inserter(classes),
                             [&](const PathClass& path) { return bdpt_makes(path) && !makes(path); });
    return classes;
}

}  // namespace plumb
