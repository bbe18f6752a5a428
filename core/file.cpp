#include "core/file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

#include "core/error.h"

namespace plumb {
namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& file, std::string_view why) {
    throw Error(fmt::format("{}: cannot be written: {}", file.string(), why));
}

/// What went wrong in writing the file itself; empty when all went well.
std::string write_here(const fs::path& file, std::string_view text) {
    std::ofstream stream(file, std::ios::binary);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    return stream ? "" : std::strerror(errno);
}

/// The file in which writing under this name ends up.
fs::path behind_links(const fs::path& file) {
    std::error_code dangling;
    const fs::path target = fs::is_symlink(file) ? fs::canonical(file, dangling) : file;
    return dangling ? file : target;
}

bool is_device_or_pipe(const fs::path& file) {
    return fs::exists(file) && !fs::is_regular_file(file) && !fs::is_directory(file);
}

// A name of this process and of this call, so that no two writers meet; the extension stays, since image formats go by
// it.
fs::path name_aside(const fs::path& file) {
    static std::atomic<unsigned> calls = 0;
    return file.parent_path() /
           fmt::format(".{}.part-{}-{}{}", file.stem().string(), ::getpid(), calls++, file.extension().string());
}

}  // namespace

void write_aside(const fs::path& file, const std::function<std::string(const fs::path& here)>& write) {
    std::error_code error;
    if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
    if (error) fail(file, error.message());
    if (fs::is_directory(file)) fail(file, "it is a folder");

    const fs::path target = behind_links(file);
    const bool in_place = is_device_or_pipe(target);
    const fs::path here = in_place ? target : name_aside(target);
    const std::string reason = write(here);
    if (in_place && !reason.empty()) fail(file, reason);
    if (in_place) return;
    if (reason.empty()) fs::rename(here, target, error);
    if (reason.empty() && !error) return;
    std::error_code ignored;
    fs::remove(here, ignored);
    fail(file, error ? error.message() : reason);
}

void write_folder_aside(const fs::path& folder, const std::function<void(const fs::path& here)>& write) {
    const fs::path here = name_aside(folder), before = name_aside(folder);
    std::error_code error, ignored;
    try {
        write(here);
        const bool replaces = fs::exists(folder);
        if (replaces) fs::rename(folder, before, error);
        if (error) fail(folder, error.message());
        fs::rename(here, folder, error);
        if (error && replaces) fs::rename(before, folder, ignored);
        if (error) fail(folder, error.message());
    } catch (...) {
        fs::remove_all(here, ignored);
        throw;
    }
    fs::remove_all(before, ignored);
}

void write_file(const fs::path& file, std::string_view text) {
    write_aside(file, [&](const fs::path& here) { return write_here(here, text); });
}

void check_writable(const fs::path& file) {
    if (fs::is_directory(file)) fail(file, "it is a folder");
    const fs::path target = behind_links(file);
    if (is_device_or_pipe(target)) return;
    fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
    while (!fs::exists(folder) && folder.has_parent_path()) folder = folder.parent_path();
    if (!fs::exists(folder)) folder = ".";  // of a relative path: its first folder will be made here
    if (!fs::is_directory(folder)) fail(file, fmt::format("{} is not a folder", folder.string()));
    const fs::path probe = name_aside(folder / "plumb");
    if (const std::string reason = write_here(probe, ""); !reason.empty()) fail(file, reason);
    fs::remove(probe);
}

std::string read_file(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (stream && !fs::is_directory(file)) text << stream.rdbuf();
    if (!stream || fs::is_directory(file))
        throw Error(fmt::format("{}: cannot be read: {}", file.string(),
                                fs::exists(file) ? "not a readable file" : "there is no such file"));
    return std::move(text).str();
}

}  // namespace plumb
