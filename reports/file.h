#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace plumb {

/// Writes aside, then renames: readers see the old file or the new one, never half of it. Missing folders are made.
/// Throws Error naming the file when it cannot be written.
void write_file(const std::filesystem::path& file, std::string_view text);

/// The whole file; throws Error naming it when it cannot be read.
std::string read_file(const std::filesystem::path& file);

}  // namespace plumb
