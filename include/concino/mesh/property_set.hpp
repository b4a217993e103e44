// The named, typed properties that a mesh holds: one column of values per property. property.hpp is the way in.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/error.hpp>

#include <memory>
#include <string>
#include <string_view>
#include <typeinfo>
#include <vector>

namespace concino {

enum class element_kind { vert, edge, face, poly };

inline std::string_view to_string(element_kind k) {
  constexpr std::string_view names[] = {"vert", "edge", "face", "poly"};
  return names[static_cast<unsigned>(k)];
}

namespace detail {

template<class Id>
inline constexpr element_kind kind_of = std::same_as<Id, vert_id>   ? element_kind::vert
                                        : std::same_as<Id, edge_id> ? element_kind::edge
                                        : std::same_as<Id, face_id> ? element_kind::face
                                                                    : element_kind::poly;

struct column_base {
  virtual ~column_base() = default;
  virtual std::shared_ptr<column_base> clone() const = 0;
  virtual void resize(std::size_t n) = 0;
  virtual const std::type_info& type() const = 0;
};

/// A wrapper keeps bools apart, so that each value can be referred to and written by its own thread.
template<class T>
struct column final : column_base {
  struct cell {
    T value{};
  };
  std::vector<cell> cells;

  explicit column(std::size_t n) : cells(n) {}
  std::shared_ptr<column_base> clone() const override { return std::make_shared<column>(*this); }
  void resize(std::size_t n) override { cells.resize(n); }
  const std::type_info& type() const override { return typeid(T); }
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
    std::shared_ptr<detail::column_base> values;
  };
  std::vector<entry> entries_;

  detail::column_base* find(element_kind kind, std::string_view name, std::shared_ptr<detail::column_base>* shared = nullptr) const {
    for (const entry& e : entries_)
      if (e.kind == kind && e.name == name) {
        if (shared) *shared = e.values;
        return e.values.get();
      }
    return nullptr;
  }

 public:
  property_set() = default;
  property_set(const property_set& o) {
    for (const entry& e : o.entries_) entries_.push_back({e.kind, e.name, e.values->clone()});
  }
  property_set(property_set&&) noexcept = default;
  property_set& operator=(property_set o) noexcept {
    entries_.swap(o.entries_);
    return *this;
  }

  /// The column of that name, made with n default values if there is none.
  template<class T>
  std::shared_ptr<detail::column<T>> get(element_kind kind, std::string_view name, std::size_t n) {
    if (auto found = find_column<T>(kind, name)) return found;
    auto fresh = std::make_shared<detail::column<T>>(n);
    entries_.push_back({kind, std::string(name), fresh});
    return fresh;
  }

  /// Null if there is none of that name; invalid_argument if it holds values of another type.
  template<class T>
  std::shared_ptr<detail::column<T>> find_column(element_kind kind, std::string_view name) const {
    std::shared_ptr<detail::column_base> shared;
    const detail::column_base* const at = find(kind, name, &shared);
    if (!at) return nullptr;
    if (at->type() != typeid(T))
      throw invalid_argument(std::string(to_string(kind)) + " property \"" + std::string(name) + "\" holds values of type " + at->type().name() +
                             ", not of the type asked for (" + typeid(T).name() + "); use another name or remove it first");
    return std::static_pointer_cast<detail::column<T>>(std::move(shared));
  }

  bool remove(element_kind kind, std::string_view name) {
    return std::erase_if(entries_, [&](const entry& e) { return e.kind == kind && e.name == name; }) > 0;
  }

  /// After elements were added.
  void resize(element_kind kind, std::size_t n) {
    for (entry& e : entries_)
      if (e.kind == kind) e.values->resize(n);
  }

  std::vector<property_info> list() const {
    std::vector<property_info> all;
    for (const entry& e : entries_) all.push_back({e.kind, e.name, &e.values->type()});
    return all;
  }
};

}  // namespace concino
