// The writer of Wavefront OBJ: surfaces, and the material library with the colours of their polys.
#pragma once

#include <concino/io/detail/obj/obj_corner_values.hpp>
#include <concino/io/detail/obj/obj_format.hpp>
#include <concino/io/detail/obj/write_mtl.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

/// The name of a poly (object, group, material) in the form that a line can hold. Sets `changed` if it differs. Only
/// names that look like labels do so afterwards: a reader takes groups with such names for labels.
inline std::string written_name(const std::string& name, bool& changed) {
  if (name.empty()) return name;
  std::string written = line_name(name, changed);
  if (int label = 0; written != name && is_number(written, "label_", label)) written.insert(0, "_");
  return written;
}

/// Writes a line with the name of a poly whenever it changes.
class obj_names {
  write_context& c_;
  std::string_view keyword_;
  std::string last_, last_written_;  // as the mesh has it, and as the file has it

 public:
  bool changed = false;

  obj_names(write_context& c, std::string_view keyword) : c_(c), keyword_(keyword) {}
  void before_poly(const std::string& name) {
    if (std::string_view(name) == last_) return;
    last_ = name;
    std::string written = written_name(name, changed);
    if (written == last_written_) return;
    last_written_ = std::move(written);
    c_.out << keyword_;
    if (!name.empty()) c_.out << ' ' << last_written_;
    c_.out << '\n';
  }
};

/// The name of a group for a label, which is_number recognises.
inline std::string label_name(int label) {
  const std::uint64_t size = label < 0 ? 0 - static_cast<std::uint64_t>(label) : static_cast<std::uint64_t>(label);
  return core::joined({label < 0 ? "label_-" : "label_", size});
}

/// Whether the labels are equal to the numbers that a reader would assign to the names, some of which may be equal in
/// the file only.
inline bool labels_number(std::size_t polys, const flat_values<std::string>& names, const flat_values<int>& labels) {
  name_numbers number;
  bool ignored = false;
  int last = 0;
  for (std::size_t p = 0; p < polys; ++p) {
    if (p == 0 || std::string_view(names[p]) != names[p - 1]) last = number(written_name(names[p], ignored));
    if (last != labels[p]) return false;
  }
  return true;
}

/// The distinct values of a property of corners, and the one of each corner, numbered from 1; 0: the corner has none.
template<class T>
class obj_corner_numbers {
  distinct_corner_values<T> distinct_;
  std::vector<std::uint32_t> number_;

 public:
  std::size_t num_not_finite = 0;

  obj_corner_numbers(const flat_values<T>& property, std::size_t corners) {
    for (std::size_t k = 0; property && k < corners; ++k) {
      const T& x = property[k];
      number_.push_back(is_finite(x) ? distinct_.add(x) + 1 : 0);
      num_not_finite += number_.back() == 0 && !is_no_corner_value(x);
    }
  }
  const std::vector<T>& values() const { return distinct_.values(); }
  std::uint32_t operator[](std::size_t corner) const { return number_.empty() ? 0 : number_[corner]; }
};

/// Writes the lines of texture coordinates and normals, and then what follows the vert of each corner.
class obj_corners {
  write_context& c_;
  obj_corner_numbers<texture_point> texture_;
  obj_corner_numbers<vec3> normal_;

 public:
  obj_corners(write_context& c, flat_mesh& m)
      : c_(c),
        texture_(m.corner_values<texture_point>("texture"), m.poly_verts.values.size()),
        normal_(m.corner_values<vec3>("normal"), m.poly_verts.values.size()) {
    c.declare_stored<texture_point>(element_kind::corner, "texture");
    c.declare_stored<vec3>(element_kind::corner, "normal");
    if (const std::size_t n = texture_.num_not_finite + normal_.num_not_finite)
      c.report.lost.push_back(core::joined({n, " texture coordinates or normals of corners that are not finite"}));
  }
  void write_values() {
    for (const texture_point& t : texture_.values()) c_.out << "vt " << t[0] << ' ' << t[1] << '\n';
    for (const vec3& n : normal_.values()) {
      c_.out << "vn ";
      write_point(c_.out, n);
      c_.out << '\n';
    }
  }
  bool any() const { return !texture_.values().empty() || !normal_.values().empty(); }
  void after_vert(std::size_t corner) {
    const std::uint32_t t = texture_[corner], n = normal_[corner];
    if (t) c_.out << '/' << t;
    if (n) c_.out << (t ? "/" : "//") << n;
  }
};

