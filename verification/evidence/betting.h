#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/interval.h"
#include "core/moments.h"

namespace plumb {

/// The test behind every mean claim, as a value that is fed blocks of samples: e-processes, each a product of
/// 1 + lambda (x − m) with lambda chosen before x is seen [Waudby-Smith & Ramdas 2024]. Under "the mean is m" (or on
/// the far side of m, for a lambda of the right sign) such a product is a non-negative supermartingale that starts at
/// 1, so the chance that it *ever* reaches 1/a is at most a (Ville): every look is allowed.
///
///   against the claim     mixture over lambda = ±2^j delta/variance at the ends of `allowed`;   refuted at 1/alpha
///   against too large     lambda = −delta/variance at the upper end of `resolved`  } both at 1/beta: holds
///   against too small     lambda = +delta/variance at its lower end                }
///
/// An infinite end asks for nothing on its side. With bounds on the values, lambda is kept where every factor is at
/// least 1/2, and the risks are exact. Without, a factor can only be kept positive by clamping: then looks count
/// only while the sample's skewness allows a normal approximation, and from min_samples on. A bet that the mean is
/// larger needs only a lower bound: for non-negative values "too large" and "not too small" are exact, at any look.
class MeanTest {
public:
    struct Setting {
        Interval allowed;   ///< the means that the claim allows
        Interval resolved;  ///< the means that `holds` leaves possible; contains `allowed`
        double delta;       ///< the deviation to look for first; sets the size of the bets
        Interval bounds;    ///< of one value; infinite where unknown
        double alpha, beta;
        std::uint64_t min_samples;  ///< before which nothing holds and no bet without bounds is made
    };
    enum class Decision { none, holds, refuted };

    explicit MeanTest(const Setting& setting);

    /// Samples are consumed in blocks of this size (lambda is fixed within a block); the last may be shorter.
    [[nodiscard]] std::size_t block_size() const;
    /// Feeds the next block. Values must be finite, within the bounds, and of a size not far from delta's: mean_is()
    /// subtracts the reference and divides by delta.
    Decision add(std::span<const double> block);

    [[nodiscard]] const Moments& moments() const { return moments_; }
    [[nodiscard]] double p_value() const;  ///< 1/max of the e-process against the claim, valid at any stop
    /// Logarithm of the e-process against the claim as it stands: its expectation under the claim is at most 1.
    [[nodiscard]] double log_evidence() const { return log_evidence(false); }
    [[nodiscard]] bool exact() const { return exact_below_ && exact_above_; }
    /// Whether bets whose risks are exact refute the claim, those that rest on seen values left out.
    [[nodiscard]] bool refuted_exactly() const;
    /// Whether the guard on skewness lets a look count that is not exact.
    [[nodiscard]] bool tails_allow_a_decision() const;
    /// A 1 − beta confidence sequence for the mean (normal mixture, asymptotic), for the report.
    [[nodiscard]] Interval mean_interval() const;

    static constexpr std::size_t largest_block = 256;
    static constexpr int scales = 8;  ///< lambda = 2^j delta/variance, j = −1 … 5, and as large as is safe

private:
    struct Bet {
        double m;      ///< the mean that is bet against
        double scale;  ///< lambda in units of delta/variance, with its sign
        double log_wealth = 0;
    };
    [[nodiscard]] bool is_exact(const Bet& bet) const { return bet.scale > 0 ? exact_below_ : exact_above_; }
    [[nodiscard]] bool excludes_large() const;
    [[nodiscard]] bool excludes_small() const;
    [[nodiscard]] double log_evidence(bool exact_bets_only) const;
    [[nodiscard]] double variance_guess(std::uint64_t least_seen) const;
    void play(std::span<const double> block, const Interval& values);
    void record_maxima();
    [[nodiscard]] double lambda(const Bet& bet, double variance) const;

    Setting setting_;
    bool exact_below_, exact_above_;
    Moments moments_;
    Interval seen_{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    std::vector<Bet> against_claim_;
    Bet against_large_, against_small_;
    double max_log_claim_ = 0, max_log_large_ = 0, max_log_small_ = 0;  ///< over the looks that count
    double max_log_exact_ = 0;                                          ///< of exact bets against the claim
    double z_guard_;
};

}  // namespace plumb
