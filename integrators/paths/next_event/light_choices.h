#pragma once

#include <memory>
#include <string>
#include <vector>

#include "integrators/paths/next_event/light_choice.h"

namespace plumb {

/// In proportion to what lights emit, whatever the vertex.
std::shared_ptr<const LightChoice> choice_by_power();
/// All lights alike.
std::shared_ptr<const LightChoice> uniform_choice();

/// A choice that can be asked for by name.
struct NamedLightChoice {
    std::string id, summary;
    std::shared_ptr<const LightChoice> (*make)();
};
const std::vector<NamedLightChoice>& light_choices();

}  // namespace plumb
