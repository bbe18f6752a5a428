#include "scenes/mitsuba/plugins.h"

#include <algorithm>

#include "core/error.h"
#include "scenes/description.h"

namespace plumb {

namespace {

using description::Types;

template <class... Models>
void add(std::vector<Plugin>& plugins, const std::string& kind, Types<Models...> models) {
    for_each_type(models, [&]<class Model>(std::type_identity<Model>) {
        for (const auto& [name, summary] : Model::plugins)
            plugins.push_back({kind, std::string(name), std::string(summary)});
    });
}

std::vector<Plugin> plugins_of_all_lists() {
    std::vector<Plugin> all;
    add(all, "bsdf", description::MaterialModels{});
    add(all, "emitter", Types<description::AreaEmitter>{});
    add(all, "emitter", description::EmitterModels{});
    add(all, "film", Types<description::Film>{});
    add(all, "rfilter", FilterModels{});
    add(all, "sensor", description::SensorModels{});
    add(all, "shape", description::ShapeModels{});
    add(all, "texture", description::TextureModels{});
    std::ranges::sort(all, {}, [](const Plugin& plugin) { return std::tie(plugin.kind, plugin.name); });
    return all;
}

}  // namespace

const std::vector<Plugin>& known_plugins() {
    static const std::vector<Plugin> all = plugins_of_all_lists();
    return all;
}

std::vector<std::string> plugin_names(const std::string& kind) {
    std::vector<std::string> names;
    for (const Plugin& plugin : known_plugins())
        if (plugin.kind == kind) names.push_back(plugin.name);
    if (names.empty()) throw Error(fmt::format("no plugins of the kind '{}'", kind));
    return names;
}

}  // namespace plumb
