// Properties on their way into files and out of them.
#pragma once

#include <concino/io/contents.hpp>
#include <concino/mesh/property.hpp>

namespace concino::detail {

/// Labels of the file as the property "label", where the mesh can have properties. Elements are walked in the order of the file.
template<class M>
void give_labels(M& m, const file_contents& contents, load_report* report) {
  const auto give = [](const std::vector<int>& labels, const auto& elements, const auto& property) {
    std::size_t i = 0;
    for (auto x : elements) property[x] = labels[i++];
  };
  if constexpr (HasProperties<M>) {
    if (!contents.vert_labels.empty()) give(contents.vert_labels, verts(m), vert_property<int>(m, "label"));
    if (!contents.poly_labels.empty()) give(contents.poly_labels, polys(m), poly_property<int>(m, "label"));
  } else if (report) {
    if (!contents.vert_labels.empty()) report->skipped.push_back("labels of verts");
    if (!contents.poly_labels.empty()) report->skipped.push_back("labels of polys");
  }
}

inline bool is_label(const property_info& p) {
  return p.name == "label" && *p.type == typeid(int) && (p.kind == element_kind::vert || p.kind == element_kind::poly);
}

/// What to ask for the label of a vert or poly: the property "label" if there is one of int, else 0.
template<element_kind Kind, class M>
auto int_labels(const M& m) {
  if constexpr (HasProperties<M>) {
    bool has = false;
    for (const property_info& p : property_list(m)) has = has || (p.kind == Kind && is_label(p));
    if constexpr (Kind == element_kind::vert) {
      const auto labels = has ? find_vert_property<int>(m, "label") : property_map<vert_t<M>, const int>{};
      return [labels](const vert_t<M>& v) { return labels ? labels[v] : 0; };
    } else {
      const auto labels = has ? find_poly_property<int>(m, "label") : property_map<poly_t<M>, const int>{};
      return [labels](const poly_t<M>& p) { return labels ? labels[p] : 0; };
    }
  } else {
    return [](const auto&) { return 0; };
  }
}

/// Says which properties of m a format drops.
template<class M>
void tell_of_lost_properties(const M& m, bool keeps_labels, std::string_view format, std::vector<std::string>& lost) {
  if constexpr (HasProperties<M>)
    for (const property_info& p : property_list(m))
      if (!keeps_labels || !is_label(p))
        lost.push_back(std::string(to_string(p.kind)) + " property \"" + p.name + "\": " + std::string(format) + " has no place for it");
}

}  // namespace concino::detail
