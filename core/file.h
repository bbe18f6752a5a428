#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace plumb {

/// Writes aside, then renames: readers see the old file or the new one, never half of it. Missing folders are made,
/// symbolic links kept; a device or a pipe takes the text as it is. Throws Error naming the file when it cannot be
/// written.
void write_file(const std::filesystem::path& file, std::string_view text);

/// Throws the same Error where write_file() would, as far as one can know before; leaves nothing behind.
void check_writable(const std::filesystem::path& file);

/// The whole file; throws Error naming it when it cannot be read.
std::string read_file(const std::filesystem::path& file);

}  // namespace plumb
