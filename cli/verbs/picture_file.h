#pragma once

#include <filesystem>
#include <map>

#include "reports/run/results.h"
#include "scenes/film/film.h"

namespace plumb::cli {

/// Writes the film's image in the format of the file's name: every layer and the metadata, the film's error among them,
/// where the format holds floats and names, else the colours that a person looks at. Missing folders are made.
void write_picture(const std::filesystem::path& file, const Film& film, const std::map<std::string, std::string>& of);

/// Writes `file.json` beside an output: what is no function of scene and settings, and what was counted.
void write_side_record(const std::filesystem::path& file, const std::vector<Field>& record);
std::vector<Field> bad_values_of(const Film& film);
/// Prints how many values there are that should not be, where there are any.
void print_bad_values(const BadValues& bad);

}  // namespace plumb::cli
