// Point location and inside tests are consistent between neighbouring polys, also on verts, edges and faces.
#include <concino/geometry/bounding_tree.hpp>

#include <concino/mesh/boundary.hpp>

#include <support/closed_surfaces.hpp>
#include <support/kinds.hpp>
#include <support/poly_triangles.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

template<class R, class T>
bool holds(const R& range, const T& x) {
  for (const auto& y : range)
    if (y == x) return true;
  return false;
}

template<class M, class R>
vec3 mean_of(const M& m, const R& verts_of) {
  vec3 sum;
  double n = 0;
  for (const auto v : verts_of) {
    sum += point(m, v);
    n += 1;
  }
  return sum / n;
}

/// x rotated by a matrix with short decimal entries.
vec3 turned(const vec3& x) { return {0.36 * x.x + 0.48 * x.y - 0.8 * x.z, -0.8 * x.x + 0.6 * x.y, 0.48 * x.x + 0.64 * x.y + 0.6 * x.z}; }

}  // namespace

TEST_CASE_TEMPLATE("locate: every point of a jittered grid is in the only poly with winding number 1", M, CONCINO_VOLUME_KINDS) {
  const M m(jittered(grid_arrays<M>(3), 0.06));
  const auto tree = bounding_tree(m);
  std::vector<std::vector<corners3>> skins;
  for (const auto p : polys(m)) skins.push_back(triangles_of(m, p));
  point_stream at(1, 0.07, 0.93);
  for (int i = 0; i < 50; ++i) {
    const vec3 x = at();
    const auto p = tree.locate(x);
    REQUIRE(p);
    for (std::size_t k = 0; k < skins.size(); ++k) CHECK(std::abs(times_round(skins[k], x) - (k == index_of(m, *p) ? 1 : 0)) < 1e-6);
    CHECK(tree.is_inside(x));
  }
  point_stream outside(2, 1.07, 2);
  for (int i = 0; i < 50; ++i) {
    const vec3 x = outside();
    CHECK(!tree.locate(x));
    CHECK(!tree.is_inside(x));
  }
}

TEST_CASE_TEMPLATE("locate: a point on a vert, edge or face of a volume is in one of its polys", M, CONCINO_VOLUME_KINDS) {
  for (const double jitter : {0.0, 0.06}) {
    const M m(jittered(grid_arrays<M>(4), jitter));
    const auto tree = bounding_tree(m);
    for (const auto v : verts(m)) {
      const auto p = tree.locate(point(m, v));
      REQUIRE(p);
      CHECK(holds(adj_v2p(m, v), *p));
    }
    if (jitter > 0) continue;  // midpoints are exactly on their edges and faces only if they need no rounding
    for (const auto e : edges(m)) {
      const auto p = tree.locate(mean_of(m, adj_e2v(m, e)));
      REQUIRE(p);
      CHECK(holds(adj_e2p(m, e), *p));
    }
    for (const auto f : faces(m)) {
      const auto ring = adj_f2v(m, f);
      std::vector<vec3> x;
      for (const auto v : ring) x.push_back(point(m, v));
      if (x.size() == 8) continue;  // the middle of an L is a corner
      const auto p = tree.locate(x[0] + 0.5 * (0.5 * (x[1] - x[0]) + 0.5 * (x[2] - x[0])));
      REQUIRE(p);
      CHECK(holds(adj_f2p(m, f), *p));
    }
  }
}

TEST_CASE_TEMPLATE("locate: finds a poly for exactly the points inside a regular grid and on its boundary", M, CONCINO_VOLUME_KINDS) {
  const M m = grid<M>(2);
  const auto tree = bounding_tree(m);
  for (int i = -1; i <= 9; ++i)
    for (int j = -1; j <= 9; ++j)
      for (int k = -1; k <= 9; ++k) {
        const vec3 x{i / 8.0, j / 8.0, k / 8.0};
        const bool inside = i >= 0 && j >= 0 && k >= 0 && i <= 8 && j <= 8 && k <= 8;
        const auto p = tree.locate(x);
        CHECK(p.has_value() == inside);
        if (!inside) continue;
        box b;
        b.add(x);
        CHECK(holds(tree.in_box(b), *p));
      }
}

TEST_CASE_TEMPLATE("locate: every point of a planar surface is in one polygon, also with an axis in the plane", M, CONCINO_SURFACE_KINDS) {
  auto arrays = jittered(grid_arrays<M>(4), 0.04, false);
  for (const bool turn : {false, true}) {
    if (turn)
      for (vec3& x : arrays.points) x = turned(x);
    const M m(arrays);
    const auto tree = bounding_tree(m);
    point_stream at(3, 0.05, 0.95);
    for (int i = 0; i < 200; ++i) {
      vec3 x = at();
      x.z = 0;
      if (turn) x = turned(x);
      const auto p = tree.locate(x);
      REQUIRE(p);
      double least = 1;
      for (const auto& t : triangles_of(m, *p)) least = std::min(least, distance_to(t, x));
      CHECK(least < 1e-15);
    }
    for (const auto v : verts(m)) {
      const auto p = tree.locate(point(m, v));
      REQUIRE(p);
      CHECK(holds(adj_v2p(m, v), *p));
    }
    CHECK(!tree.locate(turn ? turned({1.2, 0.5, 0}) : vec3{1.2, 0.5, 0}));
  }
}

