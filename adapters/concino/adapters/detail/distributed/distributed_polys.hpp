// Some polys of a distributed mesh, brought to the first process as a mesh.
#pragma once

#include <concino/adapters/detail/distributed/distributed_records.hpp>
#include <concino/adapters/detail/distributed/distributed_verts.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/mpi/mpi_all_to_all.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/mesh/element_map.hpp>

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// Polys and their verts, in the order of their global numbers.
template<class M>
struct gathered_polys {
  M mesh;
  std::vector<std::uint64_t> vert_numbers, poly_numbers;  // by index in mesh
};

/// The polys for which is_chosen(p), of all processes. On the first process; nothing on others. Collective.
template<class M, class IsChosen>
gathered_polys<M> gather_polys(const distributed<M>& m, const IsChosen& is_chosen) {
  int size = 1;
  (MPI_Comm_size)(m.communicator(), &size);
  poly_records own;
  std::vector<std::vector<std::size_t>> sent(static_cast<std::size_t>(size));
  on_all(m.communicator(), [&] {
    std::vector<std::uint64_t> vert_numbers, poly_numbers;
    for (const vert_t<M> v : verts(m)) vert_numbers.push_back(m.global_number(v));
    for (const poly_t<M> p : polys(m)) {
      if (!m.is_ghost(p) && is_chosen(p)) sent[0].push_back(poly_numbers.size());
      poly_numbers.push_back(m.global_number(p));
    }
    own = records_of(m.base(), std::move(vert_numbers), std::move(poly_numbers));
  });
  const std::vector<poly_records> received = send_records(m.communicator(), own, sent, from_polyhedra<M>);
  gathered_polys<M> r;
  on_all(m.communicator(), [&] {
    if (m.rank() > 0) return;
    auto part = part_of_records<M>(merged_records(received, from_polyhedra<M>));
    r.vert_numbers = std::move(part.vert_numbers);
    r.poly_numbers = std::move(part.poly_numbers);
    r.mesh = M(std::move(part.arrays));
  });
  return r;
}

/// The values of u at the verts of the gathered mesh. Collective.
template<class M, class U>
vert_map<M, double> gather_values(const distributed<M>& m, const gathered_polys<M>& gathered, const U& u) {
  struct value {
    std::uint64_t vert;
    double x;
  };
  const std::vector<std::uint64_t> wanted = all_from_all(m.communicator(), gathered.vert_numbers);
  int size = 1;
  (MPI_Comm_size)(m.communicator(), &size);
  std::vector<std::vector<value>> sent(static_cast<std::size_t>(size));
  for (const vert_t<M> v : verts(m))
    if (!m.is_ghost(v) && std::binary_search(wanted.begin(), wanted.end(), m.global_number(v)))
      sent[0].push_back({m.global_number(v), static_cast<double>(u[v])});
  auto r = make_vert_map<double>(gathered.mesh, 0.0);
  for (const auto& values : all_to_all(m.communicator(), sent))
    for (const auto& [vert, x] : values)
      r.values()[static_cast<std::size_t>(std::lower_bound(wanted.begin(), wanted.end(), vert) - wanted.begin())] = x;
  return r;
}

}  // namespace concino::detail
