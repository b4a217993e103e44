// The result of eigenfunctions, whichever method computes them. Not part of <concino/fields.hpp>, as eigenfunctions.
#pragma once

#include <concino/core/eigenproblem.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/mesh/element_map.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace concino {

template<class M>
struct eigenfunctions_result {
  std::vector<double> values;                  // smallest first, in units of 1 / length^2
  std::vector<vert_map<M, double>> functions;  // the integral of the square of each is 1, of a product of two 0, with
                                               // respect to the mass
  std::vector<double> residuals;               // as those of eigenpairs
  std::size_t isolated = 0;                    // verts without polys, where functions are 0
  std::size_t iterations = 0;                  // as those of eigenpairs
  bool has_converged = true;                   // whether all residuals meet the tolerance
};

namespace core {

/// The functions on the verts of m whose values are the vectors of these pairs.
template<class M>
eigenfunctions_result<std::remove_cvref_t<M>> eigenfunctions_from(M&& m, const eigenpairs_result& pairs) {
  eigenfunctions_result<std::remove_cvref_t<M>> r;
  for (Eigen::Index i = 0; i < pairs.values.size(); ++i) {
    r.values.push_back(pairs.values[i]);
    r.residuals.push_back(pairs.residuals[i]);
    r.functions.push_back(make_vert_map<double>(m, 0.0));
    std::span<double> u = r.functions.back().values();
    for (std::size_t v = 0; v < u.size(); ++v) u[v] = pairs.vectors(static_cast<Eigen::Index>(v), i);
  }
  for (const vert_t<M> v : verts(m)) {
    bool has_poly = false;
    for ([[maybe_unused]] const poly_t<M> p : adj_v2p(m, v)) has_poly = true;
    r.isolated += !has_poly;
  }
  r.iterations = pairs.iterations;
  r.has_converged = pairs.has_converged;
  return r;
}

}  // namespace core

// What to write instead of calls that cannot compile.
template<class... T> void eigenfunctions(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void eigenfunctions(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void eigenfunctions(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: a point at each vert, or with_points(m, map)

}  // namespace concino
