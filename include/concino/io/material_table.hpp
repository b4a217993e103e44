// Materials of surfaces: all lines of the material libraries of a file, kept from load to save.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace concino {

/// One material of a .mtl library. The property "material" (std::string) of a poly is the name of its material.
struct material {
  std::string name = {};
  std::vector<std::string> lines =
      {};  // in order, without newmtl: "Kd 0.8 0.1 0", "Ns 20", comments, and lines that only other programs know

  friend bool operator==(const material&, const material&) = default;
};

/// The mesh property "materials": load fills it from all libraries that an .obj file names, and save writes it.
/// The property "color" of polys has their colours too, and takes precedence where the two differ.
struct material_table {
  std::vector<material> materials = {};     // if two have the same name, the first is used
  std::vector<std::string> libraries = {};  // the names of libraries in the mesh's file, in order
  std::vector<std::string> unread = {};     // those of them that were missing or could not be read; save names them
                                            // again
  std::vector<std::string> head = {};       // lines of the libraries before their first material

  bool empty() const { return materials.empty() && libraries.empty() && unread.empty() && head.empty(); }
  /// The first material of that name, or null.      Cost: O(number of materials).
  const material* find(std::string_view name) const {
    for (const material& m : materials)
      if (std::string_view(m.name) == name) return &m;
    return nullptr;
  }

  friend bool operator==(const material_table&, const material_table&) = default;
};

}  // namespace concino
