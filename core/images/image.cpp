#include "core/images/image.h"

#include <dlfcn.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/file.h"
#include "core/images/module.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

// Beside the program, where the build leaves it, or where an installation does; a bare name is for the system to find.
fs::path place_of_module() {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    const fs::path name = "libplumb_image_module.so";
    for (const fs::path& folder : {program, program / "../core", program / PLUMB_MODULES_FROM_PROGRAM})
        if (fs::exists(folder / name, ignored)) return folder / name;
    return name;
}

void* loaded_module() {
    if (void* const module = ::dlopen(place_of_module().c_str(), RTLD_NOW | RTLD_LOCAL)) return module;
    throw Error(fmt::format("images can be neither read nor written: {}", ::dlerror()));
}

template <class Function>
Function function_of_module(const char* name) {
    static void* const module = loaded_module();
    return reinterpret_cast<Function>(::dlsym(module, name));
}

std::string in_one_line(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    return text;
}

}  // namespace

Image read_image(const fs::path& file) {
    if (!fs::exists(file)) throw Error(fmt::format("{}: there is no such file", file.string()));
    ImageParts parts;
    std::string why;
    function_of_module<decltype(&plumb_decode_image)>("plumb_decode_image")(file.c_str(), &parts, &why);
    if (!why.empty()) throw Error(fmt::format("{}: not a readable image: {}", file.string(), in_one_line(why)));
    try {
        return picture_of(std::move(parts));
    } catch (const std::invalid_argument& error) {
        throw Error(fmt::format("{}: not a readable image: {}", file.string(), error.what()));
    }
}

void require_finite(const Image& image, const fs::path& file) {
    const auto bad = std::ranges::find_if(image.values, [](float v) { return !std::isfinite(v); });
    if (bad == image.values.end()) return;
    const auto index = static_cast<std::size_t>(bad - image.values.begin()), channels = image.channels.size();
    const std::size_t pixel = index / channels, width = static_cast<std::size_t>(image.width);
    throw Error(fmt::format("{}: pixel ({}, {}), channel {} is {}; accepted are finite numbers", file.string(),
                            pixel % width, pixel / width, image.channels[index % channels], *bad));
}

void check_image_format(const fs::path& file) {
    std::string why;
    function_of_module<decltype(&plumb_find_encoder)>("plumb_find_encoder")(file.c_str(), &why);
    if (!why.empty()) throw Error(fmt::format("{}: cannot be written: {}", file.string(), in_one_line(why)));
}

void write_image(const fs::path& file, const Image& image) {
    write_aside(file, [&](const fs::path& here) {
        std::string why;
        function_of_module<decltype(&plumb_encode_image)>("plumb_encode_image")(here.c_str(), &image, &why);
        return in_one_line(why);
    });
}

}  // namespace plumb
