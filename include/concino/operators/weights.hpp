// Which numbers stand on the edges of a Laplacian, and how they are computed.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/concepts/primal_graph.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/vec3.hpp>
#include <concino/operators/detail/de_goes.hpp>
#include <concino/operators/detail/simplex_weights.hpp>
#include <concino/operators/detail/virtual_elements.hpp>
#include <concino/operators/detail/virtual_refinement.hpp>

#include <Eigen/SparseCore>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace concino {

/// standard:           virtual elements of order 1: right on every polygon and polyhedron, concave and non-planar ones too; on triangles
///                     and tets the same as cotangent. On a mere graph, which has no polys or points, the same as uniform.
/// uniform:            1 on every edge; any graph.
/// cotangent:          minus the measure of each triangle or tet times the scalar product of the gradients of the hat functions of the edge's
///                     ends, summed: half the cotangents of the angles opposite the edge on surfaces, a sixth of the lengths of the
///                     opposite edges times the cotangents of the dihedral angles there in volumes. Negative weights are kept: they are
///                     what makes linear functions harmonic. Polys must be triangles or tets.
/// virtual_refinement: cotangents of the triangles or tets about one virtual point for each poly (and face), which is then eliminated. For comparison;
///                     polys must be star-shaped about that point.
/// de_goes:            the Laplacian of de Goes, Butts and Desbrun for polygons. For comparison; surfaces only.
enum class weights { standard, uniform, cotangent, virtual_refinement, de_goes };

namespace detail {

/// 1 on every edge.
template<PrimalGraph M>
struct uniform_weights {
  const M& m;

