// Areas and volumes that two polys have in common.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/geometry/polygon.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// The parts of a poly: triangles, of which the fourth point is not used, or tets. The poly is the sum of the
/// positively oriented ones less that of the others, whatever its shape is.
struct signed_simplices {
  std::vector<std::array<vec3, 4>> parts;
  vec3 normal;  // of a polygon: its vector area
};

/// The common area of two polygons in the plane of the second. 0 if they face different sides.
double common_area(const signed_simplices& a, const signed_simplices& b);

/// The common volume of two polyhedra.
double common_volume(const signed_simplices& a, const signed_simplices& b);

/// Fans of triangles about the first vert of a polygon; cones from the first vert of a polyhedron over its faces, which
/// are fans about their mean points as in `volume`.
template<class M>
void read_simplices(const M& m, const poly_t<M>& p, signed_simplices& to) {
  to.parts.clear();
  vec3 apex, previous;
  std::size_t n = 0;
  if constexpr (dimension_v<M> == 2) {  // polygons have no faces
    for (const vert_t<M> v : adj_p2v(m, p)) {
      const vec3 x = to_vec3(point(m, v));
      if (n == 0) apex = x;
      if (n > 1) to.parts.push_back({apex, previous, x, vec3()});
      previous = x;
      ++n;
    }
    to.normal = area_vector_of(m, adj_p2v(m, p));
  } else {
    for (const vert_t<M> v : adj_p2v(m, p)) {
      apex = to_vec3(point(m, v));
      break;
    }
    std::vector<vec3> loop;
    for (const face_t<M> f : adj_p2f(m, p)) {
      loop.clear();
      bool has_apex = false;
      for (const vert_t<M> v : adj_f2v(m, f)) {
        loop.push_back(to_vec3(point(m, v)));
        has_apex = has_apex || loop.back() == apex;
      }
      n = loop.size();
      if (has_apex && n == 3) continue;
      const bool is_outward = face_is_outward(m, p, f);
      const auto add = [&](const vec3& a, const vec3& b, const vec3& c) {
        to.parts.push_back(is_outward ? std::array{apex, a, b, c} : std::array{apex, a, c, b});
      };
      if (n == 3) add(loop[0], loop[1], loop[2]);
      const vec3 middle = shape_of(m, adj_f2v(m, f)).mean;
      for (std::size_t k = 0; k < n && n > 3; ++k) add(middle, loop[k], loop[(k + 1) % n]);
    }
  }
}

template<class M>
double common_measure(const signed_simplices& a, const signed_simplices& b) {
  if constexpr (dimension_v<M> == 2) return common_area(a, b);  // areas of polygons, volumes of polyhedra
  else return common_volume(a, b);
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/values/overlap.ipp>
#endif
