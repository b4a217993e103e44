// The verts of a problem on a distributed mesh: rows of its matrices, prescribed values, and those that are unknown.
#pragma once

#include <concino/adapters/detail/distributed/distributed_components.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/mpi/mpi_all_to_all.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/fields/support/linear_problem_parts.hpp>
#include <concino/mesh/element_map.hpp>

#include <petscsys.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino::detail {

/// The verts that have polys, numbered over all processes as rows of matrices, and the prescribed values. Vectors have
/// an entry for each local vert, by index. The constructor is collective. T: double or vec3.
template<class M, field_value T = double>
class distributed_problem {
  const distributed<M>* mesh_;
  const char* caller_;
  struct prescription {
    T value = {};
    std::uint8_t is_prescribed = 0, is_contradicted = 0;
  };
  std::vector<prescription> values_;
  std::vector<PetscInt> rows_;  // of each local vert; -1 if it has no polys
  std::vector<vert_t<M>> own_;  // the verts of this process, by row
  PetscInt first_ = 0;

  std::size_t index(const vert_t<M>& v) const { return index_of(mesh_->base(), v); }
  const ghost_exchange& exchange() const { return mesh_->exchange(static_cast<const vert_t<M>*>(nullptr)); }

  template<class Values>
  void read(const Values& values) {
    on_all(mesh_->communicator(), [&] {
      for (const auto& [vert, number] : values) {
        const vert_t<M> v = vert;
        if (v == vert_t<M>()) continue;  // of other processes
        const T x = as_field_value<T>(number);
        if (!contains(mesh_->base(), v))
          core::throw_joined<invalid_mesh>({caller_, ": a value is given at what is no vert of this process"});
        for (std::size_t k = 0; k < component_count<T>; ++k)
          if (!std::isfinite(field_component(x, k)))
            core::throw_joined<invalid_argument>(
                {caller_, ": the value given at vert ", mesh_->global_number(v), " is not finite"});
        combine(values_[index(v)], {x, 1, 0});
      }
    });
    exchange().to_owners(values_.data(), combine);
    exchange().to_ghosts(values_.data());
    on_all(mesh_->communicator(), [&] {
      for (const vert_t<M> v : verts(mesh_->base()))
        if (values_[index(v)].is_contradicted)
          core::throw_joined<invalid_argument>(
              {caller_, ": vert ", mesh_->global_number(v), " is given two different values"});
    });
  }
  static void combine(prescription& known, const prescription& other) {
    if (!other.is_prescribed) return;
    if (known.is_prescribed && !(known.value == other.value)) known.is_contradicted = 1;
    known.is_contradicted |= other.is_contradicted;
    if (!known.is_prescribed) known.value = other.value;
    known.is_prescribed = 1;
  }

  /// Every component has a prescribed value.
  void check_components() const {
    const distributed_components components = find_components(*mesh_);
    std::vector<double> has_value(components.size());
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (values_[i].is_prescribed && rows_[i] >= 0) has_value[components.of_vert[i]] = 1;
    add_over_processes(mesh_->communicator(), has_value);
    for (std::size_t k = 0; k < has_value.size(); ++k)
      if (!(has_value[k] > 0))
        core::throw_joined<solver_error>({caller_, ": the component of vert ", components.first_vert[k],
                                          " has no prescribed value; give one at any of its verts"});
  }

  void number_rows() {
    const M& m = mesh_->base();
    std::vector<char> has_polys(rows_.size());
    for (const poly_t<M> p : polys(m))
      for (const vert_t<M> v : adj_p2v(m, p)) has_polys[index(v)] = 1;
    for (const vert_t<M> v : verts(m))
      if (!mesh_->is_ghost(v) && has_polys[index(v)]) own_.push_back(v);
    long long count = static_cast<long long>(own_.size()), before = 0, total = 0;
    (MPI_Exscan)(&count, &before, 1, MPI_LONG_LONG, MPI_SUM, mesh_->communicator());
    (MPI_Allreduce)(&count, &total, 1, MPI_LONG_LONG, MPI_SUM, mesh_->communicator());
    if (mesh_->rank() == 0) before = 0;  // MPI leaves it undefined
    if (total > std::numeric_limits<PetscInt>::max())
      core::throw_joined<unsupported>({caller_, ": PETSc was built with indices that cannot count the verts"});
    first_ = static_cast<PetscInt>(before);
    for (std::size_t k = 0; k < own_.size(); ++k) rows_[index(own_[k])] = first_ + static_cast<PetscInt>(k);
    exchange().to_ghosts(rows_.data());
  }

 public:
  /// values: pairs of a local vert and its value; each process may give any of its own and of its ghosts.
  /// is_definite: no component needs a value.
  template<class Values>
  distributed_problem(const distributed<M>& m, const Values& values, const char* caller, bool is_definite = false)
      : mesh_(&m), caller_(caller), values_(vert_index_bound(m)), rows_(values_.size(), -1) {
    number_rows();
    read(values);
    if (!is_definite) check_components();
  }

  const distributed<M>& mesh() const { return *mesh_; }
  const char* caller() const { return caller_; }
  std::vector<T> zeros() const { return std::vector<T>(values_.size(), T{}); }
  PetscInt first_row() const { return first_; }
  /// The row of the local vert with this index in matrices over all verts that have polys; -1 if it has none.
  PetscInt matrix_row(std::size_t index) const { return rows_[index]; }
  /// The verts of this process that have polys, by row.
  const std::vector<vert_t<M>>& own() const { return own_; }
  /// Whether the local vert with this index has polys and no prescribed value.
  bool is_unknown(std::size_t index) const { return rows_[index] >= 0 && !values_[index].is_prescribed; }

  /// The given values, isolated_value at all other verts.
  vert_map<distributed<M>, T> prescribed(double isolated_value) const {
    auto u = make_vert_map<T>(*mesh_, same_in_all_components<T>(isolated_value));
    for (const vert_t<M> v : verts(mesh_->base()))
      if (values_[index(v)].is_prescribed) u[v] = values_[index(v)].value;
    return u;
  }
};

}  // namespace concino::detail
