// Cotangent weights: one number per edge, summed over the triangles or tets at it.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/vec3.hpp>
#include <concino/operators/detail/simplex_weights.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace concino::detail {

/// The weights of an EmbeddedMesh of triangles or tets, as a map over edges.
template<EmbeddedMesh M>
class cotangent_weights {
  static constexpr int dimension = dimension_v<M>;
  static constexpr std::size_t corners = static_cast<std::size_t>(dimension) + 1;
  static constexpr std::size_t edges_per_poly = dimension == 2 ? 3 : 6;
  // The usual order of edges in a poly. Polyhedra may have any order; this one is tried first.
  static constexpr std::size_t likely_ends[2][6][2] = {{{0, 1}, {1, 2}, {2, 0}},
                                                       {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

  const M& m_;
  const char* caller_;
  std::vector<double> weight_;

  /// Whether {a, b} equals {c, d} as a set. Has no branches, because they would be mispredicted.
  static bool are(const vert_t<M>& a, const vert_t<M>& b, const vert_t<M>& c, const vert_t<M>& d) {
    return ((int{a == c} & int{b == d}) | (int{a == d} & int{b == c})) != 0;
  }
  static double searched(const std::array<vert_t<M>, corners>& corner, const simplex_weights<dimension>& weight,
                         const vert_t<M>& a, const vert_t<M>& b) {
    std::size_t i = 0, j = 0;
    for (std::size_t k = 0; k < corners; ++k) {
      if (corner[k] == a) i = k;
      if (corner[k] == b) j = k;
    }
    return weight(i, j);
  }

  [[noreturn, gnu::noinline, gnu::cold]] void throw_no_simplex(const poly_t<M>& p, std::size_t n) const {
    core::throw_joined<unsupported>({caller_, ": poly ", index_of(m_, p), " has ", n, " verts and is not a ",
                                     dimension == 2 ? "triangle" : "tet",
                                     "; use virtual_elements or uniform, or split the polys"});
  }
  [[noreturn, gnu::noinline, gnu::cold]] void throw_degenerate(const poly_t<M>& p) const {
    core::throw_joined<invalid_mesh>(
        {caller_, ": poly ", index_of(m_, p),
         " is degenerate: it has no area or volume, or points that are not finite, so its angles have no cotangents; remove it, move "
         "its verts or use uniform"});
  }

  void add(const poly_t<M>& p) {
    std::array<vert_t<M>, corners> corner;
    std::array<vec3, corners> points;
    std::size_t n = 0;
    for (const vert_t<M> v : adj_p2v(m_, p)) {
      if (n < corners) {
        corner[n] = v;
        points[n] = to_vec3(point(m_, v));
      }
      ++n;
    }
    if (n != corners) throw_no_simplex(p, n);
    const simplex_weights<dimension> weight(points);
    double sum = 0;
    const auto& edge_list = adj_p2e(m_, p);
    auto it = edge_list.begin();
    for (std::size_t k = 0; k < edges_per_poly; ++k, ++it) {
      const edge_t<M> e = *it;
      const auto [i, j] = likely_ends[dimension - 2][k];
      double w = weight(i, j);
      if constexpr (VolumeMesh<M> && !TetMesh<M>) {  // the edges of polyhedra come in any order
        const auto [a, b] = end_verts(m_, e);
        if (!are(a, b, corner[i], corner[j])) w = searched(corner, weight, a, b);
      }
      sum += w;
      weight_[index_of(m_, e)] += w;
    }
    if (!std::isfinite(sum)) throw_degenerate(p);
  }

 public:
  /// Errors: unsupported if some poly is no triangle or tet, invalid_mesh if it is degenerate; messages begin with
  ///         `caller`.
  cotangent_weights(const M& m, const char* caller) : m_(m), caller_(caller), weight_(edge_index_bound(m)) {
    for (const poly_t<M> p : polys(m)) add(p);
  }

  double operator[](const edge_t<M>& e) const { return weight_[index_of(m_, e)]; }
};

}  // namespace concino::detail
