// The unknown verts of a problem on a distributed mesh, and the values that are prescribed at others.
#pragma once

#include <concino/adapters/detail/distributed/distributed_components.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/mpi/mpi_all_to_all.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>

#include <petscsys.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino::detail {

/// The unknown verts, numbered over all processes, and the prescribed values. Vectors have an entry for each local
/// vert, by index. Every function is collective.
template<class M>
class distributed_problem {
  const distributed<M>* mesh_;
  const char* caller_;
  struct prescription {
    double value = 0;
    std::uint8_t is_prescribed = 0, is_contradicted = 0;
  };
  std::vector<prescription> values_;
  std::vector<PetscInt> unknown_;  // the row of each local vert; -1 if it is none
  std::vector<char> has_polys_;
  std::vector<vert_t<M>> own_;  // unknown verts of this process, by row
  PetscInt first_ = 0;

  std::size_t index(const vert_t<M>& v) const { return index_of(mesh_->base(), v); }
  const ghost_exchange& exchange() const { return mesh_->exchange(static_cast<const vert_t<M>*>(nullptr)); }

  template<class Values>
  void read(const Values& values) {
    on_all(mesh_->communicator(), [&] {
      for (const auto& [v, x] : values) {
        if (!contains(mesh_->base(), v))
          core::throw_joined<invalid_mesh>({caller_, ": a value is given at what is no vert of this process"});
        if (!std::isfinite(static_cast<double>(x)))
          core::throw_joined<invalid_argument>(
              {caller_, ": the value given at vert ", mesh_->global_number(v), " is not finite"});
        combine(values_[index(v)], {static_cast<double>(x), 1, 0});
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
    if (known.is_prescribed && known.value != other.value) known.is_contradicted = 1;
    known.is_contradicted |= other.is_contradicted;
    if (!known.is_prescribed) known.value = other.value;
    known.is_prescribed = 1;
  }

  /// Every component has a prescribed value.
  void check_components() const {
    const distributed_components components = find_components(*mesh_);
    std::vector<double> has_value(components.size());
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (values_[i].is_prescribed && has_polys_[i]) has_value[components.of_vert[i]] = 1;
    add_over_processes(mesh_->communicator(), has_value);
    for (std::size_t k = 0; k < has_value.size(); ++k)
      if (!(has_value[k] > 0))
        core::throw_joined<solver_error>({caller_, ": the component of vert ", components.first_vert[k],
                                          " has no prescribed value; give one at any of its verts"});
  }

  void number_unknowns() {
    const M& m = mesh_->base();
    for (const vert_t<M> v : verts(m))
      if (!mesh_->is_ghost(v) && has_polys_[index(v)] && !values_[index(v)].is_prescribed) own_.push_back(v);
    long long count = static_cast<long long>(own_.size()), before = 0, total = 0;
    (MPI_Exscan)(&count, &before, 1, MPI_LONG_LONG, MPI_SUM, mesh_->communicator());
    (MPI_Allreduce)(&count, &total, 1, MPI_LONG_LONG, MPI_SUM, mesh_->communicator());
    if (mesh_->rank() == 0) before = 0;  // MPI leaves it undefined
    if (total > std::numeric_limits<PetscInt>::max())
      core::throw_joined<unsupported>({caller_, ": PETSc was built with indices that cannot count the unknowns"});
    first_ = static_cast<PetscInt>(before);
    for (std::size_t k = 0; k < own_.size(); ++k) unknown_[index(own_[k])] = first_ + static_cast<PetscInt>(k);
    exchange().to_ghosts(unknown_.data());
  }

 public:
  /// values: pairs of a local vert and its value; each process may give any of its own and of its ghosts.
  /// is_definite: no component needs a value.
  template<class Values>
  distributed_problem(const distributed<M>& m, const Values& values, const char* caller, bool is_definite = false)
      : mesh_(&m), caller_(caller), values_(vert_index_bound(m)), unknown_(values_.size(), -1),
        has_polys_(values_.size()) {
    for (const poly_t<M> p : polys(m))
      for (const vert_t<M> v : adj_p2v(m, p)) has_polys_[index(v)] = 1;
    read(values);
    if (!is_definite) check_components();
    number_unknowns();
  }

  const distributed<M>& mesh() const { return *mesh_; }
  const char* caller() const { return caller_; }
  std::vector<double> zeros() const { return std::vector<double>(values_.size(), 0.0); }
  PetscInt first_row() const { return first_; }
  /// The row of the local vert with this index; -1 if it is not unknown.
  PetscInt row(std::size_t index) const { return unknown_[index]; }
  /// The unknown verts of this process, by row.
  const std::vector<vert_t<M>>& own() const { return own_; }

  /// The given values, isolated_value at all other verts.
  vert_map<distributed<M>, double> prescribed(double isolated_value) const {
    auto u = make_vert_map<double>(*mesh_, isolated_value);
    for (const vert_t<M> v : verts(mesh_->base()))
      if (values_[index(v)].is_prescribed) u[v] = values_[index(v)].value;
    return u;
  }
};

}  // namespace concino::detail
