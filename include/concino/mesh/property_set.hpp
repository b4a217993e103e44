// The named, typed properties that a mesh holds: one column of values per property. property.hpp is the way in.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/error.hpp>
#include <concino/mesh/detail/live.hpp>

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

/// What a property gives values to; `mesh`: one value to the mesh as a whole.
enum class element_kind { vert, edge, face, poly, mesh };

/// The name of a kind of elements: "vert", "edge", "face", "poly" or "mesh".
/// Needs:  one of the kinds above.      Result: a text that is always there.      Cost: O(1).      Errors: none.
inline std::string_view to_string(element_kind k) {
  constexpr std::string_view names[] = {"vert", "edge", "face", "poly", "mesh"};
  return names[static_cast<unsigned>(k)];
}

namespace detail {

/// What a column has to know of the type of its values. Columns are no templates: each would take longer to compile than all that is done
/// with most of them.
struct value_type {
  std::size_t size, alignment;
  const std::type_info* type;
  void (*make)(void* at);                    // a default value
  void (*copy)(void* at, const void* from);  // null, like the others: copying bytes will do
  void (*move)(void* at, void* from);        // or copy, if moving may throw
  void (*destroy)(void* at);
};

template<class T>
struct value_functions {
  static void make(void* at) { ::new (at) T{}; }
  static void copy(void* at, const void* from) { ::new (at) T(*static_cast<const T*>(from)); }
  static void move(void* at, void* from) { ::new (at) T(std::move_if_noexcept(*static_cast<T*>(from))); }
  static void destroy(void* at) { static_cast<T*>(at)->~T(); }

  static constexpr value_type type() {
    if constexpr (std::is_trivially_copyable_v<T>) return {sizeof(T), alignof(T), &typeid(T), make, nullptr, nullptr, nullptr};
    else return {sizeof(T), alignof(T), &typeid(T), make, copy, move, destroy};
  }
};
template<class T>
inline constexpr value_type values_of = value_functions<T>::type();

/// The values of one property, one after another.
class column {
  const value_type* type_;
  unsigned char* data_ = nullptr;
  std::size_t size_ = 0, room_ = 0;

  unsigned char* at(std::size_t i) const { return data_ + i * type_->size; }

  void make_room(std::size_t n);

 public:
  explicit column(const value_type& type) : type_(&type) {}
  column(const value_type& type, std::size_t n);
  column(const column& o);
  /// Value i is that of o at source[i], a default where that is ~0.
  column(const column& o, const std::vector<std::uint32_t>& source);
  column& operator=(const column&) = delete;
  ~column();

  void* data() const { return data_; }  // not null, even if there are no values, in a column made for a number of them
  std::size_t size() const { return size_; }
  const std::type_info& type() const { return *type_->type; }

  /// New ones are default values.
  void resize(std::size_t n);
};

}  // namespace detail

/// One entry of property_list(m).
struct property_info {
  element_kind kind;
  std::string name;
  const std::type_info* type;
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
  /// Takes over all properties of one kind of another mesh: element i gets the values of source[i] there, default values where that is ~0.
  void gather(const property_set& given, element_kind kind, const std::vector<std::uint32_t>& source);

  /// Default values for elements that are about to be added. If one of them cannot be made, nothing has changed.
  void grow(const detail::index_bounds& before, const detail::index_bounds& after);

  std::size_t size() const { return entries_.size(); }
  property_info info(std::size_t i) const;
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/property_set.ipp>
#endif
