#include "core/images/module.h"

#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdint>

namespace {

// libpng and others print to standard error by themselves, whatever OpenImageIO reports.
class SilentStandardError {
public:
    SilentStandardError() : saved_(::dup(STDERR_FILENO)) {
        const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
        ::dup2(nowhere, STDERR_FILENO);
        ::close(nowhere);
    }
    ~SilentStandardError() {
        ::dup2(saved_, STDERR_FILENO);
        ::close(saved_);
    }
    SilentStandardError(const SilentStandardError&) = delete;
    SilentStandardError& operator=(const SilentStandardError&) = delete;

private:
    int saved_;
};

// What is wrong with the layout; empty where an Image can hold it.
std::string objection(const OIIO::ImageSpec& spec) {
    if (spec.deep) return "it is a deep image; accepted are images with one value a channel";
    if (spec.width < 1 || spec.height < 1 || spec.depth != 1 || spec.nchannels < 1)
        return fmt::format("it has {} × {} × {} pixels of {} channels; accepted are flat images", spec.width,
                           spec.height, spec.depth, spec.nchannels);
    if (spec.image_pixels() > (std::uint64_t{1} << 30) / static_cast<std::uint64_t>(spec.nchannels))
        return fmt::format("it has {} × {} pixels of {} channels; accepted are 2^30 numbers", spec.width, spec.height,
                           spec.nchannels);
    return {};
}

std::string or_unknown(const std::string& error) {
    return error.empty() ? "of unknown format" : error;
}

void use_one_thread() {
    // Threads of its own help nothing in one image, and ThreadSanitizer cannot see into them.
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1);
}

std::map<std::string, std::string> text_attributes(const OIIO::ImageSpec& spec) {
    std::map<std::string, std::string> texts;
    for (const auto& attribute : spec.extra_attribs)
        if (attribute.type() == OIIO::TypeString) texts[attribute.name().string()] = attribute.get_string();
    return texts;
}

plumb::ImagePart part_of(OIIO::ImageInput& input, int number, std::string* why) {
    const OIIO::ImageSpec& spec = input.spec();
    plumb::ImagePart part;
    *why = objection(spec);
    if (!why->empty()) return part;
    part.image = {spec.width,
                  spec.height,
                  spec.channelnames,
                  {},
                  text_attributes(spec),
                  !spec.format.is_floating_point(),
                  {std::string(spec.get_string_attribute("oiio:ColorSpace")), spec.get_float_attribute("oiio:Gamma")}};
    part.data = {spec.x, spec.y, spec.width, spec.height};
    part.display = {spec.full_x, spec.full_y, spec.full_width, spec.full_height};
    part.orientation = spec.get_int_attribute("Orientation", 1);
    part.name = std::string(spec.get_string_attribute("oiio:subimagename"));
    part.image.values.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    const bool read = input.read_image(number, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, part.image.values.data());
    // some readers fill what is missing and only complain
    if (!read || input.has_error()) *why = or_unknown(input.geterror());
    return part;
}

std::unique_ptr<OIIO::ImageOutput> encoder(const char* file, std::string* why) {
    auto output = OIIO::ImageOutput::create(file);
    if (!output) *why = "no image format has this extension: " + OIIO::geterror();
    return output;
}

}  // namespace

void plumb_find_encoder(const char* file, std::string* why) {
    encoder(file, why);
}

void plumb_decode_image(const char* file, plumb::ImageParts* parts, std::string* why) {
    const SilentStandardError silence;
    use_one_thread();
    // The file's own numbers: else OpenImageIO multiplies colours by an alpha that they do not contain, as PNG's do
    // not.
    OIIO::ImageSpec as_stored;
    as_stored.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(file, &as_stored);
    if (!input) {
        *why = or_unknown(OIIO::geterror());
        return;
    }
    parts->format = input->format_name();
    const bool is_exr = parts->format == "openexr";
    for (int number = 0; number == 0 || (is_exr && input->seek_subimage(number, 0)); ++number) {
        parts->parts.push_back(part_of(*input, number, why));
        if (!is_exr) parts->parts.back().display = parts->parts.back().data;  // elsewhere an offset is a printer's
        if (!why->empty()) return;
    }
    (void)input->geterror();  // that there are no more parts
}

void plumb_encode_image(const char* file, const plumb::Image* image, std::string* why) {
    const SilentStandardError silence;
    use_one_thread();
    const auto output = encoder(file, why);
    if (!output) return;
    OIIO::ImageSpec spec(image->width, image->height, static_cast<int>(image->channels.size()), OIIO::TypeDesc::FLOAT);
    spec.channelnames = image->channels;
    for (const auto& [name, value] : image->metadata) spec.attribute(name, value);
    spec.attribute("DateTime", "");  // else OpenImageIO writes the time, and no two files are the same
    const bool written = output->open(file, spec) && output->write_image(OIIO::TypeDesc::FLOAT, image->values.data());
    if (!output->close() || !written) *why = or_unknown(output->geterror());
}
