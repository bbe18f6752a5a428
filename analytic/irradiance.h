#pragma once

#include <vector>

#include "core/vec3.h"

namespace plumb {

// Irradiance at a point p with unit normal n from a light of radiance 1 with nothing in between. Derived
// here, held to quadratures in irradiance_test.cpp and by the claims light/irradiance/*.

/// The irradiance from a polygon that shines to the side from which its corners run counterclockwise; any polygon, any
/// place, parts below the horizon of n cut off. By Stokes, ∫ n·ω dω = ½ Σ θ_i n·γ_i over the edges, where θ_i is the
/// angle that the edge subtends and γ_i the unit normal of its plane with p [Lambert 1760; Baum, Rushmeier & Winget
/// 1989, eq. 9]. It is 0 from behind.
double polygon_irradiance(Vec3 p, Vec3 n, const std::vector<Vec3>& corners);

/// The irradiance from a sphere seen from outside, whose part below the horizon is cut off [Snyder 1996].
double sphere_irradiance(Vec3 p, Vec3 n, Vec3 centre, double radius);

/// The irradiance from a disk that shines to the side of its unit normal; p is in front of it, and the whole disk above
/// the horizon of n (throws Error otherwise: no closed form there).
double disk_irradiance(Vec3 p, Vec3 n, Vec3 centre, Vec3 normal, double radius);

/// The form factor between two equal a × b rectangles, parallel and opposite at distance c [Howell, C-11].
double parallel_rectangles_form_factor(double a, double b, double c);

/// The form factor from a rectangle of width w to a rectangle of height h at a right angle, which share an edge of
/// length l [Howell, C-14].
double perpendicular_rectangles_form_factor(double l, double w, double h);

/// The radius, in the plane in focus, of the disk into which a thin lens spreads a point at this depth: rays from every
/// point o of the lens through the point p meet the plane z = focus at p·focus/z + o (1 − focus/z) (similar triangles).
double circle_of_confusion(double lens_radius, double focus, double depth);

}  // namespace plumb
