// Values of fields at verts: numbers or vectors, from maps, from functions of points, or from containers of pairs.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/core/iterable.hpp>
#include <concino/core/vec3.hpp>

#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace concino::requirement {

/// F has a number or a point for each vert of M: a map f[v], or a function f(x) of the point of the vert, a vec3.
template<class F, class M>
concept is_function_of_points = Embedded<M> &&(
    requires(const std::remove_cvref_t<F>& f, const vec3& x) {
      { f(x) } -> std::convertible_to<double>;
    } ||
    requires(const std::remove_cvref_t<F>& f, const vec3& x) {
      { f(x)[2] } -> std::convertible_to<double>;
    });
template<class F, class M>
concept is_given_field = gives_numbers_or_points<F, vert_t<M>> || is_function_of_points<F, M>;

}  // namespace concino::requirement

namespace concino::detail {

/// A value of a field at a vert: a number, or a vector, which is solved for component by component with one
/// factorisation.
template<class T>
concept field_value = std::same_as<T, double> || std::same_as<T, vec3>;

template<field_value T>
inline constexpr std::size_t component_count = std::same_as<T, double> ? 1 : 3;
inline double& field_component(double& x, std::size_t) { return x; }
inline double field_component(const double& x, std::size_t) { return x; }
inline double& field_component(vec3& x, std::size_t k) { return x[k]; }
inline double field_component(const vec3& x, std::size_t k) { return x[k]; }

template<field_value T, class X>
T as_field_value(const X& x) {
  if constexpr (std::same_as<T, double>) return static_cast<double>(x);
  else return to_vec3(x);
}
template<field_value T>
T same_in_all_components(double x) {
  if constexpr (std::same_as<T, double>) return x;
  else return {x, x, x};
}

/// The value of a field at a vert: that of a map, or of a function at its point.
template<class M, class F>
decltype(auto) value_at(const M& m, const F& f, const vert_t<M>& v) {
  if constexpr (requirement::gives_numbers_or_points<F, vert_t<M>>) return f[v];
  else return f(to_vec3(point(m, v)));
}
/// double if the values of a field on M are numbers, vec3 otherwise.
template<class F, class M>
  requires requirement::is_given_field<F, M>
using field_value_of = std::conditional_t<
    std::convertible_to<decltype(value_at(std::declval<const std::remove_cvref_t<M>&>(), std::declval<const F&>(),
                                          std::declval<const vert_t<M>&>())),
                        double>,
    double, vec3>;

/// Elements X in a container or braces; or pairs of an X and a T, or other values that decompose into two parts.
template<class R, class X> concept holds_elements = core::iterable<R> && requires(const R& r) {
  requires std::convertible_to<decltype(*r.begin()), X>;
};
template<class R> concept holds_pairs = core::iterable<R> && requires(const R& r) {
  (*r.begin()).first;
  (*r.begin()).second;
};
template<class R, class X> concept holds_pairs_of = holds_pairs<R> && requires(const R& r) {
  requires std::convertible_to<decltype((*r.begin()).first), X>;
};
template<class P> concept is_decomposable = std::is_aggregate_v<P> || requires { std::tuple_size<P>::value; };
template<class R> concept holds_decomposables = core::iterable<R> && !holds_pairs<R> && requires(const R& r) {
  requires is_decomposable<std::remove_cvref_t<decltype(*r.begin())>>;
};
template<class R, class X>
concept gives_values = !holds_elements<R, X> && (holds_pairs_of<R, X> || holds_decomposables<R>);
template<class R, class X> concept names_elements = holds_elements<R, X> || gives_values<R, X>;

}  // namespace concino::detail
