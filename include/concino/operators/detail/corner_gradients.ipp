// Gradients on a poly computed from the positions of its verts; see corner_gradients.hpp.
#pragma once

#include <concino/operators/corner_gradients.hpp>

#include <cmath>
#include <cstddef>

namespace concino {

CONCINO_INLINE bool corner_gradient_arrays::has_gradients() const {
  double sum = measure;
  for (const vec3& g : gradient) sum += g.x + g.y + g.z;
  return std::isfinite(sum) && measure != 0;
}

CONCINO_INLINE void corner_gradient_arrays::centre() {
  const std::size_t n = points.size();
  if (n == 0) {
    mean = {};
    return;
  }
  const vec3 origin = points[0];  // differences first: so a poly far from the origin loses no digits
  vec3 sum;
  for (vec3& x : points) sum += x = x - origin;
  const vec3 middle = sum / static_cast<double>(n);
  for (vec3& x : points) x -= middle;
  mean = origin + middle;
}

CONCINO_INLINE void corner_gradient_arrays::visit_polygon() {
  const std::size_t n = points.size();
  normal = {};
  for (std::size_t i = 0; i < n; ++i) normal += cross(points[i], points[i + 1 < n ? i + 1 : 0]);
  normal *= 0.5;
  measure = norm(normal);
  gradient.resize(n);
  const vec3 direction = normal / measure;
  for (std::size_t i = 0; i < n; ++i) {
    const vec3 diagonal = points[i + 1 < n ? i + 1 : 0] - points[i > 0 ? i - 1 : n - 1];
    gradient[i] = 0.5 * cross(diagonal, direction) / measure;
  }
}

}  // namespace concino
