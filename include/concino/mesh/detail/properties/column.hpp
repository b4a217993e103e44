// The values of one property, one after another, without their type.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/mesh/property_kinds.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>
#include <typeinfo>
#include <utility>

namespace concino {

class element_origins;

}  // namespace concino

namespace concino::detail {

/// Values that have a mean: factor * x, and x + y. Integers have none: they are counts or names.
template<class T>
concept scalable = !std::integral<T> && requires(const T& x, double factor) {
  { factor * x } -> std::convertible_to<T>;
  { x + x } -> std::convertible_to<T>;
};
template<class T>
concept countable = std::integral<T> && !std::same_as<T, bool>;

template<scalable T> T scaled_value(const T& x, double factor) { return static_cast<T>(factor * x); }
template<scalable T> void add_scaled(T& to, const T& x, double factor) { to = static_cast<T>(to + factor * x); }
template<countable T> T scaled_value(const T& x, double) { return x; }
template<countable T> void add_scaled(T& to, const T& x, double) {
  to = static_cast<T>(static_cast<std::uint64_t>(to) + static_cast<std::uint64_t>(x));  // wraps rather than overflows
}
template<class T, std::size_t N>
  requires(scalable<T> && N > 0)
std::array<T, N> scaled_value(std::array<T, N> x, double factor) {
  for (std::size_t i = 0; i < N; ++i) x[i] = scaled_value(x[i], factor);
  return x;
}
template<class T, std::size_t N>
  requires(scalable<T> && N > 0)
void add_scaled(std::array<T, N>& to, const std::array<T, N>& x, double factor) {
  for (std::size_t i = 0; i < N; ++i) add_scaled(to[i], x[i], factor);
}

/// The operations of a column on its values (type erasure). Columns are not templates: each would take longer to
/// compile than most of what is done with them.
struct value_type {
  std::size_t size, alignment;
  const std::type_info* type;
  void (*make)(void* at);                    // a default value; null: all bytes are 0
  void (*copy)(void* at, const void* from);  // null, like the others: the bytes can be copied
  void (*move)(void* at, void* from);        // or copy, if moving may throw
  void (*destroy)(void* at);
  property_rule rule;                                           // unless the user sets another one
  void (*scale)(void* at, const void* from, double factor);     // constructs factor * from; null: the values cannot be
                                                                // split
  void (*add)(void* at, const void* from, double factor);       // adds factor * from, with the factor 1 if values
                                                                // cannot be split; null: there is no sum
  bool moves_without_throwing;
  std::size_t num_parts = 1;                                    // the functions scale and add apply to each of so many
                                                                // parts of equal size
};

/// Numbers and arrays of numbers need few functions, as files have them in many types.
template<class T> inline constexpr bool is_zero_by_default = std::is_arithmetic_v<T>;
template<class T, std::size_t N> inline constexpr bool is_zero_by_default<std::array<T, N>> = std::is_arithmetic_v<T>;

template<class T>
struct value_functions {
  static void make(void* at) { ::new (at) T{}; }
  static void copy(void* at, const void* from) { ::new (at) T(*static_cast<const T*>(from)); }
  static void move(void* at, void* from) { ::new (at) T(std::move_if_noexcept(*static_cast<T*>(from))); }
  static void destroy(void* at) { static_cast<T*>(at)->~T(); }

  static void scale(void* at, const void* from, double factor) {
    ::new (at) T(detail::scaled_value(*static_cast<const T*>(from), factor));
  }
  static void add(void* at, const void* from, double factor) {
    detail::add_scaled(*static_cast<T*>(at), *static_cast<const T*>(from), factor);
  }

  static constexpr value_type type() {
    value_type t{sizeof(T),
                 alignof(T),
                 &typeid(T),
                 nullptr,
                 nullptr,
                 nullptr,
                 nullptr,
                 property_rule::copy,
                 nullptr,
                 nullptr,
                 std::is_nothrow_move_constructible_v<T>};
    if constexpr (!is_zero_by_default<T>) t.make = make;
    if constexpr (!std::is_trivially_copyable_v<T>) t.copy = copy, t.move = move, t.destroy = destroy;
    if constexpr (requires(T& x) { detail::add_scaled(x, x, 1.0); }) {
      t.add = add;
      if constexpr (!std::integral<T>) t.scale = scale, t.rule = property_rule::interpolate;
    }
    return t;
  }
};
/// Arrays of numbers use the functions of one number: files have arrays of many lengths.
template<class T, std::size_t N>
  requires(std::is_arithmetic_v<T> && N > 0)
struct value_functions<std::array<T, N>> {
  static constexpr value_type type() {
    value_type t = value_functions<T>::type();
    t.size = sizeof(std::array<T, N>), t.type = &typeid(std::array<T, N>), t.num_parts = N;
    if constexpr (std::integral<T>) t.add = nullptr;
    return t;
  }
};
template<class T>
inline constexpr value_type values_of = value_functions<T>::type();

/// The values of one property, one after another.
class column {
  const value_type* type_;
  unsigned char* data_ = nullptr;
  std::size_t size_ = 0, room_ = 0;
  property_rule rule_;

  unsigned char* at(std::size_t i) const { return data_ + i * type_->size; }

  void make_room(std::size_t n);
  void make_default();
  void copy_value(const column& o, std::size_t from);
  void apply_to_parts(void (*f)(void*, const void*, double), std::size_t i, const column& o, std::size_t from,
                      double factor);
  void interpolate(const column& o, const element_origins& from);
  void copy_largest(const column& o, const element_origins& from);
  void sum(const column& o, const element_origins& from);

 public:
  explicit column(const value_type& type) : type_(&type), rule_(type.rule) {}
  column(const value_type& type, std::size_t n);
  column(const column& o);
  /// Value i follows by o's rule from the values of o at from[i]; it is a default value if there are none.
  column(const column& o, const element_origins& from);
  column& operator=(const column&) = delete;
  ~column();

  void* data() const { return data_; }  // not null in a column made for a number of values, even if that is 0
  std::size_t size() const { return size_; }
  const std::type_info& type() const { return *type_->type; }
  const value_type& operations() const { return *type_; }
  property_rule rule() const { return rule_; }
  /// Returns false if values of this type do not allow the rule.
  bool set_rule(property_rule rule);

  /// New values are default values.
  void resize(std::size_t n);
  bool is_bytes() const { return !type_->copy; }
  /// Moves value k of `from`, which has values of the same type, to position i, whose value is replaced. Only if moving
  /// does not throw.
  void take(std::size_t i, column& from, std::size_t k) noexcept;

  void swap_values(column& o) noexcept;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/properties/column.ipp>
#endif
