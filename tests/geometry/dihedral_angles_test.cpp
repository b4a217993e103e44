#include <concino/geometry/dihedral_angles.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/geometry/corner_angles.hpp>
#include <concino/mesh/boundary.hpp>

#include <support/closed_surfaces.hpp>
#include <support/corpus_meshes.hpp>
#include <support/kinds.hpp>
#include <support/motions.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double pi = std::numbers::pi;

template<class R>
std::size_t length(const R& r) {
  std::size_t n = 0;
  for ([[maybe_unused]] const auto x : r) ++n;
  return n;
}

}  // namespace

TEST_CASE_TEMPLATE("dihedral_angle: is pi where a surface is flat, and on its boundary", M, CONCINO_SURFACE_KINDS) {
  const M m(rotated(two_grids_arrays<M>(2)));
  const auto angle = dihedral_angles(m);
  for (const auto e : edges(m)) {
    CHECK(angle[e] == doctest::Approx(pi).epsilon(1e-12));
    if (length(adj_e2p(m, e)) != 2) CHECK(angle[e] == pi);
  }
}

TEST_CASE_TEMPLATE("dihedral_angle: is right at convex, flat and concave edges, and reversed if inverted", M, CONCINO_SURFACE_KINDS) {
  std::set<voxel> cube;
  for (int i = 0; i < 8; ++i) cube.insert({i & 1, (i >> 1) & 1, i >> 2});
  cube.erase({1, 1, 1});
  auto skin = voxel_skin(cube);
  const M m = from_quads<M>(skin);
  for (std::size_t q = 0; q < skin.verts.size(); q += 4) std::swap(skin.verts[q + 1], skin.verts[q + 3]);
  const M inside_out = from_quads<M>(skin);
  const auto count = [](const M& surface) {
    const auto angle = dihedral_angles(surface);
    std::array<int, 4> n{};
    for (const auto e : edges(surface)) {
      const double quarters = angle[e] / (pi / 2);
      CHECK(std::abs(quarters - std::round(quarters)) < 1e-14);
      CHECK(angle[e] == doctest::Approx(dihedral_angle(surface, e)));
      if (std::lround(quarters) % 2) ++n[static_cast<std::size_t>(std::lround(quarters))];
    }
    return n;
  };
  const int halves = arity_v<M> == 0 ? 2 : 1;
  CHECK(count(m) == std::array<int, 4>{0, 27 * halves, 0, 3 * halves});
  CHECK(count(inside_out) == std::array<int, 4>{0, 3 * halves, 0, 27 * halves});
}

TEST_CASE_TEMPLATE("dihedral_angle: the angles around an edge sum to 2 pi, or to the angle of the boundary", M, CONCINO_VOLUME_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.08));  // with faces that are not planar
  const auto skin = boundary(m);
  std::size_t inside = 0;
  for (const auto e : edges(m)) {
    double sum = 0;
    for (const auto p : adj_e2p(m, e)) sum += dihedral_angle(m, p, e);
    if (!contains(skin, e)) ++inside;
    CHECK(sum == doctest::Approx(contains(skin, e) ? dihedral_angle(skin, e) : 2 * pi).epsilon(1e-12));
  }
  CHECK(inside > 0);
}

TEST_CASE_TEMPLATE("dihedral_angle: does not depend on scale and rotation, and is the same on the archetype", M, CONCINO_KINDS) {
  const auto arrays = jittered(grid_arrays<M>(1), 0.08);
  const M m(arrays), turned(rotated(arrays)), twice(scaled(arrays, 2)), small(scaled(arrays, 0x1p-900)), large(scaled(arrays, 0x1p1020));
  const auto g = only_embedded_mesh(m);
  const auto check = [&](const auto& angle_of, const auto& stripped) {
    const double angle = angle_of(m);
    CHECK(angle_of(twice) == angle);
    CHECK(angle_of(small) == doctest::Approx(angle).epsilon(1e-13));
    CHECK(angle_of(large) == doctest::Approx(angle).epsilon(1e-13));
    CHECK(angle_of(turned) == doctest::Approx(angle).epsilon(1e-11));
    CHECK(stripped == doctest::Approx(angle).epsilon(1e-12));
  };
  for (const auto e : edges(m)) {
    if constexpr (SurfaceMesh<M>) check([&](const M& x) { return dihedral_angle(x, e); }, dihedral_angle(g, g.edge(e)));
    else
      for (const auto p : adj_e2p(m, e)) check([&](const M& x) { return dihedral_angle(x, p, e); }, dihedral_angle(g, g.poly(p), g.edge(e)));
  }
}

