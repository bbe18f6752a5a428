#pragma once

#include <vector>

#include "core/vec3.h"

namespace plumb {

/// A rectangle that shines and reflects diffusely on the side of edge_1 × edge_2; its edges are at a right angle.
struct RadiosityPlate {
    Vec3 corner, edge_1, edge_2;
    double emission;  ///< radiance, everywhere alike
    double albedo;

    [[nodiscard]] Vec3 point(double s, double t) const { return corner + s * edge_1 + t * edge_2; }
    [[nodiscard]] Vec3 normal() const { return normalize(cross(edge_1, edge_2)); }
};

/// Light of all orders between plates that see each other in full, as faces of a convex body do: the radiance L with
///   L(x) = L_e(x) + ρ(x) ∫ L(y) k(x, y) dA(y),  k = cos θ_x cos θ_y / (π d²).
/// L is sought among the polynomials of degree n − 1 in s and t on each plate, for which the equation is to hold at the
/// n² Gauss–Legendre nodes. Integrals are cut into cells no larger than 1.5 times their distance from x. The error is
/// what a larger n changes: for n = 8, a few 1e-10 between plates at the distance of their sides; at the middle of the
/// faces of a closed cube 1e-5, for where plates touch, L has no derivatives and converges as a power of 1/n.
class Radiosity {
public:
    /// The radiosity of light that is reflected at most so often on its way to the eye, at least once; -1: as often as
    /// changes a double. Throws Error for another number, for an albedo that is not in [0, 1): light would never end,
    /// for an emission that is not finite, and where 10,000 reflections still change doubles.
    Radiosity(std::vector<RadiosityPlate> plates, int n, int reflections = -1);

    /// The radiance that leaves plate.point(s, t), in every direction.
    [[nodiscard]] double radiance(std::size_t plate, double s, double t) const;
    /// The integral of that radiance over the plate, of all reflections.
    [[nodiscard]] double integral(std::size_t plate) const;

private:
    [[nodiscard]] std::vector<double> gathering(std::size_t plate, double s, double t) const;
    [[nodiscard]] double leaving(std::size_t plate, const std::vector<double>& weights) const;

    std::vector<RadiosityPlate> plates_;
    std::vector<double> nodes_, weights_;  // of one axis
    std::vector<double> radiance_;         // at the nodes, plate by plate: all but the last reflection
};

}  // namespace plumb
