// The indices that elements of an OpenMesh mesh had before its garbage collection.
#pragma once

#include <concino/mesh/element_origins.hpp>

#include <OpenMesh/Core/Mesh/BaseKernel.hh>

#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// The old index of each element of one kind, as a property that OpenMesh moves with its elements. OpenMesh's own list of handles to update allocates memory
/// during the change. Property: OpenMesh::VPropHandleT<int> or a sibling.
template<class Property>
class openmesh_numbers {
  OpenMesh::BaseKernel& m_;
  Property property_;
  std::vector<std::uint32_t> origins_;

 public:
  openmesh_numbers(OpenMesh::BaseKernel& m, std::size_t bound) : m_(m) {
    origins_.reserve(bound);
    try {
      m_.add_property(property_, "concino: index before garbage collection");
    } catch (...) {
      if (property_.is_valid()) m_.remove_property(property_);
      throw;
    }
    for (std::size_t i = 0; i < bound; ++i) m_.property(property_)[static_cast<int>(i)] = static_cast<int>(i);
  }
  openmesh_numbers(const openmesh_numbers&) = delete;
  openmesh_numbers& operator=(const openmesh_numbers&) = delete;
  ~openmesh_numbers() { m_.remove_property(property_); }

  /// The origins of the elements that are left, without allocating memory.
  template<class Range>
  element_origins origins(const Range& left, std::size_t bound) {
    origins_.assign(bound, element_origins::none);
    for (const auto x : left) origins_[static_cast<std::size_t>(x.idx())] = static_cast<std::uint32_t>(m_.property(property_)[x.idx()]);
    return element_origins(std::move(origins_));
  }
};

}  // namespace concino::detail
