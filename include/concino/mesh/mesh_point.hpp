// Points on a mesh: on an edge, or on any element, with their coordinates.
#pragma once

#include <concino/concepts/mesh_traits.hpp>
#include <concino/core/vec3.hpp>

#include <variant>

namespace concino {

/// A point on an edge. parameter: in [0, 1], 0 at the first vert of adj_e2v, 1 at the second.
template<class M>
struct edge_point {
  edge_t<M> edge;
  double parameter;
};

namespace detail {

template<class M>
struct point_elements {
  using type = std::variant<vert_t<M>, edge_point<M>, poly_t<M>>;
};
template<class M>
  requires requires { typename face_t<M>; }
struct point_elements<M> {
  using type = std::variant<vert_t<M>, edge_point<M>, face_t<M>, poly_t<M>>;
};

}  // namespace detail

/// A point on a surface or in a volume: at a vert, on an edge, inside a face of a volume, or inside a poly, with its
/// coordinates.
template<class M>
struct mesh_point {
  typename detail::point_elements<M>::type element;
  vec3 position;
};

}  // namespace concino
