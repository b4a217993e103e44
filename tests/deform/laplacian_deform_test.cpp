#include <concino/deform/laplacian_deform.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/deform/biharmonic_deform.hpp>
#include <concino/deform/detail/skin/best_rotation.hpp>
#include <concino/generate/grid.hpp>

#include <support/kinds.hpp>
#include <support/motions.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// The verts with x = 0 and x = 1, moved by f and g.
template<class M, class F, class G>
std::vector<std::pair<vert_t<M>, vec3>> ends(const M& m, const F& f, const G& g, double length = 1) {
  std::vector<std::pair<vert_t<M>, vec3>> all;
  for (const auto v : verts(m)) {
    const vec3 x = to_vec3(point(m, v));
    if (x.x == 0) all.push_back({v, f(x)});
    if (x.x == length) all.push_back({v, g(x)});
  }
  return all;
}

}  // namespace

TEST_CASE_TEMPLATE("laplacian_deform: reproduces rigid motions and similarities, and handles are exact", M, CONCINO_ALL_KINDS) {
  const M m(grid_arrays<M>(4));
  const auto motion = [](const vec3& x) { return rotated(rotated(rotated(x))) + vec3{1, 2, 3}; };
  const auto larger = [](const vec3& x) { return 2.5 * rotated(x) + vec3{1, 2, 3}; };
  const auto x = laplacian_deform(m, ends(m, motion, motion)), y = laplacian_deform(m, ends(m, larger, larger));
  double worst = 0, worst_larger = 0;
  for (const auto v : verts(m)) {
    worst = std::max(worst, distance(x[v], motion(to_vec3(point(m, v)))));
    worst_larger = std::max(worst_larger, distance(y[v], larger(to_vec3(point(m, v)))));
  }
  MESSAGE("rigid motions: " << worst << ", similarities: " << worst_larger);
  CHECK(worst < 1e-10);
  CHECK(worst_larger < 1e-9);
  // three handles are enough, and one end that is turned is exactly where it was put
  const auto turn = [](const vec3& p) { return rotation({1, 0.5, 0}, {1, 0, 0}, 0.7)(p) + vec3{0.2, 0, 0}; };
  const auto same = [](const vec3& p) { return p; };
  const auto pairs = ends(m, same, turn);
  const auto z = laplacian_deform(m, pairs);
  for (const auto& [v, p] : pairs) CHECK(z[v] == p);
  const auto g = only_embedded_mesh(m);
  const auto on_archetype = laplacian_deform(g, ends(g, same, turn));
  for (const auto v : verts(g))
    for (const auto w : verts(m))
      if (index_of(g, v) == index_of(m, w)) CHECK(distance(on_archetype[v], z[w]) < 1e-9);
  std::vector<std::pair<vert_t<M>, vec3>> three;
  for (const auto v : verts(m))
    if (const vec3 p = to_vec3(point(m, v)); p == vec3{0, 0, 0} || p == vec3{1, 0, 0} || p == vec3{0, 1, 0}) three.push_back({v, motion(p)});
  REQUIRE(three.size() == 3);
  const auto w = laplacian_deform(m, three);
  for (const auto v : verts(m)) CHECK(distance(w[v], motion(to_vec3(point(m, v)))) < 1e-10);
}

