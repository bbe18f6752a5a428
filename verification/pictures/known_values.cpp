#include "verification/pictures/known_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/moments.h"
#include "verification/evidence/distributions.h"
#include "verification/pictures/known_values_verdict.h"
#include "verification/pictures/samples_needed.h"
#include "verification/pictures/weighted_pixels.h"

namespace plumb {
namespace {

std::vector<double> means_of(const Picture& picture) {
    std::vector<Moments> moments(picture.channels.size());
    for (std::size_t k = 0; k < picture.mean.size(); ++k)
        if (std::isfinite(picture.mean[k])) moments[k % moments.size()].add(picture.mean[k]);
    std::vector<double> means;
    for (const Moments& m : moments) means.push_back(m.count() > 0 ? std::abs(m.mean()) : 0);
    return means;
}

// What a relative deviation is relative to: a value of 0 has none of its own.
double scale_of(const KnownValue& known, std::size_t channel, const std::vector<double>& means) {
    const double own = std::abs(known.value[channel]);
    if (own > 0) return own;
    double largest = 0;
    for (const double value : known.value) largest = std::max(largest, std::abs(value));
    return largest > 0 ? largest : means[channel];
}

// Pixels whose samples were all alike may have paths that none of them found: they are believed where the value is
// right, and where it is wrong only if it is not black and its neighbours have no noise either.
bool is_believed(const Picture& picture, const WeightedPixels& pixels, std::size_t channel,
                 const MeanDifference& found) {
    if (found.standard_error > 0 || std::isinf(picture.degrees)) return true;
    if (picture.degrees < 3) return false;
    if (found.p_value == 1) return true;
    for (const PixelWeight& pixel : pixels)
        for (int v = std::max(0, pixel.y - 1); v <= std::min(picture.height - 1, pixel.y + 1); ++v)
            for (int u = std::max(0, pixel.x - 1); u <= std::min(picture.width - 1, pixel.x + 1); ++u)
                if (picture.variance[picture.at(u, v, channel)] > 0) return false;
    return found.a != 0;
}

TileState state_of(const MeanDifference& found, double beta) {
    const bool trusted = interval_is_trusted(found, beta);
    if (found.interval.inside({-found.delta, found.delta}) && trusted) return TileState::same;
    return trusted ? TileState::too_noisy : TileState::heavy_tails;
}

PixelBox box_of(const WeightedPixels& pixels) {
    const auto &first = pixels.front(), &last = pixels.back();
    return {first.x, first.y, last.x - first.x + 1, last.y - first.y + 1};
}

/// Sums as skewed as those of so many pixels: difference_of() takes them for the sums of one.
DifferenceSums as_of_one(DifferenceSums around, double pixels) {
    for (double* third : {&around.third_a, &around.third_b}) *third /= std::sqrt(pixels);
    for (double* error : {&around.third_error_a, &around.third_error_b}) *error /= pixels;
    return around;
}

/// What the values of one channel have in common.
struct Together {
    WeightedPixels pixels = {};
    DifferenceSums around = {};
    double known = 0, error = 0;
    std::size_t count = 0;

    void add(const WeightedPixels& of, const DifferenceSums& around_it, const KnownValue& value, std::size_t channel,
             double scale) {
        for (const auto& [x, y, weight] : of) pixels.push_back({x, y, weight / scale});
        around.merge(around_it);
        known += value.value[channel] / scale;
        error += value.error / scale;
        ++count;
    }
    /// Each pixel once, and means for sums.
    void finish() {
        std::ranges::sort(pixels, {}, [](const PixelWeight& p) { return std::pair{p.y, p.x}; });
        WeightedPixels once;
        const auto n = static_cast<double>(count);
        for (const auto& [x, y, weight] : pixels) {
            if (once.empty() || once.back().x != x || once.back().y != y) once.push_back({x, y, 0});
            once.back().weight += weight / n;
        }
        pixels = std::move(once);
        known /= n;
        error /= n;
    }
};

/// Judges values of a picture, at the level of each test.
class Judge {
public:
    Judge(const Picture& picture, const CheckSettings& settings, double level)
        : picture_(picture), settings_(settings), level_(level), means_(means_of(picture)) {
        for (std::size_t c = 0; c < picture.channels.size(); ++c) {
            channels_.emplace_back(picture, c);
            together_.emplace_back();
        }
    }

