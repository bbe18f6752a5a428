#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/picture_file.h"
#include "core/file.h"
#include "scenes/film/film_part.h"

namespace plumb::cli {

int merge_films(const MergeOptions& options) {
    const std::filesystem::path out = options.image;
    check_writable(out);
    check_image_format(out);
    const FilmPart whole = read_film_parts({options.stores.begin(), options.stores.end()});
    write_picture(out, whole.film, whole.metadata);
    std::vector<Field> record{{"rays", whole.rays}};
    for (Field& field : bad_values_of(whole.film)) record.push_back(std::move(field));
    write_side_record(out, record);
    print_bad_values(whole.film.bad_values());
    fmt::print("{} passes of {} parts; {}\n", whole.film.replicates(), options.stores.size(), out.string());
    return 0;
}

}  // namespace plumb::cli
