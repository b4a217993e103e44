// Prints the quality metrics, the shapes that have them, and their acceptable values.
#pragma once

#include <concino/quality/metric.hpp>

#include <fmt/core.h>

#include <cmath>
#include <string>

namespace metrics {

/// The acceptable range of a metric, and its ideal value; empty if it is not defined for the shape.
inline std::string acceptable(concino::metric what, concino::poly_shape shape) {
  if (!concino::is_defined(what, shape)) return "";
  const auto limits = concino::limits_of(what, shape);
  const auto [low, high] = limits.acceptable;
  if (std::isinf(high)) return fmt::format("{:.3g} or more", low);
  return fmt::format("{:.3g} to {:.3g}", low, high);
}

inline void print_metrics() {
  using concino::poly_shape;
  fmt::print("| metric | worse if | triangle | quad | polygon | tet | hex | prism, pyramid, polyhedron |\n|---|---|---|---|---|---|---|---|\n");
  for (std::size_t i = 0; i < concino::num_metrics; ++i) {
    const auto what = static_cast<concino::metric>(i);
    fmt::print("| `{}` | {} |", concino::name_of(what), concino::larger_is_worse(what) ? "larger" : "smaller");
    for (const poly_shape s : {poly_shape::triangle, poly_shape::quad, poly_shape::polygon, poly_shape::tet, poly_shape::hex, poly_shape::polyhedron})
      fmt::print(" {} |", acceptable(what, s));
    fmt::print("\n");
  }
}

}  // namespace metrics
