// What a process saves of a distributed mesh: its polys, its verts without polys, and their numbers and owners.
#pragma once

#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/core/message.hpp>
#include <concino/mesh/property_set.hpp>

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace concino::detail {

/// The elements by index in the local mesh, and properties of all local elements: named ones, numbers and owners.
struct piece_of_process {
  std::vector<std::uint32_t> polys, loose_verts;
  property_set properties;
};

template<class M, class Elements>
void store_numbers(const distributed<M>& m, element_kind kind, const Elements& elements, std::size_t bound,
                   property_set& all) {
  auto* const ids = static_cast<std::int64_t*>(all.get(kind, "global_id", values_of<std::int64_t>, bound)->data());
  auto* const owners = static_cast<int*>(all.get(kind, "owner", values_of<int>, bound)->data());
  for (const auto x : elements) {
    ids[index_of(m, x)] = static_cast<std::int64_t>(m.global_number(x));
    owners[index_of(m, x)] = m.owner(x);
  }
}

/// The properties of a distributed mesh that a piece has: those of verts, polys and the mesh, but for names that
/// save_pvtu uses itself.
template<class M>
property_set properties_of_piece(const distributed<M>& m) {
  const property_set& all = traits<distributed<M>>::properties(m);
  property_set kept;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const property_info p = all.info(i);
    const bool is_reserved = p.kind != element_kind::mesh && (p.name == "global_id" || p.name == "owner");
    if (p.kind == element_kind::edge || p.kind == element_kind::face || p.kind == element_kind::corner || is_reserved)
      continue;
    const column& values = *all.values(i);
    column copies(values);
    kept.get(p.kind, p.name, values.operations(), values.size())->swap_values(copies);
  }
  return kept;
}

/// Brings the values of verts that other processes own up to date; polys of others are in no piece. All processes have
/// the same properties. Collective.
template<class M>
void update_ghosts(const distributed<M>& m, const property_set& all) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const column& values = *all.values(i);
    if (all.kind(i) == element_kind::vert && values.is_bytes())  // no file has others
      m.exchange(static_cast<const vert_t<M>*>(nullptr)).to_ghosts(values.data(), values.operations().size);
  }
}

template<class M>
piece_of_process local_piece(const distributed<M>& m) {
  piece_of_process r;
  r.properties = properties_of_piece(m);
  for (const poly_t<M> p : polys(m))
    if (!m.is_ghost(p)) r.polys.push_back(static_cast<std::uint32_t>(index_of(m, p)));
  for (const vert_t<M> v : verts(m))
    if (num_elements(adj_v2p(m, v)) == 0) r.loose_verts.push_back(static_cast<std::uint32_t>(index_of(m, v)));
  store_numbers(m, element_kind::vert, verts(m), vert_index_bound(m), r.properties);
  store_numbers(m, element_kind::poly, polys(m), poly_index_bound(m), r.properties);
  return r;
}

/// Checks the names of what is saved. Collective. Errors: invalid_argument.
template<class M, class Values>
void check_named_values(const distributed<M>& m, const Values& values) {
  std::string list;  // of this process, and of the first one
  on_all(m.communicator(), [&] {
    std::set<std::string> names;
    for (const auto& v : values) {
      if (&v.mesh() != &m)
        core::throw_joined<invalid_argument>({"save_pvtu: \"", v.name(), "\" is a map of another mesh"});
      if (v.name() == "global_id" || v.name() == "owner")
        core::throw_joined<invalid_argument>(
            {"save_pvtu: \"", v.name(), "\" is the name of what save_pvtu adds; choose another"});
      const std::string name = core::joined({to_string(v.kind()), " \"", v.name(), "\""});
      if (!names.insert(name).second) core::throw_joined<invalid_argument>({"save_pvtu: two maps are named ", name});
      list += core::joined({list.empty() ? "" : ", ", name});
    }
    const property_set& properties = traits<distributed<M>>::properties(m);
    for (std::size_t i = 0; i < properties.size(); ++i)
      list += core::joined({list.empty() ? "" : ", ", to_string(properties.kind(i)), " \"", properties.info(i).name,
                            "\""});
  });
  std::string first = list;
  auto length = static_cast<std::uint64_t>(first.size());
  (MPI_Bcast)(&length, 1, MPI_UINT64_T, 0, m.communicator());
  first.resize(static_cast<std::size_t>(length));
  (MPI_Bcast)(first.data(), static_cast<int>(length), MPI_CHAR, 0, m.communicator());
  on_all(m.communicator(), [&] {
    if (list != first)
      core::throw_joined<invalid_argument>(
          {"save_pvtu: the maps and properties are not the same on all processes: ", first, "; ", list});
  });
}

}  // namespace concino::detail
