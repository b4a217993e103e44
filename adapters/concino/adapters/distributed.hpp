// A mesh divided among processes: each holds its part and one layer of ghosts as an ordinary mesh.
// Needs: MPI (Debian: petsc-dev brings it; libopenmpi-dev). MPI is running, as by petsc_session or MPI_Init.
#pragma once

#include <concino/adapters/detail/distributed/distributed_exchange.hpp>
#include <concino/adapters/detail/distributed/distributed_scatter.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/concepts/views/forward.hpp>
#include <concino/core/message.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/property.hpp>
#include <concino/mesh/submesh.hpp>

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino {

/// The part of a mesh that this process holds: the polys that belong to it, and as ghosts those of other processes that
/// share a vert with one of them. It models what M models; the elements are the local ones, and the functions of this
/// library that do not say otherwise compute with them alone. Each poly belongs to one process, and each vert to the
/// lowest of the processes whose polys it has. Verts without polys belong to the first process. Local elements have the
/// order of their global numbers, verts without polys come last. Named properties of verts, polys and the mesh are kept
/// if their values are numbers, arrays of 2, 3, 4, 6 or 9 numbers, vec3 or rgba. Names, and properties of edges, faces
/// and corners, are not.
/// Needs:  M: one of the six meshes of this library.
/// Errors: every error of the constructor is thrown on all processes. invalid_argument if a poly is in no part of
///         0, 1, ... number of processes - 1.
template<class M>
class distributed {
  M mesh_;
  MPI_Comm communicator_;
  int rank_ = 0;
  std::vector<std::uint64_t> vert_numbers_, poly_numbers_;
  std::vector<int> vert_owners_, poly_owners_;
  std::size_t num_verts_in_order_ = 0;  // then follow verts without polys, in their order
  detail::ghost_exchange vert_exchange_, poly_exchange_;
  std::uint64_t totals_[2] = {0, 0};

  static detail::ghost_exchange exchange_of(MPI_Comm communicator, const std::vector<std::uint64_t>& numbers,
                                            const std::vector<int>& owners) {
    const auto sorted_end = std::is_sorted_until(numbers.begin(), numbers.end());  // no ghost is a vert without polys
    return {communicator, numbers, owners, [&](std::uint64_t number) {
              return static_cast<std::size_t>(std::lower_bound(numbers.begin(), sorted_end, number) - numbers.begin());
            }};
  }

 public:
  /// Divides the mesh of the first process. All processes of the communicator call it together; the others may pass any
  /// mesh and map.
  /// Needs:  part[p] is the process of each poly p of m, as in partition(m, n, metis).part; n processes or fewer.
  /// Cost:   the first process reads the whole mesh once for each process, and holds all parts for a while.
  template<class Part>
  distributed(MPI_Comm communicator, const M& m, const Part& part)
      : distributed(communicator, detail::scatter(communicator, m, part)) {}

  /// From the arrays of each process, as load_distributed has them.
  distributed(MPI_Comm communicator, detail::mesh_part<detail::part_arrays<M>>&& own) : communicator_(communicator) {
    (MPI_Comm_rank)(communicator, &rank_);
    vert_numbers_ = std::move(own.vert_numbers), vert_owners_ = std::move(own.vert_owners);
    poly_numbers_ = std::move(own.poly_numbers), poly_owners_ = std::move(own.poly_owners);
    const auto loose = std::is_sorted_until(vert_numbers_.begin(), vert_numbers_.end());
    num_verts_in_order_ = static_cast<std::size_t>(loose - vert_numbers_.begin());
    detail::on_all(communicator, [&] {
      mesh_ = M(std::move(own.arrays));
      own.store_properties(mesh_.properties());
    });
    vert_exchange_ = exchange_of(communicator, vert_numbers_, vert_owners_);
    poly_exchange_ = exchange_of(communicator, poly_numbers_, poly_owners_);
    totals_[0] = static_cast<std::uint64_t>(std::count(vert_owners_.begin(), vert_owners_.end(), rank_));
    totals_[1] = static_cast<std::uint64_t>(std::count(poly_owners_.begin(), poly_owners_.end(), rank_));
    (MPI_Allreduce)(MPI_IN_PLACE, totals_, 2, MPI_UINT64_T, MPI_SUM, communicator);
  }

  /// The mesh of the part and its ghosts.
  const M& base() const { return mesh_; }
  /// Its named properties, which vert_property(d, "u") and the like use.
  property_set& properties() { return mesh_.properties(); }
  MPI_Comm communicator() const { return communicator_; }
  int rank() const { return rank_; }

  /// The process that a local vert or poly belongs to.
  int owner(const vert_t<M>& v) const { return vert_owners_[index_of(mesh_, v)]; }
  int owner(const poly_t<M>& p) const { return poly_owners_[index_of(mesh_, p)]; }
  bool is_ghost(const vert_t<M>& v) const { return owner(v) != rank_; }
  bool is_ghost(const poly_t<M>& p) const { return owner(p) != rank_; }
  /// The position in the order of the whole mesh.
  std::uint64_t global_number(const vert_t<M>& v) const { return vert_numbers_[index_of(mesh_, v)]; }
  std::uint64_t global_number(const poly_t<M>& p) const { return poly_numbers_[index_of(mesh_, p)]; }
  /// The local vert with a global number, or vert_t<M>{} on processes that do not have it.
  /// Cost:   O(log V).
  /// Errors: invalid_argument if there is no such vert.
  vert_t<M> vert(std::uint64_t number) const {
    if (number >= num_global_verts())
      core::throw_joined<invalid_argument>(
          {"distributed: there is no vert ", number, "; the mesh has ", num_global_verts(), " verts"});
    const auto begin = vert_numbers_.begin(), loose = begin + static_cast<std::ptrdiff_t>(num_verts_in_order_);
    for (const auto& [first, last] : {std::pair(begin, loose), std::pair(loose, vert_numbers_.end())})
      if (const auto found = std::lower_bound(first, last, number); found != last && *found == number)
        return vert_t<M>{static_cast<std::size_t>(found - begin)};
    return {};
  }
  /// The numbers of verts and polys of the whole mesh.
  std::uint64_t num_global_verts() const { return totals_[0]; }
  std::uint64_t num_global_polys() const { return totals_[1]; }

  const detail::ghost_exchange& exchange(const vert_t<M>*) const { return vert_exchange_; }
  const detail::ghost_exchange& exchange(const poly_t<M>*) const { return poly_exchange_; }
};

template<class M>
struct mesh_traits<distributed<M>> : detail::forward_all<distributed<M>, M>,
                                     detail::forward_points<distributed<M>, M>,
                                     detail::forward_properties<distributed<M>, M>,
                                     detail::fixed_arity<arity_v<M>> {
  using detail::forward_properties<distributed<M>, M>::properties;
  static property_set& properties(distributed<M>& m) { return m.properties(); }
  template<class X>  // a vert or poly
    requires requires(const distributed<M>& m, const X& x) { m.global_number(x); }
  static std::size_t number_in_messages(const distributed<M>& m, const X& x) {
    return static_cast<std::size_t>(m.global_number(x));
  }
};

/// Brings the values at ghosts up to date, from the processes that own them. All processes call it together.
/// Needs:  a map of verts or polys of a distributed mesh; T is trivially copyable.
/// Result: map[x] of each ghost x is that of its owner.
/// Cost:   one message to and from each process with common verts or polys.
/// Errors: none.
template<class M, class X, class T>
void exchange_ghosts(element_map<distributed<M>, X, T>& map) {
  map.mesh().exchange(static_cast<const X*>(nullptr)).to_ghosts(map.data());
}

/// The polys that belong to this process, without ghosts, as a view.
/// Needs:  a distributed mesh, which outlives the view.
/// Result: a mesh with the polys of this process, their verts, edges and faces. Each poly of the whole mesh is in
///         exactly one of these.
/// Cost:   O(size of the polys) time, a bit for each element.
/// Errors: none.
template<class M>
auto owned_part(const distributed<M>& m) {
  return submesh(m, [&](const poly_t<M>& p) { return !m.is_ghost(p); });
}
template<class M>
void owned_part(const distributed<M>&&) = delete;  // give the mesh a name: distributed d(...);

}  // namespace concino
