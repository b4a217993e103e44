// Bodies of properties.hpp: stores the values of elements in a file as properties of a mesh.
#pragma once

#include <concino/io/detail/cells/face_key.hpp>
#include <concino/io/detail/values/properties.hpp>

#include <algorithm>
#include <cstring>

namespace concino::detail {

CONCINO_INLINE void set_values(property_set& all, element_kind kind, const char* name, const value_type& type,
                               const void* values, const std::vector<std::uint32_t>& where, std::size_t bound) {
  unsigned char* const to = static_cast<unsigned char*>(all.get(kind, name, type, bound)->data());
  const unsigned char* from = static_cast<const unsigned char*>(values);
  for (const std::uint32_t i : where) {
    std::memcpy(to + i * type.size, from, type.size);
    from += type.size;
  }
}

CONCINO_INLINE void set_vert_property(property_set& all, file_contents& contents,
                                      const std::vector<std::uint32_t>& where, std::size_t bound) {
  const auto give = [&](const char* name, const value_type& type, std::size_t n, const void* values) {
    if (n) set_values(all, element_kind::vert, name, type, values, where, bound);
  };
  give("label", values_of<int>, contents.vert_labels.size(), contents.vert_labels.data());
  give("color", values_of<rgba>, contents.vert_colors.size(), contents.vert_colors.values().data());
  give("normal", values_of<vec3>, contents.vert_normals.size(), contents.vert_normals.values().data());
  give("texture", values_of<std::array<double, 2>>, contents.vert_textures.size(),
       contents.vert_textures.values().data());
}

CONCINO_INLINE void set_names(property_set& all, const char* name, const name_runs& names,
                              const std::vector<std::uint32_t>& where, std::size_t bound) {
  if (names.empty()) return;
  std::string* const to =
      static_cast<std::string*>(all.get(element_kind::poly, name, values_of<std::string>, bound)->data());
  names.for_each(where.size(), [&](std::size_t i, std::size_t end, std::string_view text) {
    for (; i != end; ++i) to[where[i]].assign(text.data(), text.size());
  });
}

CONCINO_INLINE void set_poly_property(property_set& all, file_contents& contents,
                                      const std::vector<std::uint32_t>& where, std::size_t bound) {
  const auto give = [&](const char* name, const value_type& type, std::size_t n, const void* values) {
    if (n) set_values(all, element_kind::poly, name, type, values, where, bound);
  };
  give("label", values_of<int>, contents.poly_labels.size(), contents.poly_labels.data());
  give("color", values_of<rgba>, contents.poly_colors.size(), contents.poly_colors.values().data());
  set_names(all, "object", contents.objects, where, bound);
  set_names(all, "group", contents.groups, where, bound);
  set_names(all, "material", contents.materials, where, bound);
}

CONCINO_INLINE void report_skipped(const file_contents& contents, load_report& report) {
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
  for (const property_column& c : contents.properties)
    report.skipped.push_back(core::joined({to_string(c.kind), " property \"", c.name, "\""}));
}

CONCINO_INLINE bool has_only_properties(const file_contents& c) {
  return c.table.empty() && c.vert_labels.empty() && c.vert_colors.empty() && c.vert_normals.empty() &&
         c.vert_textures.empty() && c.poly_labels.empty() && c.poly_colors.empty() && c.objects.empty() &&
         c.groups.empty() && c.materials.empty() && !has_columns(c, element_kind::edge) &&
         !has_columns(c, element_kind::corner);
}

CONCINO_INLINE bool has_columns(const file_contents& contents, element_kind kind) {
  for (const property_column& c : contents.properties)
    if (c.kind == kind) return true;
  return false;
}

CONCINO_INLINE void set_columns(property_set& all, file_contents& contents, element_kind kind,
                                const std::vector<std::uint32_t>& where, std::size_t bound, load_report* report) {
  const auto is_taken = [&](const std::string& name) {
    for (std::size_t i = 0; i < all.size(); ++i)
      if (const property_info p = all.info(i); p.kind == kind && p.name == name) return true;
    return false;
  };
  const auto missing = static_cast<std::size_t>(std::count(where.begin(), where.end(), ~0u));
  const auto is_used = [&](const std::string& name) {  // by a property, or by values that follow
    return is_taken(name) ||
           std::any_of(contents.properties.begin(), contents.properties.end(),
                       [&](const property_column& c) { return c.kind == kind && c.values && c.name == name; });
  };
  bool any = false;
  for (property_column& c : contents.properties) {
    if (c.kind != kind || !c.values) continue;
    std::string name = c.name;
    if (is_taken(name)) {
      for (unsigned n = 2; is_used(name); ++n) name = core::joined({c.name, "_", n});
      if (report)
        report->notes.push_back(core::joined(
            {"another ", to_string(kind), " property \"", c.name, "\" in the file is the property \"", name, "\""}));
    }
    const value_type& type = c.values->operations();
    const std::shared_ptr<column> to = all.get(kind, name, type, bound);
    const auto* from = static_cast<const unsigned char*>(c.values->data());
    auto* const first = static_cast<unsigned char*>(to->data());
    for (std::size_t i = 0, n = std::min(where.size(), c.values->size()); i < n; ++i) {
      if (where[i] == ~0u) continue;
      if (type.copy) replace_value(type, first + where[i] * type.size, from + i * type.size);
      else std::memcpy(first + where[i] * type.size, from + i * type.size, type.size);
    }
    any = true;
    c.values.reset();
  }
  if (any && missing && report)
    report->skipped.push_back(
        core::joined({"values of ", missing, " elements of kind ", to_string(kind), " that the mesh does not have"}));
}

CONCINO_INLINE element_finder::element_finder(const listed_elements& listed)
    : listed_(listed), where_(listed.size(), ~0u), next_(listed.size()) {
  keys_.reserve(listed.size());
  for (std::uint32_t i = 0; i < listed.size(); ++i)
    keys_.emplace_back(face_key(listed.verts.data() + listed.offsets[i], listed.offsets[i + 1] - listed.offsets[i]), i);
  std::sort(keys_.begin(), keys_.end());
}

/// Needs: sorted verts.
CONCINO_INLINE bool element_finder::is_same(std::uint32_t i) {
  sorted_.assign(listed_.verts.begin() + listed_.offsets[i], listed_.verts.begin() + listed_.offsets[i + 1]);
  std::sort(sorted_.begin(), sorted_.end());
  return sorted_ == verts;
}

CONCINO_INLINE void element_finder::match(std::size_t index) {
  std::sort(verts.begin(), verts.end());
  const std::uint64_t key = face_key(verts.data(), verts.size());
  auto at = std::lower_bound(keys_.begin(), keys_.end(), std::pair{key, 0u});
  const auto skip_others = [&] {
    while (at != keys_.end() && at->first == key && !is_same(at->second)) ++at;
    return at != keys_.end() && at->first == key;
  };
  if (skip_others()) {
    const auto first = at;
    at += next_[first->second];
    if (skip_others()) {
      where_[at->second] = static_cast<std::uint32_t>(index);
      next_[first->second] = static_cast<std::uint32_t>(at - first) + 1;
    }
  }
  verts.clear();
}

CONCINO_INLINE const std::vector<std::uint32_t>& element_finder::finish() {
  for (std::size_t k = 1; k < keys_.size(); ++k) {
    const std::uint32_t before = keys_[k - 1].second, i = keys_[k].second;
    if (keys_[k].first != keys_[k - 1].first || where_[i] != ~0u || where_[before] == ~0u) continue;
    verts.assign(listed_.verts.begin() + listed_.offsets[before], listed_.verts.begin() + listed_.offsets[before + 1]);
    std::sort(verts.begin(), verts.end());
    if (is_same(i)) where_[i] = where_[before];
  }
  return where_;
}

}  // namespace concino::detail