TEST_CASE_TEMPLATE("locate: finds the nearest polygon above or below a point", M, CONCINO_SURFACE_KINDS) {
  auto arrays = grid_arrays<M>(4);
  const M flat(arrays);
  for (vec3& x : arrays.points) x.z = 0.5 * x.x * x.y;
  const M hill(arrays);
  const auto plan = bounding_tree(flat), tree = bounding_tree(hill);
  for (int i = -1; i <= 17; ++i)
    for (int j = -1; j <= 17; ++j)
      for (const double z : {-5.0, 1.0, 9.0}) CHECK(tree.locate({i / 16.0, j / 16.0, z}) == plan.locate({i / 16.0, j / 16.0, 0}));
  for (const auto e : edges(flat)) {
    const auto p = plan.locate(mean_of(flat, adj_e2v(flat, e)));
    REQUIRE(p);
    CHECK(holds(adj_e2p(flat, e), *p));
  }
  const trimesh floors({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 3}, {1, 0, 3}, {0, 1, 3}}, {{0, 1, 2}, {3, 4, 5}});
  const auto stairs = bounding_tree(floors);
  CHECK(stairs.locate({0.25, 0.25, 1.4}) == poly_id{0});
  CHECK(stairs.locate({0.25, 0.25, 1.5}) == poly_id{0});
  CHECK(stairs.locate({0.25, 0.25, 1.6}) == poly_id{1});
}

TEST_CASE("locate: works along each axis") {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto arrays = polygon_grid(2);
    for (vec3& x : arrays.points) {
      vec3 y;
      y[axis] = 7;
      y[(axis + 1) % 3] = x.x;
      y[(axis + 2) % 3] = x.y;
      x = y;
    }
    const polygonmesh m(arrays);
    const auto tree = bounding_tree(m);
    vec3 x;
    x[axis] = 7.5;
    x[(axis + 1) % 3] = x[(axis + 2) % 3] = 0.3;  // in the square around the first L, but not in the L
    CHECK(tree.locate(x) == poly_id{1});
  }
}

TEST_CASE_TEMPLATE("is_inside: is right for voxels, also if rays pass along faces, edges and verts", M, CONCINO_SURFACE_KINDS) {
  std::set<voxel> voxels;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 3; ++k)
        if ((i + 2 * j + k) % 3 || i == 1) voxels.insert({i, j, k});
  const M m = from_quads<M>(voxel_skin(voxels));
  const auto tree = bounding_tree(m);
  const auto filled = [&](double x, double y, double z) {  // the voxels are closed: any voxel around the point counts
    for (const double a : {x - 0.25, x + 0.25})
      for (const double b : {y - 0.25, y + 0.25})
        for (const double c : {z - 0.25, z + 0.25})
          if (voxels.count({int(std::floor(a)), int(std::floor(b)), int(std::floor(c))})) return true;
    return false;
  };
  for (int i = -1; i <= 9; ++i)
    for (int j = -1; j <= 9; ++j)
      for (int k = -1; k <= 7; ++k) {
        const vec3 x{i / 2.0, j / 2.0, k / 2.0};
        CHECK(tree.is_inside(x) == filled(x.x, x.y, x.z));
        CHECK(tree.is_inside(x, {.rule = inside_rule::parity}) == filled(x.x, x.y, x.z));
      }
}

TEST_CASE("is_inside: a point inside nested surfaces is inside by winding number, outside by parity") {
  surface_arrays nested = voxel_skin({{0, 0, 0}});
  const surface_arrays inner = nested;
  for (vec3& x : nested.points) x = 4 * x - vec3{1.5, 1.5, 1.5};
  for (const vec3& x : inner.points) nested.points.push_back(x);
  for (const vert_id v : inner.verts) nested.verts.push_back(vert_id{v.raw() + 8});
  const quadmesh m(nested);
  const auto tree = bounding_tree(m);
  CHECK(tree.is_inside({0.5, 0.5, 0.5}));
  CHECK(!tree.is_inside({0.5, 0.5, 0.5}, {.rule = inside_rule::parity}));
  CHECK(tree.is_inside({2, 0.5, 0.5}, {.rule = inside_rule::parity}));
  CHECK(!tree.is_inside({0.5, 0.5, 3}));
}

TEST_CASE("is_inside: throws if the surface is open") {
  const trimesh m = grid<trimesh>(2);
  const auto tree = bounding_tree(m);
  CHECK_THROWS_AS(tree.is_inside({0.5, 0.5, 1}), invalid_mesh);
  CHECK(tree.locate({0.5, 0.5, 1}));
}

TEST_CASE_TEMPLATE("is_inside: the inside of the boundary of a volume is the volume", M, CONCINO_VOLUME_KINDS) {
  const M m = grid<M>(3);
  const auto skin = boundary(m);
  const auto tree = bounding_tree(m);
  const auto around = bounding_tree(skin);
  point_stream at(5, -0.2, 1.2);
  for (int i = 0; i < 100; ++i) {
    const vec3 x = at();
    CHECK(around.is_inside(x) == tree.is_inside(x));
    if (!tree.is_inside(x)) CHECK(std::abs(around.closest(x).distance - tree.closest(x).distance) < 1e-15);
  }
}

TEST_CASE("locate: finds inverted polys too") {
  const tetmesh t({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1, 3}});
  CHECK(bounding_tree(t).locate({0.1, 0.1, 0.1}) == poly_id{0});
  const hexmesh h({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, {{4, 5, 6, 7, 0, 1, 2, 3}});
  CHECK(bounding_tree(h).locate({0.1, 0.1, 0.1}) == poly_id{0});
}
