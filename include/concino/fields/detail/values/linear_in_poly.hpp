// The linear function on a poly that is nearest to values at its verts.
#pragma once

#include <concino/operators/gradient.hpp>

#include <cstddef>

namespace concino::detail {

/// The mean of the values at the mean of the verts, with the mean gradient. On triangles and tets it is the linear
/// interpolant; on all polys it reproduces linear functions.
struct linear_function {
  vec3 origin, gradient;
  double value = 0;

  double operator()(const vec3& x) const { return value + dot(gradient, x - origin); }
};

/// On polys without measure it is constant.
template<class Local, class M, class U>
linear_function linear_in_poly(Local& local, const M& m, const poly_t<M>& p, const U& u) {
  linear_function f;
  local.visit(m, p);
  const std::size_t n = local.verts.size();
  if (n == 0) return f;
  const vec3 first = to_vec3(point(m, local.verts[0]));
  const double first_value = static_cast<double>(u[local.verts[0]]);
  vec3 sum;
  double values = 0;
  for (std::size_t k = 1; k < n; ++k) {
    sum += to_vec3(point(m, local.verts[k])) - first;
    values += static_cast<double>(u[local.verts[k]]) - first_value;  // differences, so that constants are exact
  }
  f.origin = first + sum / static_cast<double>(n);
  f.value = first_value + values / static_cast<double>(n);
  if (local.has_gradients()) f.gradient = gradient_of(local, u);
  return f;
}

}  // namespace concino::detail
