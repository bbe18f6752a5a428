#include "studies/scene_part.h"

#include <fmt/ranges.h>

#include "core/error.h"
#include "core/numbers.h"
#include "scenes/shipped/shipped.h"

namespace plumb {
namespace {

// x, y, width, height.
std::vector<int> parse_region(const std::string& text) {
    std::vector<int> numbers = parse_integers(text, 2);
    if (numbers.empty())
        numbers = parse_integers(text, 4);
    else
        numbers.insert(numbers.end(), {1, 1});
    if (numbers.empty() || numbers[2] < 1 || numbers[3] < 1)
        throw Error(fmt::format("'{}' is no part of a film; accepted: x,y or x,y,width,height in pixels", text));
    return numbers;
}

}  // namespace

std::optional<ScenePart> scene_part(const std::string& id, LoadedScenes& scenes) {
    const std::size_t colon = id.rfind(':');
    const std::string asked = id.substr(0, colon);
    std::vector<int> n;
    if (colon != std::string::npos) n = parse_region(id.substr(colon + 1));
    if (!find_scene_file(asked)) return {};
    std::shared_ptr<const LoadedScene> scene = scenes.get(asked);
    const FilmSize film = scene->scene.sensor().film();
    if (n.empty()) n = {0, 0, film.width, film.height};
    if (n[0] < 0 || n[1] < 0 || n[2] > film.width - n[0] || n[3] > film.height - n[1])
        throw Error(fmt::format("{}:{}: accepted are pixels of a film of {} x {}", asked, fmt::join(n, ","), film.width,
                                film.height));
    return ScenePart{id, std::move(scene), {n[0], n[1], n[2], n[3]}};
}

}  // namespace plumb
