#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace plumb {

/// An image whose name says what it is.
struct NamedImage {
    std::filesystem::path file;
    std::uint64_t samples = 0;                                  ///< of {spp}
    double seconds = std::numeric_limits<double>::quiet_NaN();  ///< of {seconds}; NaN where the pattern has none
};

/// The files that match a pattern with {spp}, {seed} and {seconds} in its last part, by samples and name. Throws Error
/// for a pattern without {spp}, with other braces, or that no file matches.
std::vector<NamedImage> images_matching(const std::string& pattern);

}  // namespace plumb
