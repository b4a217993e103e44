// What holds for every remeshing of a surface, whatever library its mesh is of.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/geometry/bounding_tree.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/edge_length.hpp>
#include <concino/geometry/normals.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/remesh/remesh.hpp>
#include <concino/validate/check_laws.hpp>

#include <doctest/doctest.h>

namespace concino::testing {

template<class M>
long euler_number(const M& m) {
  return static_cast<long>(num_verts(m)) - static_cast<long>(num_edges(m)) + static_cast<long>(num_polys(m));
}

template<class M>
double mean_edge_length(const M& m) {
  double sum = 0;
  for (const auto e : edges(m)) sum += edge_length(m, e);
  return sum / static_cast<double>(num_edges(m));
}

/// The triangles of `after` that are seen from behind by every triangle of `before` within half a length.
template<class M>
std::size_t num_inverted(const trimesh& before, const M& after, double length) {
  const auto tree = bounding_tree(before);
  std::size_t n = 0;
  for (const auto p : polys(after)) {
    const vec3 x = centroid(after, p), direction = normal(after, p), half{0.5 * length, 0.5 * length, 0.5 * length};
    bool seen = false;
    for (const auto q : tree.in_box({x - half, x + half})) seen = seen || dot(direction, normal(before, q)) > 0;
    n += !seen;
  }
  return n;
}

/// Checks what a remeshing to edges of one length promises.
template<class M>
void check_remeshing(const trimesh& before, const M& after, const remeshing& r, double length, double least_share = 0.9) {
  for (const auto& b : check_laws(after)) FAIL_CHECK(b.law << ": " << b.what);
  CHECK(euler_number(after) == euler_number(before));
  CHECK(r.share_of_lengths >= least_share);
  CHECK(r.error < 0.5 * length);
  const auto tree = bounding_tree(before);
  double most = 0, off = 0;
  for (const auto p : polys(after)) most = std::max(most, tree.closest(centroid(after, p)).distance);
  for (const auto v : verts(after)) off = std::max(off, tree.closest(to_vec3(point(after, v))).distance);
  CHECK(most <= r.error);
  CHECK(off <= 0.5 * length);
  CHECK(num_inverted(before, after, length) == 0);
}

}  // namespace concino::testing
