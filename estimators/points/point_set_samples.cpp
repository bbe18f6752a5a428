#include "estimators/points/point_set_samples.h"

#include <span>

namespace plumb {

void PointSetSamples::start(const PathKey& key) {
    const bool same_sets = key.seed == key_.seed && key.pixel == key_.pixel && key.sample / n_ == key_.sample / n_;
    if (!same_sets) sets_.clear();
    key_ = key;
}

Drawn PointSetSamples::at(Slot slot) {
    std::vector<Point<2>>& set = sets_[slot];
    if (set.empty()) {
        const std::uint64_t pixel_and_pass = static_cast<std::uint64_t>(key_.pixel) << 32 | key_.sample / n_;
        RandomStream random(key_.seed, pixel_and_pass, slot_index(slot));
        set = generate_(n_, random);
        shuffle(std::span(set), random);
    }
    return {set[key_.sample % n_]};
}

}  // namespace plumb
