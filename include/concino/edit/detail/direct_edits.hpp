// Which operators a mesh does itself; see concepts/editable.hpp.
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/concepts/mesh_traits.hpp>

#include <concepts>
#include <optional>

namespace concino::detail {

template<class M> concept splits_edges = requires(M& m, edge_t<M> e, const vec3& x) {
  { traits<M>::split_edge(m, e, x) } -> std::same_as<std::optional<vert_t<M>>>;
};
template<class M> concept flips_edges = requires(M& m, edge_t<M> e) {
  { traits<M>::flip_edge(m, e) } -> std::same_as<bool>;
};
template<class M> concept collapses_edges = requires(M& m, edge_t<M> e, const vec3& x) {
  { traits<M>::collapse_edge(m, e, x) } -> std::same_as<bool>;
};

/// The point (1 - t) a + t b of the edge between a and b; its ends to the bit for 0 and 1.
inline vec3 point_between(const vec3& a, const vec3& b, double t) {
  if (t == 0) return a;
  return t == 1 ? b : (1 - t) * a + t * b;
}

}  // namespace concino::detail
