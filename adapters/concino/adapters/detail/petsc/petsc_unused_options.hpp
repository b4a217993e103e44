// Options of PETSc's database that nothing has read: misspelt ones, or those without effect.
#pragma once

#include <concino/adapters/detail/petsc/petsc_calls.hpp>
#include <concino/core/error.hpp>

#include <petscsys.h>

#include <string>
#include <vector>

namespace concino::detail {

/// Those with the prefix of a solver, or those of solvers if it has none.
inline std::vector<std::string> find_unused_options(const petsc_errors& errors, const std::string& prefix) {
  std::vector<std::string> unused;
  PetscInt n = 0;
  char **names = nullptr, **values = nullptr;
  errors.check(PetscOptionsLeftGet(nullptr, &n, &names, &values), "reading the options");
  for (PetscInt i = 0; i < n; ++i) {
    const std::string name = names[i];
    const auto begins_with = [&](const char* text) { return name.rfind(text, 0) == 0; };
    if (prefix.empty() ? begins_with("ksp_") || begins_with("pc_") || begins_with("mg_") : begins_with(prefix.c_str()))
      unused.push_back(name);
  }
  errors.check(PetscOptionsLeftRestore(nullptr, &n, &names, &values), "reading the options");
  return unused;
}

inline void check_unused_options(const std::vector<std::string>& unused) {
  if (!unused.empty())
    core::throw_joined<invalid_argument>({"petsc: the option -", unused.front(),
                                          " is misspelt, or has no effect on this solver; correct or remove it, or set"
                                          " accept_unused_options"});
}

}  // namespace concino::detail
