// Definitions of properties.hpp.
#pragma once

#include <concino/io/detail/properties.hpp>

#include <cstring>

namespace concino::detail {

[[gnu::noinline]] CONCINO_INLINE void set_values(property_set& all, element_kind kind, const char* name, const value_type& type, const void* values,
                        const std::vector<std::uint32_t>& where, std::size_t bound) {
  unsigned char* const to = static_cast<unsigned char*>(all.get(kind, name, type, bound)->data());
  const unsigned char* from = static_cast<const unsigned char*>(values);
  for (const std::uint32_t i : where) {
    std::memcpy(to + i * type.size, from, type.size);
    from += type.size;
  }
}

[[gnu::noinline, gnu::cold]] CONCINO_INLINE void set_vert_property(property_set& all, file_contents& contents, const std::vector<std::uint32_t>& where, std::size_t bound) {
  const auto give = [&](const char* name, const value_type& type, std::size_t n, const void* values) {
    if (n) set_values(all, element_kind::vert, name, type, values, where, bound);
  };
  give("label", values_of<int>, contents.vert_labels.size(), contents.vert_labels.data());
  give("color", values_of<rgba>, contents.vert_colors.size(), contents.vert_colors.values().data());
  give("normal", values_of<vec3>, contents.vert_normals.size(), contents.vert_normals.values().data());
  give("texture", values_of<std::array<double, 2>>, contents.vert_textures.size(), contents.vert_textures.values().data());
}

[[gnu::noinline, gnu::cold]] CONCINO_INLINE void set_names(property_set& all, const char* name, const name_runs& names, const std::vector<std::uint32_t>& where, std::size_t bound) {
  if (names.empty()) return;
  std::string* const to = static_cast<std::string*>(all.get(element_kind::poly, name, values_of<std::string>, bound)->data());
  names.for_each(where.size(), [&](std::size_t i, std::size_t end, std::string_view text) {
    for (; i != end; ++i) to[where[i]].assign(text.data(), text.size());
  });
}

[[gnu::noinline, gnu::cold]] CONCINO_INLINE void set_poly_property(property_set& all, file_contents& contents, const std::vector<std::uint32_t>& where, std::size_t bound) {
  const auto give = [&](const char* name, const value_type& type, std::size_t n, const void* values) {
    if (n) set_values(all, element_kind::poly, name, type, values, where, bound);
  };
  give("label", values_of<int>, contents.poly_labels.size(), contents.poly_labels.data());
  give("color", values_of<rgba>, contents.poly_colors.size(), contents.poly_colors.values().data());
  set_names(all, "object", contents.objects, where, bound);
  set_names(all, "group", contents.groups, where, bound);
  set_names(all, "material", contents.materials, where, bound);
}

[[gnu::noinline, gnu::cold]] CONCINO_INLINE void report_skipped(const file_contents& contents, load_report& report) {
  const auto skipped = [&](bool is_empty, const char* what) {
    if (!is_empty) report.skipped.push_back(what);
  };
  skipped(contents.vert_labels.empty(), "labels of verts");
  skipped(contents.vert_colors.empty(), "colours of verts");
  skipped(contents.vert_normals.empty(), "normals of verts");
  skipped(contents.vert_textures.empty(), "texture coordinates of verts");
  skipped(contents.poly_labels.empty(), "labels of polys");
  skipped(contents.poly_colors.empty(), "colours of polys");
  skipped(contents.objects.empty(), "names of objects");
  skipped(contents.groups.empty(), "names of groups");
  skipped(contents.materials.empty(), "names of materials");
  skipped(contents.table.materials.empty(), "definitions of materials in libraries");
}

}  // namespace concino::detail
