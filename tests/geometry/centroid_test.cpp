#include <concino/geometry/centroid.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/mesh/boundary.hpp>

#include <support/kinds.hpp>
#include <support/motions.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {
double off(const vec3& a, const vec3& b) { return norm(a - b); }
}

TEST_CASE_TEMPLATE("centroid: the mean of centroids, weighted by measure, is that of the mesh", M, CONCINO_KINDS) {
  auto arrays = grid_arrays<M>(3);
  for (vec3& x : arrays.points) x = {2 * x.x + 0.5 * x.y + 100, x.y - 7, x.z};  // an affine map, so the centroid is known
  const M m(arrays);
  vec3 sum;
  for (const auto p : polys(m)) sum += measure(m, p) * centroid(m, p);
  const vec3 expected = {2 * 0.5 + 0.25 + 100, 0.5 - 7, SurfaceMesh<M> ? 0.0 : 0.5};
  CHECK(off(sum / total_measure(m), expected) < 1e-11);
}

TEST_CASE_TEMPLATE("centroid: has the same result on the archetype", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05));
  const auto g = only_embedded_mesh(m);
  for (const auto p : polys(m)) {
    CHECK(off(centroid(g, g.poly(p)), centroid(m, p)) < 1e-14);
    CHECK(off(vert_mean(g, g.poly(p)), vert_mean(m, p)) < 1e-14);
  }
}

TEST_CASE_TEMPLATE("centroids: returns the centroid of each poly", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05));
  const auto centre = centroids(m);
  for (const auto p : polys(m)) CHECK(centre[p] == centroid(m, p));
  const auto g = only_embedded_mesh(m);
  const auto stripped = centroids(g);
  for (const auto p : polys(m)) CHECK(stripped[g.poly(p)] == centroid(g, g.poly(p)));
}

TEST_CASE_TEMPLATE("centroid: of a face equals that of the boundary polygon", M, CONCINO_VOLUME_KINDS) {
  const M m = grid<M>(2);
  const auto skin = boundary(m);
  for (const auto f : polys(skin)) CHECK(off(centroid(m, f), centroid(skin, f)) < 1e-15);
  const auto g = only_embedded_mesh(m);
  for (const auto f : faces(m)) CHECK(off(centroid(g, g.face(f)), centroid(m, f)) < 1e-15);
}

TEST_CASE("centroid: is right for an L, a pyramid and an inverted poly") {
  const polygonmesh l({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, {{0, 1, 2, 3, 4, 5}, {5, 4, 3, 2, 1, 0}});
  for (const auto p : polys(l)) CHECK(off(centroid(l, p), vec3{5.0 / 6, 5.0 / 6, 0}) < 1e-15);
  CHECK(off(vert_mean(l, poly_id{0}), vec3{1, 1, 0}) < 1e-15);
  // a hex deformed to a pyramid: its centroid is at a quarter of its height
  const hexmesh pyramid({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 4}, {1, 1, 4}, {1, 1, 4}, {1, 1, 4}}, {{0, 1, 2, 3, 4, 5, 6, 7}});
  CHECK(off(centroid(pyramid, poly_id{0}), vec3{1, 1, 1}) < 1e-14);
  const tetmesh t({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}, {{0, 1, 2, 3}, {1, 0, 2, 3}});
  for (const auto p : polys(t)) CHECK(off(centroid(t, p), vec3{1, 1, 1}) < 1e-14);
}

TEST_CASE("centroid: of a poly without measure is the mean of its verts") {
  const trimesh line({{0, 0, 0}, {1, 1, 1}, {5, 5, 5}}, {{0, 1, 2}});
  CHECK(centroid(line, poly_id{0}) == vec3{2, 2, 2});
  const tetmesh flat({{0, 0, 0}, {0.1, 0.7, 0}, {0.3, 0.9, 0}, {1, 0.3, 0}}, {{0, 1, 2, 3}});
  CHECK(centroid(flat, poly_id{0}) == vert_mean(flat, poly_id{0}));
}

TEST_CASE_TEMPLATE("centroid: scales with the mesh in the whole range of doubles", M, CONCINO_KINDS) {
  const auto arrays = grid_arrays<M>(3);
  const M m(arrays);
  for (const double scale : {0x1p-400, 0x1p-300, 0x1p-90, 0x1p90, 0x1p300, 0x1p996, 0x1p1022}) {
    const M s(scaled(arrays, scale));
    const auto all = centroids(s);
    for (const auto p : polys(m)) {
      CHECK(distance(all[p] / scale, centroid(m, p)) < 1e-14);
      CHECK(distance(vert_mean(s, p) / scale, vert_mean(m, p)) < 1e-14);
    }
    if constexpr (VolumeMesh<M>)
      for (const auto f : faces(m)) CHECK(distance(centroid(s, f) / scale, centroid(m, f)) < 1e-14);
  }
  auto wide = scaled(arrays, 0x1p1022);
  for (vec3& x : wide.points) x = 3.9 * (x - vec3{0x1p1021, 0x1p1021, SurfaceMesh<M> ? 0 : 0x1p1021});
  const M w(wide);
  for (const auto p : polys(w)) CHECK((is_finite(centroid(w, p)) && is_finite(vert_mean(w, p))));
}
