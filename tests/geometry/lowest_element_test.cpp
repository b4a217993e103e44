#include <concino/geometry/lowest_element.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/grid.hpp>
#include <concino/generate/jitter.hpp>
#include <concino/geometry/centroid.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <variant>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
vec3 mean_of(const M& m, const auto& some) {
  vec3 sum;
  double n = 0;
  for (const vert_t<M> v : some) {
    sum += to_vec3(point(m, v));
    ++n;
  }
  return sum / n;
}

template<class M>
M jittered() {
  M m = make_grid<M>({.cells = {3, 3, 3}});
  jitter(m, 0.2);
  return m;
}

}  // namespace

TEST_CASE_TEMPLATE("lowest_element: places of a poly at its verts, edges and faces", M, CONCINO_KINDS) {
  const M m = jittered<M>();
  for (const auto p : polys(m)) {
    for (const auto v : adj_p2v(m, p)) {
      const auto found = lowest_element(m, mesh_point<M>{p, point(m, v)});
      CHECK(std::get<vert_t<M>>(found.element) == v);
      CHECK(found.position == point(m, v));
    }
    for (const auto e : adj_p2e(m, p))
      for (const double t : {0.5, 0.3, 1e-9}) {
        const auto [a, b] = end_verts(m, e);
        const vec3 x = (1 - t) * point(m, a) + t * point(m, b);
        const auto found = lowest_element(m, mesh_point<M>{p, x});
        const auto& on = std::get<edge_point<M>>(found.element);
        CHECK(on.edge == e);
        CHECK(std::abs(on.parameter - t) < 1e-12);
        CHECK(distance(found.position, x) < 1e-15);
      }
    if constexpr (dimension_v<M> == 3)
      for (const auto f : adj_p2f(m, p)) {
        std::vector<vec3> x;
        for (const auto v : adj_f2v(m, f)) x.push_back(point(m, v));
        if (x.size() > 3) continue;  // not planar
        const vec3 inside = 0.5 * x[0] + 0.3 * x[1] + 0.2 * x[2];
        CHECK(std::get<face_t<M>>(lowest_element(m, mesh_point<M>{p, inside}).element) == f);
        CHECK(std::get<face_t<M>>(lowest_element(m, mesh_point<M>{f, inside}).element) == f);
      }
    const vec3 middle = mean_of(m, adj_p2v(m, p));
    const auto found = lowest_element(m, mesh_point<M>{p, middle});
    CHECK(std::get<poly_t<M>>(found.element) == p);
    CHECK(distance(found.position, middle) < (dimension_v<M> == 2 ? 0.05 : 1e-15));  // polygons need not be planar
  }
}

TEST_CASE_TEMPLATE("lowest_element: the faces of a cell that are not planar", M, CONCINO_VOLUME_KINDS) {
  const M m = jittered<M>();
  for (const auto f : faces(m)) {
    const vec3 middle = mean_of(m, adj_f2v(m, f));
    const auto at = lowest_element(m, mesh_point<M>{f, middle});
    CHECK(std::get<face_t<M>>(at.element) == f);
    for (const auto p : adj_f2p(m, f)) CHECK(std::get<face_t<M>>(lowest_element(m, mesh_point<M>{p, at.position}).element) == f);
  }
}

TEST_CASE_TEMPLATE("lowest_element: scale, and distance from the origin", M, trimesh, tetmesh) {
  for (const double scale : {1e-200, 1e-9, 1e200})
    for (const vec3& shift : {vec3(), vec3(1e5, -3e5, 2e5)}) {
      auto m = make_grid<M>({.cells = {2, 2, 2}});
      for (const auto v : verts(m)) set_point(m, v, scale * (point(m, v) + shift));
      for (const auto p : polys(m))
        for (const auto e : adj_p2e(m, p)) {
          const auto [a, b] = end_verts(m, e);
          CHECK(std::get<edge_point<M>>(lowest_element(m, mesh_point<M>{p, 0.7 * point(m, a) + 0.3 * point(m, b)}).element).edge == e);
          CHECK(std::get<vert_t<M>>(lowest_element(m, mesh_point<M>{edge_point<M>{e, 1}, {}}).element) == b);
          CHECK(std::get<edge_point<M>>(lowest_element(m, mesh_point<M>{edge_point<M>{e, 0.25}, {}}).element).parameter == 0.25);
        }
    }
}

TEST_CASE("lowest_element: a place outside by less than 1e-6 of the diameter is moved to the poly") {
  const trimesh m({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, {{0, 1, 2}});
  const auto place = [&](const vec3& x) { return lowest_element(m, mesh_point<trimesh>{poly_id{0}, x}); };
  CHECK(place({1, 1, 4e-6}).position == vec3(1, 1, 0));
  CHECK(std::holds_alternative<poly_id>(place({1, 1, 4e-6}).element));
  CHECK(place({1, -4e-6, 0}).position == vec3(1, 0, 0));
  CHECK(std::get<edge_point<trimesh>>(place({1, -4e-6, 0}).element).parameter == doctest::Approx(0.25));
  CHECK(std::get<vert_id>(place({-2e-6, -2e-6, 0}).element) == vert_id{0});
  CHECK(std::holds_alternative<poly_id>(place({1, 1e-9, 0}).element));
  CHECK_THROWS_AS(place({1, -6e-6, 0}), invalid_argument);
}

TEST_CASE("lowest_element: work on an archetype") {
  const auto m = jittered<tetmesh>();
  const auto weak = only_embedded_mesh(m);
  for (const auto e : edges(m)) {
    const auto [a, b] = end_verts(m, e);
    for (const auto p : adj_e2p(m, e)) {
      const vec3 x = 0.5 * (point(m, a) + point(m, b));
      const auto found = lowest_element(weak, mesh_point<std::remove_cvref_t<decltype(weak)>>{weak.poly(p), x});
      CHECK(found.position == lowest_element(m, mesh_point<tetmesh>{p, x}).position);
    }
  }
}

TEST_CASE("lowest_element: errors") {
  auto m = make_grid<tetmesh>({.cells = {2, 2, 2}});
  using place = mesh_point<tetmesh>;
  CHECK_THROWS_WITH_AS(lowest_element(m, place{vert_id{99}, {}}),
                       "lowest_element: the place, vert 99, is no vert of the mesh; take it from verts(m)", invalid_mesh);
  CHECK_THROWS_AS(lowest_element(m, place{edge_point<tetmesh>{edge_id{999}, 0.5}, {}}), invalid_mesh);
  CHECK_THROWS_AS(lowest_element(m, place{face_id{999}, {}}), invalid_mesh);
  CHECK_THROWS_AS(lowest_element(m, place{poly_id{999}, {}}), invalid_mesh);
  CHECK_THROWS_WITH_AS(lowest_element(m, place{edge_point<tetmesh>{edge_id{0}, 1.5}, {}}),
                       "lowest_element: the place is on an edge, but its parameter is not in [0, 1]",
                       invalid_argument);
  CHECK_THROWS_WITH_AS(lowest_element(m, place{poly_id{0}, {0, std::nan(""), 0}}), "lowest_element: the position of the place is not finite", invalid_argument);
  CHECK_THROWS_WITH_AS(lowest_element(m, place{poly_id{0}, {3, 3, 3}}),
                       doctest::Contains("lowest_element: the position of the place is not in poly 0, but "), invalid_argument);
  set_point(m, vert_id{0}, vec3(0, std::nan(""), 0));
  CHECK_THROWS_WITH_AS(lowest_element(m, place{poly_id{0}, {}}), "lowest_element: poly 0 has points that are not finite", invalid_mesh);
}
