#include "cli/picture_file.h"

#include <fmt/format.h>

#include "core/file.h"
#include "core/srgb.h"
#include "integrators/references/provenance.h"
#include "reports/run/json.h"

namespace plumb::cli {
namespace {

// Formats that hold floats and names get every layer, the others what a person looks at.
Image fit_for(const std::filesystem::path& file, const Image& image) {
    const std::string format = file.extension().string();
    if (format == ".exr" || format == ".tif" || format == ".tiff") return image;
    const bool linear = format == ".hdr" || format == ".pfm";
    const auto srgb = [](float x) { return srgb_from_linear(std::clamp(x, 0.f, 1.f)); };
    Image colours{image.width, image.height, {"R", "G", "B"}, {}, image.metadata};
    for (std::size_t i = 0; i < image.values.size(); i += image.channels.size())
        for (std::size_t c = 0; c < 3; ++c)
            colours.values.push_back(linear ? image.values[i + c] : srgb(image.values[i + c]));
    return colours;
}

}  // namespace

void write_picture(const std::filesystem::path& file, const Film& film, const std::map<std::string, std::string>& of) {
    Image image = film.image();
    image.metadata = of;
    image.metadata.merge(metadata_of(error_of(film)));
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
    write_image(file, fit_for(file, image));
}

void write_side_record(const std::filesystem::path& file, const std::vector<Field>& record) {
    write_file(file.string() + ".json", reports::list_json(std::vector<reports::ListRow>{record}));
}

std::vector<Field> bad_values_of(const Film& film) {
    const BadValues& bad = film.bad_values();
    return {{"nan", bad.nan}, {"infinite", bad.infinite}, {"negative", bad.negative}, {"large", bad.large}};
}

void print_bad_values(const BadValues& bad) {
    if (bad == BadValues{}) return;
    fmt::print(
        "values that should not be: {} NaN, {} infinite, {} negative, {} of 2^31 and more; NaN and infinite ones "
        "count as 0\n",
        bad.nan, bad.infinite, bad.negative, bad.large);
}

}  // namespace plumb::cli
