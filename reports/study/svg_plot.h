#pragma once

#include <string>
#include <vector>

namespace plumb::reports {

/// A place on a line, with the band about it. The axes are logarithmic: a place that is not positive is left out; a low
/// bound that is not, or an infinite high one, is drawn a factor of ten away, the former marked ▽.
struct SvgPoint {
    double x = 0, y = 0, low = 0, high = 0;
};

struct SvgLine {
    std::string name;
    std::size_t style = 0;  ///< index of colour and symbol
    std::vector<SvgPoint> points;
};

/// A plot on two logarithmic axes with bands, guides of the given exponents and a legend.
struct SvgPlot {
    std::string title, subtitle, x_label, y_label;
    bool powers_of_two = false;  ///< ticks of the x axis
    std::vector<SvgLine> lines;
    std::vector<double> slopes;
};

/// The plot as a file of its own: SVG 1.1 on a white ground, no script, no reference to anything else.
std::string to_svg(const SvgPlot& plot);

}  // namespace plumb::reports
