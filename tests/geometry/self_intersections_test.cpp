#include <concino/geometry/self_intersections.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/io/load.hpp>

#include <support/closed_surfaces.hpp>
#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/poly_triangles.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

using triangle = std::array<vec3, 3>;

/// Whether two triangles without common corners intersect. The result must not depend on the order of the triangles and of their corners.
bool meet(const triangle& s, const triangle& t) {
  int yes = 0, asked = 0;
  for (unsigned turn = 0; turn < 3; ++turn)
    for (const bool flip : {false, true})
      for (const bool second_first : {false, true}) {
        std::vector<vec3> x;
        for (unsigned k = 0; k < 3; ++k) x.push_back(s[(k + turn) % 3]);
        for (unsigned k = 0; k < 3; ++k) x.push_back(t[flip ? 2 - k : k]);
        const unsigned f = second_first ? 3 : 0;
        const trimesh m(x, std::vector<std::array<unsigned, 3>>{{f, f + 1, f + 2}, {3 - f, 4 - f, 5 - f}});
        const auto pairs = self_intersections(m);
        if (!pairs.empty()) CHECK(pairs[0] == std::pair{poly_id{0}, poly_id{1}});
        yes += pairs.size() == 1;
        ++asked;
      }
  CHECK((yes == 0 || yes == asked));
  return yes == asked;
}

/// Shears the triangle exactly, so that it is parallel to no coordinate plane.
triangle sheared(triangle t) {
  for (vec3& x : t) x = {x.x, x.y + 2 * x.x, x.z + x.x - 3 * x.y};
  return t;
}

