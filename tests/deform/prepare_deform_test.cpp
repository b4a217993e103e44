#include <concino/deform/prepare_deform.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/deform/affine_map.hpp>
#include <concino/deform/detail/skin/best_rotation.hpp>
#include <concino/generate/grid.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/operators/uniform.hpp>

#include <support/kinds.hpp>
#include <support/motions.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

vec3 moved(const vec3& x) { return rotated(rotated(rotated(x))) + vec3{3, -4, 5}; }

/// The verts with x = 0 and x = 1, and where they are.
template<class M>
std::vector<std::pair<vert_t<M>, vec3>> ends(const M& m, double length = 1) {
  std::vector<std::pair<vert_t<M>, vec3>> all;
  for (const auto v : verts(m))
    if (const vec3 x = to_vec3(point(m, v)); x.x == 0 || x.x == length) all.push_back({v, x});
  return all;
}
template<class P>
auto keys(const P& pairs) {
  std::vector<std::remove_cvref_t<decltype(pairs[0].first)>> all;
  for (const auto& [v, x] : pairs) all.push_back(v);
  return all;
}

}  // namespace

TEST_CASE_TEMPLATE("prepare_deform: reproduces rigid motions, and its energy falls", M, CONCINO_ALL_KINDS) {
  for (const rigid_cells rigidity : {rigid_cells::spokes, rigid_cells::spokes_and_rims}) {
    CAPTURE(rigidity);
    const M m(grid_arrays<M>(4));
    auto pairs = ends(m);
    const auto arap = prepare_deform(m, keys(pairs), {.rigidity = rigidity});
    for (auto& [v, x] : pairs) x = moved(x);
    const auto x = arap.with_positions(pairs);
    double worst = 0;
    for (const auto v : verts(m)) worst = std::max(worst, distance(x.points[v], moved(to_vec3(point(m, v)))));
    CHECK(worst < 1e-10);
    CHECK(x.has_converged);
    // from a bad start
    auto start = make_vert_map<vec3>(m);
    for (const auto v : verts(m)) start[v] = moved(to_vec3(point(m, v))) + 0.2 * vec3{std::sin(9.0 * static_cast<double>(index_of(m, v))), std::sin(7.0 * static_cast<double>(index_of(m, v))), 0};
    const auto y = arap.with_positions_from(start, pairs, {.max_iterations = 3000, .tolerance = 0});
    worst = 0;
    for (const auto v : verts(m)) worst = std::max(worst, distance(y.points[v], moved(to_vec3(point(m, v)))));
    CHECK(worst < 1e-10);
    // one end turned by a right angle
    for (auto& [v, p] : pairs) {
      p = to_vec3(point(m, v));
      if (p.x == 1) p = rotation({1, 0, 0}, {1, 0, 0}, 1.5)(p) + vec3{0.5, 0, 0};
    }
    const auto z = arap.with_positions(pairs, {.max_iterations = 200, .tolerance = 1e-9});
    CHECK(z.energies.size() > 3);
    for (std::size_t i = 1; i < z.energies.size(); ++i) CHECK(z.energies[i] <= z.energies[i - 1]);
    for (const auto& [v, p] : pairs) CHECK(z.points[v] == p);
    const auto g = only_embedded_mesh(m);
    std::vector<std::pair<vert_t<decltype(g)>, vec3>> same;
    for (const auto v : verts(g))
      for (const auto& [w, p] : pairs)
        if (index_of(g, v) == index_of(m, w)) same.push_back({v, p});
    const auto on_archetype = prepare_deform(g, keys(same), {.rigidity = rigidity}).with_positions(same, {.max_iterations = 200, .tolerance = 1e-9});
    for (const auto v : verts(g))
      for (const auto w : verts(m))
        if (index_of(g, v) == index_of(m, w)) CHECK(distance(on_archetype.points[v], z.points[w]) < 1e-9);
    // warm starts need fewer iterations
    const auto again = arap.with_positions_from(z.points, pairs, {.max_iterations = 200, .tolerance = 1e-6});
    CHECK(again.energies.size() <= 3);
    CHECK(arap.with_positions(pairs, {.max_iterations = 0}).energies.size() == 1);
  }
}

