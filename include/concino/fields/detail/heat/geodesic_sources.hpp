// The sources of distance queries: verts, or pairs of a vert and a number.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/iterable.hpp>
#include <concino/core/message.hpp>

#include <cmath>
#include <concepts>
#include <type_traits>
#include <utility>

namespace concino::detail {

template<class S> using source_value_t = std::remove_cvref_t<decltype(*std::declval<const S&>().begin())>;

template<class M, class S> concept gives_distances = core::iterable<S> && requires(const S& s) {
  static_cast<vert_t<M>>((*s.begin()).first);
  static_cast<double>((*s.begin()).second);
};
/// A vert (even if its type is a range), or several.
template<class M, class S>
concept gives_one_vert = std::same_as<S, vert_t<M>> ||(!core::iterable<S> && std::convertible_to<S, vert_t<M>>);
template<class M, class S>
concept gives_some_verts = core::iterable<S> && !std::same_as<S, vert_t<M>> && !std::same_as<S, poly_t<M>> &&
                           std::convertible_to<source_value_t<S>, vert_t<M>>;
template<class M, class S>
concept gives_verts = PrimalGraph<M> && !gives_distances<M, S> && (gives_one_vert<M, S> || gives_some_verts<M, S>);

/// Calls add(vert, distance) for one vert, for each of several, or for each pair of a vert and a number.
template<class M, class S, class F>
void for_each_distance_source(const S& sources, F&& add) {
  if constexpr (gives_distances<M, S>) {
    for (const auto& [v, d] : sources) add(static_cast<vert_t<M>>(v), static_cast<double>(d));
  } else if constexpr (gives_some_verts<M, S>) {
    for (const auto& v : sources) add(static_cast<vert_t<M>>(v), 0.0);
  } else {
    add(static_cast<vert_t<M>>(sources), 0.0);
  }
}

/// number(): that of v in messages.
/// Errors: as heat_geodesics.
template<class M, class Number>
void check_distance_source(const M& m, const vert_t<M>& v, double distance, const Number& number) {
  if (!contains(m, v))
    throw invalid_mesh("heat_geodesics: a source is not a vert of the mesh; take it from verts(m)");
  if (!std::isfinite(distance))
    core::throw_joined<invalid_argument>({"heat_geodesics: the initial distance at vert ", number(), " is not finite"});
}
inline void check_has_source(bool has_source) {
  if (!has_source) throw invalid_argument("heat_geodesics: there is no source; give at least one vert");
}

}  // namespace concino::detail
