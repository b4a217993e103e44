// The stiffness matrix of one polygon after de Goes, Butts and Desbrun.
#pragma once

#include <concino/operators/corner_gradients.hpp>
#include <concino/operators/discretisation.hpp>

#include <cstddef>
#include <vector>

namespace concino::detail {

/// Fills in the positive semidefinite matrix K of one polygon: |p| G^T G + R^T R. G is the mean gradient. R u is the
/// difference of u along each edge minus the difference predicted by the mean gradient (their stabilisation with lambda
/// = 1). On triangles R is 0.
/// Needs:  Embedded SurfaceMesh.      Cost: O(n^2) for n verts; allocates only for the largest poly.
/// Errors: invalid_mesh if the polygon has no area or a point is not finite.
/// Source: de Goes, Butts, Desbrun 2020, "Discrete differential operators on polygonal meshes".
template<SurfaceMesh M>
  requires Embedded<M>
class de_goes_element {
  const M& m_;
  corner_gradients<M> corners_;
  std::vector<vec3> bend_;   // of each vert: the incoming edge minus the outgoing edge, along the polygon
  std::vector<vec3> other_;  // the factor of the other vert's gradient, see below

 public:
  explicit de_goes_element(const M& m) : m_(m) {}

  void operator()(const poly_t<M>& p, local_matrix<vert_t<M>>& out) {
    corners_.visit(m_, p);
    if (!corners_.has_gradients()) throw_no_measure("Laplacian of de Goes", m_, p);
    out.verts = corners_.verts;
    const std::vector<vec3>& g = corners_.gradient;
    const std::size_t n = g.size();
    out.entries.resize(n * (n + 1) / 2);
    // R = D - E G, with D the differences along edges and the rows of E the edges projected to the plane of the
    // polygon. So R^T R is D^T D - H^T G - G^T H + G^T E^T E G, where the columns h of H = E^T D are the bends. With
    // |p| G^T G the total is D^T D - H^T G + G^T Q, where the columns of Q are |p| g + E^T E g - h.
    other_.assign(n, vec3{});
    bend_.assign(n, vec3{});
    if (n > 3) {
      const vec3 normal = corners_.normal / corners_.measure;
      vec3 square[3];  // rows of E^T E
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = i + 1 < n ? i + 1 : 0;
        vec3 edge = corners_.points[next] - corners_.points[i];
        edge -= dot(edge, normal) * normal;
        bend_[i] -= edge;
        bend_[next] += edge;
        for (std::size_t k = 0; k < 3; ++k) square[k] += edge[k] * edge;
      }
      for (std::size_t i = 0; i < n; ++i)
        other_[i] = vec3{dot(square[0], g[i]), dot(square[1], g[i]), dot(square[2], g[i])} - bend_[i];
    }
    for (std::size_t i = 0; i < n; ++i) other_[i] += corners_.measure * g[i];
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j <= i; ++j) out.at(i, j) = dot(g[i], other_[j]) - dot(bend_[i], g[j]);
    if (n == 3) return;
    for (std::size_t i = 0; i < n; ++i) {
      out.at(i, i) += 2;
      const std::size_t next = i + 1 < n ? i + 1 : 0;
      out.at(i > next ? i : next, i > next ? next : i) -= 1;
    }
  }
};

}  // namespace concino::detail