TEST_CASE_TEMPLATE("prepare_deform: the energy of spokes and rims is what its definition says", M, CONCINO_ALL_KINDS) {
  const M m(grid_arrays<M>(2));
  auto pairs = ends(m);
  const auto arap = prepare_deform(m, keys(pairs), {.rigidity = rigid_cells::spokes_and_rims});
  CHECK(arap.num_made_positive() == 0);
  auto start = make_vert_map<vec3>(m);
  for (const auto v : verts(m)) {
    const vec3 x = to_vec3(point(m, v));
    start[v] = rotated(x) + 0.3 * vec3{std::sin(5 * x.y), x.x * x.y, std::cos(3 * x.x + x.z)};
  }
  for (auto& [v, x] : pairs) x = start[v];
  const double energy = arap.with_positions_from(start, pairs, {.max_iterations = 0}).energies[0];
  auto of_poly = virtual_elements.poly_matrices(m);
  local_matrix<vert_t<M>> k;
  double expected = 0;
  for (const auto v : verts(m)) {
    detail::moment_matrix moments;
    double squares = 0;  // of both, minus twice the products with the best rotation
    for (const auto p : adj_v2p(m, v)) {
      of_poly(p, k);
      for (std::size_t i = 0; i < k.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
          const vec3 e = to_vec3(point(m, k.verts[i])) - to_vec3(point(m, k.verts[j])), d = start[k.verts[i]] - start[k.verts[j]];
          moments.add(-k.at(i, j), e, d);
          squares -= k.at(i, j) * (dot(e, e) + dot(d, d));
        }
    }
    const auto r = detail::best_rotation(moments);
    expected += squares - 2 * (dot(r[0], moments.of[0]) + dot(r[1], moments.of[1]) + dot(r[2], moments.of[2]));
  }
  CHECK(energy == doctest::Approx(expected).epsilon(1e-11));
}

TEST_CASE("prepare_deform: a closed form: a rod that is stretched") {
  // A strip with uniform weights along x is a chain of springs: stretched, its points are evenly spaced.
  const quadmesh m(quad_grid(6));
  auto pairs = ends(m);
  const auto arap = prepare_deform(m, keys(pairs), uniform);
  CHECK(arap.num_made_positive() == 0);
  for (auto& [v, x] : pairs) x.x *= 2;
  const auto x = arap.with_positions(pairs, {.max_iterations = 1000, .tolerance = 0});
  for (const auto v : verts(m)) CHECK(distance(x.points[v], {2 * point(m, v).x, point(m, v).y, 0}) < 1e-9);
  // Each inner edge along x is 1/6 too long, from both ends.
  CHECK(x.energies.back() == doctest::Approx(2 * 6 * 7 / 36.0).epsilon(1e-12));
}

TEST_CASE("prepare_deform: a bar twisted by 180 degrees in steps of 30 has no inverted cell") {
  tetmesh bar = make_grid<tetmesh>({.cells = {16, 4, 4}, .max = {4, 1, 1}});
  for (const rigid_cells rigidity : {rigid_cells::spokes, rigid_cells::spokes_and_rims}) {
    CAPTURE(rigidity);
    auto pairs = ends(bar, 4);
    const auto rest = pairs;
    const auto arap = prepare_deform(bar, keys(pairs), {.rigidity = rigidity});
    auto x = arap.with_positions(pairs);
    for (int step = 1; step <= 6; ++step) {
      for (std::size_t i = 0; i < pairs.size(); ++i)
        if (rest[i].second.x == 4) pairs[i].second = rotation({4, 0.5, 0.5}, {1, 0, 0}, step * std::numbers::pi / 6)(rest[i].second);
      x = arap.with_positions_from(x.points, pairs, {.max_iterations = 200, .tolerance = 1e-5});
      auto twisted = bar;
      for (const auto v : verts(bar)) set_point(twisted, v, x.points[v]);
      std::size_t inverted = 0;
      for (const auto p : polys(twisted)) inverted += !(volume(twisted, p) > 0);
      CHECK(inverted == 0);
      for (std::size_t i = 1; i < x.energies.size(); ++i) CHECK(x.energies[i] <= x.energies[i - 1]);
    }
    // the middle is turned by half of it, and the ends are where they were put
    for (const auto v : verts(bar))
      if (point(bar, v).x == 2) CHECK(distance(x.points[v], rotation({4, 0.5, 0.5}, {1, 0, 0}, std::numbers::pi / 2)(point(bar, v))) < 0.1);
  }
}

