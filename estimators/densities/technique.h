#pragma once

#include <functional>
#include <string>
#include <utility>

#include "core/point.h"
#include "core/random.h"

namespace plumb {

/// A sampling technique on the unit cube, whatever stands behind it.
template <int D>
struct Technique {
    std::string name;
    std::function<Point<D>(const Point<D>& u)> sample;  ///< u uniform on the unit cube
    std::function<double(const Point<D>&)> pdf;
};

/// A point of the unit cube, uniform.
template <int D>
Point<D> uniform_point(RandomStream& random) {
    Point<D> u;
    for (double& coordinate : u) coordinate = random.uniform();
    return u;
}

/// A one-dimensional density (density.h, piecewise_constant.h) as a technique.
template <class Density>
Technique<1> technique_1d(std::string name, const Density& density) {
    return {std::move(name), [density](const Point<1>& u) { return Point<1>{density.sample(u[0])}; },
            [density](const Point<1>& x) { return density.pdf(x[0]); }};
}

/// A density on points (density_2d.h) as a technique.
template <class Density>
Technique<2> technique_2d(std::string name, const Density& density) {
    return {std::move(name), [density](const Point<2>& u) { return density.sample(u); },
            [density](const Point<2>& x) { return density.pdf(x); }};
}

}  // namespace plumb
