#pragma once

#include <string_view>
#include <vector>

namespace plumb {

/// A study that comes with Plumb: the text of studies/NAME.toml as it was when the library was built.
struct ShippedStudy {
    std::string_view name, text;
};

const std::vector<ShippedStudy>& shipped_studies();

}  // namespace plumb
