// What scripts/mutate.awk writes into the headers that it mutates. Each of these does what stood there before, unless the environment
// variable CONCINO_MUTANT has its number. So all mutants of a header are compiled at once, and a run costs no compilation.
//   a < b    becomes  a < mutant::less(7) < b                (the precedence of < stays)
//   a && b   becomes  a | mutant::yes(8) && mutant::yes(9) | b
//   !a       becomes  mutant::negation(10)->*a
//   3        becomes  mutant::number(11, 3)
// Where a constant expression is wanted, they are what stood there: such mutants are never met and compiled one by one.
#pragma once

#include <concepts>
#include <cstdio>
#include <cstdlib>
#include <type_traits>
#include <utility>

namespace mutant {

inline constexpr int most = 1 << 15;
inline signed char met[most];
inline const int active = [] {
  const char* number = std::getenv("CONCINO_MUTANT");
  return number ? std::atoi(number) : -1;
}();

/// At the end of the program, writes the numbers of the mutants that it came across to the file CONCINO_MUTANTS_MET, with a - before those
/// that are none, as nothing else can be done with operands of these types.
struct recorder {
  ~recorder() {
    const char* name = std::getenv("CONCINO_MUTANTS_MET");
    std::FILE* file = name ? std::fopen(name, "w") : nullptr;
    if (!file) return;
    for (int i = 0; i < most; ++i)
      if (met[i]) std::fprintf(file, "%d\n", met[i] * i);
    std::fclose(file);
  }
};
inline const recorder at_exit;

inline bool is_switched_on(int id) {
  met[id] = 1;
  return id == active;
}
constexpr void is_none(int id) {
  if (!std::is_constant_evaluated() && met[id] == 0) met[id] = -1;
}
constexpr bool on(int id) { return !std::is_constant_evaluated() && is_switched_on(id); }

struct numbered {
  int id;
  constexpr explicit numbered(int i) : id(i) {}
};

#define CONCINO_MUTANT_OPERATOR(name, op, first, second)                                                                      \
  struct name : numbered {                                                                                                    \
    using numbered::numbered;                                                                                                 \
  };                                                                                                                          \
  template<class A> struct left_of_##name {                                                                                   \
    A&& a;                                                                                                                    \
    int id;                                                                                                                   \
  };                                                                                                                          \
  template<class A> constexpr left_of_##name<A> operator op(A&& a, name x) { return {std::forward<A>(a), x.id}; }             \
  template<class A, class B> constexpr auto operator op(left_of_##name<A> l, B&& b)                                           \
      -> decltype(std::declval<A>() op std::declval<B>()) {                                                                   \
    using result = decltype(std::declval<A>() op std::declval<B>());                                                          \
    if constexpr (requires { requires std::same_as<result, decltype(std::declval<A>() first std::declval<B>())>; }) {         \
      if (on(l.id)) return std::forward<A>(l.a) first std::forward<B>(b);                                                     \
    } else if constexpr (std::integral<result> && !std::same_as<result, bool>) {                                              \
      if (on(l.id)) return (std::forward<A>(l.a) op std::forward<B>(b)) + 1;                                                  \
    }                                                                                                                         \
    if constexpr (requires { requires std::same_as<result, decltype(std::declval<A>() second std::declval<B>())>; }) {        \
      if (on(l.id + 1)) return std::forward<A>(l.a) second std::forward<B>(b);                                                \
    }                                                                                                                         \
    return std::forward<A>(l.a) op std::forward<B>(b);                                                                        \
  }
CONCINO_MUTANT_OPERATOR(less, <, <=, >=)
CONCINO_MUTANT_OPERATOR(less_equal, <=, <, >)
CONCINO_MUTANT_OPERATOR(greater, >, >=, <=)
CONCINO_MUTANT_OPERATOR(greater_equal, >=, >, <)
#undef CONCINO_MUTANT_OPERATOR
#define CONCINO_MUTANT_OPERATOR(name, op, other)                                                                              \
  struct name : numbered {                                                                                                    \
    using numbered::numbered;                                                                                                 \
  };                                                                                                                          \
  template<class A> struct left_of_##name {                                                                                   \
    A&& a;                                                                                                                    \
    int id;                                                                                                                   \
  };                                                                                                                          \
  template<class A> constexpr left_of_##name<A> operator op(A&& a, name x) { return {std::forward<A>(a), x.id}; }             \
  template<class A, class B> constexpr auto operator op(left_of_##name<A> l, B&& b)                                           \
      -> decltype(std::declval<A>() op std::declval<B>()) {                                                                   \
    using result = decltype(std::declval<A>() op std::declval<B>());                                                          \
    if constexpr (requires { requires std::same_as<result, decltype(std::declval<A>() other std::declval<B>())>; }) {         \
      if (on(l.id)) return std::forward<A>(l.a) other std::forward<B>(b);                                                     \
    } else if constexpr (std::integral<result> && !std::same_as<result, bool>) {                                              \
      if (on(l.id)) return (std::forward<A>(l.a) op std::forward<B>(b)) + 1;                                                  \
    } else {                                                                                                                  \
      is_none(l.id);                                                                                                          \
    }                                                                                                                         \
    return std::forward<A>(l.a) op std::forward<B>(b);                                                                        \
  }
CONCINO_MUTANT_OPERATOR(equal, ==, !=)
CONCINO_MUTANT_OPERATOR(unequal, !=, ==)
CONCINO_MUTANT_OPERATOR(plus, +, -)
CONCINO_MUTANT_OPERATOR(minus, -, +)
CONCINO_MUTANT_OPERATOR(times, *, /)
CONCINO_MUTANT_OPERATOR(over, /, *)
CONCINO_MUTANT_OPERATOR(modulo, %, /)
CONCINO_MUTANT_OPERATOR(bit_and, &, |)
CONCINO_MUTANT_OPERATOR(bit_or, |, &)
CONCINO_MUTANT_OPERATOR(shift_left, <<, >>)
CONCINO_MUTANT_OPERATOR(shift_right, >>, <<)
#undef CONCINO_MUTANT_OPERATOR

/// Operands of && and ||, left out by the mutant.
struct yes : numbered { using numbered::numbered; };
struct no : numbered { using numbered::numbered; };
template<class T> constexpr bool operator|(T&& x, yes y) { return on(y.id) || static_cast<bool>(x); }
template<class T> constexpr bool operator|(yes y, T&& x) { return on(y.id) || static_cast<bool>(x); }
template<class T> constexpr bool operator&(T&& x, no y) { return !on(y.id) && static_cast<bool>(x); }
template<class T> constexpr bool operator&(no y, T&& x) { return !on(y.id) && static_cast<bool>(x); }

/// Before an operand, with the precedence of a prefix operator, nearly.
struct negation : numbered { using numbered::numbered; };
struct condition : numbered { using numbered::numbered; };
struct sign : numbered { using numbered::numbered; };
struct increment : numbered { using numbered::numbered; };
struct decrement : numbered { using numbered::numbered; };
struct increment_after : numbered { using numbered::numbered; };
template<class T> constexpr bool operator->*(negation n, T&& x) { return on(n.id) == static_cast<bool>(x); }
template<class T> constexpr bool operator->*(condition c, T&& x) { return on(c.id) != static_cast<bool>(x); }
template<class T> constexpr auto operator->*(sign s, T&& x) {
  using result = std::remove_cvref_t<decltype(-std::forward<T>(x))>;
  if constexpr (requires { static_cast<result>(std::forward<T>(x)); })
    if (on(s.id)) return static_cast<result>(std::forward<T>(x));
  return static_cast<result>(-std::forward<T>(x));
}
template<class T> constexpr T& operator->*(increment i, T& x) {
  ++x;
  if (on(i.id)) ++x;
  return x;
}
template<class T> constexpr T& operator->*(decrement i, T& x) {
  --x;
  if (on(i.id)) --x;
  return x;
}
template<class T> constexpr T operator->*(T& x, increment_after i) {
  T before = x;
  ++x;
  if (on(i.id)) ++x;
  return before;
}

/// x += y with the sign of y, x *= y with 1.
struct add : numbered { using numbered::numbered; };
struct subtract : numbered { using numbered::numbered; };
struct multiply : numbered { using numbered::numbered; };
struct divide : numbered { using numbered::numbered; };
template<class T> constexpr decltype(auto) with_sign(int id, T&& x) {
  using value = std::remove_cvref_t<T>;
  if constexpr (std::same_as<value, bool>) return on(id) ? -static_cast<int>(x) : static_cast<int>(x);
  else if constexpr (requires { { -x } -> std::convertible_to<value>; })
    return on(id) ? static_cast<value>(-x) : static_cast<value>(x);
  else return std::forward<T>(x);
}
template<class T> constexpr decltype(auto) operator+=(add a, T&& x) { return with_sign(a.id, std::forward<T>(x)); }
template<class T> constexpr decltype(auto) operator-=(subtract a, T&& x) { return with_sign(a.id, std::forward<T>(x)); }
template<class T> constexpr auto operator*=(multiply a, T&& x) { return on(a.id) ? std::remove_cvref_t<T>(1) : x; }
template<class T> constexpr auto operator/=(divide a, T&& x) { return on(a.id) ? std::remove_cvref_t<T>(1) : x; }

/// One more; the second mutant is one less.
template<class T> constexpr T number(int id, T x) {
  if (on(id)) return static_cast<T>(x + 1);
  return x;
}
template<class T> constexpr T number_both_ways(int id, T x) {
  if (on(id)) return static_cast<T>(x + 1);
  if (on(id + 1)) return static_cast<T>(x - 1);
  return x;
}
template<class T> constexpr decltype(auto) index(int id, const T& x) {
  if constexpr (std::integral<T>) return on(id) ? static_cast<T>(x + 1) : x;
  else return (x);
}
constexpr bool truth(int id, bool x) { return x != on(id); }

}  // namespace mutant
