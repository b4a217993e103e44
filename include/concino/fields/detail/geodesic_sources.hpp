// What distances are asked from: verts, or pairs of a vert and a number.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/graph/detail/graph_of.hpp>

namespace concino::detail {

template<class M, class S> concept gives_distances = any_range<S> && requires(const S& s) {
  static_cast<vert_t<M>>((*s.begin()).first);
  static_cast<double>((*s.begin()).second);
};
template<class M, class S> concept gives_verts = !gives_distances<M, S> && names_vert<M, vert_t<M>> && becomes_vert<M, source_element<M, S>>;

}  // namespace concino::detail
