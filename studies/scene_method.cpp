#include "studies/scene_method.h"

#include <fmt/format.h>

namespace plumb {

SceneMethod scene_method(const std::string& id) {
    const std::size_t plus = id.find('+');
    RenderMethod render{.integrator = id.substr(0, plus)};
    if (plus != std::string::npos) render.sampler = id.substr(plus + 1);
    return {id, resolved(render)};
}

std::string in_words(const SceneMethod& method) {
    std::string words = fmt::format("{}, {}", method.render.integrator, method.render.sampler);
    for (const auto& [name, value] : method.render.parameters) words += fmt::format(", {}={}", name, value);
    return words;
}

}  // namespace plumb
