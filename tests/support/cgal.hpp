// Constructs CGAL meshes from arrays: vert i is the i-th vertex, poly i the i-th face.
#pragma once

#include <concino/mesh/arrays.hpp>

#include <support/meshes.hpp>

#include <CGAL/Surface_mesh.h>

#include <doctest/doctest.h>

#include <concepts>
#include <vector>

namespace concino::testing {

/// The list of verts of each poly.
inline std::vector<std::vector<unsigned>> polys_of(const surface_arrays& s) {
  const surface_arrays o = with_offsets(s);
  std::vector<std::vector<unsigned>> polys;
  for (std::size_t p = 0; p + 1 < o.offsets.size(); ++p) {
    polys.emplace_back();
    for (auto i = o.offsets[p]; i < o.offsets[p + 1]; ++i) polys.back().push_back(o.verts[i].raw());
  }
  return polys;
}

/// Converts a point to P: a CGAL point in space or in the plane, an array of three numbers, or a vec3.
template<class P>
P cgal_point(const vec3& x) {
  if constexpr (requires { requires P::Ambient_dimension::value == 2; }) return P(x.x, x.y);
  else if constexpr (requires { typename P::value_type; }) return {typename P::value_type(x.x), typename P::value_type(x.y), typename P::value_type(x.z)};
  else return P(x.x, x.y, x.z);
}

template<class P>
CGAL::Surface_mesh<P> cgal_surface(const surface_arrays& s) {
  CGAL::Surface_mesh<P> m;
  for (const vec3& x : s.points) m.add_vertex(cgal_point<P>(x));
  for (const auto& poly : polys_of(s)) {
    std::vector<CGAL::SM_Vertex_index> ring;
    for (const unsigned v : poly) ring.emplace_back(v);
    REQUIRE(m.add_face(ring).is_valid());
  }
  return m;
}

}  // namespace concino::testing
