#include <CLI/CLI.hpp>
#include <iterator>

#include "cli/common_options.h"
#include "cli/session.h"
#include "cli/verb.h"
#include "core/error.h"
#include "core/file.h"
#include "estimators/reweighting/sample_weighting.h"
#include "studies/own/user_integrand.h"

namespace plumb::cli::verbs {
namespace {

struct Options {
    std::string points, out = "-";
    bool periodic = false;       ///< 0 and 1 are one place
    std::vector<double> domain;  ///< x0, x1[, y0, y1]; empty: the unit cube
};

template <int D>
std::vector<double> weights_of(const NumberTable& points, const Options& options, std::size_t& repeated) {
    std::vector<Point<D>> places = own::places_of<D>(points, options.domain);
    std::vector<double> weights = find_sample_weighting<D>(options.periodic ? "torus" : "voronoi").weights(places);
    repeated = repeated_places<D>(std::move(places), options.periodic);
    double volume = 1;
    for (std::size_t axis = 0; axis < options.domain.size() / 2; ++axis)
        volume *= options.domain[2 * axis + 1] - options.domain[2 * axis];
    for (double& weight : weights) weight *= volume;
    return weights;
}

std::string csv_of(const NumberTable& points, const std::vector<double>& weights) {
    const std::vector<std::string> plain = {"x", "y"};
    const std::vector<std::string>& names = points.header.empty() ? plain : points.header;
    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    for (std::size_t column = 0; column < points.columns; ++column) fmt::format_to(out, "{},", names[column]);
    fmt::format_to(out, "weight\n");
    for (std::size_t row = 0; row < points.rows(); ++row) {
        for (std::size_t column = 0; column < points.columns; ++column)
            fmt::format_to(out, "{},", points.at(row, column));
        fmt::format_to(out, "{}\n", weights[row]);
    }
    return fmt::to_string(text);
}

void print_summary(const NumberTable& points, const std::vector<double>& weights, std::size_t repeated) {
    const auto [smallest, largest] = std::ranges::minmax_element(weights);
    const auto named = [&](auto weight) {
        return fmt::format("{:.3g} (line {})", *weight,
                           points.line(static_cast<std::size_t>(weight - weights.begin())));
    };
    fmt::print(stderr, "{} points; weights sum to {}, smallest {}, largest {}", points.rows(),
               std::reduce(weights.begin(), weights.end()), named(smallest), named(largest));
    if (repeated > 0) fmt::print(stderr, "; {} points repeat an earlier place and share its cell", repeated);
    fmt::print(stderr, "\n");
}

int weights(const Options& options) {
    require_writable({options.out});
    const NumberTable points = in_order(parse_csv(read_input(options.points), options.points), {{"x"}, {"x", "y"}});
    std::size_t repeated = 0;
    const std::vector<double> weights =
        points.columns == 1 ? weights_of<1>(points, options, repeated) : weights_of<2>(points, options, repeated);
    const std::string csv = csv_of(points, weights);
    write_output(options.out, csv);
    print_summary(points, weights, repeated);
    return 0;
}

Action add(CLI::App& verb) {
    const auto options = std::make_shared<Options>();
    verb.add_option("points", options->points, "a file with columns x or x,y; - for standard input")->required();
    verb.add_flag("--periodic", options->periodic, "weigh them on the torus, where opposite ends are one place");
    add_domain(verb, options->domain);
    verb.add_option("-o,--output", options->out, "where the CSV goes; - for standard output")->capture_default_str();
    verb.footer("Example: plumb weights points.csv --periodic -o weights.csv");
    return [options](const Catalogue&) { return weights(*options); };
}

}  // namespace

Verb weights() {
    return {"weights", "Weigh your own points by their Voronoi cells", add};
}

}  // namespace plumb::cli::verbs
