// Compares a distributed mesh with one that the first process divides.
#pragma once

#include <concino/adapters/distributed.hpp>
#include <concino/adapters/distributed_gather.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/validate.hpp>

#include <support/distributed.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace distributed_tests {

using namespace concino;

/// The process of each poly of the whole mesh, on every process.
template<class M>
std::vector<int> owners(const distributed<M>& d) {
  auto owner = make_poly_map<int>(d, -1);
  for (const auto p : polys(d)) owner[p] = d.owner(p);
  std::vector<int> all = gather(owner);
  all.resize(d.num_global_polys());
  MPI_Bcast(all.data(), static_cast<int>(all.size()), MPI_INT, 0, MPI_COMM_WORLD);
  return all;
}

/// The verts of the polys and faces by global numbers; of polyhedra sorted, because their faces may be others in another order.
template<class M>
std::vector<std::vector<std::uint64_t>> lists_of(const distributed<M>& m) {
  std::vector<std::vector<std::uint64_t>> all;
  const auto numbers = [&](const auto& around, bool is_sorted) {
    std::vector<std::uint64_t> r;
    for (const auto v : around) r.push_back(m.global_number(v));
    if (is_sorted) std::sort(r.begin(), r.end());
    return r;
  };
  for (const auto p : polys(m)) all.push_back(numbers(adj_p2v(m, p), arity_v<M> == 0 && dimension_v<M> == 3));
  if constexpr (dimension_v<M> == 3) {
    std::vector<std::vector<std::uint64_t>> of_faces;
    for (const auto f : faces(m)) of_faces.push_back(numbers(adj_f2v(m, f), true));
    std::sort(of_faces.begin(), of_faces.end());
    all.insert(all.end(), of_faces.begin(), of_faces.end());
  }
  return all;
}

/// d is what the constructor makes of m with the same parts.
template<class M>
void check_same(const distributed<M>& d, const M& m) {
  CHECK(d.num_global_verts() == num_verts(m));
  CHECK(d.num_global_polys() == num_polys(m));
  const std::vector<int> owner = owners(d);
  auto part = make_poly_map<int>(m, 0);
  for (const auto p : polys(m)) part[p] = owner.at(number(m, p));
  const distributed<M> expected(MPI_COMM_WORLD, m, part);
  CHECK(check_laws(d).empty());
  REQUIRE(num_verts(d) == num_verts(expected));
  REQUIRE(num_polys(d) == num_polys(expected));
  CHECK(lists_of(d) == lists_of(expected));
  std::size_t num_wrong = 0;
  for (const auto v : verts(d)) {
    const auto w = vert_at(m, index_of(d, v));
    num_wrong += !(point(d, v) == point(expected, w));
    num_wrong += d.global_number(v) != expected.global_number(w) || d.owner(v) != expected.owner(w);
  }
  for (const auto p : polys(d)) {
    const auto q = poly_at(m, index_of(d, p));
    num_wrong += d.global_number(p) != expected.global_number(q) || d.owner(p) != expected.owner(q);
    num_wrong += !(std::abs(measure(d, p) - measure(expected, q)) < 1e-14);
  }
  CHECK(num_wrong == 0);
  check_properties(d, m);
  auto u = make_vert_map<double>(d, -1.0);
  for (const auto v : verts(d))
    if (!d.is_ghost(v)) u[v] = static_cast<double>(d.global_number(v));
  exchange_ghosts(u);
  for (const auto v : verts(d)) num_wrong += u[v] != static_cast<double>(d.global_number(v));
  CHECK(num_wrong == 0);
}

}  // namespace distributed_tests
