// What a flip of an edge improves: verts with the regular number of edges, lengths, and shapes of triangles.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/concepts/ranges.hpp>
#include <concino/core/vec3.hpp>

namespace concino::detail {

/// How far the number of edges at a vert is from that of a regular one, squared, if `more` are added.
template<class M>
int irregularity(const M& m, const vert_t<M>& v, int more) {
  const int wanted = is_boundary(m, v) ? 4 : 6;
  const int n = static_cast<int>(num_elements(adj_v2e(m, v))) + more - wanted;
  return n * n;
}

/// What an edge counts beside the irregularity of verts.
inline int weight_of_length(bool has_good_length) { return has_good_length ? 0 : 5; }

/// What a triangle counts if it is a sliver: one of its angles is above 143 degrees.
inline int weight_of_shape(const vec3& a, const vec3& b, const vec3& c) {
  const vec3 x = b - a, y = c - b, z = a - c;
  const double xx = dot(x, x), yy = dot(y, y), zz = dot(z, z);
  // of the two sides at the greatest angle
  const double product = xx >= yy && xx >= zz ? dot(y, z) : yy >= zz ? dot(z, x) : dot(x, y);
  const double squares = xx >= yy && xx >= zz ? yy * zz : yy >= zz ? zz * xx : xx * yy;
  return product > 0 && product * product > 0.64 * squares ? 5 : 0;
}

}  // namespace concino::detail
