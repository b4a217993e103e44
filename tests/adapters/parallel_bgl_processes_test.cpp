// Walks on distributed meshes equal those of one process, on any partition. Every test also passes on one process.
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/parallel_bgl.hpp>

#include <concino/graph/bfs.hpp>
#include <concino/graph/components.hpp>
#include <concino/graph/dijkstra.hpp>
#include <concino/graph/predecessors.hpp>

#include <support/distributed.hpp>
#include <support/kinds.hpp>

#include <boost/concept/assert.hpp>
#include <boost/graph/distributed/concepts.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

using namespace concino;
using namespace concino::testing;
using namespace distributed_tests;

namespace {

BOOST_CONCEPT_ASSERT((boost::concepts::DistributedVertexListGraph<concino::detail::distributed_arcs>));
BOOST_CONCEPT_ASSERT((boost::concepts::IncidenceGraph<concino::detail::distributed_arcs>));
BOOST_CONCEPT_ASSERT((boost::concepts::AdjacencyGraph<concino::detail::distributed_arcs>));

/// Those of the local elements that have one of these numbers.
template<class M, class R>
auto numbered(const distributed<M>& d, const R& elements, const std::vector<std::uint64_t>& numbers) {
  std::vector<std::remove_cvref_t<decltype(*elements.begin())>> r;
  for (const auto x : elements)
    if (std::find(numbers.begin(), numbers.end(), d.global_number(x)) != numbers.end()) r.push_back(x);
  return r;
}

template<class M> auto whole(const M& m, const vert_t<M>&, std::uint64_t i) { return vert_at(m, i); }
template<class M> auto whole(const M& m, const poly_t<M>&, std::uint64_t i) { return poly_at(m, i); }

/// A number below n for an edge, from the numbers of its ends; the same in both directions.
std::uint64_t mixed(std::uint64_t a, std::uint64_t b, std::uint64_t n) {
  std::uint64_t x = std::min(a, b) * 7919 + std::max(a, b) * 104729 + 1;
  x ^= x >> 7, x *= 0x9e3779b97f4a7c15, x ^= x >> 29;
  return x % n;
}

/// Three sheets of triangles at one line, and one that touches at a vert.
trimesh non_manifold() {
  return trimesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, -1, 0}, {1, -1, 0}, {0, 0, 1}, {1, 0, 1}, {3, 1, 0}, {3, -1, 0}, {4, 0, 0}},
                 {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {0, 1, 5}, {1, 6, 5}, {1, 2, 6}, {0, 1, 7}, {1, 8, 7}, {1, 2, 8}, {2, 10, 9}, {10, 11, 9}});
}

/// The largest difference at local elements; infinite values are equal to themselves.
template<class M, class R, class U, class W>
double largest_difference(const distributed<M>& d, const M& m, const R& elements, const U& u, const W& expected) {
  double worst = 0;
  for (const auto x : elements) {
    const auto a = static_cast<double>(u[x]), b = static_cast<double>(expected[whole(m, x, d.global_number(x))]);
    if (a != b) worst = std::max(worst, std::abs(a - b));
  }
  return worst;
}

}  // namespace

TEST_CASE_TEMPLATE("parallel_bgl: bfs equals that of one process", M, CONCINO_ALL_KINDS) {
  const M m = two_grids<M>(3);
  const auto hops = bfs(m, {vert_at(m, 0), vert_at(m, 5)});
  const auto of_polys = bfs(m, poly_at(m, 1));
  for (const auto& part : parts_of(m)) {
    const distributed<M> d(MPI_COMM_WORLD, is_first() ? m : M(), part);
    CHECK(largest_difference(d, m, verts(d), bfs(d, numbered(d, verts(d), {0, 5})), hops) == 0);
    CHECK(largest_difference(d, m, polys(d), bfs(dual(d), numbered(d, polys(d), {1})), of_polys) == 0);
  }
}