const triangle base = {vec3{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

}  // namespace

TEST_CASE("self_intersections: finds triangles that intersect without a common vert") {
  const std::vector<std::pair<triangle, bool>> others = {
      {{vec3{1, 1, -1}, {1, 1, 1}, {9, 9, 1}}, true},         // crossing
      {{vec3{1, 1, 0}, {1, 1, 1}, {2, 1, 1}}, true},          // a vert touches the face
      {{vec3{2, 0, 0}, {1, -1, 1}, {2, -1, 1}}, true},        // a vert touches an edge
      {{vec3{2, -1, 1}, {2, 1, -1}, {2, -5, -5}}, true},      // two edges intersect
      {{vec3{1, 1, 0x1p-48}, {1, 1, 1}, {2, 1, 1}}, false},   // just above the face
      {{vec3{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}, true},          // coplanar, inside
      {{vec3{-9, -9, 0}, {90, -9, 0}, {-9, 90, 0}}, true},    // coplanar, around
      {{vec3{3, 3, 0}, {-1, 3, 0}, {-1, 2.5, 0}}, true},      // coplanar, overlapping
      {{vec3{2, 2, 0}, {4, 2, 0}, {2, 4, 0}}, true},          // coplanar, edges touch
      {{vec3{2, 2.5, 0}, {4, 2, 0}, {2, 4, 0}}, false},       // coplanar, disjoint
      {{vec3{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}, false},         // parallel
      {{vec3{5, -1, -1}, {5, -1, 1}, {5, 1, 0}}, false},      // intersects the plane outside of the triangle
      {{vec3{1, 1, 0}, {2, 1, 0}, {3, 1, 0}}, false},         // without area: it has no interior
  };
  for (const auto& [t, expected] : others) {
    CHECK(meet(base, t) == expected);
    CHECK(meet(sheared(base), sheared(t)) == expected);
  }
}

TEST_CASE("self_intersections: finds overlaps of triangles with common verts or coincident points") {
  for (const bool welded : {true, false}) {
    const auto count = [&](const triangle& t) {
      std::vector<vec3> x(base.begin(), base.end());
      std::array<unsigned, 3> corners{};
      for (unsigned k = 0; k < 3; ++k) {
        unsigned found = 3;
        for (unsigned i = 0; i < 3 && welded; ++i)
          if (base[i] == t[k]) found = i;
        if (found < 3) corners[k] = found;
        else {
          corners[k] = static_cast<unsigned>(x.size());
          x.push_back(t[k]);
        }
      }
      return self_intersections(trimesh(x, std::vector<std::array<unsigned, 3>>{{0, 1, 2}, corners})).size();
    };
    CHECK(count({vec3{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}}) == 0);   // coplanar with a common vert
    CHECK(count({vec3{0, 0, 0}, {-4, 0, 0}, {0, -4, 0}}) == 0);
    CHECK(count({vec3{0, 0, 0}, {1, 1, 1}, {2, 1, 1}}) == 0);     // a common vert, above the face
    CHECK(count({vec3{0, 0, 0}, {1, 1, 1}, {1, 1, -1}}) == 1);    // a common vert, through the face
    CHECK(count({vec3{0, 0, 0}, {1, 1, 0}, {1, 1, 1}}) == 1);     // a common vert, an edge in the face
    CHECK(count({vec3{0, 0, 0}, {4, 4, 0}, {1, 5, 0}}) == 1);     // a common vert, overlapping and coplanar
    CHECK(count({vec3{0, 0, 0}, {2, 0, 0}, {0, -1, 0}}) == 1);    // overlapping edges
    CHECK(count({vec3{0, 0, 0}, {4, 0, 0}, {0, -4, 0}}) == 0);    // coplanar with a common edge
    CHECK(count({vec3{0, 0, 0}, {4, 0, 0}, {1, 1, 1}}) == 0);     // folded at a common edge, at a small angle
    CHECK(count({vec3{0, 0, 0}, {4, 0, 0}, {1, 1, 0x1p-300}}) == 0);
    CHECK(count({vec3{0, 0, 0}, {4, 0, 0}, {1, 1, 0}}) == 1);     // folded together
    CHECK(count({vec3{4, 0, 0}, {0, 0, 0}, {9, 9, 0}}) == 1);
    CHECK(count(base) == 1);                                      // the same triangle twice
  }
}

TEST_CASE_TEMPLATE("self_intersections: grids have none, two that intersect have some", M, CONCINO_SURFACE_KINDS) {
  CHECK(self_intersections(M()).empty());
  CHECK(self_intersections(grid<M>(5)).empty());
  CHECK(self_intersections(M(jittered(grid_arrays<M>(6), 0.03, false))).empty());
  CHECK(self_intersections(M(jittered(grid_arrays<M>(6), 0.01))).empty());
  CHECK(self_intersections(from_quads<M>(rolled_grid(12, 30))).empty());
  CHECK(self_intersections(from_quads<M>(holed_board(2))).empty());
  CHECK(!self_intersections(from_quads<M>(rolled_grid(12, 30, true))).empty());  // a Klein bottle in space intersects itself
  auto arrays = two_grids_arrays<M>(3);
  const std::size_t half = (arrays.points.size() - 1) / 2;
  for (std::size_t i = half; i < 2 * half; ++i) {
    const vec3 x = arrays.points[i] - vec3{2, 0, 0};
    arrays.points[i] = {x.x + 0.01, 0.52, x.y - 0.49};  // vertical
  }
  const M m(arrays);
  const auto pairs = self_intersections(m);
  std::vector<std::pair<poly_t<M>, poly_t<M>>> expected;
  for (const auto p : polys(m))
    for (const auto q : polys(m)) {
      if (!(index_of(m, p) < index_of(m, q))) continue;
      bool crossing = false;
      for (const auto& s : triangles_of(m, p))
        for (const auto& t : triangles_of(m, q))
          for (std::size_t k = 0; k < 3; ++k) {
            const vec3 &a = s[k], d = s[(k + 1) % 3] - a, &b = t[k], e = t[(k + 1) % 3] - b;
            crossing = crossing || met_at(t, a, d) < 1 || met_at(s, b, e) < 1;
          }
      bool near = false;  // neighbours touch at their common elements
      for (const auto v : adj_p2v(m, p))
        for (const auto w : adj_p2v(m, q)) near = near || v == w;
      if (crossing && !near) expected.push_back({p, q});
    }
  CHECK(!expected.empty());
  CHECK(pairs == expected);
  const auto g = only_embedded_mesh(m);
  const auto same = self_intersections(g);
  REQUIRE(same.size() == pairs.size());
  for (std::size_t i = 0; i < same.size(); ++i) CHECK(std::pair{g.base(same[i].first), g.base(same[i].second)} == pairs[i]);
}

TEST_CASE("self_intersections: a common diagonal of two polygons is not a common edge") {
  // two quads whose common diagonal is a fold
  const polygonmesh folded({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 3}, {0, 1, -3}}, {{0, 1, 2, 3}, {0, 4, 2, 5}});
  CHECK(self_intersections(folded).size() == 1);
  // a concave polygon, and polygons in its notch
  CHECK(self_intersections(grid<polygonmesh>(3)).empty());
  const polygonmesh notch({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}, {2, 2, 1}, {2, 2, -1}, {3, 9, 0}, {2, 0.5, 1}, {2, 0.5, -1}},
                          {{0, 1, 2, 3, 4}, {5, 6, 7}, {8, 9, 7}});
  CHECK(self_intersections(notch) == std::vector<std::pair<poly_id, poly_id>>{{poly_id{0}, poly_id{2}}});
}

TEST_CASE("self_intersections: a point that is not finite throws") {
  auto arrays = triangle_grid(1);
  arrays.points[0].x = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(self_intersections(trimesh(arrays)), invalid_mesh);
}

TEST_CASE("self_intersections: a sphere has none, two that intersect have some, at any scale") {
  CONCINO_CORPUS_OR_SKIP(one, "tri/sphere.obj");
  CONCINO_CORPUS_OR_SKIP(two, "tri/two_spheres.obj");
  CHECK(self_intersections(load<trimesh>(one.string())).empty());
  const auto m = load<trimesh>(two.string());
  std::vector<corners3> triangles;
  for (const auto p : polys(m)) triangles.push_back(triangles_of(m, p)[0]);
  std::vector<std::pair<poly_id, poly_id>> expected;
  for (unsigned i = 0; i < triangles.size(); ++i)
    for (unsigned j = i + 1; j < triangles.size(); ++j) {
      const auto &s = triangles[i], &t = triangles[j];
      if (norm(s[0] - t[0]) > 0.3) continue;  // farther apart than two edges are long
      bool crossing = false, near = false;
      for (std::size_t k = 0; k < 3; ++k) {
        crossing = crossing || met_at(t, s[k], s[(k + 1) % 3] - s[k]) < 1 || met_at(s, t[k], t[(k + 1) % 3] - t[k]) < 1;
        for (std::size_t l = 0; l < 3; ++l) near = near || s[k] == t[l];
      }
      if (crossing && !near) expected.push_back({poly_id{i}, poly_id{j}});
    }
  CHECK(expected.size() > 10);
  CHECK(self_intersections(m) == expected);
  for (const double scale : {0x1p20, 0x1p-400}) {
    trimesh n = m;
    for (const auto v : verts(n)) set_point(n, v, scale * point(m, v));
    CHECK(self_intersections(n) == expected);
  }
}
