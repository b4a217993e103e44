// Requirements of concepts, each stated once. A requirement is a named concept, has_verts<M>, and beside it a struct with the sentence that says what
// to write:
//
//   struct verts_requirement {
//     template<class M> static constexpr bool holds = has_verts<M>;
//     template<class M> static consteval void explain() { static_assert(detail::missing<M>, "concino: mesh_traits<M> needs verts: ..."); }
//   };
//
// A concept is the conjunction of the named concepts; its list holds the structs in the order in which they are explained; its function explain_...
// walks that list and stops at the first that does not hold. tests/must_not_compile/explain makes the tests from the lists. A sentence stands in its
// struct, on one line, because compilers print neither a string that is a template argument (clang++ 14 prints numbers) nor one on several lines well.
#pragma once

#include <concepts>
#include <cstddef>
#include <type_traits>

namespace concino {

namespace detail {

/// False, but only once the types are known: what the assertions of explain() stand on.
template<class... T> inline constexpr bool missing = false;

}  // namespace detail

namespace requirement {

/// The requirements of a concept, in the order in which they are explained. A list may hold lists.
template<class... R> struct list {};

/// What explain_... calls when all that its list holds is there, and the concept is false all the same.
struct nothing_missing {
  template<class... T> static consteval void explain() { static_assert(detail::missing<T...>, "concino: the list of requirements does not hold all that the concept needs"); }
};

/// Whether requirement or list R holds for the types T; `first_missing` is the requirement itself, of a list the first one that does not hold.
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

/// A list on the types T, whatever is asked about: what a base needs that traits may inherit from (base_requirement of mesh_traits.hpp), or what one of
/// several types has to be.
template<class List, class... T>
struct bound {
  template<class...> static constexpr bool holds = check<List, T...>::value;
  template<class...> static consteval void explain() { first_missing<List, T...>::template explain<T...>(); }
};

}  // namespace requirement

namespace detail {

// What is wrong with a member of mesh_traits, or of links, that is there: each fails to compile with a sentence, and returns true where the member is
// missing. Asked in an assertion above the one that names the member, so that this sentence comes first. IsThere: whether there is a member of that
// name; functions with several overloads do not show it. One line per message, so that compilers show it in one.
// clang-format off

/// The function cannot be called as it has to be, or returns something that does not convert.
template<bool IsThere, bool IsCallable, class... T>
consteval bool explain_result() {
  static_assert(!IsThere || IsCallable || missing<T...>, "concino: the member is there, but cannot be called: it has to be static and public, and to take the mesh as const M& and elements of the types that are named for them");
  static_assert(!IsCallable || missing<T...>, "concino: the member is there, but what it returns does not convert to the type that is needed");
  return true;
}

/// The same of a function that a verb calls with a const M and elements of the types X.
template<bool IsThere, class Verb, class M, class... X>
consteval bool explain_value() {
  return explain_result<IsThere, std::is_invocable_v<Verb, const std::remove_cvref_t<M>&, X...>, M, X...>();
}

/// The function, called so, returns what is no ElementRange of Ts.
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

/// The number is there, but is another one.
template<bool IsThere, class M>
consteval bool explain_constant() {
  static_assert(!IsThere || missing<M>, "concino: the member is there, but has another value, or none that is known when compiling");
  return true;
}
// clang-format on

}  // namespace detail

}  // namespace concino