TEST_CASE_TEMPLATE("parallel_bgl: dijkstra equals that of one process", M, CONCINO_ALL_KINDS) {
  const M m = two_grids<M>(3);
  const auto distance = dijkstra(m, {vert_at(m, 0), vert_at(m, 5)});
  const auto of_polys = dijkstra(m, poly_at(m, 1));
  for (const auto& part : parts_of(m)) {
    const distributed<M> d(MPI_COMM_WORLD, is_first() ? m : M(), part);
    CHECK(largest_difference(d, m, verts(d), dijkstra(d, numbered(d, verts(d), {0, 5})), distance) < 1e-14);
    CHECK(largest_difference(d, m, polys(d), dijkstra(dual(d), numbered(d, polys(d), {1})), of_polys) < 1e-14);
  }
}

TEST_CASE_TEMPLATE("parallel_bgl: connected_components equal those of one process", M, CONCINO_ALL_KINDS) {
  const M m = two_grids<M>(3);
  const auto cc = connected_components(m);
  const auto of_polys = connected_components(dual(m));
  for (const auto& part : parts_of(m)) {
    const distributed<M> d(MPI_COMM_WORLD, is_first() ? m : M(), part);
    const auto own = connected_components(d);
    CHECK(own.count == 3);  // two grids and one vert
    CHECK(largest_difference(d, m, verts(d), own, cc) == 0);
    const auto own_polys = connected_components(dual(d));
    CHECK(own_polys.count == of_polys.count);
    CHECK(largest_difference(d, m, polys(d), own_polys, of_polys) == 0);
  }
}

TEST_CASE("parallel_bgl: steps and lengths on grids") {
  const quadmesh m = grid<quadmesh>(4);
  const hexmesh h = grid<hexmesh>(3);
  for (const auto& part : parts_of(m)) {
    const distributed<quadmesh> d(MPI_COMM_WORLD, is_first() ? m : quadmesh(), part);
    const auto corner = numbered(d, verts(d), {0});
    const auto hops = bfs(primal(d), corner);
    const auto distance = dijkstra(d, corner);
    for (const vert_id v : verts(d)) {
      const vec3 x = point(d, v);
      CHECK(hops[v] == std::lround(4 * (x.x + x.y)));
      CHECK(distance[v] == doctest::Approx(x.x + x.y).epsilon(1e-14));
    }
  }
  for (const auto& part : parts_of(h)) {
    const distributed<hexmesh> d(MPI_COMM_WORLD, is_first() ? h : hexmesh(), part);
    const auto distance = dijkstra(d, numbered(d, polys(d), {0}));
    const auto centre = poly_at(h, 0);
    for (const poly_id p : polys(d)) {
      const vec3 x = centroid(d, p) - centroid(h, centre);
      CHECK(distance[p] == doctest::Approx(std::abs(x.x) + std::abs(x.y) + std::abs(x.z)).epsilon(1e-13));
    }
  }
}

TEST_CASE("parallel_bgl: walks of non-manifold meshes equal those of one process") {
  const trimesh m = non_manifold();
  const auto hops = bfs(m, vert_id{11});
  const auto distance = dijkstra(dual(m), poly_id{3});
  const auto cc = connected_components(dual(m));
  CHECK(cc.count == 2);
  for (const auto& part : parts_of(m)) {
    const distributed<trimesh> d(MPI_COMM_WORLD, is_first() ? m : trimesh(), part);
    CHECK(largest_difference(d, m, verts(d), bfs(d, numbered(d, verts(d), {11})), hops) == 0);
    CHECK(largest_difference(d, m, polys(d), dijkstra(d, numbered(d, polys(d), {3})), distance) < 1e-14);
    CHECK(largest_difference(d, m, polys(d), connected_components(dual(d)), cc) == 0);
  }
}

