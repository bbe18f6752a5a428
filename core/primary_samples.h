#pragma once

#include <array>
#include <compare>
#include <cstdint>

#include "core/random.h"

namespace plumb {

/// What a pair of random numbers of a path is for. Coordinates of a path go by name, never by counting calls, so that
/// replay, Markov chains, guiding and reweighting stay aligned when a vertex skips a draw.
enum class Use : std::uint8_t {
    film,
    lens,
    time,
    wavelength,
    light,
    light_point,
    lobe,
    direction,
    roulette,
    shadow,
    visibility
};
constexpr std::size_t use_count = static_cast<std::size_t>(Use::visibility) + 1;

/// The address of a pair: the path's vertex (the sensor is 0; light subpaths count from 0x8000), its use, and the
/// sample that it is for, where the vertex takes several. Four bytes, so that it goes in a register: `path` draws some
/// ten a vertex.
struct Slot {
    std::uint16_t vertex = 0;
    Use use = Use::film;
    std::uint8_t sample = 0;
    friend auto operator<=>(const Slot&, const Slot&) = default;
};

/// The number of a sample at a vertex: 0 is the only one, or the path's own.
struct SampleIndex {
    std::uint16_t vertex;
    std::uint8_t sample = 0;

    [[nodiscard]] constexpr Slot slot(Use use) const { return {vertex, use, sample}; }
};

/// A number for each slot, as the index of a RandomStream.
constexpr std::uint64_t slot_index(Slot slot) {
    return static_cast<std::uint64_t>(slot.sample) << 24 | static_cast<std::uint64_t>(slot.vertex) << 8 |
           static_cast<std::uint8_t>(slot.use);
}

/// u in [0,1)² and the density it was drawn with there, given what was drawn before: 1 unless guided.
struct Drawn {
    std::array<double, 2> u;
    double density = 1;
};

/// The 16 bytes that replay a whole path.
struct PathKey {
    std::uint64_t seed = 0;
    std::uint32_t pixel = 0, sample = 0;
    friend bool operator==(const PathKey&, const PathKey&) = default;
};

/// The source from which an integrator takes a path's random numbers.
struct PrimarySamples {
    virtual ~PrimarySamples() = default;
    /// The numbers of the slot: the same however often and in whatever order they are asked for.
    virtual Drawn at(Slot slot) = 0;
};

/// The numbers of a part of a path as it draws them, and the density of all of them together. Each slot is drawn once.
class Draws {
public:
    explicit Draws(PrimarySamples& samples) : samples_(&samples) {}

    std::array<double, 2> at(Slot slot) {
        const Drawn drawn = samples_->at(slot);
        density_ *= drawn.density;
        return drawn.u;
    }
    /// The density of what was drawn so far: what depends on all of it, and on nothing else, is divided by it.
    [[nodiscard]] double density() const { return density_; }
    /// The draws of one vertex beside the path, on which nothing behind it depends: their density counts from here.
    [[nodiscard]] Draws branch() const { return Draws(*samples_); }

private:
    PrimarySamples* samples_;
    double density_ = 1;
};

/// Independent uniform numbers: a pure function of the key and the slot. Two slots share a block of random bits, and
/// uses that are asked for together stand side by side (light and light_point, lobe and direction): most blocks are
/// computed once for both.
class IndependentSamples final : public PrimarySamples {
public:
    explicit IndependentSamples(const PathKey& key = {}) { start(key); }
    /// The path whose numbers at() gives from now on.
    void start(const PathKey& key) {
        key_ = key;
        pair_ = none;
    }
    Drawn at(Slot slot) override {
        const std::uint64_t index = slot_index(slot);
        if (index / 2 != pair_) {
            const std::uint64_t path = static_cast<std::uint64_t>(key_.pixel) << 32 | key_.sample;
            RandomStream random(key_.seed, path, pair_ = index / 2);
            for (double& number : numbers_) number = random.uniform();
        }
        const std::size_t first = 2 * (index % 2);
        return {{numbers_[first], numbers_[first + 1]}};
    }

private:
    static constexpr std::uint64_t none = ~std::uint64_t{0};
    PathKey key_;
    std::uint64_t pair_ = none;  // of slots, whose numbers are known
    std::array<double, 4> numbers_{};
};

}  // namespace plumb