    CheckedValue value(std::size_t index, const KnownValue& known, std::size_t c) {
        const WeightedPixels pixels =
            pixels_under(picture_, known.x - known.width / 2, known.y - known.height / 2, known.width, known.height);
        CheckedValue value{.known = index, .channel = c};
        const double scale = scale_of(known, c, means_), delta = settings_.delta * scale;
        const DifferenceSums sums = channels_[c].sums(pixels, known.value[c]);
        if (sums.pixels == 0) return value;
        const DifferenceSums around = channels_[c].sums_around(box_of(pixels));
        value.found = tested(pixels, sums, around, c, delta, known.error);
        value.state = !is_believed(picture_, pixels, c, value.found) ? TileState::no_variance
                      : known.error > delta                          ? TileState::poorly_known
                                                                     : state_of(value.found, settings_.beta);
        forecast(value.found, value.state, delta + known.error);
        if (value.state != TileState::no_variance && value.state != TileState::poorly_known && scale > 0)
            together_[c].add(pixels, around, known, c, scale);
        return value;
    }

    CheckedTogether together(std::size_t c) {
        Together& all = together_[c];
        CheckedTogether found{.channel = c, .values = all.count};
        if (all.count == 0) return found;
        all.finish();
        const DifferenceSums sums = channels_[c].sums(all.pixels, all.known);
        found.found = tested(all.pixels, sums, all.around, c, settings_.delta, all.error);
        found.state = state_of(found.found, settings_.beta);
        if (found.found.p_value < level_ / static_cast<double>(channels_.size())) found.state = TileState::differs;
        forecast(found.found, found.state, settings_.delta + all.error);
        return found;
    }

private:
    MeanDifference tested(const WeightedPixels& pixels, const DifferenceSums& sums, const DifferenceSums& around,
                          std::size_t c, double delta, double error) const {
        return difference_of(sums, as_of_one(around, count_of_equals(pixels)),
                             {.degrees_a = picture_.degrees,
                              .inflation = channels_[c].inflation(pixels),
                              .epsilon = delta + error,
                              .beta = settings_.beta,
                              .delta = std::max(0.0, delta - error)});
    }
    void forecast(MeanDifference& found, TileState state, double epsilon) const {
        if (state == TileState::too_noisy || state == TileState::heavy_tails)
            found.more_samples = more_samples(found, epsilon, level_, settings_.beta);
    }

    const Picture& picture_;
    const CheckSettings& settings_;
    double level_;
    std::vector<double> means_;
    std::vector<NoisyChannel> channels_;
    std::vector<Together> together_;
};

void refute(std::vector<CheckedValue>& values, double alpha) {
    std::vector<CheckedValue*> order;
    for (CheckedValue& value : values)
        if (value.state != TileState::no_pixels && value.state != TileState::no_variance) order.push_back(&value);
    std::ranges::stable_sort(order, {}, [](const CheckedValue* v) { return v->found.p_value; });
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (order[i]->found.p_value > alpha / static_cast<double>(order.size() - i)) return;
        order[i]->state = TileState::differs;
    }
}

}  // namespace

ValuesCheck check(const Picture& picture, std::span<const KnownValue> known, const CheckSettings& settings) {
    ValuesCheck check;
    const double level = known.size() > 1 ? settings.alpha / 2 : settings.alpha;
    Judge judge(picture, settings, level);
    for (std::size_t i = 0; i < known.size(); ++i)
        for (std::size_t c = 0; c < picture.channels.size(); ++c) check.values.push_back(judge.value(i, known[i], c));
    refute(check.values, level);
    for (std::size_t c = 0; known.size() > 1 && c < picture.channels.size(); ++c)
        check.together.push_back(judge.together(c));
    check.verdict = verdict_of(check, picture, known, settings);
    return check;
}

}  // namespace plumb
