// A surface that is prepared for heat flow of vectors: its equations, factorised.
#pragma once

#include <concino/concepts/surface_mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/residual.hpp>
#include <concino/fields/detail/heat/affine_heat.hpp>
#include <concino/fields/detail/problems/make_similar_solver.hpp>
#include <concino/mesh/element_map.hpp>

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace concino::detail {

template<class Solver>
struct vector_heat {
  affine_heat equations;
  std::unique_ptr<Solver> scalar_solver, vector_solver;
  double unit = 1;  // the length of a unit of the equations

  /// Errors: those of unfold_surface, make_tangent_frames and the solver; invalid_argument if time is out of its range;
  ///         unsupported if the solver is iterative.
  template<SurfaceMesh M>
  static std::shared_ptr<const vector_heat> make(const M& m, double time, const Solver& solver, const char* caller) {
    if (!(time >= 0 && std::isfinite(time)))
      core::throw_joined<invalid_argument>(
          {caller, ": time is ", core::number_text(time), "; it has to be finite and not negative, 0 for the default"});
    const core::unfolded_surface surface = core::unfold_surface(m, caller);
    const core::unfolded_triangles& t = surface.triangles;
    vector_heat r{make_affine_heat(t, core::make_tangent_frames(m, t, caller), std::ldexp(time, -2 * t.exponent)),
                  make_similar_solver(solver), make_similar_solver(solver), std::ldexp(1.0, t.exponent)};
    core::factorize_over_verts(*r.scalar_solver, r.equations.scalars, caller, [](Eigen::Index row) { return row; });
    core::factorize_over_verts(*r.vector_solver, r.equations.vectors, caller, [](Eigen::Index row) { return row / 2; });
    if (core::is_iterative(*r.scalar_solver) || core::is_iterative(*r.vector_solver))
      core::throw_joined<unsupported>(
          {caller,
           ": the solver is iterative, so values far from the source have no correct digits; pass one that factorises, such as ldlt"});
    return std::make_shared<const vector_heat>(std::move(r));
  }

  diffused run(const std::vector<vector_source>& sources, const diffusion_outputs& extra, const char* caller) const {
    return diffuse(equations, *scalar_solver, *vector_solver, sources, extra, caller);
  }

  template<SurfaceMesh M>
  static int index_of_source(const M& m, const vert_t<M>& v, const char* caller) {
    if (!contains(m, v))
      core::throw_joined<invalid_mesh>({caller, ": a source is not a vert of the mesh; take it from verts(m)"});
    return static_cast<int>(index_of(m, v));
  }
};

}  // namespace concino::detail