TEST_CASE("laplacian_deform: details turn with a surface, and grow with it") {
  // A sheet with waves, one end turned by 40 degrees; and all handles of a sheet that grows.
  quadmesh m = make_grid<quadmesh>({.cells = {16, 8}, .max = {2, 1, 0}});
  for (const auto v : verts(m)) set_point(m, v, point(m, v) + vec3{0, 0, 0.08 * std::sin(12 * point(m, v).x) * std::cos(9 * point(m, v).y)});
  const auto same = [](const vec3& p) { return p; };
  const auto turn = [](const vec3& p) { return rotation({1, 0, 0}, {0, 1, 0}, -0.7)(p); };
  const auto pairs = ends(m, same, turn, 2);
  // the change of the directions of Laplacian vectors, beside the best rotation of the edges of each vert
  const auto matrix = laplacian(m);
  const auto turned_wrongly = [&](const auto& points) {
    double sum = 0, all = 0;
    for (const auto v : verts(m)) {
      detail::moment_matrix moments;
      vec3 rest, there;
      for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, static_cast<int>(v.raw())); it; ++it) {
        const vert_id w{static_cast<unsigned>(it.row())};
        const vec3 e = point(m, w) - point(m, v), d = points[w] - points[v];
        moments.add(std::abs(it.value()), e, d);
        rest += it.value() * e;
        there += it.value() * d;
      }
      const auto r = detail::best_rotation(moments);
      sum += norm(rest) - dot(detail::turned(r, rest), there) / norm(there);
      all += norm(rest);
    }
    return sum / all;
  };
  const double here = turned_wrongly(laplacian_deform(m, pairs)), smooth = turned_wrongly(biharmonic_deform(m, pairs));
  MESSAGE("1 - cosine of the angle between vectors, in the mean: " << here << ", by a smooth displacement " << smooth);
  CHECK(here < 0.5 * smooth);
  const auto grow = [](const vec3& p) { return 1.5 * p; };
  const auto x = laplacian_deform(m, ends(m, grow, grow, 2)), y = biharmonic_deform(m, ends(m, grow, grow, 2));
  double worst = 0, worst_smooth = 0;
  for (const auto v : verts(m)) {
    worst = std::max(worst, distance(x[v], 1.5 * point(m, v)));
    worst_smooth = std::max(worst_smooth, distance(y[v], 1.5 * point(m, v)));
  }
  CHECK(worst < 1e-9);
  CHECK(worst_smooth > 1e-3);
}

TEST_CASE("laplacian_deform: scales exactly, and does not depend on the order of elements") {
  const auto arrays = grid_arrays<polygonmesh>(3);
  const polygonmesh m(arrays), tiny(scaled(arrays, 0x1p-200));
  const auto same = [](const vec3& p) { return p; };
  const auto turn = [](const vec3& p) { return rotation({p.x, 0, 0}, {1, 0, 0}, 1)(p); };
  const auto x = laplacian_deform(m, ends(m, same, turn)), y = laplacian_deform(tiny, ends(tiny, same, turn, 0x1p-200));
  for (const auto v : verts(m)) CHECK(distance(x[v] * 0x1p-200, y[v]) <= 1e-13 * 0x1p-200);
  surface_arrays back = arrays;
  const auto last = static_cast<std::uint32_t>(arrays.points.size() - 1);
  std::reverse(back.points.begin(), back.points.end());
  for (auto& v : back.verts) v = vert_id{last - v.raw()};
  const polygonmesh reversed(back);
  const auto z = laplacian_deform(reversed, ends(reversed, same, turn));
  for (const auto v : verts(m)) CHECK(distance(x[v], z[vert_id{last - v.raw()}]) < 1e-10);
}

TEST_CASE("laplacian_deform: components move by their own handles, and those that do not determine it are named") {
  const quadmesh m(two_grids_arrays<quadmesh>(2));
  std::vector<std::pair<vert_id, vec3>> pairs;
  for (const unsigned i : {0u, 2u, 8u}) pairs.push_back({vert_id{i}, rotated(point(m, vert_id{i}))});
  CHECK_THROWS_WITH_AS((void)laplacian_deform(m, pairs), "laplacian_deform: the component of vert 9, which has 9 verts, has no handle, so that its place is not determined", solver_error);
  // the verts of the second one are 9 to 17
  for (const unsigned i : {9u, 11u}) pairs.push_back({vert_id{i}, point(m, vert_id{i}) + vec3{0, 0, 1}});
  CHECK_THROWS_WITH_AS((void)laplacian_deform(m, pairs), "laplacian_deform: the component of vert 10, which has 9 verts, has handles on a line only, so that its rotation is not determined", solver_error);
  pairs.push_back({vert_id{10}, point(m, vert_id{10}) + vec3{0, 0, 1}});
  CHECK_THROWS_AS((void)laplacian_deform(m, pairs), solver_error);
  pairs.back() = {vert_id{17}, point(m, vert_id{17}) + vec3{0, 0, 1}};
  const auto x = laplacian_deform(m, pairs);
  for (const auto v : verts(m))
    if (v.raw() < 18) CHECK(distance(x[v], v.raw() < 9 ? rotated(point(m, v)) : point(m, v) + vec3{0, 0, 1}) < 1e-12);
  // all verts of one grid are handles
  const quadmesh one(quad_grid(2));
  pairs.clear();
  for (const auto v : verts(one)) pairs.push_back({v, {1, 2, v.raw()}});
  CHECK(laplacian_deform(one, pairs)[vert_id{5}] == vec3{1, 2, 5});
}

