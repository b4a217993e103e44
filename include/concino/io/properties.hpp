// Properties on their way into files and out of them.
#pragma once

#include <concino/io/contents.hpp>
#include <concino/mesh/property.hpp>

namespace concino::detail {

/// What the file says about elements as properties, where the mesh can have them: "label", "color", "normal", "texture", "object", "group",
/// "material". Elements are walked in the order of the file.
template<class M>
void give_properties(M& m, const file_contents& contents, load_report* report) {
  if constexpr (HasProperties<M>) {
    const auto give = [](const auto& values, const auto& elements, const auto& property) {
      std::size_t i = 0;
      for (auto x : elements) property[x] = values[i++];
    };
    const auto give_names = [&](const name_runs& names, const char* name) {
      const auto property = poly_property<std::string>(m, name);
      const auto& all = polys(m);
      auto p = all.begin();
      names.for_each(static_cast<std::size_t>(num_polys(m)), [&](std::size_t i, std::size_t end, std::string_view text) {
        for (; i != end; ++i, ++p) property[*p] = text;
      });
    };
    if (!contents.vert_labels.empty()) give(contents.vert_labels, verts(m), vert_property<int>(m, "label"));
    if (!contents.vert_colors.empty()) give(contents.vert_colors, verts(m), vert_property<rgba>(m, "color"));
    if (!contents.vert_normals.empty()) give(contents.vert_normals, verts(m), vert_property<vec3>(m, "normal"));
    if (!contents.vert_textures.empty()) give(contents.vert_textures, verts(m), vert_property<std::array<double, 2>>(m, "texture"));
    if (!contents.poly_labels.empty()) give(contents.poly_labels, polys(m), poly_property<int>(m, "label"));
    if (!contents.poly_colors.empty()) give(contents.poly_colors, polys(m), poly_property<rgba>(m, "color"));
    if (!contents.objects.empty()) give_names(contents.objects, "object");
    if (!contents.groups.empty()) give_names(contents.groups, "group");
    if (!contents.materials.empty()) give_names(contents.materials, "material");
  } else if (report) {
    const auto skipped = [&](const auto& values, const char* what) {
      if (!values.empty()) report->skipped.push_back(what);
    };
    skipped(contents.vert_labels, "labels of verts");
    skipped(contents.vert_colors, "colours of verts");
    skipped(contents.vert_normals, "normals of verts");
    skipped(contents.vert_textures, "texture coordinates of verts");
    skipped(contents.poly_labels, "labels of polys");
    skipped(contents.poly_colors, "colours of polys");
    skipped(contents.objects, "names of objects");
    skipped(contents.groups, "names of groups");
    skipped(contents.materials, "names of materials");
  }
}

/// In the place of a property that is not there.
template<class T>
struct no_property {
  explicit operator bool() const { return false; }
  template<class X>
  T operator[](const X&) const {
    return T{};
  }
};

/// The property of that name and type, to be read; tests false if there is none or it is of another type.
template<element_kind Kind, class T, class M>
auto property_if_any(const M& m, std::string_view name) {
  if constexpr (HasProperties<M>) {
    bool has = false;
    for (const property_info& p : property_list(m)) has = has || (p.kind == Kind && p.name == name && *p.type == typeid(T));
    if constexpr (Kind == element_kind::vert) return has ? find_vert_property<T>(m, name) : property_map<vert_t<M>, const T>{};
    else return has ? find_poly_property<T>(m, name) : property_map<poly_t<M>, const T>{};
  } else {
    return no_property<T>{};
  }
}

/// What to ask for the label of a vert or poly: the property "label" if there is one of int, else 0.
template<element_kind Kind, class M>
auto int_labels(const M& m) {
  return [labels = property_if_any<Kind, int>(m, "label")](const auto& x) { return labels ? labels[x] : 0; };
}

/// What a format keeps of the properties of m.
struct kept_property {
  element_kind kind;
  std::string_view name;
  const std::type_info* type;
};

/// Says which properties of m a format drops: all but those in `kept`.
template<class M>
void tell_of_lost_properties(const M& m, const std::vector<kept_property>& kept, std::string_view format, std::vector<std::string>& lost) {
  if constexpr (HasProperties<M>)
    for (const property_info& p : property_list(m)) {
      bool is_kept = false;
      for (const kept_property& k : kept) is_kept = is_kept || (p.kind == k.kind && p.name == k.name && *p.type == *k.type);
      if (!is_kept)
        lost.push_back(std::string(to_string(p.kind)) + " property \"" + p.name + "\": " + std::string(format) + " has no place for it");
    }
}

}  // namespace concino::detail
