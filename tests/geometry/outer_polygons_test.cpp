#include <concino/geometry/outer_polygons.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/element_map.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <array>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("for_each_outer_polygon: visits the polys of a surface or the boundary of a volume", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05, VolumeMesh<M>));
  const auto weak = only_embedded_mesh(m);
  std::size_t met = 0, met_stripped = 0, at_verts = 0, corners = 0;
  vec3 sum;
  for_each_outer_polygon(m, [&](const poly_id& p, const auto& loop, bool is_outward) {
    ++met;
    corners += num_elements(loop);
    CHECK(contains(m, p));
    const vec3 a = area_vector_of(m, loop);
    sum += is_outward ? a : -a;
    if (SurfaceMesh<M>) CHECK(is_outward);
  });
  std::size_t expected = 0;
  if constexpr (SurfaceMesh<M>) expected = num_polys(m);  // here the dimension itself is tested
  else for (const auto f : faces(m)) expected += is_boundary(m, f);
  CHECK(met == expected);
  CHECK(norm(sum - (SurfaceMesh<M> ? vec3{0, 0, total_measure(m)} : vec3{})) < 1e-14);
  for_each_outer_polygon(weak, [&](const auto& p, const auto& loop, bool) {
    ++met_stripped;
    for (const auto v : loop) CHECK(contains(m, weak.base(v)));
    CHECK(contains(m, weak.base(p)));
  });
  CHECK(met_stripped == met);
  for (const auto v : verts(m))
    for_each_outer_polygon(m, v, [&](const poly_id&, const auto& loop, bool) {
      ++at_verts;
      bool here = false;
      for (const auto w : loop) here = here || w == v;
      CHECK(here);
    });
  CHECK(at_verts == corners);
}

TEST_CASE("for_each_outer_polygon: reports faces that are clockwise as seen from outside") {
  auto arrays = polyhedra_grid(1);
  for (auto& out : arrays.outward) out = !out;
  const polyhedralmesh m(arrays), n(polyhedra_grid(1));
  std::array<std::size_t, 2> outward{}, inward{};
  for_each_outer_polygon(m, [&](const auto&, const auto&, bool is_outward) { ++(is_outward ? outward : inward)[0]; });
  for_each_outer_polygon(n, [&](const auto&, const auto&, bool is_outward) { ++(is_outward ? outward : inward)[1]; });
  CHECK(outward[0] == inward[1]);
  CHECK(inward[0] == outward[1]);
  CHECK(outward[0] != inward[0]);
}

TEST_CASE_TEMPLATE("for_each_visible_polygon: visits polygons with exactly one visible poly", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(3), 0.05, VolumeMesh<M>));
  auto is_visible = make_poly_map<bool>(m);
  for (const auto p : polys(m)) is_visible[p] = vert_mean(m, p).x + vert_mean(m, p).y < 0.9;
  std::size_t met = 0, exposed = 0;
  vec3 sum;
  for_each_visible_polygon(m, is_visible, [&](const poly_id& p, const auto& loop, bool is_outward, bool is_exposed, const polygon_t<M>& x) {
    CHECK(std::as_const(is_visible)[p]);
    ++met, exposed += is_exposed;
    sum += is_outward ? area_vector_of(m, loop) : -area_vector_of(m, loop);
    if constexpr (SurfaceMesh<M>) CHECK(x == p);  // here the dimension itself is tested
    else CHECK(is_exposed == !is_boundary(m, x));
  });
  std::size_t expected = 0, cut = 0;
  if constexpr (SurfaceMesh<M>) {  // as above
    for (const auto p : polys(m)) expected += std::as_const(is_visible)[p];
  } else {
    CHECK(norm(sum) < 1e-13);  // the polygons close the visible part
    for (const auto f : faces(m)) {
      std::size_t visible = 0;
      for (const auto p : adj_f2p(m, f)) visible += std::as_const(is_visible)[p];
      expected += visible == 1;
      cut += visible == 1 && !is_boundary(m, f);
    }
    CHECK(cut > 0);
  }
  CHECK(met == expected);
  CHECK(exposed == cut);
  CHECK(expected > 0);
}

TEST_CASE("for_each_visible_polygon: a face of three polys is visible if exactly one of them is") {
  const tetmesh m(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, 2}}, std::vector<std::array<unsigned, 4>>{{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 2, 5}});
  face_id shared;
  for (const auto f : faces(m))
    if (num_elements(adj_f2p(m, f)) == 3) shared = f;
  for (std::size_t mask = 0; mask < 8; ++mask) {
    auto is_visible = make_poly_map<bool>(m);
    for (const auto p : polys(m)) is_visible[p] = (mask >> p.raw() & 1) != 0;
    std::size_t met = 0;
    for_each_visible_polygon(m, is_visible, [&](const auto&, const auto&, bool, bool is_exposed, const face_id& f) {
      met += f == shared;
      if (f == shared) CHECK(is_exposed);
    });
    CHECK(met == (mask == 1 || mask == 2 || mask == 4));
  }
}
