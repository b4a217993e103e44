// Laplacian eigenfunctions of surfaces and volumes of any size and any polys. Not part of <concino/fields.hpp>: in
// header-only use it takes seconds to compile, for Eigen's dense eigenvalue solver.
#pragma once

#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/fields/detail/problems/laplace_system.hpp>
#include <concino/fields/eigenfunctions_result.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>
#include <concino/solve/eigenpairs.hpp>

#include <cstddef>
#include <type_traits>

namespace concino {

struct lobpcg_eigenfunctions_options {
  bool lumped = true;                     // mass matrix, see mass_matrix: if it is not lumped, values converge from
                                          // above
  double tolerance = 1e-8;                // as in lobpcg_options
  int max_iterations = 1000;              // as in lobpcg_options
  bool accept_missed_tolerance = false;   // as in lobpcg_options
  concino::progress progress = nullptr;  // called with "eigenpairs"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// The Laplacian eigenfunctions of a surface or a volume, with Neumann boundary conditions: minus the Laplacian of each
/// is its value times the function, and its normal derivative at the boundary is zero. The Laplacian is that of the
/// discretisation argument, after the count, or that of virtual_elements. They are computed by lobpcg, without a
/// factorisation, so that meshes may be large; <concino/adapters/spectra.hpp> has the same with one.
/// Needs:  EmbeddedMesh M, no temporary; with a Discretisation also what that needs. count: at least 1, at most the
///         verts of polys.
/// Result: `count` functions; the first is constant with value 0, and the value 0 occurs once per component of polys.
///         Errors of values decrease with the square of the edge length. The sign of a function, and the basis of those
///         with the same value, depend on the order in which the mesh is stored. Scaling the mesh by a power of 2
///         scales values exactly, and also functions, but those of volumes only for a power of 4.
/// Cost:   as laplacian, mass_matrix and eigenpairs.
/// Errors: as laplacian, mass_matrix and eigenpairs.
/// Source: Vallet, Levy 2008, "Spectral geometry processing with manifold harmonics"; Reuter, Wolter, Peinecke 2006,
///         "Laplace-Beltrami spectra as Shape-DNA"; Kac 1966, "Can one hear the shape of a drum?"; that of eigenpairs.
template<class M, class D>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && Discretisation<D, M>
      eigenfunctions_result<std::remove_cvref_t<M>> eigenfunctions(M&& m, std::size_t count, const D& discretisation,
                                                                   lobpcg_method,
                                                                   const lobpcg_eigenfunctions_options& options = {}) {
    const core::profiled_options profiled(options, "eigenfunctions");
    return core::eigenfunctions_from(m, eigenpairs(detail::minus_laplacian(m, discretisation),
                                                   mass_matrix(m, {.lumped = options.lumped}), count, lobpcg,
                                                   {.tolerance = options.tolerance,
                                                    .max_iterations = options.max_iterations,
                                                    .accept_missed_tolerance = options.accept_missed_tolerance,
                                                    .progress = profiled->progress}));
  }
template<class M>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> eigenfunctions_result<std::remove_cvref_t<M>>
  eigenfunctions(M&& m, std::size_t count, lobpcg_method, const lobpcg_eigenfunctions_options& options = {}) {
    return eigenfunctions(m, count, virtual_elements, lobpcg, options);
  }

}  // namespace concino
