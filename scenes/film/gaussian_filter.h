#pragma once

#include "scenes/film/filter_model.h"

namespace plumb {

/// The normal density of this standard deviation, in pixels, cut at four of them. (Mitsuba subtracts e^-8 so that it
/// ends at 0, which moves less than 4e-4 of the mass.)
class GaussianFilter {
public:
    static constexpr std::array plugins{
        description::Plugin{"gaussian", "Gaussian, cut off at four standard deviations"}};
    static GaussianFilter load(description::Properties& properties);

    explicit GaussianFilter(double standard_deviation = 0.5);
    [[nodiscard]] double sample(double u) const;
    [[nodiscard]] double pdf(double x) const;
    [[nodiscard]] double invert(double x) const;
    [[nodiscard]] double radius() const { return 4 * sigma_; }

private:
    double sigma_;
};

}  // namespace plumb
