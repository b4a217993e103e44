// ReadableMap and WritableMap: a value per element, `p[e]`. Examples are an array indexed by descriptors, a lambda in a
// wrapper, a property of a foreign library. Only `p[e] = t` is needed for writing, so proxies qualify.
#pragma once

#include <concino/concepts/requirement.hpp>

#include <concepts>
#include <cstddef>
#include <type_traits>

namespace concino {

template<class P, class E>
concept ReadableMap = requires(const std::remove_cvref_t<P>& p, const E& e) { p[e]; };

template<class P, class E, class T>
concept WritableMap = requires(std::remove_reference_t<P>& p, const E& e, const T& t) { p[e] = t; };

namespace requirement {

struct read_requirement {
  template<class P, class E> static constexpr bool holds = ReadableMap<P, E>;
  template<class P, class E> static consteval void explain() {
    static_assert(!requires(std::remove_cvref_t<P>& p, const E& e) { p[e]; } || detail::missing<P, E>, "concino: operator[] is there, but is not const");
    static_assert(detail::missing<P, E>, "concino: ReadableMap needs value operator[](const E&) const; m[x] is the value at element x");
  }
};
struct write_requirement {
  template<class P, class E, class T> static constexpr bool holds = WritableMap<P, E, T>;
  template<class P, class E, class T> static consteval void explain() {
    static_assert(detail::missing<P, E, T>, "concino: WritableMap needs T& or proxy operator[](const E&); m[x] = t sets the value at element x");
  }
};

using readable_map_requirements = list<read_requirement>;
using writable_map_requirements = list<write_requirement>;

/// The values of a map: numbers, or points and vectors p with p[0], p[1], p[2].
template<class P, class E>
concept gives_numbers = ReadableMap<P, E> && requires(const std::remove_cvref_t<P>& p, const E& e) {
  { p[e] } -> std::convertible_to<double>;
};
template<class P, class E>
concept gives_points = ReadableMap<P, E> && requires(const std::remove_cvref_t<P>& p, const E& e) {
  { p[e][0] } -> std::convertible_to<double>;
  { p[e][1] } -> std::convertible_to<double>;
  { p[e][2] } -> std::convertible_to<double>;
};
template<class P, class E> concept gives_numbers_or_points = gives_numbers<P, E> || gives_points<P, E>;

}  // namespace requirement

/// Fails to compile with one sentence that says what to write, if P is not a map that can be read at an E.
template<class P, class E>
consteval void explain_readable_map() {
  if constexpr (!ReadableMap<P, E>)
    requirement::first_missing<requirement::readable_map_requirements, P, E>::template explain<P, E>();
}

/// Fails to compile with one sentence that says what to write, if P is not a map in which Ts can be written at an E.
template<class P, class E, class T>
consteval void explain_writable_map() {
  if constexpr (!WritableMap<P, E, T>)
    requirement::first_missing<requirement::writable_map_requirements, P, E, T>::template explain<P, E, T>();
}

}  // namespace concino
