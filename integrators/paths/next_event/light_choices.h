#pragma once

#include <memory>
#include <string>
#include <vector>

#include "integrators/paths/next_event/light_choice.h"

namespace plumb {

/// The scene's own choice, half in proportion to what lights emit and half alike, whatever the vertex.
std::shared_ptr<const LightChoice> choice_by_power();
/// The choice of all lights with equal probabilities.
std::shared_ptr<const LightChoice> uniform_choice();

/// A choice that can be asked for by name.
struct NamedLightChoice {
    std::string id, summary;
    std::shared_ptr<const LightChoice> (*make)();
};
const std::vector<NamedLightChoice>& light_choices();

}  // namespace plumb
