#include <concino/geometry/normals.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/edit/elements.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/boundary.hpp>

#include <support/closed_surfaces.hpp>
#include <support/kinds.hpp>
#include <support/motions.hpp>
#include <support/threads.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

double off(const vec3& a, const vec3& b) { return norm(a - b); }

/// Calls f(element, its normal, its normal in the map) for the polys of a surface or the faces of a volume, then for the verts.
template<class M, class F>
void for_each_normal(const M& m, F&& f) {
  if constexpr (SurfaceMesh<M>) {
    const auto n = poly_normals(m);
    for (const auto p : polys(m)) f(p, normal(m, p), n[p]);
  } else {
    const auto n = face_normals(m);
    for (const auto x : faces(m)) f(x, normal(m, x), n[x]);
  }
  const auto n = vert_normals(m);
  for (const auto v : verts(m)) f(v, vert_normal(m, v), n[v]);
}

template<class M> concept takes_temporaries = requires(M&& m) { vert_normals(std::move(m)); };

}  // namespace

TEST_CASE_TEMPLATE("normals: on grids are parallel to the axes", M, CONCINO_KINDS) {
  const M m = grid<M>(2);
  if constexpr (SurfaceMesh<M>) {
    for_each_normal(m, [](auto, const vec3& one, const vec3& of_all) {
      CHECK(one == vec3{0, 0, 1});
      CHECK(of_all == vec3{0, 0, 1});
    });
  } else {
    const auto n = vert_normals(m);
    for (const auto v : verts(m)) {
      const vec3 x = point(m, v);
      vec3 out;  // the sum of the outward normals of the faces of the cube at v
      int sides = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        out[k] = x[k] == 0 ? -1 : x[k] == 1 ? 1 : 0;
        sides += out[k] != 0;
      }
      CHECK(norm(n[v]) == (sides ? doctest::Approx(1) : doctest::Approx(0)));
      for (std::size_t k = 0; k < 3; ++k) CHECK((n[v][k] > 0) - (n[v][k] < 0) == out[k]);
      if (sides == 1 || (sides > 0 && std::same_as<M, hexmesh>)) CHECK(off(n[v], out / norm(out)) < 1e-15);
    }
    for (const auto f : faces(m)) CHECK(normal(m, f) == area_vector_of(m, adj_f2v(m, f)) / norm(area_vector_of(m, adj_f2v(m, f))));
  }
}

TEST_CASE_TEMPLATE("normals: are the same in maps and on the archetype, and rotate with the mesh", M, CONCINO_KINDS) {
  const auto arrays = jittered(grid_arrays<M>(2), 0.08);
  const M m(arrays), turned(rotated(arrays));
  const auto g = only_embedded_mesh(m);
  const auto expected = vert_normals(m), elsewhere = vert_normals(turned);
  const auto stripped = vert_normals(g);
  for_each_normal(m, [](auto, const vec3& one, const vec3& of_all) { CHECK(off(one, of_all) < 1e-14); });
  for (const auto v : verts(m)) {
    CHECK(off(stripped[g.vert(v)], expected[v]) < 1e-14);
    CHECK(off(elsewhere[v], rotated(expected[v])) < 1e-11);
  }
  if constexpr (SurfaceMesh<M>) {
    const auto both = surface_normals(m);
    const auto polygons = poly_normals(m);
    for (const auto p : polys(m)) {
      CHECK(both.polys[p] == polygons[p]);
      CHECK(norm(polygons[p]) == doctest::Approx(1).epsilon(1e-15));
      CHECK(off(normal(turned, p), rotated(polygons[p])) < 1e-11);
    }
    for (const auto v : verts(m)) CHECK(both.verts[v] == expected[v]);
  } else {
    for (const auto f : faces(m)) CHECK(off(normal(turned, f), rotated(normal(m, f))) < 1e-11);
  }
  static_assert(!takes_temporaries<M>);
}

TEST_CASE_TEMPLATE("normals: do not depend on scale, also where areas underflow or overflow", M, CONCINO_KINDS) {
  const auto arrays = jittered(grid_arrays<M>(2), 0.08);
  const M m(arrays);
  for (const double scale : {0x1p-480, 0x1p-560, 0x1p-900, 0x1p480, 0x1p560, 0x1p1022}) {
    const M other(scaled(arrays, scale));
    if constexpr (SurfaceMesh<M>)
      for (const auto p : polys(m)) CHECK(off(normal(other, p), normal(m, p)) < 1e-14);
    else
      for (const auto f : faces(m)) CHECK(off(normal(other, f), normal(m, f)) < 1e-14);
    const auto expected = vert_normals(m), found = vert_normals(other);
    for (const auto v : verts(m)) CHECK(off(found[v], expected[v]) < 1e-14);
  }
  for (const double scale : {0x1p-20, 0x1p20}) {
    const M other(scaled(arrays, scale));
    for_each_normal(m, [&](auto x, const vec3& one, const vec3&) {
      if constexpr (std::same_as<decltype(x), vert_id>) CHECK(vert_normal(other, x) == one);
      else CHECK(normal(other, x) == one);
    });
    const auto expected = vert_normals(m), found = vert_normals(other);
    for (const auto v : verts(m)) CHECK(found[v] == expected[v]);
  }
}

