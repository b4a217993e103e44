// The values of a map at all local verts, brought up to date at ghosts.
#pragma once

#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/mesh/element_map.hpp>

namespace concino::detail {

/// The values of u at the verts of this process, and at ghosts those of their owners. Collective.
template<class M, class U>
vert_map<distributed<M>, double> values_with_ghosts(const distributed<M>& m, const U& u) {
  auto r = make_vert_map<double>(m, 0.0);
  on_all(m.communicator(), [&] {
    for (const vert_t<M> v : verts(m))
      if (!m.is_ghost(v)) r[v] = static_cast<double>(u[v]);
  });
  exchange_ghosts(r);
  return r;
}

}  // namespace concino::detail
