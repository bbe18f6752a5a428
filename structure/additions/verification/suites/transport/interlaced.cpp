// Passes of fields have the mean of a whole picture.

#include "integrators/drivers/interlaced.h"
#include "integrators/drivers/render.h"
#include "integrators/drivers/tiles.h"
#include "integrators/estimators/path.h"
#include "verification/claim.h"
#include "verification/evidence/mean.h"
#include "verification/suites/transport/transport_subjects.h"

namespace plumb::suites {
namespace {

using Counts = std::function<double(const Interlaced& right, const RenderJob& job, std::uint32_t pass, int y)>;

/// Rows that count by another rule.
struct RowsBy final : Driver {
    Interlaced right{2};
    Counts counts;

    explicit RowsBy(Counts rule) : counts(std::move(rule)) {}
    [[nodiscard]] std::size_t pieces(const RenderJob& job) const override { return right.pieces(job); }
    void make(const RenderJob& job, std::uint32_t pass, std::size_t piece, PassImage& image) const override {
        make_rows(job, pass, piece, image, [&](int y) { return counts(right, job, pass, y); });
    }
    [[nodiscard]] std::optional<double> weight(const RenderJob&, std::uint32_t, int, int) const override { return {}; }
};

using Subject = std::shared_ptr<const Driver>;

// Inside of the sphere every path brings the same, 3/4 in all. Lower rows count more: it shows who is preferred.
Verdict unbiased(const Subject& driver, const Run& run) {
    const PathTracer path({.max_edges = 3, .roulette_edges = 3});
    const auto draw = [&](RandomStream& random) {
        const RenderSettings settings{.samples_per_pass = 1, .passes = 1, .seed = random.bits(), .crop = {0, 0, 4, 4}};
        const Film film = render({sphere_around_point(), path, settings, driver}).film;
        double sum = 0;
        for (int i = 0; i < 16; ++i) sum += film.mean(i % 4, i / 4, 0) * (0.5 + (i / 4 + 0.5) / 4) / 16;
        return sum;
    };
    return mean_is(
        draw, {.reference = 0.75, .delta = 0.015, .epsilon = 1e-5, .bounds = {0, 1.5}, .cap = std::uint64_t{1} << 16},
        run);
}

}  // namespace

void add_transport_interlaced(Catalogue& catalogue) {
    const auto right_weight = [](const Interlaced& right, const RenderJob& job, std::uint32_t pass, int y) {
        return *right.weight(job, pass, 0, y);
    };
    const Subject undivided =
        std::make_shared<RowsBy>([=](const Interlaced& right, const RenderJob& job, std::uint32_t pass, int y) {
            return right_weight(right, job, pass, y) / 2;
        });
    const Subject first = std::make_shared<RowsBy>(
        [](const Interlaced&, const RenderJob&, std::uint32_t, int y) { return y % 2 == 0 ? 2.0 : 0.0; });
    catalogue.add({.id = "render/interlaced/unbiased",
                   .statement = "A pass that draws one of two fields has the mean of a picture of both.",
                   .source = "ours, integrators/drivers/interlaced.h",
                   .kind = Kind::mean,
                   .trial = {unbiased,
                             Subject(std::make_shared<Interlaced>(2)),
                             {{"undivided", "rows count once, whatever the chance of their field", undivided},
                              {"first", "the first field is drawn in every pass", first}}}});
}

}  // namespace plumb::suites
