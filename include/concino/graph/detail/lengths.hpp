// Lengths of arcs for shortest paths: from the caller's function, or Euclidean distances between verts or between
// polys' centres.
#pragma once

#include <concino/core/flat_array.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/graph/detail/crossings.hpp>

#include <limits>
#include <vector>

namespace concino::detail {

/// from(v)(w, gap) is the length of the arc v -> w. If the length is known to be at least gap, it may be +inf instead:
/// a longer step would not improve anything.
template<class L>
struct input_lengths {
  const L& length;

  template<class Node>
  auto from(const Node& v) const {
    return [this, v](const Node& w, double) { return static_cast<double>(length(v, w)); };
  }
};

/// The distance of a and b, or +inf if it is certainly at least gap. Comparing squares first avoids most square roots;
/// the margin makes the result identical to the last bit to that without the comparison.
inline double distance_below(const vec3& a, const vec3& b, double gap) {
  const vec3 step = a - b;
  if (dot(step, step) > gap * gap * (1 + 4e-15) + 1e-290) return std::numeric_limits<double>::infinity();
  return norm(step);
}

/// Distances between verts. A neighbour that is as near as v itself cannot improve, so its coordinates are not read. If
/// they are not numbers, the step from that neighbour to v has reported it before.
template<Embedded M>
struct euclidean_vert_lengths {
  const M& m;

  auto from(const vert_t<M>& v) const {
    return [this, p = to_vec3(point(m, v))](const vert_t<M>& w, double gap) {
      if (gap <= 0) return std::numeric_limits<double>::infinity();
      return distance_below(p, to_vec3(point(m, w)), gap);
    };
  }
};

/// Distances between the centres of polys, each computed once.
template<EmbeddedMesh M>
class euclidean_poly_lengths {
  const M& m_;
  core::flat_array<vec3> centres_;

 public:
  explicit euclidean_poly_lengths(const M& m) : m_(m), centres_(poly_index_bound(m)) {
    for (const poly_t<M> p : polys(m)) centres_[index_of(m, p)] = vert_mean(m, p);
  }

  auto from(const poly_t<M>& p) const {
    return [this, c = centres_[index_of(m_, p)]](const poly_t<M>& q, double gap) {
      if (gap <= 0) return std::numeric_limits<double>::infinity();
      return distance_below(c, centres_[index_of(m_, q)], gap);
    };
  }
};

template<class M>
  requires Embedded<M>
auto default_lengths(const primal_graph<M>& g) { return euclidean_vert_lengths<M>{g.m}; }

template<class M>
  requires EmbeddedMesh<base_mesh_t<M>>
auto default_lengths(const dual_graph<M>& g) { return euclidean_poly_lengths<base_mesh_t<M>>(base_mesh(g.m)); }

}  // namespace concino::detail

namespace concino::requirement {

/// The graph selected by S has coordinates for lengths: of verts, or of the verts of polys.
template<class M, class S>
concept has_lengths = is_source<M, S> && Embedded<concino::detail::base_mesh_t<std::remove_cvref_t<M>>> &&
    (AnyMesh<concino::detail::base_mesh_t<std::remove_cvref_t<M>>> ||
     is_no_poly_type<M, concino::detail::source_element<M, S>>);

/// A function that returns the length of the arc from one node to another.
template<class L, class N> concept is_length = requires(const L& length, const N& v) {
  static_cast<double>(length(v, v));
};

}  // namespace concino::requirement
