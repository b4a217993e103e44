// Options of multigrid that suit meshes better than PETSc's own defaults, where the database of options has none.
#pragma once

#include <concino/core/message.hpp>

#include <petscsys.h>

#include <string>
#include <vector>

namespace concino::detail {

/// Adds them to the database, and removes them at the end of the scope: they are no options of the user. A vert of a
/// volume has many neighbours, 26 in a grid of hexes. With PETSc's defaults, the first coarse grid of GAMG is too
/// coarse for that, and the coarse matrices of hypre fill up. docs/scale.md has iterations and times.
class petsc_default_options {
  std::vector<std::string> added_;

  void add(const std::string& option, const char* value) {
    PetscBool is_given = PETSC_FALSE;
    if (PetscOptionsHasName(nullptr, nullptr, option.c_str(), &is_given) != 0 || is_given) return;
    if (PetscOptionsSetValue(nullptr, option.c_str(), value) == 0) added_.push_back(option);
  }

 public:
  explicit petsc_default_options(const std::string& prefix) {
    add(core::joined({"-", prefix, "pc_gamg_aggressive_coarsening"}), "0");
    add(core::joined({"-", prefix, "pc_hypre_boomeramg_coarsen_type"}), "HMIS");
    add(core::joined({"-", prefix, "pc_hypre_boomeramg_interp_type"}), "ext+i");
    add(core::joined({"-", prefix, "pc_hypre_boomeramg_P_max"}), "4");
  }
  petsc_default_options(const petsc_default_options&) = delete;
  petsc_default_options& operator=(const petsc_default_options&) = delete;
  ~petsc_default_options() {
    for (const std::string& option : added_) static_cast<void>(PetscOptionsClearValue(nullptr, option.c_str()));
  }
};

}  // namespace concino::detail
