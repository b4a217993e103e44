// Problems on meshes with removed elements, with points that are not finite, and on non-manifold meshes.
#include <concino/fields/harmonic_map.hpp>
#include <concino/fields/heat_flow.hpp>
#include <concino/fields/poisson.hpp>
#include <concino/fields/smooth.hpp>

#include <concino/edit/elements.hpp>
#include <concino/mesh/boundary.hpp>
#include <concino/operators/cotangent.hpp>

#include <support/kinds.hpp>
#include <support/user_mesh.hpp>
#include <support/values_at_verts.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("prepared problems: work with gaps in the indices", M, polygonmesh, tetmesh) {
  M m(jittered(grid_arrays<M>(3), 0.02, VolumeMesh<M>));
  const vert_id gone{static_cast<unsigned>(num_verts(m) / 2)}, a{0};
  facet_t<M> gone_too{};
  if constexpr (SurfaceMesh<M>) {
    for (const auto e : adj_v2e(m, gone)) gone_too = e;
  } else {
    for (const auto x : adj_v2f(m, gone)) gone_too = x;
  }
  remove_vert(m, gone);
  const auto ones = make_vert_map<double>(m, 1.0);
  CHECK(largest_difference(heat_flow(m, ones, 0.1), ones) < 1e-12);
  CHECK(largest_difference(smooth(m, ones, 0.1, {.exponent = 2}), ones) < 1e-12);
  const auto mass = vert_masses(m);
  const by_number f;
  const auto u = smooth(m, f, 0.1);
  double before = 0, after = 0;
  for (const auto v : verts(m)) {
    before += mass[v] * f[v];
    after += mass[v] * u[v];
  }
  CHECK(after == doctest::Approx(before).epsilon(1e-12).scale(1));
  const auto h = prepare_harmonic_map(m, {a});
  std::size_t isolated = 0;
  for (const auto v : verts(m)) {
    bool any = false;
    for ([[maybe_unused]] const auto w : adj_v2v(m, v)) any = true;
    isolated += !any;
  }
  CHECK(h.num_isolated() == isolated);
  CHECK(prepare_smooth(m, 1).num_isolated() == isolated);
  const auto two = make_vert_map<double>(m, 0.0);
  const auto flat = poisson(m, two, {.values = {{a, 2.0}}, .isolated_value = 2});
  for (const auto v : verts(m)) CHECK(flat[v] == doctest::Approx(2).epsilon(1e-12));
  CHECK_THROWS_AS(prepare_harmonic_map(m, {gone}), invalid_mesh);
  CHECK_THROWS_AS(smooth(m, f, 0.1, {.fixed = {gone}}), invalid_mesh);
  CHECK_THROWS_AS(heat_flow(m, f, 0.1, {.fixed = {gone}}), invalid_mesh);
  CHECK_THROWS_AS(poisson(m, f, {.values = {{a, 0.0}}, .fluxes = {{gone_too, 1.0}}}), invalid_mesh);
}

TEST_CASE_TEMPLATE("prepared problems: throw if a point is not finite", M, quadmesh, polyhedralmesh) {
  const by_number f;
  for (const double x : {double(NAN), double(INFINITY)}) {
    auto arrays = grid_arrays<M>(1);
    arrays.points[0].x = arrays.points[2].y = x;
    const M m(arrays);
    const vert_id a{0};
    CHECK_THROWS_AS(poisson(m, f, {.values = {{a, 0.0}}}), error);
    CHECK_THROWS_AS(heat_flow(m, f, 1), error);
    CHECK_THROWS_AS(smooth(m, f, 1), error);
    CHECK_THROWS_AS(prepare_poisson(m, {a}), error);
  }
}

TEST_CASE("prepared problems: quads may be as large as 1e200; a volume of that size throws") {
  const by_number f;
  const auto far = [](auto arrays) {
    arrays.points[0].x = arrays.points[2].y = 1e200;
    return arrays;
  };
  const quadmesh m(far(grid_arrays<quadmesh>(1)));
  const auto flow = heat_flow(m, f, 1), smoothed = smooth(m, f, 1);
  for (const auto v : verts(m)) {
    CHECK(flow[v] == doctest::Approx(f[v]));  // within time 1 no heat gets so far
    CHECK(smoothed[v] == doctest::Approx(f[v]));
  }
  CHECK_NOTHROW(prepare_poisson(m, {vert_id{0}}));
  const polyhedralmesh solid(far(grid_arrays<polyhedralmesh>(1)));
  CHECK_THROWS_AS(poisson(solid, f, {.values = {{vert_id{0}, 0.0}}}), error);
  CHECK_THROWS_AS(heat_flow(solid, f, 1), error);
  CHECK_THROWS_AS(smooth(solid, f, 1), error);
  CHECK_THROWS_AS(prepare_poisson(solid, {vert_id{0}}), error);
}

TEST_CASE("prepared problems: work at edges with three polys and verts with two fans") {
  const trimesh m({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {0.5, 0, 1}, {2, 0, 0}, {2, 1, 0}}, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {1, 5, 6}});
  const auto ones = make_vert_map<double>(m, 1.0);
  CHECK(largest_difference(heat_flow(m, ones, 3), ones) < 1e-12);
  CHECK(largest_difference(smooth(m, ones, 3, {.exponent = 2}), ones) < 1e-11);
  edge_id shared{};
  for (const auto e : edges(m)) {
    int n = 0;
    for ([[maybe_unused]] const auto p : adj_e2p(m, e)) ++n;
    if (n == 3) shared = e;
  }
  CHECK_THROWS_WITH_AS(poisson(m, ones, {.values = {{vert_id{0}, 0.0}}, .fluxes = {{shared, 1.0}}}), doctest::Contains("which has 3 polys"), invalid_mesh);
}

