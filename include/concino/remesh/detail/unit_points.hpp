// The points of a mesh, moved to the middle of their box and scaled by a power of two to about 1, so that products of
// them neither overflow nor underflow.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/bounding_box.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

class unit_points {
  vec3 centre_;
  double to_unit_ = 1, to_mesh_ = 1;

 public:
  /// Errors: invalid_mesh if a point is not finite.
  template<class M>
  unit_points(const M& m, const char* caller) {
    for (const vert_t<M> v : verts(m))
      if (!is_finite(to_vec3(point(m, v))))
        core::throw_joined<invalid_mesh>(
            {caller, ": the point of vert ", index_of(m, v), " is not finite; validate(m) lists all of them"});
    if (num_verts(m) == 0) return;
    const box b = bounding_box(m);
    centre_ = 0.5 * b.min + 0.5 * b.max;
    const vec3 half = b.max - centre_;
    int exponent = 0;
    std::frexp(std::max({half.x, half.y, half.z, 1e-300}), &exponent);
    exponent = std::min(exponent, 1000);
    to_unit_ = std::ldexp(1.0, -exponent), to_mesh_ = std::ldexp(1.0, exponent);
  }

  vec3 to_unit(const vec3& x) const { return to_unit_ * (x - centre_); }
  vec3 to_mesh(const vec3& x) const { return to_mesh_ * x + centre_; }
  double length_to_unit(double x) const { return to_unit_ * x; }
  template<class M>
  vec3 at(const M& m, const vert_t<M>& v) const { return to_unit(to_vec3(point(m, v))); }
};

}  // namespace concino::detail
