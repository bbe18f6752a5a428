#include "integrators/paths/next_event/light_choices.h"

namespace plumb {

const std::vector<NamedLightChoice>& light_choices() {
    static const std::vector<NamedLightChoice> all{
        {"power", "half in proportion to what lights emit, half all alike", choice_by_power},
        {"uniform", "all lights alike", uniform_choice},
    };
    return all;
}

}  // namespace plumb
