// Stores the values of elements in a file as properties of a mesh.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/formats/contents.hpp>
#include <concino/mesh/corner_property.hpp>
#include <concino/mesh/property.hpp>

#include <cassert>

namespace concino::detail {

/// Sets the property `name` to values that are copied as bytes: the i-th value belongs to the element with index
/// where[i].
void set_values(property_set& all, element_kind kind, const char* name, const value_type& type, const void* values,
                        const std::vector<std::uint32_t>& where, std::size_t bound);

void set_vert_property(property_set& all, file_contents& contents, const std::vector<std::uint32_t>& where,
                       std::size_t bound);

void set_names(property_set& all, const char* name, const name_runs& names, const std::vector<std::uint32_t>& where,
               std::size_t bound);

void set_poly_property(property_set& all, file_contents& contents, const std::vector<std::uint32_t>& where,
                       std::size_t bound);

void report_skipped(const file_contents& contents, load_report& report);

/// Whether contents.properties has columns of a kind.
bool has_columns(const file_contents& contents, element_kind kind);
/// Whether there are no other values than contents.properties, and none of edges and corners.
bool has_only_properties(const file_contents& contents);

/// Sets the properties of contents.properties of a kind, and frees their columns. The i-th value belongs to the element
/// with index where[i]; it is skipped if that is ~0u.
void set_columns(property_set& all, file_contents& contents, element_kind kind, const std::vector<std::uint32_t>& where,
                 std::size_t bound, load_report* report);

/// Finds listed elements by their verts, in any order.
class element_finder {
  const listed_elements& listed_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys_;  // of the listed elements: face_key and number, sorted
  std::vector<vert_id> sorted_;
  std::vector<std::uint32_t> where_;
  std::vector<std::uint32_t> next_;  // by the first listed element with some verts: the number of entries of keys_
                                     // behind it up to the next one to be found

  bool is_same(std::uint32_t i);

 public:
  std::vector<vert_id> verts;  // of the element to find, filled by the caller

  explicit element_finder(const listed_elements& listed);

  /// Finds the element with these verts, which has this index in the mesh, and clears them. Where several elements of
  /// the mesh have the same verts, the second one belongs to the second listed element, and so on.
  void match(std::size_t index);
  /// The index in the mesh of each listed element; ~0u if it was not found. If more elements are listed with some verts
  /// than the mesh has, the others are the last one.
  const std::vector<std::uint32_t>& finish();
};

template<class M>
void set_columns_of_corners(M& m, file_contents& contents, std::vector<std::uint32_t>& where, load_report* report) {
  if constexpr (NumbersCorners<M>) {
    for (const poly_t<M> p : polys(m))
      for (std::size_t k = 0, n = num_elements(adj_p2v(m, p)); k < n; ++k)
        where.push_back(static_cast<std::uint32_t>(traits<M>::first_corner(m, p) + k));
    set_columns(traits<M>::properties(m), contents, element_kind::corner, where, traits<M>::corner_index_bound(m),
                report);
    where.clear();
  }
}

/// Needs: columns of verts, faces, polys and the mesh only, if OfPolys.
template<bool OfPolys, class M>
void set_all_columns(M& m, file_contents& contents, load_report* report) {
  property_set& all = traits<M>::properties(m);
  std::vector<std::uint32_t> where;
  if (has_columns(contents, element_kind::vert)) {
    for (const vert_t<M> v : verts(m)) where.push_back(static_cast<std::uint32_t>(index_of(m, v)));
    set_columns(all, contents, element_kind::vert, where, vert_index_bound(m), report);
    where.clear();
  }
  if (has_columns(contents, element_kind::poly)) {
    for (const poly_t<M> p : polys(m)) where.push_back(static_cast<std::uint32_t>(index_of(m, p)));
    set_columns(all, contents, element_kind::poly, where, poly_index_bound(m), report);
    where.clear();
  }
  [[maybe_unused]] const auto number_of = [&](const auto& v) { return static_cast<std::uint32_t>(index_of(m, v)); };
  if constexpr (!OfPolys) {
    if (has_columns(contents, element_kind::corner)) set_columns_of_corners(m, contents, where, report);
    if (has_columns(contents, element_kind::edge)) {
      element_finder finder(contents.edges);
      for (const edge_t<M> e : edges(m)) {
        for (const vert_t<M> v : adj_e2v(m, e)) finder.verts.push_back(vert_id{number_of(v)});
        finder.match(index_of(m, e));
      }
      set_columns(all, contents, element_kind::edge, finder.finish(), edge_index_bound(m), report);
    }
  }
  if constexpr (dimension_v<M> == 3) {  // surfaces have no faces
    if (has_columns(contents, element_kind::face) && contents.lists_all_faces) {
      for (const face_t<M> f : faces(m)) where.push_back(number_of(f));
      set_columns(all, contents, element_kind::face, where, face_index_bound(m), report);
    } else if (has_columns(contents, element_kind::face)) {
      element_finder finder(contents.faces);
      for (const face_t<M> f : faces(m)) {
        for (const vert_t<M> v : adj_f2v(m, f)) finder.verts.push_back(vert_id{number_of(v)});
        finder.match(index_of(m, f));
      }
      set_columns(all, contents, element_kind::face, finder.finish(), face_index_bound(m), report);
    }
  }
  set_columns(all, contents, element_kind::mesh, {0}, 1, report);
}

/// Sets the properties of a mesh from the values in a file, if the mesh can have properties: "label", "color",
/// "normal", "texture", "object", "group" and "material" of elements, "materials" of the mesh itself, and those of
/// contents.properties. The mesh has its elements in the order of the file.
/// OnlyProperties: the formats of the program have nothing but contents.properties of verts, faces, polys and the mesh;
/// the rest is not compiled.
template<bool OnlyProperties = false, class M>
void set_properties(M& m, file_contents& contents, load_report* report) {
  if constexpr (HasProperties<M> && OnlyProperties) {
    assert(has_only_properties(contents));
    if (!contents.properties.empty()) set_all_columns<true>(m, contents, report);
  } else if constexpr (HasProperties<M>) {
    if (!contents.table.empty()) *mesh_property<material_table>(m, "materials") = std::move(contents.table);
    std::vector<std::uint32_t> where;
    if (!contents.vert_labels.empty() || !contents.vert_colors.empty() || !contents.vert_normals.empty() ||
        !contents.vert_textures.empty()) {
      for (const vert_t<M> v : verts(m)) where.push_back(static_cast<std::uint32_t>(index_of(m, v)));
      set_vert_property(traits<M>::properties(m), contents, where, vert_index_bound(m));
      where.clear();
    }
    if (!contents.poly_labels.empty() || !contents.poly_colors.empty() || !contents.objects.empty() ||
        !contents.groups.empty() || !contents.materials.empty()) {
      for (const poly_t<M> p : polys(m)) where.push_back(static_cast<std::uint32_t>(index_of(m, p)));
      set_poly_property(traits<M>::properties(m), contents, where, poly_index_bound(m));
    }
    if (!contents.properties.empty()) set_all_columns<false>(m, contents, report);
  } else if (report) {
    report_skipped(contents, *report);
  }
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/values/properties.ipp>
#endif
