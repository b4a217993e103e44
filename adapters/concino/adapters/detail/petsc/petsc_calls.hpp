// Owners of PETSc's objects, and its errors as exceptions.
#pragma once

#include <concino/core/error.hpp>

#include <petscksp.h>

#include <string>
#include <type_traits>
#include <utility>

namespace concino::detail {

/// One object of PETSc. It is not destroyed after PETSc has ended.
template<class T, PetscErrorCode (*destroy)(T*)>
class petsc_object {
  T object_ = nullptr;

 public:
  petsc_object() = default;
  petsc_object(petsc_object&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  petsc_object& operator=(petsc_object&& other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }
  ~petsc_object() { reset(); }

  void reset() {
    if (object_ && !PetscFinalizeCalled) static_cast<void>(destroy(&object_));
    object_ = nullptr;
  }
  T* address() {
    reset();
    return &object_;
  }
  operator T() const { return object_; }
};

using petsc_matrix = petsc_object<Mat, MatDestroy>;
using petsc_vector = petsc_object<Vec, VecDestroy>;
using petsc_krylov = petsc_object<KSP, KSPDestroy>;
using petsc_null_space = petsc_object<MatNullSpace, MatNullSpaceDestroy>;

/// While it exists, errors of PETSc are kept here instead of printed.
class petsc_errors {
  std::string first_;

  static PetscErrorCode keep(MPI_Comm, int, const char*, const char*, PetscErrorCode code, PetscErrorType type,
                             const char* what, void* self) {
    if (type == PETSC_ERROR_INITIAL && what) static_cast<petsc_errors*>(self)->first_ = what;
    return code;
  }

 public:
  petsc_errors() { static_cast<void>(PetscPushErrorHandler(keep, this)); }
  petsc_errors(const petsc_errors&) = delete;
  petsc_errors& operator=(const petsc_errors&) = delete;
  ~petsc_errors() { static_cast<void>(PetscPopErrorHandler()); }

  /// code: what a function of PETSc has returned.
  void check(PetscErrorCode code, const char* during) const {
    if (code == 0) return;
    const char* kind = nullptr;
    if (first_.empty()) static_cast<void>(PetscErrorMessage(code, &kind, nullptr));
    core::throw_joined<solver_error>({"petsc: ", during, " failed: ",
                                      !first_.empty() ? first_.c_str()
                                      : kind          ? kind
                                                      : "no reason is known"});
  }
};

inline void check_petsc_is_running() {
  static_assert(std::is_same_v<PetscScalar, double>,
                "concino: petsc needs a PETSc of real numbers in double precision");
  if (!PetscInitializeCalled || PetscFinalizeCalled)
    throw invalid_argument("petsc: PETSc is not running: write concino::petsc_session session(argc, argv) in main");
}

}  // namespace concino::detail
