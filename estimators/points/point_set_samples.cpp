#include "estimators/points/point_set_samples.h"

#include <span>

namespace plumb {

namespace {

constexpr std::uint16_t first_light_slot = 0x8000;

}  // namespace

void PointSetSamples::start(const PathKey& key) {
    const bool same_sets = key.seed == key_.seed && key.pixel == key_.pixel && key.sample / n_ == key_.sample / n_;
    if (!same_sets || now_ == 0) ++now_;
    key_ = key;
}

PointSetSamples::Set& PointSetSamples::set_of(Slot slot) {
    if (slot.sample > 0) return of_more_samples_[slot];
    const bool of_light = slot.vertex >= first_light_slot;
    std::vector<Set>& sets = of_light ? from_light_ : from_sensor_;
    const std::size_t vertex = slot.vertex - (of_light ? first_light_slot : 0u);
    const std::size_t number = vertex * use_count + static_cast<std::size_t>(slot.use);
    if (number >= sets.size()) sets.resize((vertex + 1) * use_count);
    return sets[number];
}

Drawn PointSetSamples::at(Slot slot) {
    Set& set = set_of(slot);
    if (set.made_for != now_) {
        const std::uint64_t pixel_and_pass = static_cast<std::uint64_t>(key_.pixel) << 32 | key_.sample / n_;
        RandomStream random(key_.seed, pixel_and_pass, slot_index(slot));
        set.points = generate_(n_, random);
        shuffle(std::span(set.points), random);
        set.made_for = now_;
    }
    return {set.points[key_.sample % n_]};
}

}  // namespace plumb