TEST_CASE("dihedral_angle: is right for known cells") {
  const tetmesh regular({{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}}, {{0, 1, 2, 3}, {0, 2, 1, 3}});  // the second tet is inverted
  for (const auto e : edges(regular)) {
    CHECK(dihedral_angle(regular, poly_id{0}, e) == doctest::Approx(std::acos(1.0 / 3)).epsilon(1e-15));
    CHECK(dihedral_angle(regular, poly_id{1}, e) == doctest::Approx(2 * pi - std::acos(1.0 / 3)).epsilon(1e-15));
  }
  const hexmesh cube = grid<hexmesh>(1);
  for (const auto e : edges(cube)) CHECK(dihedral_angle(cube, poly_id{0}, e) == doctest::Approx(pi / 2).epsilon(1e-15));
  const polyhedralmesh block = grid<polyhedralmesh>(1);  // a prism over an L, and a box beside it
  double concave = 0;
  for (const auto e : adj_p2e(block, poly_id{0})) concave = std::max(concave, dihedral_angle(block, poly_id{0}, e));
  CHECK(concave == doctest::Approx(3 * pi / 2).epsilon(1e-15));
  const trimesh octahedron({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                           {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
  for (const auto e : edges(octahedron)) CHECK(dihedral_angle(octahedron, e) == doctest::Approx(std::acos(-1.0 / 3)).epsilon(1e-15));
}

TEST_CASE("dihedral_angle: handles folds, opposite orientations, non-manifold edges and degenerate polys") {
  const std::vector<vec3> x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {3, 0, 0}};
  const auto at_first_edge = [&](std::vector<std::vector<int>> triangles) {  // the dihedral angle at the edge from vert 0 to vert 1
    const trimesh m(x, triangles);
    for (const auto e : edges(m))
      if (adj_e2v(m, e)[0] == vert_id{0} && adj_e2v(m, e)[1] == vert_id{1}) return dihedral_angle(m, e);
    return -1.0;
  };
  CHECK(at_first_edge({{0, 1, 2}, {1, 0, 3}}) == doctest::Approx(3 * pi / 2));  // the normal of the first triangle points to vert 3
  CHECK(at_first_edge({{0, 1, 2}, {0, 1, 3}}) == doctest::Approx(3 * pi / 2));
  CHECK(at_first_edge({{1, 0, 2}, {1, 0, 3}}) == doctest::Approx(pi / 2));
  CHECK(at_first_edge({{0, 1, 2}, {0, 1, 4}}) == doctest::Approx(pi));
  CHECK(at_first_edge({{0, 1, 2}, {1, 0, 3}, {1, 0, 4}}) == pi);
  CHECK(at_first_edge({{0, 1, 2}, {1, 0, 5}}) == pi);
  const trimesh folded({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {1, 0, 3}});
  CHECK(dihedral_angle(folded, edge_id{0}) == 0);
  CHECK_FALSE(std::signbit(dihedral_angle(folded, edge_id{0})));
  const trimesh no_length({{0, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}});
  CHECK(dihedral_angle(no_length, edge_id{0}) == pi);
  const trimesh no_number({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, std::numeric_limits<double>::quiet_NaN()}}, {{0, 1, 2}, {1, 0, 3}});
  CHECK(std::isnan(dihedral_angle(no_number, edge_id{0})));
}

TEST_CASE("dihedral_angle: throws for an edge of another poly") {
  const hexmesh m = grid<hexmesh>(2);
  for (const auto e : edges(m))
    for (const auto p : polys(m)) {
      const auto own = adj_p2e(m, p);
      if (std::find(own.begin(), own.end(), e) == own.end()) CHECK_THROWS_AS(dihedral_angle(m, p, e), invalid_argument);
      else CHECK(dihedral_angle(m, p, e) == doctest::Approx(pi / 2));
    }
}

TEST_CASE("dihedral_angle: works on a user's volume") {
  const user_mesh::volume v = user_mesh::volume_example();
  for (const auto e : adj_p2e(v, user_mesh::cell{0})) CHECK(dihedral_angle(v, user_mesh::cell{0}, e) == doctest::Approx(pi / 2));
  double base = 0, ridge = 0;
  for (const auto e : adj_p2e(v, user_mesh::cell{1})) {
    const auto ends = adj_e2v(v, e);
    (ends[1] == user_mesh::vertex{8} ? ridge : base) += dihedral_angle(v, user_mesh::cell{1}, e);
  }
  CHECK(base == doctest::Approx(4 * std::atan(2.0)));
  CHECK(ridge == doctest::Approx(4 * std::acos(-0.2)));
}

TEST_CASE("corpus: dihedral angles of the regular dodecahedron are the known ones") {
  CONCINO_CORPUS_OR_SKIP(path, "polygon/dodecahedron.obj");
  const auto m = load<polygonmesh>(path.string());
  for (const auto e : edges(m)) CHECK(dihedral_angle(m, e) == doctest::Approx(std::acos(-1 / std::sqrt(5.0))).epsilon(1e-6));
  for (const auto p : polys(m))
    for (const auto v : adj_p2v(m, p)) CHECK(corner_angle(m, p, v) == doctest::Approx(0.6 * pi).epsilon(1e-6));
}
