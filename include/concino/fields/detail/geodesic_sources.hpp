// What distances are asked from: verts, or pairs of a vert and a number.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/graph/detail/graph_of.hpp>

#include <concepts>

namespace concino::detail {

template<class M, class S> concept gives_distances = any_range<S> && requires(const S& s) {
  static_cast<vert_t<M>>((*s.begin()).first);
  static_cast<double>((*s.begin()).second);
};
template<class M, class S> concept gives_verts = !gives_distances<M, S> && names_vert<M, vert_t<M>> && becomes_vert<M, source_element<M, S>>;

/// Calls add(vert, distance) for one vert, for each of several, or for each pair of a vert and a number.
template<class M, class S, class F>
void for_each_source(const S& sources, F&& add) {
  if constexpr (gives_distances<M, S>) {
    for (const auto& [v, d] : sources) add(static_cast<vert_t<M>>(v), static_cast<double>(d));
  } else if constexpr (any_range<S> && !std::same_as<S, vert_t<M>>) {
    for (const auto& v : sources) add(static_cast<vert_t<M>>(v), 0.0);
  } else {
    add(static_cast<vert_t<M>>(sources), 0.0);
  }
}

}  // namespace concino::detail
