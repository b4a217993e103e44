// The named, typed properties that a mesh holds: one column of values per property. property.hpp is the way in.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/error.hpp>
#include <concino/mesh/detail/alive_elements.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <type_traits>
#include <typeinfo>
#include <utility>
#include <vector>

namespace concino {

/// What a property gives values to; `mesh`: one value to the mesh as a whole; `corner`: to each vert of each poly.
enum class element_kind { vert, edge, face, poly, mesh, corner };

/// The name of a kind of elements: "vert", "edge", "face", "poly", "mesh" or "corner".
/// Needs:  one of the kinds above.      Result: a text that is always there.      Cost: O(1).      Errors: none.
inline std::string_view to_string(element_kind k) {
  constexpr std::string_view names[] = {"vert", "edge", "face", "poly", "mesh", "corner"};
  return names[static_cast<unsigned>(k)];
}

/// What becomes of the values of a property where elements are copied, split, merged or put between others: how the value of an element follows from
/// those of the elements that it was made of. An element that is no more than a copy has the value of its origin by the first two.
enum class property_rule {
  interpolate,  // their mean, weighted by what they have in common: of numbers, vectors, arrays of numbers, colours
  copy,         // the value of the one that it has most in common with: of anything, such as names and labels
  sum,          // they are parted and added up, so that the sum over all elements stays what it is: masses, counts
};

/// The name of a rule: "interpolate", "copy" or "sum".
/// Needs:  one of the rules above.      Result: a text that is always there.      Cost: O(1).      Errors: none.
inline std::string_view to_string(property_rule r) {
  constexpr std::string_view names[] = {"interpolate", "copy", "sum"};
  return names[static_cast<unsigned>(r)];
}

class element_origins;
struct correspondence;

namespace detail {

/// Values that have a mean: factor * x, and x + y. Those of integers do not: they are counts or names.
template<class T>
concept scalable = !std::integral<T> && requires(const T& x, double factor) {
  { factor * x } -> std::convertible_to<T>;
  { x + x } -> std::convertible_to<T>;
};
template<class T>
concept countable = std::integral<T> && !std::same_as<T, bool>;

template<scalable T> T scaled(const T& x, double factor) { return static_cast<T>(factor * x); }
template<scalable T> void add_scaled(T& to, const T& x, double factor) { to = static_cast<T>(to + factor * x); }
template<countable T> T scaled(const T& x, double) { return x; }
template<countable T> void add_scaled(T& to, const T& x, double) {
  to = static_cast<T>(static_cast<std::uint64_t>(to) + static_cast<std::uint64_t>(x));  // wraps rather than overflows
}
template<class T, std::size_t N>
  requires(scalable<T> && N > 0)
std::array<T, N> scaled(std::array<T, N> x, double factor) {
  for (T& part : x) part = scaled(part, factor);
  return x;
}
template<class T, std::size_t N>
  requires(scalable<T> && N > 0)
void add_scaled(std::array<T, N>& to, const std::array<T, N>& x, double factor) {
  for (std::size_t i = 0; i < N; ++i) add_scaled(to[i], x[i], factor);
}

/// What a column has to know of the type of its values. Columns are no templates: each would take longer to compile than all that is done
/// with most of them.
struct value_type {
  std::size_t size, alignment;
  const std::type_info* type;
  void (*make)(void* at);                    // a default value
  void (*copy)(void* at, const void* from);  // null, like the others: copying bytes will do
  void (*move)(void* at, void* from);        // or copy, if moving may throw
  void (*destroy)(void* at);
  property_rule rule;                                           // unless another one is set
  void (*scale)(void* at, const void* from, double factor);     // makes factor * from; null: the values cannot be parted
  void (*add)(void* at, const void* from, double factor);       // adds factor * from, of values that cannot be parted with the factor 1; null: there is no sum
};

template<class T>
struct value_functions {
  static void make(void* at) { ::new (at) T{}; }
  static void copy(void* at, const void* from) { ::new (at) T(*static_cast<const T*>(from)); }
  static void move(void* at, void* from) { ::new (at) T(std::move_if_noexcept(*static_cast<T*>(from))); }
  static void destroy(void* at) { static_cast<T*>(at)->~T(); }

  static void scale(void* at, const void* from, double factor) { ::new (at) T(detail::scaled(*static_cast<const T*>(from), factor)); }
  static void add(void* at, const void* from, double factor) { detail::add_scaled(*static_cast<T*>(at), *static_cast<const T*>(from), factor); }

  static constexpr value_type type() {
    value_type t{sizeof(T), alignof(T), &typeid(T), make, nullptr, nullptr, nullptr, property_rule::copy, nullptr, nullptr};
    if constexpr (!std::is_trivially_copyable_v<T>) t.copy = copy, t.move = move, t.destroy = destroy;
    if constexpr (requires(T& x) { detail::add_scaled(x, x, 1.0); }) {
      t.add = add;
      if constexpr (!std::integral<T>) t.scale = scale, t.rule = property_rule::interpolate;
    }
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
  void copy_value(const column& o, std::size_t from);
  void interpolate(const column& o, const element_origins& from);
  void copy_largest(const column& o, const element_origins& from);
  void sum(const column& o, const element_origins& from);

 public:
  explicit column(const value_type& type) : type_(&type), rule_(type.rule) {}
  column(const value_type& type, std::size_t n);
  column(const column& o);
  /// Value i follows by o's rule from those of o at from[i]; a default where there is none.
  column(const column& o, const element_origins& from);
  column& operator=(const column&) = delete;
  ~column();

  void* data() const { return data_; }  // not null, even if there are no values, in a column made for a number of them
  std::size_t size() const { return size_; }
  const std::type_info& type() const { return *type_->type; }
  property_rule rule() const { return rule_; }
  /// False if values of this type do not allow it.
  bool set_rule(property_rule rule);

  /// New ones are default values.
  void resize(std::size_t n);
};

}  // namespace detail

/// One entry of property_list(m).
struct property_info {
  element_kind kind;
  std::string name;
  const std::type_info* type;
  property_rule rule;
};

class property_set {
  struct entry {
    element_kind kind;
    std::string name;
    std::shared_ptr<detail::column> values;
  };
  std::vector<entry> entries_;

 public:
  property_set();
  property_set(const property_set& o);
  property_set(property_set&&) noexcept;
  ~property_set();
  property_set& operator=(property_set o) noexcept;

  /// The column of that name, made with n default values if there is none.
  std::shared_ptr<detail::column> get(element_kind kind, std::string_view name, const detail::value_type& type, std::size_t n);

  /// Null if there is none of that name; invalid_argument if it holds values of another type.
  std::shared_ptr<detail::column> find(element_kind kind, std::string_view name, const detail::value_type& type) const;

  /// Of the property of that name and type; null if there is none.
  const void* values_if_any(element_kind kind, std::string_view name, const std::type_info& type) const;

  bool remove(element_kind kind, std::string_view name);

  bool has(element_kind kind) const;
  void set_rule(element_kind kind, std::string_view name, property_rule rule);

  /// Takes over the properties of another mesh that the elements of this one were made of, and those of the mesh as a whole. One of the same kind and name
  /// is replaced. All or nothing.
  void transfer(const property_set& given, const correspondence& c);

  /// Default values for elements that are about to be added. If one of them cannot be made, nothing has changed.
  void grow(const detail::index_bounds& before, const detail::index_bounds& after);

  std::size_t size() const { return entries_.size(); }
  property_info info(std::size_t i) const;
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/property_set.ipp>
#endif
