// What labels of elements stand for, such as the physical groups of Gmsh and the patches of OpenFOAM: kept from load to
// save.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/mesh/property_set.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace concino {

/// The name of a label of the verts, edges, faces or polys.
struct label_name {
  element_kind kind = element_kind::poly;
  int label = 0;  // the elements of this kind whose property "label" (int) has this value
  std::string name = {};
  std::vector<std::string> lines = {};  // what else the file says about it, in order: "type wall;" in OpenFOAM files

  friend bool operator==(const label_name&, const label_name&) = default;
};

/// The mesh property "label_names": load fills it from formats that name groups of elements, and save writes it to
/// them. If a kind has a label or a name twice, the first is used.
struct label_names {
  std::vector<label_name> names = {};

  /// The first name of that label, or null.      Cost: O(number of names).
  const label_name* find(element_kind kind, int label) const {
    for (const label_name& n : names)
      if (n.kind == kind && n.label == label) return &n;
    return nullptr;
  }
  /// The first label of that name, or null.
  const label_name* find(element_kind kind, std::string_view name) const {
    for (const label_name& n : names)
      if (n.kind == kind && std::string_view(n.name) == name) return &n;
    return nullptr;
  }

  friend bool operator==(const label_names&, const label_names&) = default;
};

}  // namespace concino