TEST_CASE("prepare_deform: scales exactly, and does not depend on the order of elements") {
  const auto arrays = grid_arrays<polygonmesh>(3);
  const polygonmesh m(arrays), tiny(scaled(arrays, 0x1p-200));
  auto pairs = ends(m), tiny_pairs = ends(tiny, 0x1p-200);
  for (auto* all : {&pairs, &tiny_pairs})
    for (auto& [v, x] : *all)
      if (x.x > 0) x = rotation({x.x, 0, 0}, {1, 0, 0}, 1)(x);
  for (const rigid_cells rigidity : {rigid_cells::spokes, rigid_cells::spokes_and_rims}) {
    const prepare_deform_options options{.rigidity = rigidity};
    const auto x = prepare_deform(m, keys(pairs), options).with_positions(pairs), y = prepare_deform(tiny, keys(tiny_pairs), options).with_positions(tiny_pairs);
    for (const auto v : verts(m)) CHECK(distance(x.points[v] * 0x1p-200, y.points[v]) <= 1e-14 * 0x1p-200);
    CHECK(y.energies.size() == x.energies.size());
    // verts in reverse order
    surface_arrays back = arrays;
    const auto last = static_cast<std::uint32_t>(arrays.points.size() - 1);
    std::reverse(back.points.begin(), back.points.end());
    for (auto& v : back.verts) v = vert_id{last - v.raw()};
    const polygonmesh reversed(back);
    std::vector<std::pair<vert_id, vec3>> other;
    for (const auto& [v, p] : pairs) other.push_back({vert_id{last - v.raw()}, p});
    const auto z = prepare_deform(reversed, keys(other), options).with_positions(other);
    for (const auto v : verts(m)) CHECK(distance(x.points[v], z.points[vert_id{last - v.raw()}]) < 1e-10);
  }
}

TEST_CASE("prepare_deform: components with handles of their own, few handles, and verts without edges") {
  const auto m = trimesh(two_grids_arrays<trimesh>(2));
  const vert_id a{0}, b{8}, c{9}, d{17};
  const auto arap = prepare_deform(m, {a, b, c, d});
  const auto x = arap.with_positions({{a, point(m, a)}, {b, point(m, b)}, {c, point(m, c) + vec3{0, 0, 1}}, {d, point(m, d) + vec3{0, 0, 1}}});
  for (const auto v : verts(m))
    if (v.raw() < 18) CHECK(distance(x.points[v], point(m, v) + vec3{0, 0, v.raw() < 9 ? 0 : 1}) < 1e-12);
  CHECK_THROWS_WITH_AS((void)prepare_deform(m, {a, b}), "prepare_deform: the component of vert 9, which has 9 verts, has no handle, so that its place is not determined", solver_error);
  CHECK_THROWS_AS((void)prepare_deform(m, std::vector<vert_id>{}), solver_error);
  const trimesh one(triangle_grid(2));
  const auto lifted = prepare_deform(one, {a}).with_positions({{a, {0, 0, 5}}});
  for (const auto v : verts(one)) CHECK(distance(lifted.points[v], point(one, v) + vec3{0, 0, 5}) < 1e-12);
  std::vector<vert_id> all(verts(one).begin(), verts(one).end());
  const auto everywhere = prepare_deform(one, all);
  std::vector<std::pair<vert_id, vec3>> there;
  for (const auto v : all) there.push_back({v, {1, 2, v.raw()}});
  CHECK(everywhere.with_positions(there).points[vert_id{5}] == vec3{1, 2, 5});
  CHECK(everywhere.with_positions(there).has_converged);
}

TEST_CASE("prepare_deform: negative weights are counted") {
  // The cotangents of a flat quad of two needles are negative at the diagonal.
  const trimesh m({{0, 0, 0}, {10, 0, 0}, {5, 0.5, 0}, {5, -0.5, 0}}, {{0, 1, 2}, {1, 0, 3}});
  const auto arap = prepare_deform(m, {vert_id{2}, vert_id{3}});
  CHECK(arap.num_made_positive() == 1);
  const auto x = arap.with_positions({{vert_id{2}, {5, 1, 0}}, {vert_id{3}, {5, -1, 0}}});
  for (std::size_t i = 1; i < x.energies.size(); ++i) CHECK(x.energies[i] <= x.energies[i - 1]);
  // with rims they need not be made positive
  const auto rims = prepare_deform(m, {vert_id{2}, vert_id{3}}, {.rigidity = rigid_cells::spokes_and_rims});
  CHECK(rims.num_made_positive() == 0);
  const auto y = rims.with_positions({{vert_id{2}, {5, 1, 0}}, {vert_id{3}, {5, -1, 0}}});
  for (std::size_t i = 1; i < y.energies.size(); ++i) CHECK(y.energies[i] <= y.energies[i - 1]);
}

