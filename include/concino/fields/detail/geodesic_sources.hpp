// What distances are asked from: verts, or pairs of a vert and a number.
#pragma once

#include <concino/concepts/mesh.hpp>

#include <concepts>
#include <type_traits>
#include <utility>

namespace concino::detail {

template<class S> concept holds_sources = requires(const S& s) { s.begin(); s.end(); *s.begin(); };
template<class S> using held_source = std::remove_cvref_t<decltype(*std::declval<const S&>().begin())>;

template<class M, class S> concept gives_distances = holds_sources<S> && requires(const S& s) {
  static_cast<vert_t<M>>((*s.begin()).first);
  static_cast<double>((*s.begin()).second);
};
/// A vert, be that something that can be walked itself, or several.
template<class M, class S> concept gives_one_vert = std::same_as<S, vert_t<M>> || (!holds_sources<S> && std::convertible_to<S, vert_t<M>>);
template<class M, class S>
concept gives_some_verts = holds_sources<S> && !std::same_as<S, vert_t<M>> && !std::same_as<S, poly_t<M>> && std::convertible_to<held_source<S>, vert_t<M>>;
template<class M, class S> concept gives_verts = PrimalGraph<M> && !gives_distances<M, S> && (gives_one_vert<M, S> || gives_some_verts<M, S>);

/// Calls add(vert, distance) for one vert, for each of several, or for each pair of a vert and a number.
template<class M, class S, class F>
void for_each_source(const S& sources, F&& add) {
  if constexpr (gives_distances<M, S>) {
    for (const auto& [v, d] : sources) add(static_cast<vert_t<M>>(v), static_cast<double>(d));
  } else if constexpr (gives_some_verts<M, S>) {
    for (const auto& v : sources) add(static_cast<vert_t<M>>(v), 0.0);
  } else {
    add(static_cast<vert_t<M>>(sources), 0.0);
  }
}

}  // namespace concino::detail