TEST_CASE_TEMPLATE("normals: the vector areas of a closed surface or boundary sum to 0", M, CONCINO_VOLUME_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.08));
  const auto skin = boundary(m);
  vec3 sum;
  for (const auto p : polys(skin)) sum += area_vector(skin, p);
  CHECK(norm(sum) < 1e-14);
  const auto of_volume = vert_normals(m);
  const auto of_skin = vert_normals(skin);
  for (const auto v : verts(skin)) CHECK(off(of_volume[v], of_skin[v]) < 1e-14);
}

TEST_CASE_TEMPLATE("normals: on a torus point away from its core, at verts and polygons", M, CONCINO_SURFACE_KINDS) {
  const M m = from_quads<M>(rolled_grid(24, 48));
  const auto n = surface_normals(m);
  vec3 sum;
  const double side = dot(n.verts[vert_id{0}], vec3{1, 0, 0}) > 0 ? 1 : -1;
  for (const auto p : polys(m)) sum += area_vector(m, p);
  CHECK(norm(sum) < 1e-11);
  for (const auto v : verts(m)) {
    const vec3 x = point(m, v);
    const double r = std::hypot(x.x, x.y);
    const vec3 out = x - 3 / r * vec3{x.x, x.y, 0.0};
    CHECK(side * dot(n.verts[v], out / norm(out)) > 0.98);
  }
}

TEST_CASE("normals: weights are areas, without those of deleted polys") {
  trimesh m({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}});  // the areas are 2, 1 and 1
  const auto n = vert_normals(m);
  CHECK(off(n[vert_id{0}], vec3{1, 1, 2} / std::sqrt(6.0)) < 1e-15);
  CHECK(off(n[vert_id{3}], vec3{1, 1, 0} / std::sqrt(2.0)) < 1e-15);
  remove_poly(m, poly_id{1});
  const auto fewer = vert_normals(m);
  CHECK(off(fewer[vert_id{0}], vec3{0, 1, 2} / std::sqrt(5.0)) < 1e-15);
  CHECK(off(vert_normal(m, vert_id{0}), fewer[vert_id{0}]) < 1e-15);
}

TEST_CASE("normals: of polys without area are 0") {
  const double huge = std::numeric_limits<double>::max();
  const trimesh m({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 1, 5}, {2, 1, 5}, {2, 1, 5}, {7, 7, 7}}, {{0, 1, 2}, {3, 4, 5}});
  for_each_normal(m, [](auto, const vec3& one, const vec3& of_all) {
    CHECK(one == vec3{});
    CHECK(of_all == vec3{});
  });
  const auto both = surface_normals(m);
  for (const auto p : polys(m)) CHECK(both.polys[p] == vec3{});
  const quadmesh saddle({{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}}, {{0, 1, 2, 3}});
  CHECK(normal(saddle, poly_id{0}) == vec3{0, 0, 1});
  const polygonmesh l({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, {{0, 1, 2, 3, 4, 5}, {5, 4, 3, 2, 1, 0}});
  CHECK(normal(l, poly_id{0}) == vec3{0, 0, 1});
  CHECK(normal(l, poly_id{1}) == vec3{0, 0, -1});
  CHECK(vert_normal(l, vert_id{3}) == vec3{});  // the normals of two polys cancel
  const trimesh widest({{-huge, -huge, 0}, {huge, -huge, 0}, {-huge, huge, 0}}, {{0, 1, 2}});
  CHECK(normal(widest, poly_id{0}) == vec3{0, 0, 1});
  CHECK(vert_normals(widest)[vert_id{2}] == vec3{0, 0, 1});
}

TEST_CASE("normals: points that are not finite change only adjacent normals") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf}) {
    const trimesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {bad, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
    const auto n = surface_normals(m);
    CHECK(n.polys[poly_id{0}] == vec3{0, 0, 1});
    CHECK_FALSE(is_finite(n.polys[poly_id{2}]));
    CHECK_FALSE(is_finite(n.verts[vert_id{3}]));
    CHECK(n.verts[vert_id{1}] == vec3{0, 0, 1});
  }
}

TEST_CASE("normals: work on users' meshes") {
  const user_mesh::surface s = user_mesh::surface_example();
  const auto n = surface_normals(s);
  for (const auto p : polys(s)) CHECK(n.polys[p] == vec3{0, 0, 1});
  CHECK(n.verts[user_mesh::vertex{0}] == vec3{0, 0, 1});
  CHECK(n.verts[user_mesh::vertex{7}] == vec3{});
  const user_mesh::volume v = user_mesh::volume_example();
  const auto around = vert_normals(v);
  CHECK(off(around[user_mesh::vertex{0}], vec3{-1, -1, -1} / std::sqrt(3.0)) < 1e-15);
  CHECK(off(around[user_mesh::vertex{8}], vec3{0, 0, 1}) < 1e-15);
  CHECK(around[user_mesh::vertex{9}] == vec3{});
}

TEST_CASE_TEMPLATE("normals: do not depend on the number of threads; empty meshes have none", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(SurfaceMesh<M> ? 40 : 8), 0.01)), none;
  CHECK(vert_normals(none).values().empty());
  const auto alone = vert_normals(m);
  for (const int threads : {1, 3, 4}) {
    const with_num_threads now(threads);
    const auto together = vert_normals(m);
    for (const auto v : verts(m)) CHECK(together[v] == alone[v]);
  }
  for (const auto v : verts(m)) CHECK((norm(alone[v]) > 0.5 || VolumeMesh<M>));
}
