// Maps give a value per element. Anything with `p[e]` is one: an array indexed by descriptors, a lambda in a wrapper, a property of a
// foreign library. Writing is `p[e] = t` and nothing more, so proxies qualify.
#pragma once

#include <concepts>
#include <cstddef>
#include <type_traits>

namespace concino {

template<class P, class E>
concept ReadableMap = requires(const std::remove_cvref_t<P>& p, const E& e) { p[e]; };

template<class P, class E, class T>
concept WritableMap = requires(std::remove_reference_t<P>& p, const E& e, const T& t) { p[e] = t; };

namespace requirement {

/// What a map gives: numbers, or points and vectors p with p[0], p[1], p[2].
template<class P, class E> concept gives_numbers = ReadableMap<P, E> && requires(const std::remove_cvref_t<P>& p, const E& e) {
  { p[e] } -> std::convertible_to<double>;
};
template<class P, class E> concept gives_points = ReadableMap<P, E> && requires(const std::remove_cvref_t<P>& p, const E& e) {
  { p[e][0] } -> std::convertible_to<double>;
  { p[e][1] } -> std::convertible_to<double>;
  { p[e][2] } -> std::convertible_to<double>;
};
template<class P, class E> concept gives_numbers_or_points = gives_numbers<P, E> || gives_points<P, E>;

}  // namespace requirement

namespace detail {

/// False, but only once the types are known.
template<class... T> inline constexpr bool no_map = false;

}  // namespace detail

/// Fails to compile with one sentence that says what to write where P is no map that can be read at an E.
template<class P, class E>
consteval void explain_readable_map() {
  if constexpr (!ReadableMap<P, E>)
    static_assert(detail::no_map<P, E>, "concino: ReadableMap needs value operator[](const E&) const; m[x] is the value at element x");
}

/// Fails to compile with one sentence that says what to write where P is no map in which Ts can be written at an E.
template<class P, class E, class T>
consteval void explain_writable_map() {
  if constexpr (!WritableMap<P, E, T>)
    static_assert(detail::no_map<P, E, T>, "concino: WritableMap needs T& or proxy operator[](const E&); m[x] = t sets the value at element x");
}

}  // namespace concino
