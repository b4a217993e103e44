// The writer of Gmsh files, version 2.2, text and binary: surfaces of triangles and quads; volumes of tets, hexes,
// prisms and pyramids, recognised by their faces.
#pragma once

#include <concino/io/detail/gmsh/gmsh_format.hpp>
#include <concino/io/detail/gmsh/gmsh_listed.hpp>
#include <concino/io/detail/gmsh/gmsh_output.hpp>
#include <concino/io/label_names.hpp>

#include <limits>
#include <string_view>
#include <vector>

namespace concino::detail {

/// Version 2.2 is written, as all programs that read version 4.1 read it too, and many read no other. Besides, it holds
/// a label for each element, where version 4.1 holds one for each entity.
class gmsh_writer {
  write_context& c_;
  flat_mesh& m_;
  gmsh_lists lists_;
  gmsh_output out_;
  std::uint64_t num_moved_ = 0;  // elements whose entity has another tag

 public:
  gmsh_writer(write_context& c, flat_mesh& m) : c_(c), m_(m), lists_(c, m), out_(c.out, c.options.binary) {}

  void write() {
    declare_labels();
    collect_properties();
    lists_.collect();
    check_counts();
    out_.begin_file();
    write_names();
    write_nodes();
    write_elements();
    for (const gmsh_property& p : lists_.properties) write_property(p);
    if (lists_.num_large_faces)
      c_.report.lost.push_back(
          core::joined({"values of ", lists_.num_large_faces, " faces that are neither triangles nor quads"}));
    if (num_moved_)
      c_.report.lost.push_back(
          core::joined({"\"entity_tag\" of ", num_moved_,
                        " elements: tags are positive, and elements of one entity have one label"}));
  }

 private:
  static constexpr std::uint64_t max_tag_ = std::numeric_limits<std::int32_t>::max();

  void declare_labels() {
    for (const element_kind kind : {element_kind::poly, element_kind::face, element_kind::edge, element_kind::vert}) {
      if (kind == element_kind::face && m_.dimension == 2) continue;
      c_.declare_stored<int>(kind, "label");
      c_.declare_stored<int>(kind, "entity_tag");
      if (kind != element_kind::poly) c_.declare_stored<int>(kind, "entity");
    }
    c_.declare_stored<label_names>(element_kind::mesh, "label_names");
  }

  /// Whether it has the name of a label of elements, of whatever type.
  static bool is_label(const flat_property& p) {
    return p.name == "label" || p.name == "entity_tag" || (p.name == "entity" && p.kind != element_kind::poly);
  }
  static bool is_writable_name(std::string_view name) {
    return !name.empty() && name.find_first_of("\"\r\n") == name.npos;
  }

  /// Finds the properties that consist of 1, 3 or 9 numbers that are exact as doubles.
  void collect_properties() {
    std::vector<flat_property> all = m_.property_list();
    for (flat_property& p : m_.edge_property_list()) all.push_back(std::move(p));
    for (const element_kind kind : {element_kind::vert, element_kind::poly, element_kind::face, element_kind::edge})
      for (const flat_property& p : all) {
        const vtk_property_type t = vtk_type_of(*p.type);
        if (p.kind != kind || is_label(p) || !is_writable_name(p.name) || t.number == vtk_number::none ||
            t.number == vtk_number::int64 || t.number == vtk_number::uint64 ||
            (t.components != 1 && t.components != 3 && t.components != 9))
          continue;
        lists_.properties.push_back({kind,
                                     p.name,
                                     t,
                                     {static_cast<const unsigned char*>(p.values), p.indices},
                                     t.components * vtk_names_of(t.number).size});
        c_.declare_stored(kind, p.name, *p.type);
        if (t.number != vtk_number::float64)
          c_.report.lost.push_back(core::joined({to_string(kind), " property \"", p.name,
                                                 "\": its numbers are written as doubles, and read again as such"}));
      }
  }

  std::uint64_t num_elements() const {
    std::uint64_t n = 0;
    for (const gmsh_listed* l : lists()) n += l->elements.size();
    return n;
  }
  std::array<const gmsh_listed*, 4> lists() const {
    return {&lists_.of_polys, &lists_.of_faces, &lists_.of_edges, &lists_.of_verts};
  }

  void check_counts() {
    if (m_.points.size() > max_tag_ || num_elements() > max_tag_)
      c_.throw_cannot_hold(".msh", {"more than ", max_tag_, " verts or elements"}, ".vtu");
  }

