// Writes surfaces as Wavefront OBJ, and the material library that holds the colours of their polys.
#pragma once

#include <concino/io/detail/write_mtl.hpp>

namespace concino::detail {

/// Names of polys on lines of their own, where they change.
class obj_names {
  write_state& c_;
  std::string_view keyword_;
  std::string last_;

 public:
  bool changed = false;

  obj_names(write_state& c, std::string_view keyword) : c_(c), keyword_(keyword) {}
  [[gnu::noinline]] void before_poly(const std::string& name) {
    if (std::string_view(name) == last_) return;
    last_ = name;
    c_.out << keyword_;
    if (!name.empty()) c_.out << ' ' << line_name(name, changed);
    c_.out << '\n';
  }
};

/// What says_number reads back.
inline std::string label_name(int label) {
  const std::uint64_t size = label < 0 ? 0 - static_cast<std::uint64_t>(label) : static_cast<std::uint64_t>(label);
  return core::joined({label < 0 ? "label_-" : "label_", size});
}

/// Whether a reader finds the labels again by numbering the names.
template<class M>
bool labels_number(const M& m, const std::string* names, const int* labels) {
  name_numbers number;
  for (const poly_t<M> p : polys(m))
    if (number(names[index_of(m, p)]) != labels[index_of(m, p)]) return false;
  return true;
}

template<class M>
void write_obj(write_context<M>& c) {
  if constexpr (dimension_v<M> == 3) {  // the format holds surfaces only
    c.cannot_hold(".obj", {"volumes"}, ".mesh or .hedra");
  } else {
    const M& m = c.mesh;
    const rgba* const vert_color = values_if_any<rgba>(m, element_kind::vert, "color");
    const std::string* const object = values_if_any<std::string>(m, element_kind::poly, "object");
    const std::string* const group = values_if_any<std::string>(m, element_kind::poly, "group");
    const int* const label = values_if_any<int>(m, element_kind::poly, "label");
    const bool labels_are_names = label && (group || object) && labels_number(m, group ? group : object, label);
    const bool labels_are_groups = label && !group && !labels_are_names;
    c.keep(element_kind::vert, "color", typeid(rgba));
    for (const char* const name : {"object", "group", "material"}) c.keep(element_kind::poly, name, typeid(std::string));
    if (labels_are_names || labels_are_groups) c.keep(element_kind::poly, "label", typeid(int));

    c.out << "# " << num_verts(m) << " verts, " << num_polys(m) << " polys\n";
    mtl_names material(c, values_if_any<std::string>(m, element_kind::poly, "material"), values_if_any<rgba>(m, element_kind::poly, "color"),
                       values_if_any<material_table>(m, element_kind::mesh, "materials"));
    if (material.any()) {
      for (const poly_t<M> p : polys(m)) material.register_poly(index_of(m, p));
      for (const poly_t<M> p : polys(m)) material.assign_material(index_of(m, p));
    }
    material.end();
    bool transparent = false;
    for (const vert_t<M> v : verts(m)) {
      c.out << "v ";
      write_point(c.out, c.next_point(v));
      if (vert_color) {
        const rgba& x = vert_color[index_of(m, v)];
        transparent = transparent || x.a != 1;
        for (const float part : {x.r, x.g, x.b}) {
          c.out << ' ';
          write_part(c.out, c.finite(part), false);
        }
      }
      c.out << '\n';
      c.tell();
    }
    obj_names objects(c, "o"), groups(c, "g"), materials(c, "usemtl");
    std::size_t walked = 0;
    for (const poly_t<M> p : polys(m)) {
      const std::size_t i = index_of(m, p);
      if (object) objects.before_poly(object[i]);
      if (group) groups.before_poly(group[i]);
      else if (labels_are_groups) groups.before_poly(label_name(label[i]));
      if (material.any()) materials.before_poly(material[walked++]);
      c.out << 'f';
      for (const vert_t<M> v : adj_p2v(m, p)) c.out << ' ' << c.number_of(v) + 1;
      c.out << '\n';
      c.tell();
    }
    if (transparent) c.report.lost.push_back("opacity of verts: .obj has no place for it");
    if (objects.changed || groups.changed || material.changed)
      c.report.lost.push_back("names of polys that no line of .obj can hold: they were changed");
  }
}

}  // namespace concino::detail
