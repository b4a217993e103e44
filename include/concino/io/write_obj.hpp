// Writes surfaces as Wavefront OBJ, and the material library that holds the colours of their polys.
#pragma once

#include <concino/io/write_common.hpp>
#include <concino/io/write_mtl.hpp>

namespace concino::detail {

/// Names of polys on lines of their own, where they change.
template<class M>
class obj_names {
  write_context<M>& c_;
  std::string_view keyword_;
  std::string last_;

 public:
  bool changed = false;

  obj_names(write_context<M>& c, std::string_view keyword) : c_(c), keyword_(keyword) {}
  void before_poly(const std::string& name) {
    if (name == last_) return;
    last_ = name;
    c_.out << keyword_;
    if (!name.empty()) c_.out << ' ' << line_name(name, changed);
    c_.out << '\n';
  }
};

/// Whether a reader finds the labels again by numbering the names.
template<class M, class Names, class Labels>
bool labels_number(const M& m, const Names& names, const Labels& labels) {
  name_numbers number;
  for (poly_t<M> p : polys(m))
    if (number(std::string(names[p])) != labels[p]) return false;
  return true;
}

template<class M>
void write_obj(write_context<M>& c) {
  if constexpr (dimension_v<M> == 3) {
    throw_cannot_hold(c.name, ".obj", "volumes", ".mesh or .hedra");
  } else {
    const M& m = c.mesh;
    const auto vert_color = property_if_any<element_kind::vert, rgba>(m, "color");
    const auto object = property_if_any<element_kind::poly, std::string>(m, "object");
    const auto group = property_if_any<element_kind::poly, std::string>(m, "group");
    const auto label = property_if_any<element_kind::poly, int>(m, "label");
    const bool labels_are_names = label && (group ? labels_number(m, group, label) : object && labels_number(m, object, label));
    const bool labels_are_groups = label && !group && !labels_are_names;
    c.template keep<rgba>(element_kind::vert, "color");
    for (const char* const name : {"object", "group", "material"}) c.template keep<std::string>(element_kind::poly, name);
    if (labels_are_names || labels_are_groups) c.template keep<int>(element_kind::poly, "label");

    c.out << "# " << static_cast<std::size_t>(num_verts(m)) << " verts, " << static_cast<std::size_t>(num_polys(m)) << " polys\n";
    mtl_names<M> material(c);
    bool transparent = false;
    write_points(c, "v ", [&](const vert_t<M>& v) {
      if (!vert_color) return;
      const rgba x = vert_color[v];
      transparent = transparent || x.a != 1;
      for (const float part : {x.r, x.g, x.b}) {
        c.out << ' ';
        write_part(c.out, c.finite(part), false);
      }
    });
    obj_names<M> objects(c, "o"), groups(c, "g"), materials(c, "usemtl");
    for (poly_t<M> p : polys(m)) {
      if (object) objects.before_poly(object[p]);
      if (group) groups.before_poly(group[p]);
      else if (labels_are_groups) groups.before_poly("label_" + std::to_string(label[p]));
      if (material) materials.before_poly(material(p));
      c.out << 'f';
      for (vert_t<M> v : adj_p2v(m, p)) c.out << ' ' << c.number_of(v) + 1;
      c.out << '\n';
      c.tell();
    }
    if (transparent) c.report.lost.push_back("opacity of verts: .obj has no place for it");
    if (objects.changed || groups.changed || material.changed)
      c.report.lost.push_back("names of polys that no line of .obj can hold: they were changed");
    material.end();
  }
}

}  // namespace concino::detail