  void write_names() {
    const label_names* const all = m_.mesh_value<label_names>("label_names");
    if (!all) return;
    std::vector<std::pair<int, const label_name*>> names;
    std::size_t num_lost = 0, num_lines = 0, num_long = 0;
    for (const label_name& n : all->names) {
      int dimension = -1;
      for (const gmsh_listed* const l : lists())
        if (l->kind == n.kind && (n.kind != element_kind::face || m_.dimension == 3)) dimension = l->dimension;
      if (dimension < 0 || n.name.find_first_of("\"\r\n") != n.name.npos) {
        ++num_lost;
        continue;
      }
      names.emplace_back(dimension, &n);
      num_lines += n.lines.size();
      num_long += n.name.size() > 127;
    }
    if (num_lost)
      c_.report.lost.push_back(
          core::joined({num_lost,
                        " names of labels: with line ends or quotation marks, or of elements that the mesh "
                        "does not have"}));
    if (num_lines) c_.report.lost.push_back(core::joined({num_lines, " lines about labels in \"label_names\""}));
    if (num_long)
      c_.report.notes.push_back(
          core::joined({num_long, " names of labels have more than the 127 bytes that Gmsh reads"}));
    if (names.empty()) return;
    out_.begin_section("PhysicalNames");
    out_.line(names.size());
    for (const auto& [dimension, n] : names) out_.group(dimension, n->label, n->name);
    out_.end_section("PhysicalNames");
  }

  void write_nodes() {
    out_.begin_section("Nodes");
    out_.line(m_.points.size());
    for (std::size_t v = 0; v < m_.points.size(); ++v) {
      const vec3& p = m_.points[v];
      out_.integer(static_cast<std::int64_t>(v) + 1);
      out_.real(p.x), out_.real(p.y), out_.real(p.z);
      out_.end_row();
      c_.report_progress();
    }
    out_.end_rows();
    out_.end_section("Nodes");
  }

  void write_elements() {
    out_.begin_section("Elements");
    out_.line(num_elements());
    std::int64_t tag = 1;
    for (const gmsh_listed* const l : lists()) {
      std::vector<gmsh_entity_key> keys;
      for (std::size_t i = 0; i < l->elements.size(); ++i) keys.push_back(l->key(i));
      const gmsh_entity_tags entities(keys);
      const vert_id* v = l->verts.data();
      for (std::size_t i = 0; i < keys.size(); ++i) {
        const gmsh_shape shape = l->shapes[i];
        if (c_.options.binary && (i == 0 || shape != l->shapes[i - 1])) {
          const auto same = std::find_if(l->shapes.begin() + static_cast<std::ptrdiff_t>(i), l->shapes.end(),
                                         [&](gmsh_shape s) { return s != shape; });
          out_.integer(linear_gmsh_type(shape));
          out_.integer(same - l->shapes.begin() - static_cast<std::ptrdiff_t>(i));
          out_.integer(2);
        }
        out_.integer(tag++);
        if (!c_.options.binary) out_.integer(linear_gmsh_type(shape)), out_.integer(2);
        const int entity = entities(keys[i]);
        num_moved_ += keys[i].entity != 0 && keys[i].entity != entity;
        out_.integer(keys[i].label), out_.integer(entity);
        for (const vert_id* const past = v + gmsh_type_of(linear_gmsh_type(shape)).nodes; v != past; ++v)
          out_.integer(std::int64_t{v->raw()} + 1);
        out_.end_row();
        if (l->kind == element_kind::poly) c_.report_progress();
      }
    }
    out_.end_rows();
    out_.end_section("Elements");
  }

  /// Writes the values of verts, or of all elements of a kind that are listed.
  void write_property(const gmsh_property& p) {
    const bool of_nodes = p.kind == element_kind::vert;
    std::int64_t tag = 1;
    const gmsh_listed* listed = nullptr;
    for (const gmsh_listed* const l : lists()) {
      if (l->kind == p.kind) {
        listed = l;
        break;
      }
      tag += static_cast<std::int64_t>(l->elements.size());
    }
    const std::size_t n = of_nodes ? m_.points.size() : listed->elements.size();
    if (n == 0) {
      const bool is_listed_by_value = p.kind == element_kind::face || p.kind == element_kind::edge;
      c_.report.lost.push_back(core::joined(
          {to_string(p.kind), " property \"", p.name,
           is_listed_by_value ? "\", which has default values only: .msh lists elements with other values"
                              : "\", which has no values"}));
      return;
    }
    const std::string_view section = of_nodes ? "NodeData" : "ElementData";
    out_.begin_section(section);
    out_.line(1);
    out_.quoted_line(p.name);
    out_.line(1), out_.line(0);  // the time
    out_.line(3), out_.line(0), out_.line(p.type.components), out_.line(n);
    for (std::size_t i = 0; i < n; ++i) {
      out_.integer(of_nodes ? static_cast<std::int64_t>(i) + 1 : tag + static_cast<std::int64_t>(i));
      p.for_each_number(of_nodes ? i : listed->elements[i], [&](double x) { out_.real(x); });
      out_.end_row();
    }
    out_.end_rows();
    out_.end_section(section);
  }
};

}  // namespace concino::detail

namespace concino {

inline void gmsh_format::write(write_context& c, flat_mesh& m) { detail::gmsh_writer(c, m).write(); }

}  // namespace concino
