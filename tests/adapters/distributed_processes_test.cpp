// Distributed meshes on several processes. Every test also passes on one.
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/distributed_gather.hpp>
#include <concino/adapters/metis_partition.hpp>

#include <concino/core/system_checks.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/property.hpp>
#include <concino/validate.hpp>

#include <support/distributed.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;
using namespace distributed_tests;

TEST_CASE_TEMPLATE("distributed: each process holds its part and the polys that share a vert with it", M, CONCINO_ALL_KINDS) {
  const M m = two_grids<M>(3);
  for (const auto& part : parts_of(m)) {
    const distributed<M> d(MPI_COMM_WORLD, is_first() ? m : M(), part);
    static_assert(EmbeddedMesh<distributed<M>>);
    CHECK(d.num_global_verts() == num_verts(m));
    CHECK(d.num_global_polys() == num_polys(m));
    CHECK(check_laws(d).empty());
    std::set<std::uint64_t> expected, found;
    for (const auto p : polys(m)) {
      bool is_near = false;
      for (const auto v : adj_p2v(m, p))
        for (const auto q : adj_v2p(m, v)) is_near = is_near || part[q] == rank();
      if (is_near) expected.insert(number(m, p));
    }
    for (const auto p : polys(d)) {
      found.insert(d.global_number(p));
      CHECK(d.is_ghost(p) == (part[poly_at(m, d.global_number(p))] != rank()));
      CHECK(d.owner(p) == part[poly_at(m, d.global_number(p))]);
    }
    CHECK(found == expected);
    std::size_t own = 0;
    for (const auto v : verts(d)) {
      const vec3 a = point(d, v), b = point(m, vert_at(m, d.global_number(v)));
      CHECK((a.x == b.x && a.y == b.y && a.z == b.z));
      own += !d.is_ghost(v);
    }
    CHECK(sum_of_all(static_cast<double>(own)) == static_cast<double>(num_verts(m)));
    CHECK(std::abs(sum_of_all(total_measure(owned_part(d))) - total_measure(m)) < 1e-12);
    // every local poly has the verts of the poly with that number
    for (const auto p : polys(d)) {
      std::vector<std::uint64_t> local, whole;
      for (const auto v : adj_p2v(d, p)) local.push_back(d.global_number(v));
      for (const auto v : adj_p2v(m, poly_at(m, d.global_number(p)))) whole.push_back(number(m, v));
      CHECK(local == whole);
    }
  }
}

TEST_CASE_TEMPLATE("distributed: values of ghosts come from their owners", M, CONCINO_KINDS) {
  const M m = grid<M>(4);
  for (const auto& part : parts_of(m)) {
    const distributed<M> d(MPI_COMM_WORLD, is_first() ? m : M(), part);
    auto u = make_vert_map<double>(d, -1.0);
    auto w = make_poly_map<vec3>(d);
    for (const auto v : verts(d))
      if (!d.is_ghost(v)) u[v] = std::sqrt(static_cast<double>(d.global_number(v)));
    for (const auto p : polys(d))
      if (!d.is_ghost(p)) w[p] = {static_cast<double>(d.global_number(p)), 1, static_cast<double>(d.owner(p))};
    exchange_ghosts(u);
    exchange_ghosts(w);
    for (const auto v : verts(d)) CHECK(u[v] == std::sqrt(static_cast<double>(d.global_number(v))));
    const auto all = gather(u);
    const auto of_polys = gather(w);
    CHECK(all.size() == (is_first() ? num_verts(m) : 0));
    for (std::size_t i = 0; i < all.size(); ++i) CHECK(all[i] == std::sqrt(static_cast<double>(i)));
    for (std::size_t i = 0; i < of_polys.size(); ++i) CHECK(of_polys[i].x == static_cast<double>(i));
    const auto at_verts = gather(u, m);
    const auto at_polys = gather(w, m);
    for (const auto v : verts(m)) CHECK(at_verts[v] == (is_first() ? std::sqrt(static_cast<double>(number(m, v))) : 0.0));
    for (const auto p : polys(m)) CHECK(at_polys[p].x == (is_first() ? static_cast<double>(number(m, p)) : 0.0));
    const M other = grid<M>(3);
    CHECK_THROWS_WITH_AS(gather(u, other), "gather: the mesh is not the one that was divided", invalid_mesh);
    for (const auto p : polys(d)) CHECK((w[p].x == static_cast<double>(d.global_number(p)) && w[p].z == d.owner(p)));
  }
}

