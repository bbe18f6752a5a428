#include "studies/image_series.h"

#include <filesystem>

#include "core/error.h"
#include "core/images/image.h"
#include "core/images/layers.h"
#include "reports/study/csv.h"
#include "reports/text/text.h"
#include "studies/image_pattern.h"
#include "verification/pictures/image_convergence.h"

namespace plumb {
namespace {

struct ReferencePicture {
    std::string file;
    Image image;
    Picture picture;
    bool variance_known;
};

ReferencePicture read_reference(const std::string& file) {
    if (file == "auto") throw Error("converge --images: --reference auto is for scenes (--on); give --reference FILE");
    if (file.empty()) throw Error("converge --images: against what? Give --reference FILE");
    ReferencePicture reference{file, picture_layer(read_image(file), file), {}, false};
    reference.variance_known = has_variance(reference.image, file);
    reference.picture =
        picture_of(std::vector{reference.image}, std::vector{reference.file}, !reference.variance_known);
    return reference;
}

// Reads and groups them; nothing but the pixels that count is kept.
std::vector<RendersAt> read_renders(const std::vector<NamedImage>& files, const ReferencePicture& reference) {
    std::vector<RendersAt> groups;
    std::vector<Image> of_group;
    for (const NamedImage& named : files) {
        const std::string file = named.file.string();
        if (std::filesystem::equivalent(named.file, reference.file))
            throw Error(fmt::format("{}: the reference is among the images", file));
        if (groups.empty() || groups.back().samples != named.samples) {
            groups.push_back({.samples = named.samples, .seconds = 0});
            of_group.clear();
        }
        RendersAt& at = groups.back();
        of_group.push_back(picture_layer(read_image(named.file), named.file));
        at.files.push_back(file);
        require_independent(of_group, at.files);
        require_independent(std::vector{reference.image, of_group.back()}, std::vector{reference.file, file});
        at.renders.push_back(picture_of(std::vector{of_group.back()}, std::vector{file}, true));
        at.seconds += named.seconds;
    }
    for (RendersAt& at : groups) {
        at.seconds /= static_cast<double>(at.renders.size());
        if (at.renders.size() < 2 && !reference.variance_known)
            throw Error(
                fmt::format("{}: the only image of {} samples, and {} has no layers variance.R …, so no error is "
                            "known; give two seeds or more, or a reference with its variance",
                            at.files[0], at.samples, reference.file));
    }
    return groups;
}

Series series_of(const std::vector<RendersAt>& groups, const ReferencePicture& reference, const std::string& pattern) {
    Series series;
    series.estimator = pattern;
    series.integrand = reference.file;
    for (const RendersAt& at : groups) {
        series.points.push_back(convergence_point(at, reference.picture));
        series.replicates = std::max<std::uint64_t>(series.replicates, at.renders.size());
    }
    series.slope = fit_slope(series.points, 0.95);
    return series;
}

}  // namespace

ImageSeries measure_images(const std::string& pattern, const std::string& reference_file) {
    const std::vector<NamedImage> files = images_matching(pattern);
    const ReferencePicture reference = read_reference(reference_file);
    const std::vector<RendersAt> groups = read_renders(files, reference);
    ImageSeries measured{.series = series_of(groups, reference, pattern),
                         .images = {},
                         .power = power_of(reference.picture),
                         .said = {}};
    for (const RendersAt& at : groups) measured.images.push_back(at.renders.size());
    measured.said = fmt::format("{}: {}, whose own variance is {}", pattern, reference.file,
                                reference.variance_known ? "subtracted" : "not known and not subtracted");
    return measured;
}

reports::StudyResult figure_of(const std::vector<ImageSeries>& all, const reports::RunInfo& run) {
    const ImageSeries& first = all.front();
    reports::FigurePanel panel{.integrand = first.series.integrand,
                               .integral = std::sqrt(first.power),  // so that its relative MSE is the relMSE
                               .series = {},
                               .unit = "samples per pixel"};
    std::string text =
        "The mean squared error of a pixel over its channels, against the samples that a pixel took. The "
        "relative MSE is the MSE over the mean square of the reference.";
    for (const ImageSeries& one : all) {
        panel.series.push_back(one.series);
        text += "\n\nTruth of " + one.said + ".";
    }
    reports::FigureText about{.id = "renders", .title = "Error of renders", .text = text};
    about.x_label = "samples per pixel";
    about.metrics = {reports::metric_from("relative_mse")};
    about.slopes = {-1};
    return {.run = run,
            .about = {.name = "renders",
                      .title = "Error of renders",
                      .text = fmt::format("{} of pictures against {}.",
                                          all.size() == 1 ? "One series" : "Several series", first.series.integrand),
                      .source = {},
                      .renders = true},
            .figures = {{about, {panel}}}};
}

std::string csv_of(const std::vector<ImageSeries>& all) {
    using reports::csv_cell;
    std::string csv = "pattern,reference,spp,images,seconds,mse,mse_low,mse_high,relmse,bias,bias_standard_error\r\n";
    for (const ImageSeries& one : all)
        for (std::size_t i = 0; i < one.series.points.size(); ++i) {
            const ConvergencePoint& p = one.series.points[i];
            csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\r\n", csv_cell(one.series.estimator),
                               csv_cell(one.series.integrand), p.n, one.images[i], csv_cell(p.seconds), csv_cell(p.mse),
                               csv_cell(p.mse_interval.low), csv_cell(p.mse_interval.high), csv_cell(p.mse / one.power),
                               csv_cell(p.bias), csv_cell(p.bias_standard_error));
        }
    return csv;
}

std::string text_of(const ImageSeries& measured, int columns) {
    const Series& series = measured.series;
    std::vector<std::vector<std::string>> rows;
    const bool timed = std::isfinite(series.points.front().seconds);
    for (std::size_t i = 0; i < series.points.size(); ++i) {
        const ConvergencePoint& p = series.points[i];
        const double cost = timed ? p.seconds : static_cast<double>(p.n);
        rows.push_back(
            {std::to_string(p.n), std::to_string(measured.images[i]), reports::readable(p.seconds),
             reports::readable(p.mse),
             fmt::format("[{}, {}]", reports::readable(p.mse_interval.low), reports::readable(p.mse_interval.high)),
             reports::readable(p.mse / measured.power),
             fmt::format("{} ± {}", reports::readable(p.bias), reports::readable(p.bias_standard_error)),
             p.mse > 0 ? reports::readable(1 / (p.mse * cost)) : "–"});
    }
    return fmt::format("{}slope {} [{}, {}]\n",
                       reports::table({{"spp", reports::Align::right},
                                       {"images", reports::Align::right},
                                       {"seconds", reports::Align::right},
                                       {"mse", reports::Align::right},
                                       {"95 %"},
                                       {"relMSE", reports::Align::right},
                                       {"bias ± standard error"},
                                       {timed ? "1/(mse·seconds)" : "1/(mse·spp)", reports::Align::right}},
                                      rows, static_cast<std::size_t>(columns)),
                       reports::readable(series.slope.value), reports::readable(series.slope.interval.low),
                       reports::readable(series.slope.interval.high));
}

}  // namespace plumb
