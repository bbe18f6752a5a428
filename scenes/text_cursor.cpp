#include "scenes/text_cursor.h"

#include <fstream>

namespace plumb {

std::string read_file(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary | std::ios::ate);
    if (!stream || std::filesystem::is_directory(file)) throw Error("cannot read " + file.string());
    std::string text(static_cast<std::size_t>(stream.tellg()), '\0');
    stream.seekg(0);
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (!stream) throw Error("cannot read all of " + file.string());
    return text;
}

}  // namespace plumb
