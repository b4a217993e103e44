// Materials of surfaces: what the libraries of a file say of them, kept whole from load to save.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace concino {

/// What a .mtl library says of one material. Polys name it by their property "material" (std::string).
struct material {
  std::string name = {};
  std::vector<std::string> lines =
      {};  // in order, without newmtl: "Kd 0.8 0.1 0", "Ns 20", comments, and lines that only other programs know

  friend bool operator==(const material&, const material&) = default;
};

/// The mesh property "materials": load makes it of all libraries that an .obj file names, save writes it.
/// Colours of polys are in their property "color" too, which decides where the two differ.
struct material_table {
  std::vector<material> materials = {};     // of two of one name the first counts
  std::vector<std::string> libraries = {};  // files that the mesh's file names, in order
  std::vector<std::string> unread = {};     // of these: files that were not there, or could not be read; save names them again
  std::vector<std::string> head = {};       // lines of the libraries before their first material

  bool empty() const { return materials.empty() && libraries.empty() && unread.empty() && head.empty(); }
  /// The first of that name, or null.      Cost: O(number of materials).
  const material* find(std::string_view name) const {
    for (const material& m : materials)
      if (std::string_view(m.name) == name) return &m;
    return nullptr;
  }

  friend bool operator==(const material_table&, const material_table&) = default;
};

}  // namespace concino
