#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace plumb {

/// Lets `write` write a file beside this one, then renames it: readers see the old file or the new one, never half of
/// it, and no two writers meet, whether threads or processes. `write` gets a name with the file's extension and returns
/// what went wrong, or nothing. Missing folders are made, symbolic links kept; a device or a pipe is written where it
/// stands. Throws Error naming the file when it cannot be written; what stood aside is removed.
void write_aside(const std::filesystem::path& file,
                 const std::function<std::string(const std::filesystem::path& here)>& write);

/// Makes the text the whole content of the file, by write_aside().
void write_file(const std::filesystem::path& file, std::string_view text);

/// The same of a whole folder, which `write` makes and fills: it takes the place of a former one and of all in it.
void write_folder_aside(const std::filesystem::path& folder,
                        const std::function<void(const std::filesystem::path& here)>& write);

/// Throws the Error that write_aside() would, as far as one can know before; leaves nothing behind.
void check_writable(const std::filesystem::path& file);

/// The whole file; throws Error naming it when it cannot be read.
std::string read_file(const std::filesystem::path& file);

}  // namespace plumb
