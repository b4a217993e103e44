// The tables of quality metrics: for each shape, its metrics with their limits and the functions that compute them from
// points.
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/quality/metric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace concino::detail {

/// What the value of a metric depends on. Faces run counter-clockwise seen from outside; surfaces have none.
struct poly_geometry {
  poly_shape shape{};
  std::span<const vec3> points;              // in the standard order of the shape, else in cyclic order or in any
  std::span<const unsigned> face_begins;     // where the verts of each face begin, and the number of all
  std::span<const unsigned> face_verts;      // numbers of points
  double mean_size = 0;                      // the mean area or volume of the polys of the mesh
};

/// Computes the values of n polys of one shape, whose points follow one another. One call for many polys takes less
/// than half the time for simple metrics.
using metric_function = void (*)(const poly_geometry& all, std::size_t n, double* values);

struct metric_row {
  metric what;
  metric_function compute;  // products of 8 lengths neither overflow nor underflow
  metric_limits limits;
};

/// Calls a member function of an object that is constructed from the poly.
template<class Kernel, double (Kernel::*Value)() const>
void metric_of(const poly_geometry& all, std::size_t n, double* values) {
  poly_geometry g = all;
  const std::size_t size = all.points.size() / n;
  for (std::size_t i = 0; i < n; ++i) {
    g.points = all.points.subspan(i * size, size);
    values[i] = (Kernel(g).*Value)();
  }
}

/// The length of a vector that is not so short or long that its square has fewer digits.
inline double length_of(const vec3& x) { return std::sqrt(dot(x, x)); }

inline constexpr double no_limit = std::numeric_limits<double>::infinity();
inline constexpr double no_ideal = std::numeric_limits<double>::quiet_NaN();

// Limits that many metrics share: ratios that are at least 1, parts of 1, measures.
constexpr metric_limits ratio_to(double acceptable) { return {{1, acceptable}, {1, no_limit}, 1, 0}; }
constexpr metric_limits part_from(double acceptable) { return {{acceptable, 1}, {0, 1}, 1, 0}; }
constexpr metric_limits signed_part_from(double acceptable) { return {{acceptable, 1}, {-1, 1}, 1, 0}; }
constexpr metric_limits relative_from(double acceptable) { return {{acceptable, 1}, {0, 1}, no_ideal, 0}; }
constexpr metric_limits deviation_to(double acceptable, double full) { return {{0, acceptable}, {0, full}, 0, 0}; }
constexpr metric_limits size_of(double ideal, unsigned length_power) {
  return {{0, no_limit}, {-no_limit, no_limit}, ideal, length_power};
}

/// a / b, or infinity if b is not positive: for metrics that are at least 0 and worse if larger.
inline double ratio_or_infinite(double a, double b) { return b > 0 ? a / b : no_limit; }
/// a / b, or 0 if b is not positive: for metrics that are worse if smaller.
inline double ratio_or_zero(double a, double b) { return b > 0 ? a / b : 0; }
inline double in_degrees(double radians) { return radians * (180 / std::numbers::pi); }

/// The angle between two vectors, in degrees; 0 if one has no length.
// -0 counts as 0
inline double angle_in_degrees(const vec3& a, const vec3& b) {
  return in_degrees(std::atan2(length_of(cross(a, b)), dot(a, b) + 0.0));
}

/// min(s, 1/s)^2 for s = size / mean; 0 if either is not positive.
inline double squared_relative_size(double size, double mean) {
  if (!(size > 0 && mean > 0)) return 0;
  const double s = std::min(size / mean, mean / size);
  return s * s;
}

/// The largest deviation of angles from that of the regular shape, as a part of what is possible.
inline double skew_of_angles(double smallest, double largest, double regular) {
  return std::max((largest - regular) / (180 - regular), (regular - smallest) / regular);
}

std::span<const metric_row> triangle_rows();
std::span<const metric_row> quad_rows();
std::span<const metric_row> tet_rows();
std::span<const metric_row> hex_rows();
std::span<const metric_row> polygon_rows();     // of all polygons; triangles and quads have rows of their own besides
std::span<const metric_row> polyhedron_rows();  // of all volume cells; tets and hexes have rows of their own besides

/// Whether a value is not worse than all of a range.
inline bool is_acceptable_in(const value_range& range, bool larger_values_are_worse, double value) {
  return larger_values_are_worse ? value <= range.high : value >= range.low;
}

/// The row of a metric, or null if it is not defined for the shape.
const metric_row* find_row(metric what, poly_shape shape);

/// The values of a metric for n polys of one shape with points of any magnitude. NaN if a point is not finite.
void evaluate(const metric_row& row, const poly_geometry& all, std::size_t n, double* values);

/// The verts of the faces of a standard shape.
void set_standard_faces(poly_geometry& g);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/quality/detail/hex_metrics.ipp>
#include <concino/quality/detail/metric.ipp>
#include <concino/quality/detail/polygon_metrics.ipp>
#include <concino/quality/detail/polyhedron_metrics.ipp>
#include <concino/quality/detail/quad_metrics.ipp>
#include <concino/quality/detail/tet_metrics.ipp>
#include <concino/quality/detail/triangle_metrics.ipp>
#include <concino/quality/detail/kernel_fraction.ipp>
#endif