TEST_CASE("parallel_bgl: predecessors lead to the sources") {
  const tetmesh m = two_grids<tetmesh>(3);
  for (const auto& part : parts_of(m)) {
    distributed<tetmesh> d(MPI_COMM_WORLD, is_first() ? m : tetmesh(), part);
    auto from = make_vert_map<vert_id>(d);
    const auto sources = numbered(d, verts(d), {0, 7});
    const auto hops = bfs(d, sources, {.predecessors = &from});
    for (const vert_id v : verts(d)) {
      if (d.is_ghost(v) || hops[v] <= 0) CHECK(from[v] == v);
      else CHECK(hops[from[v]] == hops[v] - 1);
    }
    const auto distance = dijkstra(d, sources, {.predecessors = &from, .max_distance = 1});
    for (const vert_id v : verts(d)) {
      if (d.is_ghost(v) || distance[v] == 0 || std::isinf(distance[v])) CHECK(from[v] == v);
      else CHECK(distance[v] == distance[from[v]] + norm(to_vec3(point(d, v)) - to_vec3(point(d, from[v]))));
    }
  }
}

TEST_CASE("parallel_bgl: options exclude the same as on one process") {
  const quadmesh m = two_grids<quadmesh>(5);
  const auto numbers_of = [](const auto& mesh, const auto& number, edge_id e) {
    const auto [a, b] = end_verts(mesh, e);
    return mixed(number(a), number(b), 3);
  };
  const auto number_in_m = [&](vert_id v) { return number(m, v); };
  const auto may_enter = [&](vert_id v) { return number(m, v) % 4 != 0; };
  const auto may_cross = [&](edge_id e) { return numbers_of(m, number_in_m, e) != 0; };
  const auto hops = bfs(m, vert_id{0}, {.may_enter = may_enter, .max_hops = 6});
  const auto distance = dijkstra(m, vert_id{0}, {.may_cross = may_cross, .max_distance = 0.9});
  const auto cc = connected_components(m, {.may_enter = may_enter, .may_cross = may_cross});
  const auto of_polys = connected_components(dual(m), {.may_cross = may_cross});
  CHECK(cc.count > 5);
  CHECK(of_polys.count > 5);
  for (const auto& part : parts_of(m)) {
    const distributed<quadmesh> d(MPI_COMM_WORLD, is_first() ? m : quadmesh(), part);
    const auto number_in_d = [&](vert_id v) { return d.global_number(v); };
    const auto enters = [&](vert_id v) { return d.global_number(v) % 4 != 0; };
    const auto crosses = [&](edge_id e) { return numbers_of(d, number_in_d, e) != 0; };
    const auto sources = numbered(d, verts(d), {0});
    CHECK(largest_difference(d, m, verts(d), bfs(d, sources, {.may_enter = enters, .max_hops = 6}), hops) == 0);
    CHECK(largest_difference(d, m, verts(d), dijkstra(d, sources, {.may_cross = crosses, .max_distance = 0.9}), distance) < 1e-14);
    const auto own = connected_components(d, {.may_enter = enters, .may_cross = crosses});
    CHECK(own.count == cc.count);
    CHECK(largest_difference(d, m, verts(d), own, cc) == 0);
    const auto own_polys = connected_components(dual(d), {.may_cross = crosses});
    CHECK(own_polys.count == of_polys.count);
    CHECK(largest_difference(d, m, polys(d), own_polys, of_polys) == 0);
  }
}

TEST_CASE("parallel_bgl: lengths of the caller, also zero, infinite and of very different sizes") {
  const trimesh m = grid<trimesh>(12);
  const auto between = [](std::uint64_t a, std::uint64_t b) {
    const std::uint64_t k = mixed(a, b, 12);
    return k == 0 ? 0 : k == 1 ? std::numeric_limits<double>::infinity() : std::pow(7.3, static_cast<double>(k) - 9);
  };
  const auto distance = dijkstra(m, {vert_id{3}, vert_id{80}}, [&](vert_id a, vert_id b) { return between(number(m, a), number(m, b)); });
  for (const auto& part : parts_of(m)) {
    const distributed<trimesh> d(MPI_COMM_WORLD, is_first() ? m : trimesh(), part);
    auto from = make_vert_map<vert_id>(d);
    const auto length = [&](vert_id a, vert_id b) { return between(d.global_number(a), d.global_number(b)); };
    const auto own = dijkstra(d, numbered(d, verts(d), {3, 80}), length, {.predecessors = &from});
    CHECK(largest_difference(d, m, verts(d), own, distance) == 0);
    for (const vert_id v : verts(d))
      if (from[v] != v) CHECK(own[v] == own[from[v]] + length(from[v], v));
  }
}

