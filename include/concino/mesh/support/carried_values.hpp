// carried_values: the values of properties at elements that an edit changes or makes. They are found before the edit,
// by the rule of each property, and written after it, which needs no memory and cannot fail.
#pragma once

#include <concino/mesh/element_origins.hpp>
#include <concino/mesh/property_set.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace concino {

class carried_values {
  struct values {
    element_kind kind;
    std::shared_ptr<detail::column> to;
    std::unique_ptr<detail::column> found;
  };
  std::vector<values> all_;

 public:
  /// `origins` are those of the elements that the edit changes or makes, which are numbered from 0 in each kind;
  /// corners are numbered too. Their indices are those of the mesh before. `of_sums` are the same for properties with
  /// the rule `sum`. Properties whose values may throw when they are moved are left out.
  carried_values(const property_set& properties, const correspondence& origins, const correspondence& of_sums);

  /// Writes the values of one of these elements to the element with this index, or the corner with this number, of the
  /// mesh after.
  void write(element_kind kind, std::size_t number, std::size_t index) noexcept;
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/properties/carried_values.ipp>
#endif
