// The gradient of a function with values at the verts of one polygon or polyhedron: one vector for each vert. The
// gradient matrix, the Laplacian and the masses are assembled from these vectors.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/number_in_messages.hpp>
#include <concino/geometry/measure.hpp>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino {

namespace detail {

template<class M>
[[noreturn, gnu::noinline, gnu::cold]] void throw_no_measure(const char* caller, const M& m, const poly_t<M>& p) {
  core::throw_joined<invalid_mesh>(
      {caller, ": poly ", core::number_in_messages(m, p), dimension_v<M> == 2 ? " has no area" : " has no volume",
       ", or points that are not finite, so functions on it have no gradient; remove it or move its verts"});
}

/// Integrates the hat functions times `sign` times the normal over a face, and calls share(i, integral) for each vert
/// i. The face is a fan of triangles about the mean point of its verts. Functions are linear on each triangle, with the
/// mean value at the mean point. around: the verts minus that point.
/// Result: the sum of the integrals, `sign` times the vector area. Linear functions are integrated exactly.
template<class F>
vec3 integrate_fan(const std::vector<vec3>& around, double sign, F&& share) {
  const std::size_t n = around.size();
  vec3 area;
  for (std::size_t i = 0; i < n; ++i) area += cross(around[i], around[i + 1 < n ? i + 1 : 0]);
  area *= 0.5 * sign;
  const vec3 middle = area / (3 * static_cast<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const vec3 diagonal = around[i + 1 < n ? i + 1 : 0] - around[i > 0 ? i - 1 : n - 1];
    share(i, (sign / 6) * cross(around[i], diagonal) + middle);
  }
  return area;
}

}  // namespace detail

/// The gradients on a poly as arrays, independent of the mesh type.
struct corner_gradient_arrays {
  std::vector<vec3> points;    // of each vert, relative to the mean of the verts
  std::vector<vec3> gradient;  // of each vert; not finite where the poly has no measure
  vec3 mean;                   // of the verts
  vec3 normal;                 // of a polygon: its vector area
  double measure = 0;          // area, or volume: negative for an inverted poly

  /// Whether the poly visited last has a measure and finite points. There is no tolerance: the thinnest poly has
  /// gradients.
  bool has_gradients() const;

 protected:
  /// Makes the points relative to their mean.
  void centre();
  void visit_polygon();
};

/// The verts of a poly and, for each, the vector g_i such that the mean gradient of u over the poly is the sum of u_i
/// g_i. One object serves for many polys, so that nothing is allocated for each.
///
/// Polygons: the integral of u times the outward normal along the edges, divided by the area. u is linear on each edge;
/// g_i is normal to the vector area. Polyhedra: the integral of u n over the faces, divided by the volume. Each face is
/// a fan of linear triangles about its mean point, with the mean value. These are the faces that `volume` uses, so
/// linear functions have their exact gradient whether faces are planar or not.
template<EmbeddedMesh M>
struct corner_gradients : corner_gradient_arrays {
  std::vector<vert_t<M>> verts;

  void visit(const M& m, const poly_t<M>& p) {
    verts.clear();
    points.clear();
    for (const vert_t<M> v : adj_p2v(m, p)) {
      verts.push_back(v);
      points.push_back(to_vec3(point(m, v)));
    }
    centre();
    if constexpr (SurfaceMesh<M>) {  // integrates along edges of a polygon, or over the triangles of faces
      visit_polygon();
    } else {
      gradient.assign(verts.size(), vec3{});
      measure = 0;
      sort_many(m);
      for (const face_t<M> f : adj_p2f(m, p)) add_face(m, f, face_is_outward(m, p, f) ? 1.0 : -1.0);
      measure /= 3;
      for (vec3& g : gradient) g = g / measure;
    }
  }

 private:
  std::vector<std::size_t> corner_;  // of one face: the positions of its verts in `verts`
  std::vector<vec3> around_;         // of one face: its verts relative to its mean point
  std::vector<std::uint64_t> sorted_;  // of polys of many verts: index in the mesh, then the position in 32 bits,
                                       // sorted

  /// The position of v in `verts`: by linear search, or by its index in polys of many verts.
  std::size_t corner_of(const M& m, const vert_t<M>& v) const {
    std::size_t i = 0;
    if (sorted_.empty()) {
      while (i < verts.size() && !(verts[i] == v)) ++i;
    } else {
      const std::uint64_t* const first = sorted_.data();
      i = static_cast<std::uint32_t>(
          *std::lower_bound(first, first + sorted_.size(), static_cast<std::uint64_t>(index_of(m, v)) << 32));
    }
    assert(i < verts.size() && "the verts of a poly are those of its faces");
    return i;
  }
  void sort_many(const M& m) {
    sorted_.clear();
    if (verts.size() <= 32) return;
    for (std::size_t i = 0; i < verts.size(); ++i)
      sorted_.push_back(static_cast<std::uint64_t>(index_of(m, verts[i])) << 32 | i);
    std::sort(sorted_.begin(), sorted_.end());
  }

  template<class Face>
  void add_face(const M& m, const Face& f, double sign) {
    corner_.clear();
    around_.clear();
    vec3 sum;
    for (const vert_t<M> v : adj_f2v(m, f)) {
      const std::size_t i = corner_of(m, v);
      corner_.push_back(i);
      around_.push_back(points[i]);
      sum += points[i];
    }
    const std::size_t n = corner_.size();
    if (n == 0) return;
    const vec3 c = sum / static_cast<double>(n);
    for (vec3& x : around_) x -= c;
    measure += dot(c, detail::integrate_fan(around_, sign,
                                            [&](std::size_t i, const vec3& share) { gradient[corner_[i]] += share; }));
  }
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/operators/detail/corner_gradients.ipp>
#endif
