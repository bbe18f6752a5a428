#include "cli/verbs/picture_file.h"

#include <fmt/format.h>

#include "core/file.h"
#include "integrators/references/provenance.h"
#include "reports/run/json.h"
#include "scenes/film/encoding.h"

namespace plumb::cli {

void write_picture(const std::filesystem::path& file, const Film& film, const std::map<std::string, std::string>& of) {
    Image image = film.image();
    image.metadata = of;
    image.metadata.merge(metadata_of(error_of(film)));
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
    write_image(file, encoded_for(file, image));
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
