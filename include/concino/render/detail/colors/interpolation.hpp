// Interpolation of values at corners over a polygon, and how fast the result changes in the picture.
#pragma once

#include <concino/render/detail/colors/band_coverage.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace concino::detail {

/// The weights of corners at a point: of all corners of a polygon, or of three of them.
struct interpolation {
  std::uint32_t first = 0;                 // the first corner of the polygon
  std::span<const double> weights;         // of the corners from the first one on; empty: only those of the triangle
                                           // have weights
  std::array<std::uint32_t, 3> triangle{};
  std::array<double, 3> bary{};

  /// sum + the mean of of_corner(c) over the corners c.
  template<class F, class T>
  T operator()(F&& of_corner, T sum) const {
    if (weights.empty())
      for (std::size_t k = 0; k < 3; ++k) sum += of_corner(triangle[k]) * bary[k];
    else
      for (std::size_t i = 0; i < weights.size(); ++i)
        sum += of_corner(first + static_cast<std::uint32_t>(i)) * weights[i];
    return sum;
  }

  /// The corner with the largest weight.
  std::uint32_t nearest() const {
    std::uint32_t best = triangle[0];
    double most = -std::numeric_limits<double>::infinity();
    const auto add = [&](std::uint32_t corner, double weight) {
      if (weight > most) best = corner, most = weight;
    };
    if (weights.empty())
      for (std::size_t k = 0; k < 3; ++k) add(triangle[k], bary[k]);
    else
      for (std::size_t i = 0; i < weights.size(); ++i) add(first + static_cast<std::uint32_t>(i), weights[i]);
    return best;
  }
};

/// The interpolation at a sample, and at two points beside it, a part of the way to the next samples to the right and
/// above.
struct sampled_interpolation {
  interpolation at, right, up;
  double right_part = 0, up_part = 0;  // 0: the surface is seen from its edge, so that values change without bound

  template<class F>
  sample_step step(F&& of_corner) const {
    const double here = at(of_corner, 0.0), unbounded = std::numeric_limits<double>::infinity();
    return {right_part > 0 ? (right(of_corner, 0.0) - here) / right_part : unbounded,
            up_part > 0 ? (up(of_corner, 0.0) - here) / up_part : unbounded};
  }
};

}  // namespace concino::detail
