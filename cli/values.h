#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

// Each of these functions reads what an option says from text. It throws Error, which names the text and what is
// accepted.
namespace plumb::cli {

/// A duration: "90", "90s", "1.5m", "2h".
std::chrono::duration<double> parse_duration(const std::string& text);
/// A whole number from `least` to `most`: "1000", "1e3".
std::uint64_t parse_count(const std::string& text, std::uint64_t least, std::uint64_t most);
/// A strategy "s,t": vertices from the light and from the sensor, s >= 0, t >= 1 and not both ends alone.
std::vector<int> parse_strategy(const std::string& text);
/// A crop "x,y,width,height" in pixels.
std::vector<int> parse_crop(const std::string& text);
/// A number of edges, "3", or "all" as 0.
int parse_edges(const std::string& text);
/// A definition "name=value".
std::pair<std::string, std::string> parse_definition(const std::string& text);
/// A domain "0,1" or "0,2,-1,1": both ends of each axis.
std::vector<double> parse_domain(const std::string& text);

}  // namespace plumb::cli
