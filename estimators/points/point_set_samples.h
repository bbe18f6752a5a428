#pragma once

#include <functional>
#include <map>
#include <vector>

#include "core/point.h"
#include "core/primary_samples.h"
#include "core/random.h"

namespace plumb {

/// The n samples of one pixel in one pass: for every slot a point set of its own, in an order of its own ("padding"),
/// so that one pair of numbers is spread over the samples and pairs of different slots are independent. A path is still
/// a function of its key: seed, pixel, and sample = pass · n + index in the pass.
class PointSetSamples final : public PrimarySamples {
public:
    /// n points in [0,1)², each of them uniform.
    using Generate = std::function<std::vector<Point<2>>(std::uint64_t n, RandomStream& random)>;

    PointSetSamples(Generate generate, std::uint32_t n) : generate_(std::move(generate)), n_(n) {}

    /// The path whose numbers at() gives from now on. Sets are kept as long as pixel and pass stay the same.
    void start(const PathKey& key);
    Drawn at(Slot slot) override;

private:
    /// The points of one slot, and for which pixel and pass they were made.
    struct Set {
        std::uint64_t made_for = 0;
        std::vector<Point<2>> points;
    };
    Set& set_of(Slot slot);

    Generate generate_;
    std::uint32_t n_;
    PathKey key_{~std::uint64_t{0}, ~std::uint32_t{0}, ~std::uint32_t{0}};
    std::uint64_t now_ = 0;                      // counts pixels and passes as they come
    std::vector<Set> from_sensor_, from_light_;  // by slot, of the two subpaths' vertices
    std::map<Slot, Set> of_more_samples_;        // the rare slots of a vertex's second sample and later ones
};

}  // namespace plumb
