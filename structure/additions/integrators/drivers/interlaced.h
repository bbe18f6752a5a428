#pragma once

#include <functional>

#include "core/parameters.h"
#include "integrators/drivers/driver.h"

namespace plumb {

/// Each pass draws one of so many fields, every `fields`-th row, as television did; which one is a function of
/// (seed, pass), all alike. What is drawn counts `fields` times: each pass is unbiased.
struct Interlaced final : Driver {
    std::uint64_t fields;

    explicit Interlaced(std::uint64_t number_of_fields) : fields(number_of_fields) {}

    [[nodiscard]] std::size_t pieces(const RenderJob& job) const override;
    void make(const RenderJob& job, std::uint32_t pass, std::size_t piece, PassImage& image) const override;
    [[nodiscard]] std::optional<double> weight(const RenderJob& job, std::uint32_t pass, int x, int y) const override;
};

/// A piece of a pass whose rows count so much; those of weight 0 are left out.
void make_rows(const RenderJob& job, std::uint32_t pass, std::size_t piece, PassImage& image,
               const std::function<double(int y)>& weight);

const Parameter interlaced_fields{"fields", "that the rows are dealt to", Parameter::Integer{2, 1, 64}};
std::unique_ptr<Driver> make_interlaced(const RenderJob& job, const Parameters& parameters);

}  // namespace plumb