TEST_CASE("prepare_deform: bad input") {
  const trimesh m(triangle_grid(2));
  const vert_id a{0}, b{8};
  const auto arap = prepare_deform(m, {a, b, a});
  CHECK(&arap.mesh() == &m);
  CHECK_THROWS_WITH_AS((void)prepare_deform(m, {vert_id{9}}), "prepare_deform: a handle is no vert of the mesh", invalid_mesh);
  CHECK_THROWS_WITH_AS((void)arap.with_positions({{a, {0, 0, 0}}}), "with_positions: vert 8 is a handle, but is given no position", invalid_argument);
  CHECK_THROWS_AS((void)arap.with_positions(std::vector<std::pair<vert_id, vec3>>{}), invalid_argument);
  CHECK_THROWS_WITH_AS((void)arap.with_positions({{a, {0, 0, 0}}, {b, {0, not_a_number, 0}}}), "with_positions: the position of vert 8 has a coordinate that is not finite", invalid_argument);
  CHECK_THROWS_WITH_AS((void)arap.with_positions({{a, {0, 0, 0}}, {b, {0, 0, 0}}, {b, {0, 0, 1}}}), "with_positions: vert 8 is given two different positions", invalid_argument);
  CHECK_NOTHROW((void)arap.with_positions({{a, {0, 0, 0}}, {b, {0, 0, 0}}, {b, {0, 0, 0}}}));
  CHECK_THROWS_WITH_AS((void)arap.with_positions({{a, {0, 0, 0}}, {b, {0, 0, 0}}, {vert_id{1}, {0, 0, 1}}}), "with_positions: vert 1 is given a position, but it is no handle; pass it to prepare_deform", invalid_argument);
  CHECK_THROWS_AS((void)arap.with_positions({{a, {0, 0, 0}}, {vert_id{99}, {0, 0, 0}}}), invalid_mesh);
  CHECK_THROWS_WITH_AS((void)arap.with_positions({{a, {0, 0, 0}}, {b, {0, 0, 0}}}, {.max_iterations = -1}), "with_positions: max_iterations is -1; it must be 0 or more", invalid_argument);
  CHECK_THROWS_AS((void)arap.with_positions({{a, {0, 0, 0}}, {b, {0, 0, 0}}}, {.tolerance = not_a_number}), invalid_argument);
  auto start = make_vert_map<vec3>(m);
  start[vert_id{4}].x = not_a_number;
  CHECK_THROWS_AS((void)arap.with_positions_from(start, {{a, {0, 0, 0}}, {b, {0, 0, 0}}}), invalid_argument);
  const trimesh two(two_grids_arrays<trimesh>(2));
  auto bad = m;
  set_point(bad, vert_id{4}, vec3{not_a_number, 0, 0});
  CHECK_THROWS_AS((void)prepare_deform(bad, {a}), invalid_mesh);
  CHECK_THROWS_WITH_AS((void)prepare_deform(m, {a}, uniform, {.rigidity = rigid_cells::spokes_and_rims}), "prepare_deform: spokes and rims need a discretisation with matrices of polys, such as virtual_elements", unsupported);
  CHECK_THROWS_WITH_AS((void)prepare_deform(two, {a}, {.rigidity = rigid_cells::spokes_and_rims}), doctest::Contains("the component of vert 9, which has 9 verts, has no handle"), solver_error);
  CHECK_THROWS_AS((void)prepare_deform(bad, {a}, {.rigidity = rigid_cells::spokes_and_rims}), invalid_mesh);
  CHECK_THROWS_AS((void)prepare_deform(m, {a}, {.progress = [](double, std::string_view) { return false; }}), cancelled);
  const trimesh empty;
  CHECK(prepare_deform(empty, std::vector<vert_id>{}).with_positions(std::vector<std::pair<vert_id, vec3>>{}).has_converged);
  // all handles at one point
  const auto x = arap.with_positions({{a, {1, 1, 1}}, {b, {1, 1, 1}}});
  for (const auto v : verts(m)) CHECK(is_finite(x.points[v]));
}