TEST_CASE_TEMPLATE("distributed: named properties of verts, polys and the mesh", M, CONCINO_ALL_KINDS) {
  M m = two_grids<M>(2);
  add_values(m);
  set_property_rule(m, element_kind::vert, "heat", property_rule::sum);
  poly_property<std::string>(m, "name");
  edge_property<int>(m, "ridge");
  M other;  // of the other processes, which is not read
  poly_property<float>(other, "label");
  for (const auto& part : parts_of(m)) {
    const distributed<M> d(MPI_COMM_WORLD, is_first() ? m : other, part);
    check_properties(d, m);
    const auto heat = gather(d, find_vert_property<double>(d, "heat"));
    const auto label = gather(d, find_poly_property<int>(d, "label"));
    REQUIRE(heat.size() == (is_first() ? num_verts(m) : 0));
    REQUIRE(label.size() == (is_first() ? num_polys(m) : 0));
    for (std::size_t i = 0; i < heat.size(); ++i) CHECK(heat[i] == 0.25 + static_cast<double>(i));
    for (std::size_t i = 0; i < label.size(); ++i) CHECK(label[i] == (2 * i >= num_polys(m) ? static_cast<int>(3 * i) : 0));
  }
}

TEST_CASE("distributed: verts are found by their global numbers") {
  // verts 0, 3 and 5 have no polys
  const trimesh m({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {8, 8, 8}, {0, 1, 0}, {7, 7, 7}, {1, 1, 0}}, {{1, 2, 4}, {2, 6, 4}});
  auto part = make_poly_map<int>(m, 0);
  part[poly_id{1}] = number_of_processes() - 1;
  const distributed<trimesh> d(MPI_COMM_WORLD, m, part);
  for (std::uint64_t i = 0; i < num_verts(m); ++i) {
    vert_id expected;
    for (const vert_id v : verts(d))
      if (d.global_number(v) == i) expected = v;
    CHECK(d.vert(i) == expected);
    if (is_first()) CHECK(expected != vert_id());
  }
  CHECK_THROWS_WITH_AS(d.vert(7), "distributed: there is no vert 7; the mesh has 7 verts", invalid_argument);
}

TEST_CASE("distributed: a poly in no part is an error on all processes") {
  const trimesh m = grid<trimesh>(2);
  auto part = make_poly_map<int>(m, 0);
  part[poly_id{3}] = 100;
  CHECK_THROWS_WITH_AS(distributed<trimesh>(MPI_COMM_WORLD, m, part), doctest::Contains("distributed: poly 3 is in part 100; there are "), invalid_argument);
}

TEST_CASE("distributed: an error of one process is thrown on all") {
  const int last = number_of_processes() - 1;
  const auto on_last = [&](auto error) {
    detail::on_all(MPI_COMM_WORLD, [&] {
      if (rank() == last) throw error;
    });
  };
  CHECK_THROWS_WITH_AS(on_last(invalid_mesh("a mesh")), "a mesh", invalid_mesh);
  CHECK_THROWS_WITH_AS(on_last(unsupported("u")), "u", unsupported);
  CHECK_THROWS_WITH_AS(on_last(io_error("")), "", io_error);
  CHECK_THROWS_AS(on_last(cancelled("c")), cancelled);
  CHECK_THROWS_WITH_AS(on_last(solver_error(std::string(100000, 'x'))), std::string(100000, 'x').c_str(), solver_error);
  CHECK_THROWS_WITH_AS(on_last(invalid_argument("i")), "i", invalid_argument);
  CHECK_THROWS_WITH_AS(on_last(error("e")), "e", error);
  if (number_of_processes() > 1 && rank() < last) CHECK_THROWS_WITH_AS(on_last(std::length_error("of the standard library")), "of the standard library", error);
  else CHECK_THROWS_WITH_AS(on_last(std::length_error("of the standard library")), "of the standard library", std::length_error);
  try {
    on_last(parse_error("a.obj", 7, "a number", "\"x\""));
    FAIL("there is no error");
  } catch (const parse_error& e) {
    CHECK(std::string(e.what()) == "a.obj:7: expected a number, found \"x\"");
    CHECK(e.file == "a.obj");
    CHECK(e.line == 7);
    CHECK(e.expected == "a number");
    CHECK(e.found == "\"x\"");
  }
  try {
    on_last(core::singular_row("row 3", 3));
    FAIL("there is no error");
  } catch (const core::singular_row& e) {
    CHECK(std::string(e.what()) == "row 3");
    CHECK(e.row == 3);
  }
  detail::on_all(MPI_COMM_WORLD, [] {});
}

TEST_CASE("distributed: takes empty and non-manifold meshes") {
  const trimesh empty;
  const distributed<trimesh> none(MPI_COMM_WORLD, empty, make_poly_map<int>(empty, 0));
  CHECK(num_polys(none) == 0);
  CHECK(none.num_global_verts() == 0);
  // three triangles at one edge, and one that touches at a vert
  const trimesh fan({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {2, 0, 0}, {2, 1, 0}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {1, 5, 6}});
  auto part = make_poly_map<int>(fan, 0);
  for (const poly_id p : polys(fan)) part[p] = static_cast<int>(index_of(fan, p)) % number_of_processes();
  const distributed<trimesh> d(MPI_COMM_WORLD, fan, part);
  CHECK(d.num_global_polys() == 4);
  if (number_of_processes() >= 4) CHECK(num_polys(d) == (rank() < 4 ? 4 : 0));
  CHECK(check_laws(d).empty());
}
