// The named, typed properties that a mesh holds: one column of values per property. property.hpp is the way in.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/mesh/detail/live.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
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

  [[gnu::noinline]] void make_room(std::size_t n) {
    column fresh(*type_);
    fresh.data_ = static_cast<unsigned char*>(::operator new(n * type_->size, std::align_val_t(type_->alignment)));
    fresh.room_ = n;
    if (type_->move) {
      for (; fresh.size_ < size_; ++fresh.size_) type_->move(fresh.at(fresh.size_), at(fresh.size_));
    } else if (size_ > 0) {
      std::memcpy(fresh.data_, data_, size_ * type_->size);
      fresh.size_ = size_;
    }
    std::swap(data_, fresh.data_), std::swap(size_, fresh.size_), std::swap(room_, fresh.room_);
  }

 public:
  explicit column(const value_type& type) : type_(&type) {}
  column(const value_type& type, std::size_t n) : column(type) {
    make_room(n);
    resize(n);
  }
  [[gnu::noinline]] column(const column& o) : column(*o.type_) {
    make_room(o.size_);
    if (type_->copy) {
      for (; size_ < o.size_; ++size_) type_->copy(at(size_), o.at(size_));
    } else if (o.size_ > 0) {
      std::memcpy(data_, o.data_, o.size_ * type_->size);
      size_ = o.size_;
    }
  }
  /// Value i is that of o at source[i], a default where that is ~0.
  column(const column& o, const std::vector<std::uint32_t>& source) : column(*o.type_) {
    make_room(source.size());
    for (; size_ < source.size(); ++size_) {
      const std::uint32_t from = source[size_];
      if (from == ~0u) type_->make(at(size_));
      else if (type_->copy) type_->copy(at(size_), o.at(from));
      else std::memcpy(at(size_), o.at(from), type_->size);
    }
  }
  column& operator=(const column&) = delete;
  [[gnu::noinline]] ~column() {
    resize(0);
    ::operator delete(data_, std::align_val_t(type_->alignment));
  }

  void* data() const { return data_; }  // not null, even if there are no values, in a column made for a number of them
  std::size_t size() const { return size_; }
  const std::type_info& type() const { return *type_->type; }

  /// New ones are default values.
  [[gnu::noinline]] void resize(std::size_t n) {
    if (n > room_) make_room(std::max(n, 2 * size_));
    if (type_->destroy) {
      while (size_ > n) type_->destroy(at(--size_));
      for (; size_ < n; ++size_) type_->make(at(size_));
      return;
    }
    if (size_ < n) {
      // the first one made, then copied in ever larger blocks, but no larger than a cache
      type_->make(at(size_));
      for (std::size_t made = 1, more = 1; size_ + made < n; made += more) {
        more = std::min({made, n - size_ - made, std::size_t{1024}});
        std::memcpy(at(size_ + made), at(size_), more * type_->size);
      }
    }
    size_ = n;
  }
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
  property_set() = default;
  property_set(const property_set& o) : entries_(o.entries_) {
    for (entry& e : entries_) e.values.reset(new detail::column(*e.values));
  }
  property_set(property_set&&) noexcept = default;
  property_set& operator=(property_set o) noexcept {
    entries_.swap(o.entries_);
    return *this;
  }

  /// The column of that name, made with n default values if there is none.
  [[gnu::noinline, gnu::cold]] std::shared_ptr<detail::column> get(element_kind kind, std::string_view name, const detail::value_type& type, std::size_t n) {
    if (auto found = find(kind, name, type)) return found;
    std::shared_ptr<detail::column> fresh(new detail::column(type, n));
    entries_.push_back({kind, std::string(name), fresh});
    return fresh;
  }

  /// Null if there is none of that name; invalid_argument if it holds values of another type.
  [[gnu::noinline, gnu::cold]] std::shared_ptr<detail::column> find(element_kind kind, std::string_view name, const detail::value_type& type) const {
    for (const entry& e : entries_) {
      if (e.kind != kind || e.name != name) continue;
      if (e.values->type() != *type.type)
        core::throw_joined<invalid_argument>({to_string(kind), " property \"", e.name, "\" holds values of type ", e.values->type().name(),
                                                ", not of the type asked for (", type.type->name(), "); use another name or remove it first"});
      return e.values;
    }
    return nullptr;
  }

  /// Of the property of that name and type; null if there is none.
  const void* values_if_any(element_kind kind, std::string_view name, const std::type_info& type) const {
    for (const entry& e : entries_)
      if (e.kind == kind && e.name == name && e.values->type() == type) return e.values->data();
    return nullptr;
  }

  bool remove(element_kind kind, std::string_view name) {
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if (entries_[i].kind != kind || entries_[i].name != name) continue;
      entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(i));
      return true;
    }
    return false;
  }

  bool has(element_kind kind) const {
    return std::any_of(entries_.begin(), entries_.end(), [&](const entry& e) { return e.kind == kind; });
  }
  /// Takes over all properties of one kind of another mesh: element i gets the values of source[i] there, default values where that is ~0.
  void gather(const property_set& given, element_kind kind, const std::vector<std::uint32_t>& source) {
    for (const entry& e : given.entries_)
      if (e.kind == kind) entries_.push_back({kind, e.name, std::make_shared<detail::column>(*e.values, source)});
  }

  /// Default values for elements that are about to be added. If one of them cannot be made, nothing has changed.
  void grow(const detail::index_bounds& before, const detail::index_bounds& after) {
    if (entries_.empty()) return;
    const auto resize = [&](const detail::index_bounds& to) {
      const std::size_t sizes[] = {to.verts, to.edges, to.faces, to.polys, 1};
      for (entry& e : entries_) e.values->resize(sizes[static_cast<unsigned>(e.kind)]);
    };
    try {
      resize(after);
    } catch (...) {
      resize(before);  // only destroys
      throw;
    }
  }

  std::size_t size() const { return entries_.size(); }
  property_info info(std::size_t i) const { return {entries_[i].kind, entries_[i].name, &entries_[i].values->type()}; }
};

}  // namespace concino
