// The lattice on which points of the plane are snapped for exact work on them.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/slice_layer.hpp>
#include <concino/print/planar_regions.hpp>
#include <concino/print/polygon_clipper.hpp>

#include <cmath>
#include <limits>
#include <span>

namespace concino::detail {

/// The box around points.
struct planar_box {
  double min[2] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  double max[2] = {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void add(const slice_point& p) {
    for (const std::size_t k : {0u, 1u}) {
      min[k] = p[k] < min[k] ? p[k] : min[k];
      max[k] = p[k] > max[k] ? p[k] : max[k];
    }
  }
  void add(std::span<const slice_point> points) {
    for (const slice_point& p : points) add(p);
  }
  bool is_empty() const { return !(min[0] <= max[0]); }
};

/// Multiples of a power of two, counted from the middle of a box.
class lattice {
  double unit_ = 1, origin_[2] = {0, 0};  // the origin in units

 public:
  lattice() = default;
  /// The coarsest lattice with 2^bits units or more in the size of the box with a margin of `reach` around it. Where
  /// that is finer than the last digits of the coordinates, units are those digits.
  /// Needs:  finite points.
  /// Errors: unsupported if the size has no such unit.
  lattice(const char* caller, const planar_box& box, double reach, int bits);

  double unit() const { return unit_; }
  snapped_point operator()(const slice_point& p) const {
    return {static_cast<std::int64_t>(std::nearbyint(p[0] / unit_) - origin_[0]),
            static_cast<std::int64_t>(std::nearbyint(p[1] / unit_) - origin_[1])};
  }
  slice_point operator()(const snapped_point& p) const {
    return {(static_cast<double>(p[0]) + origin_[0]) * unit_, (static_cast<double>(p[1]) + origin_[1]) * unit_};
  }
  /// The lattice with 2^bits units in each unit of this one.
  lattice finer(int bits) const {
    lattice l = *this;
    l.unit_ = std::ldexp(unit_, -bits);
    for (double& x : l.origin_) x = std::ldexp(x, bits);
    return l;
  }
};

/// Errors: invalid_argument that names a point that is not finite.
void check_finite_points(const char* caller, const planar_regions& regions, const char* which);

/// The contours of regions on a lattice.
lattice_paths snap(const planar_regions& regions, const lattice& to);
/// Regions on a lattice in units of length.
planar_regions regions_from(const lattice_regions& regions, const lattice& from);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/print/detail/regions/lattice.ipp>
#endif
