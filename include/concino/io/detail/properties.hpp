// Stores the values of elements in a file as properties of a mesh.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/contents.hpp>
#include <concino/mesh/property.hpp>

namespace concino::detail {

/// Sets the property `name` to values that are copied as bytes: the i-th value belongs to the element with index where[i].
void set_values(property_set& all, element_kind kind, const char* name, const value_type& type, const void* values,
                        const std::vector<std::uint32_t>& where, std::size_t bound);

void set_vert_property(property_set& all, file_contents& contents, const std::vector<std::uint32_t>& where, std::size_t bound);

void set_names(property_set& all, const char* name, const name_runs& names, const std::vector<std::uint32_t>& where, std::size_t bound);

void set_poly_property(property_set& all, file_contents& contents, const std::vector<std::uint32_t>& where, std::size_t bound);

void report_skipped(const file_contents& contents, load_report& report);

/// Sets the properties of a mesh from the values in a file, if the mesh can have properties: "label", "color", "normal", "texture", "object",
/// "group" and "material" of elements, "materials" of the mesh itself. The mesh has its elements in the order of the file.
template<class M>
void set_properties(M& m, file_contents& contents, load_report* report) {
  if constexpr (HasProperties<M>) {
    if (!contents.table.empty()) *mesh_property<material_table>(m, "materials") = std::move(contents.table);
    std::vector<std::uint32_t> where;
    if (!contents.vert_labels.empty() || !contents.vert_colors.empty() || !contents.vert_normals.empty() || !contents.vert_textures.empty()) {
      for (const vert_t<M> v : verts(m)) where.push_back(static_cast<std::uint32_t>(index_of(m, v)));
      set_vert_property(traits<M>::properties(m), contents, where, vert_index_bound(m));
      where.clear();
    }
    if (!contents.poly_labels.empty() || !contents.poly_colors.empty() || !contents.objects.empty() || !contents.groups.empty() ||
        !contents.materials.empty()) {
      for (const poly_t<M> p : polys(m)) where.push_back(static_cast<std::uint32_t>(index_of(m, p)));
      set_poly_property(traits<M>::properties(m), contents, where, poly_index_bound(m));
    }
  } else if (report) {
    report_skipped(contents, *report);
  }
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/properties.ipp>
#endif
