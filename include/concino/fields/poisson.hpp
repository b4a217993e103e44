// Poisson's equation: the function whose Laplacian is given, with values given at some verts. On any mesh.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/operators/detail/virtual_elements.hpp>

namespace concino {

struct poisson_options {
  concino::weights weights = concino::weights::standard;
  double isolated_value = 0;              // of verts without edges that have no value prescribed; any, NaN too
  concino::progress progress = nullptr;
};

namespace detail {

[[noreturn, gnu::noinline, gnu::cold]] inline void throw_load_not_finite(std::size_t vert) {
  throw_joined<invalid_argument>({"poisson: the load f at vert ", vert, " is not finite"});
}

/// The Galerkin mass matrix times f, poly by poly.
template<class M, class F>
vert_map<M, double> integrated_load(const M& m, const F& f) {
  auto load = make_vert_map<double>(m, 0.0);
  virtual_mass<M> element(m);
  local_matrix<vert_t<M>> local;
  std::vector<double> value;
  for (const poly_t<M> p : polys(m)) {
    element(p, local);
    const std::size_t n = local.size();
    value.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      value[i] = static_cast<double>(f[local.verts[i]]);
      if (!std::isfinite(value[i])) throw_load_not_finite(static_cast<std::size_t>(index_of(m, local.verts[i])));
    }
    for (std::size_t i = 0; i < n; ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < n; ++j) sum += local.at(i > j ? i : j, i > j ? j : i) * value[j];
      load[local.verts[i]] += sum;
    }
  }
  return load;
}

}  // namespace detail

/// The function u on the verts with -L u = M f, the weak form of -(Laplacian of u) = f, and the given values at some verts. Where none are
/// given on the boundary, the derivative of u across it is 0.
/// Needs:  Embedded AnyMesh; for cotangent weights all polys triangles or tets. f: any readable map over verts, f[v], in units of u over
///         length^2. `values` and solver as for harmonic_map.
/// Result: a map of double, u[v]. Given values are exact. M is the Galerkin mass: the load is integrated against the projected hat functions,
///         since lumping it would cost the order of the error, 2 in the size of the polys with standard weights. Verts without edges
///         get isolated_value unless a value is given; f is not read at verts of no poly.
/// Cost:   one sparse factorisation of as many unknowns as there are verts to find.
/// Errors: as harmonic_map with the same weights; invalid_argument if f is not finite at a vert of a poly; invalid_mesh if a poly has no area or
///         volume, or points that are not finite.
/// Source: Beirao da Veiga et al. 2013, Ahmad et al. 2013 (the load); paper section 2.2.
template<class M, class F, class D = std::initializer_list<std::pair<vert_t<M>, double>>, class Solver = ldlt>
  requires AnyMesh<M> && Embedded<M> && requirement::is_no_temporary<M> && ReadableMap<F, vert_t<M>> &&
           SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, double> poisson(M&& m, const F& f, const D& values, const poisson_options& options = {}, Solver&& solver = {}) {
  const std::remove_cvref_t<M>& mesh_in = m;
  detail::tell(options.progress, 0, "Poisson's equation");
  auto problem = detail::dirichlet<double>(mesh_in, values, options.isolated_value, "poisson");
  auto b = problem.no_load();
  const auto a = detail::minus_laplacian_of_unknowns<double>(mesh_in, options.weights, problem, b);
  const auto load = detail::integrated_load(mesh_in, f);
  for (const vert_t<M> v : verts(mesh_in))
    if (const int i = problem.unknown[v]; i >= 0) b[0][i] += load[v];
  detail::solve_unknowns<double>(mesh_in, problem, a, b, solver, "poisson", options.progress);
  detail::tell(options.progress, 1, "Poisson's equation");
  return std::move(problem.value);
}

}  // namespace concino
