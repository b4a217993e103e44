// The gradient of functions on verts, one vector per poly, as a sparse matrix.
#pragma once

#include <concino/core/assembly.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/poly_chunks.hpp>
#include <concino/operators/detail/compressed_columns.hpp>
#include <concino/operators/simplex_gradients.hpp>

namespace concino {

/// The gradient matrix G. Rows 3p, 3p + 1, 3p + 2 of G u are x, y and z of the mean gradient over poly p of the
/// function with values u at the verts. That is the integral of u times the outward normal over the boundary of p,
/// divided by its area or volume. Along edges u is linear; faces of volumes are fans of triangles about their mean
/// point, where u has the mean value.
/// Needs:  EmbeddedMesh; the faces of each polyhedron are closed.
/// Result: 3 poly_index_bound(m) rows, vert_index_bound(m) columns, by index_of; an entry for every vert of every poly,
///         rows sorted in each column; those of deleted elements and of verts of no poly are empty. For linear
///         functions a . x the rows of a poly give exactly a. On surfaces a loses its component along the vector area
///         of the poly. Polys need not be planar or convex. Constants have gradient 0 up to rounding errors. In units
///         of 1 / length, scales exactly. Inverted polyhedra have the same gradients.
/// Cost:   O(size of the polys) time and memory, in parallel; the same for any number of threads.
/// Errors: invalid_mesh, naming a poly without area or volume or with points that are not finite; unsupported if the
///         matrix would be too large for 32-bit indices.
/// Source: Green-Gauss; on triangles and tets the gradient of piecewise linear functions; paper section 2.2.
template<EmbeddedMesh M>
Eigen::SparseMatrix<double> gradient_matrix(const M& m) {
  constexpr const char* caller = "gradient_matrix";
  auto g = detail::empty_columns(caller, 3 * poly_index_bound(m), vert_index_bound(m));
  int* const begin = g.outerIndexPtr();
  std::vector<int> earlier_polys;  // of each corner: the number of earlier polys at its vert
  // the number of corners is known
  if constexpr (arity_v<M> > 0) earlier_polys.reserve(static_cast<std::size_t>(arity_v<M>) * num_polys(m));
  bool ascend = true;
  std::size_t next = 0;
  const core::poly_chunks<M> chunks(m, [&](const poly_t<M>& p) {
    const std::size_t index = index_of(m, p), before = earlier_polys.size();
    ascend = ascend && index >= next;
    next = index + 1;
    for (const vert_t<M> v : adj_p2v(m, p)) earlier_polys.push_back(begin[index_of(m, v) + 1]++);
    return earlier_polys.size() - before;
  });
  detail::make_room(caller, g, 3);
  int* const rows = g.innerIndexPtr();
  double* const values = g.valuePtr();
  chunks.template for_each<poly_gradients<M>>([&](auto& local, const poly_t<M>& p, std::size_t corner) {
    local.visit(m, p);
    if (!local.has_gradients()) detail::throw_no_measure(caller, m, p);
    const int row = 3 * static_cast<int>(index_of(m, p));
    const std::size_t n = local.verts.size();
    for (std::size_t i = 0; i < n; ++i) {
      const int at = begin[index_of(m, local.verts[i])] + 3 * earlier_polys[corner + i];
      const vec3 gradient = local.gradient[i];
      rows[at] = row;
      rows[at + 1] = row + 1;
      rows[at + 2] = row + 2;
      values[at] = gradient.x;
      values[at + 1] = gradient.y;
      values[at + 2] = gradient.z;
    }
    return n;
  });
  if (!ascend)
    for (Eigen::Index c = 0; c < g.cols(); ++c)
      core::sort_column(rows + begin[c], values + begin[c], static_cast<std::size_t>(begin[c + 1] - begin[c]));
  return g;
}

// What to write instead of calls that cannot compile.
template<class... T> void gradient_matrix(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void gradient_matrix(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
