// Isosurfaces of distributed meshes equal those of one process, on any partition. Every test also passes on one process.
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/distributed_isosurface.hpp>

#include <concino/geometry/measure.hpp>
#include <concino/level_sets/isosurface.hpp>

#include <support/distributed.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace concino;
using namespace concino::testing;
using namespace distributed_tests;

namespace {

/// The pieces sum to the whole, and the gathered surface is the whole.
template<class To, class M, class F>
void check_isosurface(const M& m, const F& value, const std::vector<double>& levels) {
  auto u = make_vert_map<double>(m, 0.0);
  for (const auto v : verts(m)) u[v] = value(to_vec3(point(m, v)));
  const To whole = isosurface<To>(m, u, levels).mesh;
  for (const auto& part : parts_of(m)) {
    const distributed<M> d(MPI_COMM_WORLD, is_first() ? m : M(), part);
    auto x = make_vert_map<double>(d, 0.0);
    for (const auto v : verts(d)) x[v] = d.is_ghost(v) ? std::numeric_limits<double>::quiet_NaN() : value(to_vec3(point(d, v)));
    const auto piece = isosurface<To>(d, x, levels);
    CHECK(piece.places.size() == num_verts(piece.mesh));
    for (const auto v : verts(piece.mesh)) CHECK(num_elements(adj_v2p(piece.mesh, v)) > 0);
    for (const auto p : polys(piece.mesh)) CHECK(!d.is_ghost(piece.poly_of(p)));
    CHECK(std::abs(sum_of_all(total_measure(piece.mesh)) - total_measure(whole)) < 1e-12 * (1 + total_measure(whole)));
    CHECK(sum_of_all(static_cast<double>(num_polys(piece.mesh))) == static_cast<double>(num_polys(whole)));
    const To gathered = gather_isosurface<To>(d, x, levels);
    if (!is_first()) {
      CHECK(num_verts(gathered) == 0);
      continue;
    }
    CHECK(num_verts(gathered) == num_verts(whole));
    CHECK(num_edges(gathered) == num_edges(whole));
    REQUIRE(num_polys(gathered) == num_polys(whole));
    CHECK(std::abs(total_measure(gathered) - total_measure(whole)) < 1e-12 * (1 + total_measure(whole)));
    for (const auto p : polys(whole)) CHECK(std::abs(measure(gathered, poly_at(gathered, index_of(whole, p))) - measure(whole, p)) < 1e-12);
  }
}

}  // namespace

TEST_CASE_TEMPLATE("distributed: isosurfaces equal those of one process", M, CONCINO_VOLUME_KINDS) {
  M m = grid<M>(4);
  check_isosurface<polygonmesh>(m, [](const vec3& p) { return p.x * p.x + p.y * p.y + 0.7 * p.z; }, {0.4, 0.6});
  check_isosurface<trimesh>(m, [](const vec3& p) { return std::sin(7 * p.x) + std::cos(8 * p.y) + std::sin(9 * p.z + 1); }, {0.1});
  // through verts and along faces; and faces at the value with smaller values on both sides
  check_isosurface<polygonmesh>(m, [](const vec3& p) { return p.x + p.y; }, {0.5});
  check_isosurface<polygonmesh>(m, [](const vec3& p) { return p.x; }, {0.0, 0.25, 0.5, 1.0});
  check_isosurface<polygonmesh>(m, [](const vec3& p) { return -std::abs(p.x - 0.5); }, {0.0, -0.25});
  check_isosurface<polygonmesh>(m, [](const vec3& p) { return p.x; }, {5.0});
  // faces that are not planar
  for (const auto v : verts(m)) {
    const vec3 p = to_vec3(point(m, v));
    set_point(m, v, p + vec3(0.04 * std::sin(31 * p.y), 0.04 * std::sin(17 * p.z), 0.04 * std::sin(23 * p.x + 1)));
  }
  check_isosurface<polygonmesh>(m, [](const vec3& p) { return p.x * p.y + p.z; }, {0.5, 0.9});
}

TEST_CASE("distributed: a value that is no number is the same error of an isosurface on all processes") {
  const hexmesh m = grid<hexmesh>(2);
  const distributed<hexmesh> d(MPI_COMM_WORLD, is_first() ? m : hexmesh(), parts_of(m)[1]);
  auto u = make_vert_map<double>(d, 1.0);
  for (const vert_id v : verts(d))
    if (d.global_number(v) == 13) u[v] = std::nan("");
  CHECK_THROWS_WITH_AS(isosurface(d, u, 0.5), "isosurface: the value at vert 13 is not a number (NaN)", invalid_argument);
  CHECK_THROWS_WITH_AS(gather_isosurface(d, u, 0.5), "isosurface: the value at vert 13 is not a number (NaN)", invalid_argument);
  const distributed<hexmesh> other(MPI_COMM_WORLD, is_first() ? m : hexmesh(), parts_of(m)[0]);
  CHECK_THROWS_WITH_AS(isosurface(other, u, 0.5), doctest::Contains("the values belong to another mesh"), invalid_argument);
}