/// Whether a component that can be written is larger than 1. Readers then take whole numbers for components from 0 to
/// 255.
inline bool has_large_component(const flat_values<rgba>& color, std::size_t num_verts) {
  for (std::size_t v = 0; v < num_verts; ++v)
    for (const float x : {color[v].r, color[v].g, color[v].b})
      if (x > 1 && std::isfinite(x)) return true;
  return false;
}

/// Writes the lines of verts. Returns whether the colour of one is not opaque.
inline bool write_obj_verts(write_context& c, const flat_mesh& m, const flat_values<rgba>& color) {
  bool transparent = false;
  const bool has_large = color && has_large_component(color, m.points.size());
  for (std::size_t v = 0; v < m.points.size(); ++v) {
    c.out << "v ";
    write_point(c.out, m.points[v]);
    if (color) {
      const rgba& x = color[v];
      transparent = transparent || x.a != 1;
      for (const float part : {x.r, x.g, x.b}) {
        c.out << ' ';
        write_float(c.out, c.finite(part), has_large);
      }
    }
    c.out << '\n';
    c.report_progress();
  }
  return transparent;
}

}  // namespace concino::detail

namespace concino {

inline void obj_format::write(write_context& c, flat_mesh& m) {
  const flat_values<rgba> vert_color = m.vert_values<rgba>("color");
  const flat_values<std::string> object = m.poly_values<std::string>("object");
  const flat_values<std::string> group = m.poly_values<std::string>("group");
  const flat_values<int> label = m.poly_values<int>("label");
  const bool labels_are_names =
      label && (group || object) && detail::labels_number(m.num_polys, group ? group : object, label);
  const bool labels_are_groups = label && !group && !labels_are_names;
  c.declare_stored<rgba>(element_kind::vert, "color");
  for (const char* const of_polys : {"object", "group", "material"})
    c.declare_stored<std::string>(element_kind::poly, of_polys);
  if (labels_are_names || labels_are_groups) c.declare_stored<int>(element_kind::poly, "label");

  c.out << "# " << m.points.size() << " verts, " << m.num_polys << " polys\n";
  detail::material_library_file* library = nullptr;
  if (!c.path.empty()) {
    auto library_file = std::make_unique<detail::material_library_file>(std::string(c.path), c.options.sync);
    library = library_file.get();
    c.companions = std::move(library_file);
  }
  detail::mtl_names material(c, library, m.poly_values<std::string>("material"), m.poly_values<rgba>("color"),
                             m.mesh_value<material_table>("materials"));
  for (std::size_t p = 0; material.any() && p < m.num_polys; ++p) material.register_poly(p);
  for (std::size_t p = 0; material.any() && p < m.num_polys; ++p) material.assign_material(p);
  material.end();
  const bool transparent = detail::write_obj_verts(c, m, vert_color);
  detail::obj_corners corners(c, m);
  corners.write_values();
  std::size_t corner = 0;
  detail::obj_names objects(c, "o"), groups(c, "g"), materials(c, "usemtl");
  for (std::size_t p = 0; p < m.num_polys; ++p) {
    if (object) objects.before_poly(object[p]);
    if (group) groups.before_poly(group[p]);
    else if (labels_are_groups) groups.before_poly(detail::label_name(label[p]));
    if (material.any()) materials.before_poly(material[p]);
    c.out << 'f';
    for (const vert_id v : m.poly_verts[p]) {
      c.out << ' ' << v.raw() + 1;
      if (corners.any()) corners.after_vert(corner++);
    }
    c.out << '\n';
    c.report_progress();
  }
  if (transparent) c.report.lost.push_back("opacity of verts: .obj cannot store it");
  if (objects.changed || groups.changed || material.changed)
    c.report.lost.push_back("names of polys that do not fit into a line of .obj: they were changed");
}

}  // namespace concino
