#include <CLI/CLI.hpp>
#include <filesystem>

#include "cli/verb.h"
#include "cli/verbs/picture_file.h"
#include "core/file.h"
#include "scenes/film/film_part.h"

namespace plumb::cli::verbs {

Verb merge();

namespace {

int merge_films(const std::vector<std::string>& parts, const std::filesystem::path& out) {
    check_writable(out);
    check_image_format(out);
    const FilmPart whole = read_film_parts({parts.begin(), parts.end()});
    write_picture(out, whole.film, whole.metadata);
    std::vector<Field> record{{"rays", whole.rays}};
    for (Field& field : bad_values_of(whole.film)) record.push_back(std::move(field));
    write_side_record(out, record);
    print_bad_values(whole.film.bad_values());
    fmt::print("{} passes of {} parts; {}\n", whole.film.replicates(), parts.size(), out.string());
    return 0;
}

// The verb of a catalogue's program, and parts of a film besides.
Action add(CLI::App& verb) {
    const Action merge_stores = merge().add(verb);
    const auto image = std::make_shared<std::string>();
    CLI::Option* output =
        verb.add_option("-o,--output", *image, "of parts of a film (plumb render --shard) instead: the image");
    for (const char* other : {"--json", "--junit", "--report", "--store"}) output->excludes(verb.get_option(other));
    verb.footer(verb.get_footer() + "\n         plumb merge part-*.film -o picture.exr");
    const CLI::Option* parts = verb.get_option("stores");
    return [=](const Catalogue& catalogue) {
        return image->empty() ? merge_stores(catalogue) : merge_films(parts->results(), *image);
    };
}

}  // namespace

Verb merge_with_films() {
    Verb verb = merge();
    verb.add = add;
    return verb;
}

}  // namespace plumb::cli::verbs
