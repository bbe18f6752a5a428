#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <Random123/philox.h>

namespace plumb {

/// The number that names a stream: 64-bit FNV-1a of its text (a claim's id, an estimator's name).
std::uint64_t stream_id(std::string_view name);

/// A seed that nobody chose, from the system's entropy; 53 bits, so that it survives JSON readers that know only
/// doubles.
std::uint64_t fresh_seed();

/// A stream of random numbers addressed by (seed, stream, index): its k-th number is a pure function of these and k,
/// computed by the counter-based generator Philox4x64-10 [Salmon et al. 2011]. Sample i of a claim takes index i, so
/// nothing depends on which thread drew it or on how many numbers another sample took.
class RandomStream {
public:
    using result_type = std::uint64_t;

    explicit RandomStream(std::uint64_t seed, std::uint64_t stream = 0, std::uint64_t index = 0)
        : key_{{seed, stream}}, index_(index) {}

    /// The next 64 random bits.
    std::uint64_t bits() {
        const unsigned lane = static_cast<unsigned>(next_ & 3);
        if (lane == 0) block_ = r123::Philox4x64()({{next_ >> 2, index_, 0, 0}}, key_);
        ++next_;
        return block_[lane];
    }

    /// A multiple of 2^-53 in [0, 1), uniform.
    double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

    /// A uniform integer in [0, n), n > 0, exactly uniform (Lemire's rejection).
    std::uint64_t below(std::uint64_t n);

    // A UniformRandomBitGenerator, so that Boost's and the standard's distributions can draw from it.
    std::uint64_t operator()() { return bits(); }
    static constexpr std::uint64_t min() { return 0; }
    static constexpr std::uint64_t max() { return ~std::uint64_t{0}; }

private:
    r123::Philox4x64::key_type key_;
    std::uint64_t index_;
    std::uint64_t next_ = 0;
    r123::Philox4x64::ctr_type block_{};
};

/// Fisher–Yates, the same permutation on every standard library.
template <class T>
void shuffle(std::span<T> values, RandomStream& random) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random.below(i)]);
}

/// A uniform permutation of 0 … n−1.
std::vector<std::uint32_t> random_permutation(std::uint32_t n, RandomStream& random);

}  // namespace plumb
