// The requirements of concepts, each written once. A requirement is a named concept, has_verts<M>, and a struct with
// the message that says what to write:
//
//   struct verts_requirement {
//     template<class M> static constexpr bool holds = has_verts<M>;
//     template<class M> static consteval void explain() {
//       static_assert(detail::missing<M>, "concino: mesh_traits<M> needs verts: ...");
//     }
//   };
//
// A concept is the conjunction of the named concepts. Its list has the structs in the order in which they are
// explained. Its function explain_... stops at the first one that does not hold. tests/must_not_compile/explain makes
// the tests from the lists. Each message is in its struct and on one line: clang++ 14 prints a string that is a
// template argument as numbers, and compilers print strings on several lines badly.
#pragma once

#include <concepts>
#include <cstddef>
#include <type_traits>

namespace concino {

namespace detail {

/// False, but only once the types are known; explain() uses it in its assertions.
template<class... T> inline constexpr bool missing = false;

}  // namespace detail

namespace requirement {

/// The requirements of a concept, in the order in which they are explained. A list may contain lists.
template<class... R> struct list {};

/// What explain_... calls if the whole list holds, but the concept is false.
struct nothing_missing {
  template<class... T> static consteval void explain() { static_assert(detail::missing<T...>, "concino: the list of requirements lacks some that the concept needs"); }
};

/// Whether requirement or list R holds for the types T; `first_missing` is the requirement itself, or the first one of
/// a list that does not hold.
template<class R, class... T>
struct check : std::bool_constant<R::template holds<T...>> {
  using first_missing = R;
};
template<class... R, class... T>
struct check<list<R...>, T...> : std::conjunction<check<R, T...>..., check<list<>, T...>> {};
template<class... T>
struct check<list<>, T...> : std::true_type {
  using first_missing = nothing_missing;
};

template<class List, class... T> using first_missing = typename check<List, T...>::first_missing;

/// A list with fixed types T, which ignores the types that are passed: the requirements of a base class of traits
/// (base_requirement of mesh_traits.hpp), or of one of several types.
template<class List, class... T>
struct bound {
  template<class...> static constexpr bool holds = check<List, T...>::value;
  template<class...> static consteval void explain() { first_missing<List, T...>::template explain<T...>(); }
};

}  // namespace requirement

namespace detail {

// Messages for a member of mesh_traits, or of links, that exists but is wrong. Each function fails to compile with a
// message, and returns true if the member is missing. It is called in an assertion above the one that names the member,
// so that its message comes first. IsThere: whether the member exists; it is false for functions with several
// overloads. One line per message, so that compilers print it in one line.
// clang-format off

/// The function cannot be called as required, or its result does not convert to the required type.
template<bool IsThere, bool IsCallable, class... T>
consteval bool explain_result() {
  static_assert(!IsThere || IsCallable || missing<T...>, "concino: the member is there, but cannot be called: it has to be static and public, and to take the mesh as const M& and elements of the types that are named for them");
  static_assert(!IsCallable || missing<T...>, "concino: the member is there, but what it returns does not convert to the type that is needed");
  return true;
}

/// The same for a function that a verb calls with a const M and elements of the types X.
template<bool IsThere, class Verb, class M, class... X>
consteval bool explain_value() {
  return explain_result<IsThere, std::is_invocable_v<Verb, const std::remove_cvref_t<M>&, X...>, M, X...>();
}

/// The function, called like that, returns something that is no ElementRange of Ts.
template<bool IsThere, class T, class Verb, class M, class... X>
consteval bool explain_range() {
  if constexpr (std::is_invocable_v<Verb, const std::remove_cvref_t<M>&, X...>) {
    using R = std::remove_cvref_t<std::invoke_result_t<Verb, const std::remove_cvref_t<M>&, X...>>;
    if constexpr (std::is_void_v<R>)
      static_assert(missing<R>, "concino: the member is there, but returns nothing");
    else if constexpr (!requires(R& r) { r.begin(); r.end(); })
      static_assert(missing<R>, "concino: the member is there, but what it returns has no begin() and end()");
    else if constexpr (!requires(const R& r) { r.begin(); })
      static_assert(missing<R>, "concino: the member is there, but begin() of what it returns is not const: write `iterator begin() const`");
    else if constexpr (!requires(const R& r) { r.end(); })
      static_assert(missing<R>, "concino: the member is there, but end() of what it returns is not const: write `iterator end() const`");
    else if constexpr (!requires(const R& r) { *r.begin(); })
      static_assert(missing<R>, "concino: the member is there, but the iterators of what it returns lack the operator *");
    else if constexpr (!requires(const R& r) { requires std::same_as<std::remove_cvref_t<decltype(*r.begin())>, T>; })
      static_assert(missing<R, T>, "concino: the member is there, but what it returns yields elements of another type than mesh_traits<M> names");
    else if constexpr (!requires(const R& r) { requires std::copyable<decltype(r.begin())>; })
      static_assert(missing<R>, "concino: the member is there, but the iterators of what it returns cannot be copied");
    else if constexpr (!requires(const R& r, decltype(r.begin()) it) { { it != r.end() } -> std::convertible_to<bool>; })
      static_assert(missing<R>, "concino: the member is there, but begin() and end() of what it returns cannot be compared by !=");
    else
      static_assert(missing<R>, "concino: the member is there, but the iterators of what it returns lack the operator ++");
  } else explain_result<IsThere, false, M, X...>();
  return true;
}

/// The type, of the template Type<M>, is not std::regular.
template<template<class> class Type, class M>
consteval bool explain_regular() {
  if constexpr (requires { typename Type<M>; }) {
    using T = Type<M>;
    if constexpr (!std::copyable<T>)
      static_assert(missing<T>, "concino: the type is there, but it cannot be copied and assigned");
    else if constexpr (!std::default_initializable<T>)
      static_assert(missing<T>, "concino: the type is there, but it has no default constructor");
    else
      static_assert(missing<T>, "concino: the type is there, but its values cannot be compared by ==");
  }
  return true;
}

/// The constant exists, but has another value.
template<bool IsThere, class M>
consteval bool explain_constant() {
  static_assert(!IsThere || missing<M>, "concino: the member is there, but has another value, or none that is known when compiling");
  return true;
}
// clang-format on

}  // namespace detail

}  // namespace concino
