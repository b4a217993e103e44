// The parts of one mesh, sent from the first process to all.
#pragma once

#include <concino/adapters/detail/distributed/distributed_values.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/mpi/mpi_bytes.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/property_set.hpp>
#include <concino/mesh/submesh.hpp>
#include <concino/mesh/support/arrays_of.hpp>

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::detail {

/// What a process gets: arrays of its part and ghosts, the numbers and owners of their verts and polys, and properties.
template<class Arrays>
struct mesh_part {
  Arrays arrays;
  std::vector<std::uint64_t> vert_numbers, poly_numbers;
  std::vector<int> vert_owners, poly_owners;
  sent_properties properties;
  std::vector<char> vert_values, poly_values, mesh_values;  // rows of the properties

  /// Moves the rows to the properties of a mesh.
  void store_properties(property_set& to) {
    const auto store = [&](std::vector<char>& rows, element_kind kind) {
      properties.store(rows, kind, to);
      std::vector<char>().swap(rows);
    };
    store(vert_values, element_kind::vert);
    store(poly_values, element_kind::poly);
    store(mesh_values, element_kind::mesh);
  }
  /// Calls f(array) for every array.
  template<class F>
  void for_each_array(F f) {
    f(vert_values), f(poly_values), f(mesh_values), f(arrays.points);
    if constexpr (std::is_same_v<Arrays, polyhedra_arrays>) {
      f(arrays.face_offsets), f(arrays.face_verts), f(arrays.poly_offsets), f(arrays.poly_faces), f(arrays.outward);
    } else {
      if constexpr (std::is_same_v<Arrays, surface_arrays>) f(arrays.offsets);
      f(arrays.verts);
    }
    f(vert_numbers), f(poly_numbers), f(vert_owners), f(poly_owners);
  }
};

template<class M>
using part_arrays = std::conditional_t<from_surface<M>, surface_arrays,
                                       std::conditional_t<from_polyhedra<M>, polyhedra_arrays, cell_arrays>>;

/// Divides a mesh. Verts belong to the lowest of the parts around them, verts without polys to the first one.
template<class M>
class mesh_divider {
  const M* mesh_;
  std::vector<int> poly_owner_, vert_owner_;  // by index
  std::vector<std::uint32_t> vert_number_, poly_number_;
  sent_properties properties_;

  template<class S>
  void fill(const S& s, const std::vector<std::uint32_t>& number, surface_arrays& a) const {
    a = core::arrays_of(s, number, static_cast<std::uint32_t>(arity_v<M>));
  }
  template<class S>
  void fill(const S& s, const std::vector<std::uint32_t>& number, cell_arrays& a) const {
    a.points = core::copy_points(s);
    a.arity = static_cast<std::uint32_t>(arity_v<M>);
    a.verts.reserve(a.arity * num_polys(s));
    for (const poly_t<S> p : polys(s))
      for (const vert_t<S> v : adj_p2v(s, p)) a.verts.push_back(vert_id{number[index_of(s, v)]});
  }
  template<class S>
  void fill(const S& s, const std::vector<std::uint32_t>& number, polyhedra_arrays& a) const {
    a = core::polyhedra_of(s, number, core::numbered(s, faces(s), face_index_bound(s)));
  }

 public:
  /// part[p] is the process of each poly.
  template<class Part>
  mesh_divider(const M& m, const Part& part, int processes)
      : mesh_(&m), poly_owner_(poly_index_bound(m), 0), vert_owner_(vert_index_bound(m), processes),
        vert_number_(core::numbered(m, verts(m), vert_index_bound(m))),
        poly_number_(core::numbered(m, polys(m), poly_index_bound(m))) {
    for (const poly_t<M> p : polys(m)) {
      const int owner = static_cast<int>(part[p]);
      if (owner < 0 || owner >= processes)
        core::throw_joined<invalid_argument>(
            {"distributed: poly ", index_of(m, p), " is in part ", owner, "; there are ", processes, " processes"});
      poly_owner_[index_of(m, p)] = owner;
      for (const vert_t<M> v : adj_p2v(m, p)) {
        int& o = vert_owner_[index_of(m, v)];
        o = std::min(o, owner);
      }
    }
    for (int& o : vert_owner_) o = o == processes ? 0 : o;
    properties_.add(traits<M>::properties(m), false);
  }

  mesh_part<part_arrays<M>> part_of(int process) const {
    std::vector<char> is_near(vert_index_bound(*mesh_)), is_used(is_near.size());
    for (const poly_t<M> p : polys(*mesh_))
      if (poly_owner_[index_of(*mesh_, p)] == process)
        for (const vert_t<M> v : adj_p2v(*mesh_, p)) is_near[index_of(*mesh_, v)] = 1;
    const auto s = submesh(*mesh_, [&](const poly_t<M>& p) {
      for (const vert_t<M> v : adj_p2v(*mesh_, p))
        if (is_near[index_of(*mesh_, v)]) return true;
      return false;
    });
    mesh_part<part_arrays<M>> r;
    std::vector<std::uint32_t> vert_indices, poly_indices;
    for (const poly_t<M> p : polys(s)) {
      poly_indices.push_back(static_cast<std::uint32_t>(index_of(*mesh_, p)));
      r.poly_numbers.push_back(poly_number_[index_of(*mesh_, p)]);
      r.poly_owners.push_back(poly_owner_[index_of(*mesh_, p)]);
    }
    for (const vert_t<M> v : verts(s)) {
      is_used[index_of(*mesh_, v)] = 1;
      vert_indices.push_back(static_cast<std::uint32_t>(index_of(*mesh_, v)));
      r.vert_numbers.push_back(vert_number_[index_of(*mesh_, v)]);
      r.vert_owners.push_back(vert_owner_[index_of(*mesh_, v)]);
    }
    fill(s, core::numbered(s, verts(s), vert_index_bound(s)), r.arrays);
    for (const vert_t<M> v : verts(*mesh_)) {  // those without polys, for the first process
      if (process > 0 || is_used[index_of(*mesh_, v)] || num_elements(adj_v2p(*mesh_, v)) > 0) continue;
      vert_indices.push_back(static_cast<std::uint32_t>(index_of(*mesh_, v)));
      r.arrays.points.push_back(to_vec3(point(*mesh_, v)));
      r.vert_numbers.push_back(vert_number_[index_of(*mesh_, v)]);
      r.vert_owners.push_back(0);
    }
    const property_set& all = traits<M>::properties(*mesh_);
    r.properties = properties_;
    properties_.append_rows(all, element_kind::vert, vert_indices, r.vert_values);
    properties_.append_rows(all, element_kind::poly, poly_indices, r.poly_values);
    properties_.append_rows(all, element_kind::mesh, {0}, r.mesh_values);
    return r;
  }
};

/// The part of this process. m and part are read on the first process alone. Collective.
template<class M, class Part>
mesh_part<part_arrays<M>> scatter(MPI_Comm communicator, const M& m, const Part& part) {
  int size = 1, rank = 0;
  (MPI_Comm_size)(communicator, &size);
  (MPI_Comm_rank)(communicator, &rank);
  mesh_part<part_arrays<M>> own;
  std::vector<std::vector<char>> messages(static_cast<std::size_t>(size));
  on_all(communicator, [&] {
    if (rank > 0) return;
    const mesh_divider<M> divider(m, part, size);
    own = divider.part_of(0);
    for (int r = 1; r < size; ++r) {
      auto other = divider.part_of(r);
      byte_writer writer;
      writer.put(other.properties.bytes());
      other.for_each_array([&](const auto& array) { writer.put(array); });
      messages[static_cast<std::size_t>(r)] = writer.bytes();
    }
  });
  if (rank > 0) {
    const std::vector<char> bytes = receive_bytes(0, communicator);
    byte_reader reader(bytes);
    std::vector<char> properties;
    reader.get(properties);
    own.properties.add(properties);
    own.for_each_array([&](auto& array) { reader.get(array); });
    if constexpr (!std::is_same_v<part_arrays<M>, polyhedra_arrays>)
      own.arrays.arity = static_cast<std::uint32_t>(arity_v<M>);
    return own;
  }
  for (int r = 1; r < size; ++r) send_bytes(messages[static_cast<std::size_t>(r)], r, communicator);
  return own;
}

}  // namespace concino::detail
