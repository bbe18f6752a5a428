#include "reports/file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

#include "core/error.h"

namespace plumb {
namespace fs = std::filesystem;

void write_file(const fs::path& file, std::string_view text) {
    const auto fail = [&](std::string_view why) {
        throw Error(fmt::format("{}: cannot be written: {}", file.string(), why));
    };
    std::error_code error;
    if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
    if (error) fail(error.message());
    if (fs::is_directory(file)) fail("it is a folder");

    const fs::path aside = file.string() + fmt::format(".{}.part", ::getpid());
    {
        std::ofstream stream(aside, std::ios::binary);
        stream.write(text.data(), static_cast<std::streamsize>(text.size()));
        stream.close();
        if (!stream) {
            const int reason = errno;
            fs::remove(aside, error);
            fail(std::strerror(reason));
        }
    }
    fs::rename(aside, file, error);
    if (error) {
        const std::string reason = error.message();
        fs::remove(aside, error);
        fail(reason);
    }
}

std::string read_file(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (stream && !fs::is_directory(file)) text << stream.rdbuf();
    if (!stream || fs::is_directory(file))
        throw Error(fmt::format("{}: cannot be read: {}", file.string(),
                                fs::exists(file) ? "not a readable file" : "there is no such file"));
    return text.str();
}

}  // namespace plumb