TEST_CASE("laplacian_deform: bad input") {
  const quadmesh m(quad_grid(2));
  const vert_id a{0}, b{2}, c{8};
  CHECK_THROWS_WITH_AS((void)laplacian_deform(m, std::vector<std::pair<vert_id, vec3>>{}), "laplacian_deform: there are no handles", invalid_argument);
  CHECK_THROWS_WITH_AS((void)laplacian_deform(m, {{a, {not_a_number, 0, 0}}}), "laplacian_deform: the position of vert 0 has a coordinate that is not finite", invalid_argument);
  CHECK_THROWS_WITH_AS((void)laplacian_deform(m, {{vert_id{9}, {0, 0, 0}}}), "laplacian_deform: a handle is no vert of the mesh", invalid_mesh);
  CHECK_THROWS_WITH_AS((void)laplacian_deform(m, {{a, {0, 0, 0}}, {a, {0, 0, 1}}}), "laplacian_deform: vert 0 is given two different positions", invalid_argument);
  CHECK_NOTHROW((void)laplacian_deform(m, {{a, {0, 0, 0}}, {b, {1, 0, 0}}, {a, {0, 0, 0}}, {c, {1, 1, 0}}}));
  CHECK_THROWS_AS((void)laplacian_deform(m, {{a, {0, 0, 0}}}), solver_error);
  CHECK_THROWS_AS((void)laplacian_deform(m, {{a, {0, 0, 0}}, {b, {1, 0, 0}}, {c, {1, 1, 0}}}, {.progress = [](double, std::string_view) { return false; }}), cancelled);
  auto bad = m;
  set_point(bad, vert_id{4}, vec3{not_a_number, 0, 0});
  CHECK_THROWS_AS((void)laplacian_deform(bad, {{a, {0, 0, 0}}}), invalid_mesh);
  const trimesh empty;
  CHECK_THROWS_AS((void)laplacian_deform(empty, {{a, {0, 0, 0}}}), invalid_mesh);
  // at the corners of a flat sheet of triangles, the similarity takes all that the edges can do
  const trimesh flat(triangle_grid(2));
  CHECK_THROWS_WITH_AS((void)laplacian_deform(flat, {{a, {0, 0, 0}}, {b, {1, 0, 0}}, {c, {1, 1, 0}}}), doctest::Contains("which has 9 verts, has too few handles to determine the points of this vert"), solver_error);
  // all handles at one point
  const auto x = laplacian_deform(m, {{a, {1, 1, 1}}, {b, {1, 1, 1}}, {c, {1, 1, 1}}});
  for (const auto v : verts(m)) CHECK(is_finite(x[v]));
  // a vert without polys moves with the handles
  auto with_one_more = quad_grid(2);
  with_one_more.points.push_back({5, 5, 5});
  const quadmesh n(with_one_more);
  CHECK(laplacian_deform(n, {{a, {0, 0, 1}}, {b, {1, 0, 1}}, {c, {1, 1, 1}}})[vert_id{9}] == vec3{5, 5, 6});
}
