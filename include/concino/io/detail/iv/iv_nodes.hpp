// The types of nodes of Open Inventor files that are read, and the groups that contain them.
#pragma once

#include <cstdint>
#include <string_view>

namespace concino::detail {

/// What the reader does with a node; `list`: the values in brackets.
enum class iv_node_kind : std::uint8_t { other, group, separator, coordinates, vertex_property, face_set, list };

/// The kind of a node of this type. Nodes of the kind `other` are skipped.
inline iv_node_kind iv_node_kind_of(std::string_view type) {
  if (type == "Coordinate3") return iv_node_kind::coordinates;
  if (type == "VertexProperty") return iv_node_kind::vertex_property;
  if (type == "IndexedFaceSet") return iv_node_kind::face_set;
  for (const std::string_view s : {"Separator", "Annotation", "Selection"})
    if (type == s) return iv_node_kind::separator;
  for (const std::string_view s :
       {"Group", "Switch", "TransformSeparator", "LevelOfDetail", "ShapeHints", "Info", "Label"})
    if (type == s) return iv_node_kind::group;
  return iv_node_kind::other;
}

}  // namespace concino::detail
