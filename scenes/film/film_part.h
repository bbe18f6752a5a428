#pragma once

#include <filesystem>
#include <map>

#include "scenes/film/film.h"

namespace plumb {

/// Some of a render's replicates, for a film that is finished elsewhere.
struct FilmPart {
    std::map<std::string, std::string> metadata;  ///< of the whole picture: what it is a function of
    std::uint32_t part = 1, parts = 1;            ///< the first of how many
    std::uint64_t rays = 0;
    Film film;
};

/// Writes the sums to the bit, in this machine's byte order, with a checksum behind them.
void write_film_part(const std::filesystem::path& file, const FilmPart& part);
/// Reads a part. Throws Error naming the file when it cannot be read, is something else, ends early or is damaged.
FilmPart read_film_part(const std::filesystem::path& file);

/// Merges all parts into the whole picture, to the bits of one run. Throws Error naming the file, or the part, when
/// parts are of different pictures, there twice or missing.
FilmPart read_film_parts(const std::vector<std::filesystem::path>& files);

}  // namespace plumb
