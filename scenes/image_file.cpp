#include "scenes/image_file.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <filesystem>

#include "core/error.h"

namespace plumb {

namespace fs = std::filesystem;

void write_image(const std::string& path, const Image& image) {
    const fs::path target(path);
    // The extension decides the format, so the name aside keeps it.
    const std::string aside = (target.parent_path() / (".part-" + target.filename().string())).string();
    auto output = OIIO::ImageOutput::create(aside);
    if (!output) throw Error(fmt::format("{}: no writer for this extension: {}", path, OIIO::geterror()));
    const int channels = static_cast<int>(image.channels.size());
    OIIO::ImageSpec spec(image.width, image.height, channels, OIIO::TypeDesc::FLOAT);
    spec.channelnames = image.channels;
    for (const auto& [name, value] : image.metadata) spec.attribute(name, value);
    const bool written = output->open(aside, spec) && output->write_image(OIIO::TypeDesc::FLOAT, image.values.data());
    const std::string reason = written ? "" : output->geterror();
    const bool closed = output->close();
    std::error_code failed;
    if (written && closed) fs::rename(aside, target, failed);
    if (!written || !closed || failed) {
        std::error_code ignored;
        fs::remove(aside, ignored);
        throw Error(fmt::format("{}: cannot be written: {}", path, failed ? failed.message() : reason));
    }
}

Image read_image(const std::string& path) {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) throw Error(fmt::format("{}: cannot be read: {}", path, OIIO::geterror()));
    const OIIO::ImageSpec& spec = input->spec();
    Image image{spec.width, spec.height, spec.channelnames, {}};
    image.values.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.values.data()))
        throw Error(fmt::format("{}: cannot be read: {}", path, input->geterror()));
    for (const auto& attribute : spec.extra_attribs)
        if (attribute.type() == OIIO::TypeString) image.metadata[attribute.name().string()] = attribute.get_string();
    return image;
}

}  // namespace plumb
