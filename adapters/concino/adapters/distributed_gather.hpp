// The values of a map or property of a distributed mesh, brought to the first process: gather(u), gather(d, u).
// Needs: MPI (Debian: petsc-dev brings it; libopenmpi-dev).
#pragma once

#include <concino/adapters/detail/mpi/mpi_bytes.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/property.hpp>

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace concino {

namespace detail {

template<class X, class T, class M, class Values>
std::vector<T> gather_values(const distributed<M>& m, const Values& of) {
  std::vector<std::uint64_t> numbers;
  std::vector<T> values, all;
  const auto take = [&](const auto& elements) {
    for (const X& x : elements) {
      if (m.is_ghost(x)) continue;
      numbers.push_back(m.global_number(x));
      values.push_back(of[x]);
    }
  };
  constexpr bool of_verts = std::is_same_v<X, vert_t<M>>;
  if constexpr (of_verts) take(verts(m));
  else take(polys(m));
  if (m.rank() > 0) {
    byte_writer writer;
    writer.put(numbers);
    writer.put(values);
    send_bytes(writer.bytes(), 0, m.communicator());
    return {};
  }
  int size = 1;
  (MPI_Comm_size)(m.communicator(), &size);
  all.resize(static_cast<std::size_t>(of_verts ? m.num_global_verts() : m.num_global_polys()));
  for (int r = 0; r < size; ++r) {
    if (r > 0) {
      const std::vector<char> bytes = receive_bytes(r, m.communicator());
      byte_reader reader(bytes);
      reader.get(numbers);
      reader.get(values);
    }
    for (std::size_t k = 0; k < numbers.size(); ++k) all[static_cast<std::size_t>(numbers[k])] = values[k];
  }
  return all;
}

}  // namespace detail

/// All values of a map or of a named property, to print, save or draw them. All processes call it together.
/// Needs:  a map of verts or polys of a distributed mesh, or such a property; T is trivially copyable. Ghosts are not
///         read.
/// Result: on the first process the values by global number; on others nothing.
/// Cost:   the first process holds all values, and gets one message from each other.
/// Errors: none.
template<class M, class X, class T>
  requires std::is_trivially_copyable_v<T> std::vector<T> gather(const element_map<distributed<M>, X, T>& map) {
    return detail::gather_values<X, T>(map.mesh(), map);
  }
template<class M, class X, class T>
  requires std::is_trivially_copyable_v<T> std::vector<std::remove_const_t<T>> gather(const distributed<M>& m,
                                                                                      const property_map<X, T>& u) {
    return detail::gather_values<X, std::remove_const_t<T>>(m, u);
  }

/// The same as a map of the whole mesh, to save or draw it. All processes call it together.
/// Needs:  as gather(map). m: on the first process, the mesh that was divided; others may pass any mesh.
/// Result: on the first process the values at the verts or polys of m; on others T() everywhere.
/// Cost:   as gather(map).
/// Errors: invalid_mesh on all processes if m has another number of verts or polys.
template<class M, class X, class T>
element_map<M, X, T> gather(const element_map<distributed<M>, X, T>& map, const M& m) {
  constexpr bool of_verts = std::is_same_v<X, vert_t<M>>;
  const distributed<M>& d = map.mesh();
  detail::on_all(d.communicator(), [&] {
    const bool is_other = of_verts ? num_verts(m) != d.num_global_verts() : num_polys(m) != d.num_global_polys();
    if (d.rank() == 0 && is_other) throw invalid_mesh("gather: the mesh is not the one that was divided");
  });
  const std::vector<T> values = gather(map);
  std::size_t next = 0;
  const auto give = [&](const auto& elements, element_map<M, X, T> r) {
    for (const X& x : elements)
      if (next < values.size()) r[x] = values[next++];
    return r;
  };
  if constexpr (of_verts) return give(verts(m), make_vert_map<T>(m, T()));
  else return give(polys(m), make_poly_map<T>(m, T()));
}

template<class M, class X, class T>
void gather(const element_map<distributed<M>, X, T>&, const M&&) = delete;  // give the mesh a name: auto m = load...

}  // namespace concino
