#include "analytic/image.h"

#include <dlfcn.h>

#include <algorithm>
#include <cmath>

#include "analytic/image_reader.h"
#include "core/error.h"

namespace plumb {
namespace {

// Beside the program, where the build leaves it, in an installed program's ../lib, or where the system looks.
void* loaded_module() {
    std::error_code ignored;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    const std::filesystem::path name = "libplumb_image_reader.so";
    for (const auto& path : {program / name, program / "../analytic" / name, program / "../lib" / name, name})
        if (void* const module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) return module;
    throw Error(fmt::format("images cannot be read: {}", ::dlerror()));
}

decltype(&plumb_decode_image) image_reader() {
    static void* const module = loaded_module();
    return reinterpret_cast<decltype(&plumb_decode_image)>(::dlsym(module, "plumb_decode_image"));
}

void check_values(const std::filesystem::path& file, const Image& image) {
    const auto bad = std::ranges::find_if(image.values, [](float v) { return !std::isfinite(v); });
    if (bad == image.values.end()) return;
    const auto index = static_cast<std::size_t>(bad - image.values.begin()), channels = image.channels.size();
    const std::size_t pixel = index / channels, width = static_cast<std::size_t>(image.width);
    throw Error(fmt::format("{}: pixel ({}, {}), channel {} is {}; accepted are finite numbers", file.string(),
                            pixel % width, pixel / width, image.channels[index % channels], *bad));
}

}  // namespace

Image read_image(const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) throw Error(fmt::format("{}: there is no such file", file.string()));
    Image image;
    std::string why;
    image_reader()(file.c_str(), &image, &why);
    std::ranges::replace(why, '\n', ' ');
    if (!why.empty()) throw Error(fmt::format("{}: not a readable image: {}", file.string(), why));
    check_values(file, image);
    return image;
}

}  // namespace plumb
