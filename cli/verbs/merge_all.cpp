#include <CLI/CLI.hpp>
#include <filesystem>

#include "cli/verb.h"
#include "cli/verbs/figure_outputs.h"
#include "cli/verbs/picture_file.h"
#include "core/error.h"
#include "core/file.h"
#include "reports/run/merge.h"
#include "scenes/film/film_part.h"

namespace plumb::cli::verbs {

Verb merge();

namespace {

using Files = std::vector<std::string>;

int merge_films(const Files& parts, const std::filesystem::path& out) {
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

bool holds_a_reproduction(const std::string& file) {
    const std::vector<reports::StoredRun> runs = reports::Store(file, reports::Store::Access::read).runs();
    return !runs.empty() && !reports::judges_claims(runs.back().run);
}

int merge_reproductions(const Files& stores, const FigureOutputs& outputs) {
    check_outputs(outputs);
    const reports::Results joined = join_figures(shipped_tasks_of, reports::shards_of({stores.begin(), stores.end()}));
    reports::Store store(outputs.store, reports::Store::Access::append);
    const std::int64_t run = reports::store_once(store, joined);
    return publish(shipped_tasks_of(joined.run), store.load(run), run, outputs);
}

// The verb of a catalogue's program, and besides it shards of `plumb render` and of `plumb reproduce`.
Action add(CLI::App& verb) {
    const Action merge_verdicts = merge().add(verb);
    const auto image = std::make_shared<std::string>();
    const auto out = std::make_shared<std::string>(FigureOutputs().out);
    CLI::Option* output =
        verb.add_option("-o,--output", *image, "the image that parts of a film (plumb render --shard) are merged to");
    CLI::Option* folder =
        verb.add_option("--out", *out, "the folder of the page, where plumb reproduce made the shards; '' for none")
            ->capture_default_str();
    for (const char* other : {"--json", "--junit", "--report"})
        for (CLI::Option* ours : {output, folder}) ours->excludes(verb.get_option(other));
    output->excludes(verb.get_option("--store"), folder);
    verb.footer(
        verb.get_footer() +
        "\n         plumb merge part-*.film -o picture.exr\n         plumb merge shard-*.db --out reproduction");
    const CLI::Option* parts = verb.get_option("stores");
    const CLI::Option* store = verb.get_option("--store");
    return [=](const Catalogue& catalogue) {
        const Files files = parts->results();
        if (!image->empty()) return merge_films(files, *image);
        if (holds_a_reproduction(files.front())) return merge_reproductions(files, {*out, store->as<std::string>()});
        if (folder->count() > 0) throw Error("--out is for shards of plumb reproduce; those of verify have --report");
        return merge_verdicts(catalogue);
    };
}

}  // namespace

Verb merge_all() {
    Verb verb = merge();
    verb.add = add;
    return verb;
}

}  // namespace plumb::cli::verbs
