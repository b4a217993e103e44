// The gradient of functions on verts, one vector per vert, as a sparse matrix.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/poly_chunks.hpp>
#include <concino/operators/detail/compressed_columns.hpp>
#include <concino/operators/simplex_gradients.hpp>

#include <algorithm>

namespace concino {

namespace detail {

/// The corners of all polys in the order of polys(m), and those at each vert.
struct corner_lists {
  struct corner_at {
    std::size_t poly, corner;
  };
  std::vector<std::size_t> first;     // of each poly: its first corner; one more at the end
  std::vector<std::size_t> vert;      // of each corner
  std::vector<vec3> gradient;         // of each corner, times the measure of the poly
  std::vector<std::size_t> first_at;  // of each vert: the begin of its corners; one more at the end
  std::vector<corner_at> around;

  template<class M>
  corner_lists(const char* caller, const M& m, std::vector<double>& size_around)
      : first{0}, first_at(vert_index_bound(m) + 1) {
    const core::poly_chunks<M> chunks(m, [&](const poly_t<M>& p) {
      for (const vert_t<M> v : adj_p2v(m, p)) {
        vert.push_back(index_of(m, v));
        ++first_at[vert.back() + 1];
      }
      const std::size_t n = vert.size() - first.back();
      first.push_back(vert.size());
      return n;
    });
    gradient.resize(vert.size());
    std::vector<double> size(vert.size());
    chunks.template for_each<poly_gradients<M>>([&](auto& local, const poly_t<M>& p, std::size_t corner) {
      local.visit(m, p);
      if (!local.has_gradients()) throw_no_measure(caller, m, p);
      const std::size_t n = local.verts.size();
      for (std::size_t i = 0; i < n; ++i) {
        size[corner + i] = std::abs(local.measure);
        gradient[corner + i] = size[corner + i] * local.gradient[i];
      }
      return n;
    });
    for (std::size_t v = 1; v < first_at.size(); ++v) first_at[v] += first_at[v - 1];
    around.resize(vert.size());
    size_around.assign(first_at.size() - 1, 0.0);
    std::vector<std::size_t> end(first_at);
    for (std::size_t k = 0; k + 1 < first.size(); ++k)
      for (std::size_t c = first[k]; c < first[k + 1]; ++c) {
        around[end[vert[c]]++] = {k, c};
        size_around[vert[c]] += size[c];
      }
  }
};

}  // namespace detail

/// The matrix whose rows 3v, 3v + 1, 3v + 2 give x, y and z of the gradient of u at vert v. That is the mean of the
/// gradients of the polys around it (see gradient_matrix), weighted by their areas or volumes.
/// Needs:  as gradient_matrix.
/// Result: 3 vert_index_bound(m) rows, vert_index_bound(m) columns, by index_of; an entry for every two verts of a
///         poly, rows sorted in each column; those of deleted verts and of verts of no poly are empty. Exact on linear
///         functions on planar surfaces and in volumes, at the boundary too. In units of 1 / length, scales exactly.
/// Cost:   O(sum of the squared numbers of verts of the polys) time and memory, in parallel; the same for any number of
///         threads.
/// Errors: as gradient_matrix.
/// Source: Mancinelli, Livesu, Puppo 2019, "A comparison of methods for gradient field estimation on simplicial meshes"
///         (AGS).
template<EmbeddedMesh M>
Eigen::SparseMatrix<double> vert_gradient_matrix(const M& m) {
  constexpr const char* caller = "vert_gradient_matrix";
  const std::size_t nv = vert_index_bound(m);
  auto g = detail::empty_columns(caller, 3 * nv, nv);
  std::vector<double> size_around;
  const detail::corner_lists lists(caller, m, size_around);
  int* const begin = g.outerIndexPtr();
  std::vector<std::size_t> seen_from(nv, nv);
  const auto for_each_around = [&](std::size_t v, const auto& f) {
    for (std::size_t i = lists.first_at[v]; i < lists.first_at[v + 1]; ++i) {
      const auto [poly, corner] = lists.around[i];
      for (std::size_t c = lists.first[poly]; c < lists.first[poly + 1]; ++c) f(lists.vert[c], corner);
    }
  };
  for (std::size_t v = 0; v < nv; ++v)
    for_each_around(v, [&](std::size_t w, std::size_t) {
      begin[v + 1] += seen_from[w] != v;
      seen_from[w] = v;
    });
  detail::make_room(caller, g, 3);

  // Column v: the contribution of v to the gradient of each poly around it is added to the rows of all verts of that
  // poly.
  struct contribution {
    std::size_t vert, corner;  // corners ascend with the polys, so the order of summation is fixed
    bool operator<(const contribution& o) const { return vert != o.vert ? vert < o.vert : corner < o.corner; }
  };
  constexpr std::size_t chunk = 512;
  parallel_for(
      nv / chunk + (nv % chunk != 0),
      [&](std::size_t c) {
        std::vector<contribution> contributions;
        for (std::size_t v = c * chunk; v < std::min(nv, (c + 1) * chunk); ++v) {
          contributions.clear();
          for_each_around(v, [&](std::size_t w, std::size_t corner) { contributions.push_back({w, corner}); });
          std::sort(contributions.begin(), contributions.end());
          int at = begin[v];
          for (std::size_t i = 0; i < contributions.size();) {
            const std::size_t w = contributions[i].vert;
            vec3 sum;
            for (; i < contributions.size() && contributions[i].vert == w; ++i)
              sum += lists.gradient[contributions[i].corner];
            sum /= size_around[w];
            for (std::size_t k = 0; k < 3; ++k, ++at) {
              g.innerIndexPtr()[at] = static_cast<int>(3 * w + k);
              g.valuePtr()[at] = sum[k];
            }
          }
        }
      },
      1);
  return g;
}

// What to write instead of calls that cannot compile.
template<class... T> void vert_gradient_matrix(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void vert_gradient_matrix(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
