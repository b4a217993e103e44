// The heights of verts above a plane, as a function of verts.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/geometry/lines_and_planes.hpp>

#include <cmath>

namespace concino::detail {

/// Values at verts in units of length times the length of the normal: 0 on the plane, positive above it.
template<class M>
class plane_heights {
  const M* m_;
  plane plane_;

 public:
  plane_heights(const M& m, const plane& p) : m_(&m), plane_(p) {}
  double operator[](const vert_t<M>& v) const { return dot(plane_.normal, to_vec3(point(*m_, v))) - plane_.offset; }
};

/// Errors: invalid_argument if the plane has no normal or is not finite.
template<class M>
plane_heights<M> heights_above(const M& m, const plane& p, const char* caller) {
  if (!(norm(p.normal) > 0) || !is_finite(p.normal) || !std::isfinite(p.offset))
    core::throw_joined<invalid_argument>(
        {caller, ": the plane needs a finite normal that is not 0, and a finite offset"});
  return {m, p};
}

}  // namespace concino::detail
