// Recognises the XML formats of VTK by the beginning of a file.
#pragma once

#include <string_view>

namespace concino::detail {

/// Whether a text begins with a tag <VTKFile type="..."> of this type, perhaps after a declaration and comments.
inline bool is_vtk_xml(std::string_view text, std::string_view type) {
  text = text.substr(0, 4096);
  const std::size_t from = text.find("<VTKFile");
  if (from == text.npos || text.find('<') == text.npos) return false;
  const std::string_view before = text.substr(0, text.find('<'));
  if (before.find_first_not_of(" \t\r\n\xEF\xBB\xBF") != before.npos) return false;
  const std::string_view tag = text.substr(from, text.find('>', from) - from);
  const std::size_t value = tag.find("type=");
  return value != tag.npos && tag.substr(value + 6).starts_with(type) &&
         tag.substr(value + 6 + type.size()).find_first_of("\"'") == 0;
}

}  // namespace concino::detail