TEST_CASE("poisson: nothing flows through a face without area") {
  auto arrays = grid_arrays<hexmesh>(2);
  for (vec3& x : arrays.points)
    if (x.x == 0) x.z = 0.5;
  const hexmesh m(arrays);
  std::vector<std::pair<face_id, double>> across;
  for (const auto x : faces(m)) {
    bool left = true;
    for (const auto v : adj_f2v(m, x)) left = left && point(m, v)[0] == 0;
    if (left) across.push_back({x, 7.0});
  }
  CHECK(across.size() == 4);
  const auto load = make_vert_map<double>(m, 1.0);
  const vert_id a{13};
  CHECK(largest_difference(poisson(m, load, {.values = {{a, 0.0}}, .fluxes = across}), poisson(m, load, {.values = {{a, 0.0}}})) == 0);
}

TEST_CASE("prepared problems: store a copy of a view") {
  const auto m = grid<hexmesh>(2);
  const auto s = prepare_smooth(boundary(m), 0.1);
  const auto flow = prepare_heat_flow(boundary(m), 0.1);
  const auto h = prepare_harmonic_map(boundary(m), {vert_id{0}, vert_id{26}});
  const auto surface = boundary(m);
  const by_number f;
  CHECK(largest_difference(smooth(surface, f, 0.1), s.apply(f)) == 0);
  CHECK(largest_difference(heat_flow(surface, f, 0.1), flow.advance(f)) == 0);
  const std::vector<std::pair<vert_id, double>> given{{vert_id{0}, 0}, {vert_id{26}, 1}};
  CHECK(largest_difference(harmonic_map(surface, given), h.with_values(given)) == 0);
  CHECK(num_verts(s.mesh()) == 26);
}

namespace {

/// The same for a mesh and for one with further verts that have edges, but no polys.
template<class M>
void check_edges_of_no_poly(const M& m, const M& with_edges, std::size_t added) {
  const auto a = *verts(m).begin();
  const auto f = make_vert_map<double>(m, 1.0), g = make_vert_map<double>(with_edges, 1.0);
  const auto same = [&](const auto& u, const auto& w, double there) {
    for (const auto v : verts(with_edges)) {
      const bool has_polys = num_elements(adj_v2p(with_edges, v)) > 0;
      CHECK(w[v] == doctest::Approx(has_polys ? u[v] : there).epsilon(1e-12));
    }
  };
  for (const int n : {1, 2}) {
    same(harmonic_map(m, {{a, 2.0}}, {.exponent = n}), harmonic_map(with_edges, {{a, 2.0}}, {.exponent = n, .isolated_value = 7}), 7);
    same(smooth(m, f, 0.1, {.exponent = n}), smooth(with_edges, g, 0.1, {.exponent = n}), 1);
  }
  same(poisson(m, f, {.values = {{a, 0.0}}}), poisson(with_edges, g, {.values = {{a, 0.0}}, .isolated_value = 7}), 7);
  for (const bool lumped : {false, true}) same(heat_flow(m, f, 0.1, {.lumped = lumped}), heat_flow(with_edges, g, 0.1, {.lumped = lumped}), 1);
  CHECK(prepare_harmonic_map(with_edges, {a}).num_isolated() == added);
  CHECK(prepare_poisson(with_edges, {a}).num_isolated() == added);
  CHECK(prepare_smooth(with_edges, 1).num_isolated() == added);
  CHECK(prepare_harmonic_map(with_edges, {a}, uniform).num_isolated() == 0);  // along edges they are connected
}

}  // namespace

TEST_CASE("prepared problems: verts with edges and without polys are isolated") {
  auto m = user_mesh::surface_example();
  auto more = m;
  more.es.push_back({0, 7});
  check_edges_of_no_poly(m, more, 1);
  auto solid = user_mesh::volume_example();
  solid.cells.pop_back();  // the pyramid: its apex keeps faces and edges
  solid.points.pop_back();
  user_mesh::volume cube = solid;
  cube.facets.resize(6);
  cube.points.pop_back();
  cube = {cube.points, cube.facets, cube.cells};
  check_edges_of_no_poly(cube, solid, 1);
}

TEST_CASE("prepared problems: edges of no poly connect no components, except with uniform") {
  user_mesh::surface m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {3, 4, 5}});
  m.es.push_back({1, 3});
  const user_mesh::vertex a{0}, b{4};
  const char* const message = "harmonic_map: the system is singular, because the component of vert 3 (3 verts) has no prescribed value;"
                              " give one at any of its verts";
  CHECK_THROWS_WITH_AS(harmonic_map(m, {{a, 1.0}}), message, solver_error);
  CHECK_THROWS_WITH_AS(harmonic_map(m, {{a, 1.0}}, cotangent), message, solver_error);
  CHECK(harmonic_map(m, {{a, 1.0}}, uniform)[b] == doctest::Approx(1));
  CHECK(harmonic_map(m, {{a, 1.0}, {b, 2.0}}, cotangent)[user_mesh::vertex{5}] == doctest::Approx(2));
}