  int num_neighbours(const vert_t<M>& v) const {
    int n = 0;
    for ([[maybe_unused]] const vert_t<M> w : adj_v2v(m, v)) ++n;
    return n;
  }
  template<class F>
  void for_each_neighbour(const vert_t<M>& v, F&& f) const {
    for (const vert_t<M> w : adj_v2v(m, v)) f(w, 1.0);
  }
};

/// One number per edge, summed over the polys at it.
template<AnyMesh M>
  requires Embedded<M>
class cotangent_weights {
  static constexpr int dimension = dimension_v<M>;
  static constexpr std::size_t corners = static_cast<std::size_t>(dimension) + 1;
  static constexpr std::size_t sides = dimension == 2 ? 3 : 6;
  // The order that a type may promise; where it does not, the first to try.
  static constexpr std::size_t likely_ends[2][6][2] = {{{0, 1}, {1, 2}, {2, 0}}, {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

  const M& m_;
  const char* who_;
  std::vector<double> weight_;

  /// Whether a and b are c and d, in this order or the other: not a matter for branches, which would be missed.
  static bool are(const vert_t<M>& a, const vert_t<M>& b, const vert_t<M>& c, const vert_t<M>& d) {
    return ((int{a == c} & int{b == d}) | (int{a == d} & int{b == c})) != 0;
  }
  [[gnu::noinline]] static double searched(std::array<vert_t<M>, corners> corner, simplex_weights<dimension> weight, const vert_t<M>& a,
                                           const vert_t<M>& b) {
    std::size_t i = 0, j = 0;
    for (std::size_t k = 0; k < corners; ++k) {
      if (corner[k] == a) i = k;
      if (corner[k] == b) j = k;
    }
    return weight(i, j);
  }

  std::pair<vert_t<M>, vert_t<M>> ends(const edge_t<M>& e) const {
    const auto& two = adj_e2v(m_, e);
    auto it = two.begin();
    const vert_t<M> first = *it;
    ++it;
    return {first, *it};
  }

  [[noreturn, gnu::noinline, gnu::cold]] void throw_no_simplex(const poly_t<M>& p, std::size_t n) const {
    core::throw_joined<unsupported>({who_, ": poly ", index_of(m_, p), " has ", n, " verts and is no ",
                               dimension == 2 ? "triangle" : "tet", "; use standard or uniform weights, or split the polys"});
  }
  [[noreturn, gnu::noinline, gnu::cold]] void throw_degenerate(const poly_t<M>& p) const {
    core::throw_joined<invalid_mesh>({who_, ": poly ", index_of(m_, p),
                                " is degenerate: it has no area or volume, or points that are not finite, so its angles have no cotangents; remove it, move "
                                "its verts or use uniform weights"});
  }

  void add(const poly_t<M>& p) {
    std::array<vert_t<M>, corners> corner;
    std::array<vec3, corners> place;
    std::size_t n = 0;
    for (const vert_t<M> v : adj_p2v(m_, p)) {
      if (n < corners) {
        corner[n] = v;
        place[n] = to_vec3(point(m_, v));
      }
      ++n;
    }
    if (n != corners) throw_no_simplex(p, n);
    const simplex_weights<dimension> weight(place);
    double sum = 0;
    const auto& edge_list = adj_p2e(m_, p);
    auto it = edge_list.begin();
    for (std::size_t k = 0; k < sides; ++k, ++it) {
      const edge_t<M> e = *it;
      const auto [i, j] = likely_ends[dimension - 2][k];
      double w = weight(i, j);
      if constexpr (!requirement::promises_edges_in_order<M>) {
        const auto [a, b] = ends(e);
        const std::size_t before = (k + 2) % 3;  // where half-edges name their targets, the last edge comes first
        if (!are(a, b, corner[i], corner[j]))
          w = dimension == 2 && are(a, b, corner[before], corner[k]) ? weight(before, k) : searched(corner, weight, a, b);
      }
      sum += w;
      weight_[index_of(m_, e)] += w;
    }
    if (!std::isfinite(sum)) throw_degenerate(p);
  }

 public:
  /// Errors: unsupported if some poly is no triangle or tet, invalid_mesh if it is degenerate; messages begin with `who`.
  cotangent_weights(const M& m, const char* who) : m_(m), who_(who), weight_(edge_index_bound(m)) {
    for (const poly_t<M> p : polys(m)) add(p);
  }

  int num_neighbours(const vert_t<M>& v) const {
    int n = 0;
    for ([[maybe_unused]] const edge_t<M> e : adj_v2e(m_, v)) ++n;
    return n;
  }
  template<class F>
  void for_each_neighbour(const vert_t<M>& v, F&& f) const {
    for (const edge_t<M> e : adj_v2e(m_, v)) {
      const auto [a, b] = ends(e);
      f(a == v ? b : a, weight_[index_of(m_, e)]);
    }
  }
};

/// Calls on_edges with the weights that were asked for, or on_polys(make) with what makes the matrices of polys.
/// Errors: unsupported where M has no such weights; invalid_mesh and unsupported from cotangent_weights.
template<PrimalGraph M, class OnEdges, class OnPolys>
Eigen::SparseMatrix<double> with_weights(const M& m, weights which, const OnEdges& on_edges, const OnPolys& on_polys) {
  if constexpr (AnyMesh<M> && Embedded<M>) {
    constexpr bool has_simplices = TriMesh<M> || TetMesh<M>;
    if (which == weights::de_goes && VolumeMesh<M>)
      throw unsupported("weights of de Goes, Butts and Desbrun: they are for surfaces; use standard weights");
    if (which == weights::cotangent || (has_simplices && which != weights::uniform))
      return on_edges(cotangent_weights<M>(m, which == weights::standard ? "standard weights" : "cotangent weights"));
    if constexpr (!has_simplices) {
      if (which == weights::standard) return on_polys(&poly_operator_of<virtual_stiffness<M>, M>);
      if (which == weights::virtual_refinement) return on_polys(&poly_operator_of<virtual_refinement_element<M>, M>);
      if constexpr (SurfaceMesh<M>)
        if (which == weights::de_goes) return on_polys(&poly_operator_of<de_goes_element<M>, M>);
    }
  } else if (which != weights::uniform && which != weights::standard) {
    throw unsupported(which == weights::cotangent ? "cotangent weights: the mesh type is a graph without polys or points; use uniform weights"
                                                  : "weights: the mesh type is a graph without polys or points; use uniform weights");
  }
  return on_edges(uniform_weights<M>{m});
}

}  // namespace detail

}  // namespace concino
