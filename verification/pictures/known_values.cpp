#include "verification/pictures/known_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/moments.h"
#include "verification/evidence/distributions.h"

namespace plumb {
namespace {

/// A pixel and the part of the square that it covers.
struct Covered {
    int x, y;
    double share;
};

std::vector<Covered> pixels_under(const Picture& picture, const KnownValue& known) {
    const double left = std::clamp(known.x - 0.5, 0.0, picture.width - 1.0),
                 top = std::clamp(known.y - 0.5, 0.0, picture.height - 1.0);
    const int i = static_cast<int>(std::floor(left)), j = static_cast<int>(std::floor(top));
    std::vector<Covered> covered;
    for (int y = j; y <= j + 1; ++y)
        for (int x = i; x <= i + 1; ++x) {
            const double share = (1 - std::abs(x - left)) * (1 - std::abs(y - top));
            if (share > 0) covered.push_back({x, y, share});
        }
    return covered;
}

/// One weighted mean, as sums over a single pixel. No third cumulant: a few pixels tell too little of it.
DifferenceSums sums_under(const Picture& picture, const std::vector<Covered>& covered, std::size_t channel,
                          double value) {
    DifferenceSums sums{.pixels = 1, .b = value};
    for (const auto& [x, y, share] : covered) {
        const std::size_t k = picture.at(x, y, channel);
        if (!std::isfinite(picture.mean[k])) return {};
        const double variance = share * share * (picture.variance[k] + picture.variance_rounding);
        sums.a += share * picture.mean[k];
        sums.variance_a += variance;
        sums.rounding += share * picture.rounding_at(k);
        sums.square_a += std::isinf(picture.degrees) ? 0 : variance * variance / (picture.degrees + 2);
    }
    return sums;
}

// The mean of a pixel's neighbours, up to eight that are finite; NaN without any, and where the pixel is four standard
// errors away: that is an edge in the picture, no noise.
double neighbours(const Picture& part, int x, int y) {
    Moments moments;
    for (int v = std::max(0, y - 1); v <= std::min(part.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(part.width - 1, x + 1); ++u)
            if ((u != x || v != y) && std::isfinite(part.mean[part.at(u, v, 0)]))
                moments.add(part.mean[part.at(u, v, 0)]);
    const std::size_t k = part.at(x, y, 0);
    const bool edge = std::abs(part.mean[k] - moments.mean()) > 4 * std::sqrt(part.variance[k]);
    return edge ? std::numeric_limits<double>::quiet_NaN() : moments.mean();
}

/// The sums of 17 x 17 pixels about the square, whose skewness is taken for the square's own. Each pixel is compared
/// with the mean of its neighbours, and sums_of() takes off what its neighbours differ by from theirs: a picture that
/// is quadratic in x and y leaves nothing but noise.
DifferenceSums sums_around(const Picture& picture, const Covered& centre, std::size_t channel) {
    constexpr int reach = 8;
    const int left = std::max(0, centre.x - reach), top = std::max(0, centre.y - reach);
    const PixelBox box{left, top, std::min(picture.width, centre.x + reach + 1) - left,
                       std::min(picture.height, centre.y + reach + 1) - top};
    Picture part{.width = box.width, .height = box.height, .channels = {picture.channels[channel]}};
    part.degrees = picture.degrees;
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) {
            part.mean.push_back(picture.mean[picture.at(x, y, channel)]);
            part.variance.push_back(picture.variance[picture.at(x, y, channel)]);
        }
    Picture smooth = part;
    std::ranges::fill(smooth.variance, 0);
    for (int y = 0; y < box.height; ++y)
        for (int x = 0; x < box.width; ++x) smooth.mean[smooth.at(x, y, 0)] = neighbours(part, x, y);
    const auto edge = [](int length) { return std::min(1, (length - 1) / 2); };
    const int dx = edge(box.width), dy = edge(box.height);
    return sums_of(part, smooth, {dx, dy, box.width - 2 * dx, box.height - 2 * dy}, 0);
}

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

// A pixel whose samples were all alike may have paths that none of them found: it is believed where the value is right,
// and where it is wrong only if it is not black and its neighbours have no noise either.
bool is_believed(const Picture& picture, const Covered& centre, std::size_t channel, const MeanDifference& found) {
    if (found.standard_error > 0 || std::isinf(picture.degrees)) return true;
    if (picture.degrees < 3) return false;
    if (found.p_value == 1) return true;
    for (int v = std::max(0, centre.y - 1); v <= std::min(picture.height - 1, centre.y + 1); ++v)
        for (int u = std::max(0, centre.x - 1); u <= std::min(picture.width - 1, centre.x + 1); ++u)
            if (picture.variance[picture.at(u, v, channel)] > 0) return false;
    return found.a != 0;
}

TileState state_of(const MeanDifference& found, double beta) {
    const bool trusted = interval_is_trusted(found, beta);
    if (found.interval.inside({-found.delta, found.delta}) && trusted) return TileState::same;
    return trusted ? TileState::too_noisy : TileState::heavy_tails;
}

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

std::string count_of(const ValuesCheck& check, std::size_t count, const char* what) {
    return fmt::format("{} of {} values {}", count, check.values.size(), what);
}

Verdict verdict_of(const ValuesCheck& check, const Picture& picture, std::span<const KnownValue> known,
                   const CheckSettings& settings) {
    Verdict verdict;
    verdict.samples = check.values.size();
    verdict.resolution = settings.delta;
    // The one that is furthest off, in units of its delta.
    const CheckedValue *wrong = nullptr, *open = nullptr;
    std::size_t wrong_count = 0, open_count = 0;
    const auto off = [](const CheckedValue& v) {
        const double difference = std::abs(v.found.difference);
        if (v.found.delta > 0) return difference / v.found.delta;
        return difference > 0 ? std::numeric_limits<double>::infinity() : 0;
    };
    for (const CheckedValue& value : check.values) {
        const bool refuted = value.state == TileState::differs;
        if (value.state == TileState::same) continue;
        ++(refuted ? wrong_count : open_count);
        const CheckedValue*& worst = refuted ? wrong : open;
        if (!worst || off(value) > off(*worst)) worst = &value;
        verdict.p_value = std::fmin(verdict.p_value, value.found.p_value);
    }
    const auto place = [&](const CheckedValue& v) {
        return fmt::format("{} of {}", picture.channels[v.channel], known[v.known].name);
    };
    if (wrong) {
        verdict.outcome = Outcome::refuted;
        verdict.reason = fmt::format("{}, most of all {}: found {:.5g}, known {:.5g}",
                                     count_of(check, wrong_count, wrong_count == 1 ? "is wrong" : "are wrong"),
                                     place(*wrong), wrong->found.a, wrong->found.b);
    } else if (open) {
        verdict.outcome = Outcome::undecided;
        verdict.reason =
            fmt::format("{}, least of all {} ({})",
                        count_of(check, open_count, open_count == 1 ? "is not decided" : "are not decided"),
                        place(*open), to_string(open->state));
    } else {
        verdict.outcome = Outcome::holds;
        verdict.reason =
            fmt::format("all {} values are as known, within {:.3g} %", check.values.size(), 100 * settings.delta);
    }
    return verdict;
}

}  // namespace

ValuesCheck check(const Picture& picture, std::span<const KnownValue> known, const CheckSettings& settings) {
    ValuesCheck check;
    const std::vector<double> means = means_of(picture);
    for (std::size_t i = 0; i < known.size(); ++i) {
        const std::vector<Covered> covered = pixels_under(picture, known[i]);
        const Covered& centre = std::ranges::max(covered, {}, &Covered::share);
        for (std::size_t c = 0; c < picture.channels.size(); ++c) {
            CheckedValue value{.known = i, .channel = c};
            const double delta = settings.delta * scale_of(known[i], c, means), b = known[i].value[c];
            const DifferenceSums sums = sums_under(picture, covered, c, b);
            if (sums.pixels > 0) {
                value.found = difference_of(sums, sums_around(picture, centre, c),
                                            {.degrees_a = picture.degrees,
                                             .epsilon = delta + known[i].error,
                                             .beta = settings.beta,
                                             .delta = std::max(0.0, delta - known[i].error)});
                value.state = !is_believed(picture, centre, c, value.found) ? TileState::no_variance
                              : known[i].error > delta                      ? TileState::poorly_known
                                                                            : state_of(value.found, settings.beta);
            }
            check.values.push_back(value);
        }
    }
    refute(check.values, settings.alpha);
    check.verdict = verdict_of(check, picture, known, settings);
    return check;
}

}  // namespace plumb
