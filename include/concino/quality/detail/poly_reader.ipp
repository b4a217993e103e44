// Defines what poly_reader.hpp does not read from the mesh.
#pragma once

#include <concino/core/error.hpp>
#include <concino/quality/detail/poly_reader.hpp>

#include <cmath>

namespace concino::detail {

CONCINO_INLINE metric_rows::metric_rows(metric what) : what_(what) {
  for (std::size_t i = 0; i < num_poly_shapes; ++i) of_shape_[i] = find_row(what, static_cast<poly_shape>(i));
}

CONCINO_INLINE bool metric_rows::are_relative() const {
  return what_ == metric::relative_size_squared || what_ == metric::shape_and_size || what_ == metric::shear_and_size;
}

CONCINO_INLINE void metric_rows::evaluate_at(const poly_geometry& all, std::size_t n, double* values,
                                             std::size_t poly_index) const {
  const metric_row* const row = of_shape_[static_cast<unsigned>(all.shape)];
  if (row == nullptr)
    core::throw_joined<unsupported>(
        {"quality: ", name_of(what_), " is not defined for a ", name_of(all.shape), ", such as poly ", poly_index,
         "; scaled_jacobian, mean_ratio, planarity and star_shapedness are defined for all shapes"});
  evaluate(*row, all, n, values);
}

CONCINO_INLINE void check_mean_size(double size) {
  if (!(size >= 0 && std::isfinite(size)))
    core::throw_joined<invalid_argument>({"quality_options: mean_size must be finite and not negative"});
}

}  // namespace concino::detail