TEST_CASE("parallel_bgl: many components, and messages larger than one batch") {
  const trimesh m = grid<trimesh>(40);
  for (const std::uint64_t n : {2u, 3u, 5u}) {
    const auto cc = connected_components(m, {.may_cross = [&](edge_id e) {
      const auto [a, b] = end_verts(m, e);
      return mixed(number(m, a), number(m, b), n) == 0;
    }});
    const auto part = parts_of(m)[1];
    const distributed<trimesh> d(MPI_COMM_WORLD, is_first() ? m : trimesh(), part);
    const auto own = connected_components(d, {.may_cross = [&](edge_id e) {
      const auto [a, b] = end_verts(d, e);
      return mixed(d.global_number(a), d.global_number(b), n) == 0;
    }});
    CHECK(own.count == cc.count);
    CHECK(own.count > 10);
    CHECK(largest_difference(d, m, verts(d), own, cc) == 0);
    CHECK(largest_difference(d, m, verts(d), bfs(d, numbered(d, verts(d), {n})), bfs(m, vert_at(m, n))) == 0);
  }
}

TEST_CASE("parallel_bgl: what is wrong on one process is an error on all") {
  const trimesh m = grid<trimesh>(3);
  const auto part = parts_of(m)[0];
  const distributed<trimesh> d(MPI_COMM_WORLD, is_first() ? m : trimesh(), part);
  const auto sources = numbered(d, verts(d), {0});
  const std::vector<vert_id> none, absent(is_first() ? 1u : 0u, vert_id{1000});
  CHECK_THROWS_WITH_AS(bfs(d, none), "bfs: there is no source; give at least one vert", invalid_argument);
  CHECK_THROWS_WITH_AS(dijkstra(d, std::vector<poly_id>()), "dijkstra: there is no source; give at least one poly", invalid_argument);
  CHECK_THROWS_WITH_AS(bfs(d, absent), "bfs: the source is not a vert of the mesh; take one from verts(m)", invalid_mesh);
  CHECK_THROWS_WITH_AS(bfs(d, sources, {.max_hops = d.rank() == 0 ? -1 : 3}), "bfs: max_hops is -1; it must be 0 or more", invalid_argument);
  CHECK_THROWS_WITH_AS(dijkstra(d, sources, {.max_distance = -1}), "dijkstra: max_distance must be 0 or more", invalid_argument);
  CHECK_THROWS_WITH_AS(dijkstra(d, sources, {.initial_distance = [](vert_id) { return 1.0; }}), doctest::Contains("initial_distance is not for distributed meshes"), unsupported);
  CHECK_THROWS_WITH_AS(bfs(d, sources, {.visit = [](vert_id, int) { return true; }}), "bfs: targets, visit and crossed are not for distributed meshes", unsupported);
  CHECK_THROWS_WITH_AS(dijkstra(d, sources, {.targets = {vert_id{0}}}), "dijkstra: targets, visit and crossed are not for distributed meshes", unsupported);
  const auto wrong = [&](double value) {
    return [&d, value](vert_id a, vert_id b) { return d.global_number(a) == 5 && d.global_number(b) == 6 ? value : 1.0; };
  };
  CHECK_THROWS_WITH_AS(dijkstra(d, sources, wrong(-2)), "dijkstra: the length from vert 5 to vert 6 is -2; lengths must be 0 or more", invalid_mesh);
  CHECK_THROWS_WITH_AS(dijkstra(d, sources, wrong(std::nan(""))), "dijkstra: the length from vert 5 to vert 6 is not a number; lengths must be 0 or more", invalid_mesh);
  CHECK(bfs(d, sources)[verts(d).begin() == verts(d).end() ? vert_id{0} : *verts(d).begin()] >= 0);  // and the next call works
}
