// The writer of Wavefront OBJ: surfaces, and the material library with the colours of their polys.
#pragma once

#include <concino/io/detail/obj_format.hpp>
#include <concino/io/detail/write_mtl.hpp>

namespace concino::detail {

/// Writes a line with the name of a poly (object, group, material) whenever it changes.
class obj_names {
  write_context& c_;
  std::string_view keyword_;
  std::string last_;

 public:
  bool changed = false;

  obj_names(write_context& c, std::string_view keyword) : c_(c), keyword_(keyword) {}
  [[gnu::noinline]] void before_poly(const std::string& name) {
    if (std::string_view(name) == last_) return;
    last_ = name;
    c_.out << keyword_;
    if (!name.empty()) c_.out << ' ' << line_name(name, changed);
    c_.out << '\n';
  }
};

/// The name of a group for a label, which is_number recognises.
inline std::string label_name(int label) {
  const std::uint64_t size = label < 0 ? 0 - static_cast<std::uint64_t>(label) : static_cast<std::uint64_t>(label);
  return core::joined({label < 0 ? "label_-" : "label_", size});
}

/// Whether the labels are equal to the numbers that a reader would assign to the names.
inline bool labels_number(std::size_t polys, const flat_values<std::string>& names, const flat_values<int>& labels) {
  name_numbers number;
  for (std::size_t p = 0; p < polys; ++p)
    if (number(names[p]) != labels[p]) return false;
  return true;
}

}  // namespace concino::detail

namespace concino {

inline void obj_format::write(write_context& c, flat_mesh& m) {
  const flat_values<rgba> vert_color = m.vert_values<rgba>("color");
  const flat_values<std::string> object = m.poly_values<std::string>("object");
  const flat_values<std::string> group = m.poly_values<std::string>("group");
  const flat_values<int> label = m.poly_values<int>("label");
  const bool labels_are_names = label && (group || object) && detail::labels_number(m.num_polys, group ? group : object, label);
  const bool labels_are_groups = label && !group && !labels_are_names;
  c.declare_stored<rgba>(element_kind::vert, "color");
  for (const char* const of_polys : {"object", "group", "material"}) c.declare_stored<std::string>(element_kind::poly, of_polys);
  if (labels_are_names || labels_are_groups) c.declare_stored<int>(element_kind::poly, "label");

  c.out << "# " << m.points.size() << " verts, " << m.num_polys << " polys\n";
  detail::material_library_file* library = nullptr;
  if (!c.path.empty()) {
    auto library_file = std::make_unique<detail::material_library_file>(std::string(c.path), c.options.sync);
    library = library_file.get();
    c.companions = std::move(library_file);
  }
  detail::mtl_names material(c, library, m.poly_values<std::string>("material"), m.poly_values<rgba>("color"), m.mesh_value<material_table>("materials"));
  if (material.any()) {
    for (std::size_t p = 0; p < m.num_polys; ++p) material.register_poly(p);
    for (std::size_t p = 0; p < m.num_polys; ++p) material.assign_material(p);
  }
  material.end();
  bool transparent = false;
  for (std::size_t v = 0; v < m.points.size(); ++v) {
    c.out << "v ";
    detail::write_point(c.out, m.points[v]);
    if (vert_color) {
      const rgba& x = vert_color[v];
      transparent = transparent || x.a != 1;
      for (const float part : {x.r, x.g, x.b}) {
        c.out << ' ';
        detail::write_part(c.out, c.finite(part), false);
      }
    }
    c.out << '\n';
    c.report_progress();
  }
  detail::obj_names objects(c, "o"), groups(c, "g"), materials(c, "usemtl");
  for (std::size_t p = 0; p < m.num_polys; ++p) {
    if (object) objects.before_poly(object[p]);
    if (group) groups.before_poly(group[p]);
    else if (labels_are_groups) groups.before_poly(detail::label_name(label[p]));
    if (material.any()) materials.before_poly(material[p]);
    c.out << 'f';
    for (const vert_id v : m.poly_verts[p]) c.out << ' ' << v.raw() + 1;
    c.out << '\n';
    c.report_progress();
  }
  if (transparent) c.report.lost.push_back("opacity of verts: .obj cannot store it");
  if (objects.changed || groups.changed || material.changed)
    c.report.lost.push_back("names of polys that do not fit into a line of .obj: they were changed");
}

}  // namespace concino
