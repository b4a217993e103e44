// The named, typed properties of a mesh: one column of values per property. property.hpp has the functions to use them.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/error.hpp>
#include <concino/mesh/detail/properties/column.hpp>
#include <concino/mesh/detail/rows/alive_elements.hpp>
#include <concino/mesh/property_kinds.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <typeinfo>
#include <utility>
#include <vector>

namespace concino {

struct correspondence;

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

  void transfer_kinds(const property_set& source, const correspondence& c, const bool (&wanted)[6]);

 public:
  property_set();
  property_set(const property_set& o);
  property_set(property_set&&) noexcept;
  ~property_set();
  property_set& operator=(property_set o) noexcept;

  /// The column of that name, created with n default values if there is none.
  std::shared_ptr<detail::column> get(element_kind kind, std::string_view name, const detail::value_type& type,
                                      std::size_t n);

  /// Null if there is none of that name; invalid_argument if it has values of another type.
  std::shared_ptr<detail::column> find(element_kind kind, std::string_view name, const detail::value_type& type) const;

  /// The values of the property of that name and type; null if there is none.
  const void* values_if_any(element_kind kind, std::string_view name, const std::type_info& type) const;

  bool remove(element_kind kind, std::string_view name);

  bool has(element_kind kind) const;
  void set_rule(element_kind kind, std::string_view name, property_rule rule);

  /// Transfers the properties of another mesh, of whose elements the elements of this one were made, and those of that
  /// mesh as a whole. Properties of the same kind and name are replaced. Strong exception guarantee.
  void transfer(const property_set& source, const correspondence& c);
  /// The same for properties of verts, of polys and of the mesh only, for a mesh of another dimension.
  void transfer_verts_and_polys(const property_set& source, const correspondence& c);

  /// Moves values to where their elements are now; c says where they were, each in at most one place. Handles remain
  /// valid. Strong exception guarantee.
  void renumber(const correspondence& c);

  /// Adds default values for elements that will be added. If one of them cannot be constructed, nothing changes.
  void grow(const detail::index_bounds& before, const detail::index_bounds& after);
  /// Removes the values of elements from these index bounds on.
  void shrink(const detail::index_bounds& to) noexcept;

  element_kind kind(std::size_t i) const { return entries_[i].kind; }
  /// The column of property i.
  const std::shared_ptr<detail::column>& values(std::size_t i) const { return entries_[i].values; }

  std::size_t size() const { return entries_.size(); }
  property_info info(std::size_t i) const;
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/properties/property_set.ipp>
#endif
