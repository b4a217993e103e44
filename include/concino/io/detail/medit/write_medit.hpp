// The writer of MEDIT files, text and binary: surfaces of triangles and quads; volumes of tets, hexes, prisms and
// pyramids, recognised by their faces.
#pragma once

#include <concino/io/detail/cells/recognised_cells.hpp>
#include <concino/io/detail/medit/medit_format.hpp>
#include <concino/io/detail/medit/medit_output.hpp>
#include <concino/io/detail/text/write_common.hpp>

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace concino::detail {

class medit_writer {
  static constexpr std::size_t num_shapes = 6;  // the sections of polys, the first of the table
  using element_list = std::vector<std::uint32_t>;

  write_context& c_;
  flat_mesh& m_;
  medit_output out_;

  // the polys in the order of the mesh: the section of each, and its verts in the order of the format
  std::vector<std::uint8_t> section_;
  std::vector<vert_id> verts_;
  std::size_t num_of_[num_shapes] = {};

  element_list edges_, faces_[2], normals_;  // the elements that are listed: edges; triangles and quads of a volume;
                                             // verts with a normal
  std::uint64_t num_odd_ = 0;                // marks other than 0 and 1
  std::uint64_t num_large_ = 0;              // faces of more than four verts that have a value

 public:
  medit_writer(write_context& c, flat_mesh& m, bool binary) : c_(c), m_(m), out_(c.out, binary) {}

  void write() {
    declare();
    collect_polys();
    collect_listed();
    announce();
    out_.begin_file();
    while (out_.has_next()) write_section(out_.begin());
    out_.end_file();
    std::size_t kinds = 0;
    for (const std::size_t n : num_of_) kinds += n > 0;
    if (kinds > 1)
      c_.report.notes.push_back("the file lists polys of one shape after those of another: their order changed");
    if (num_large_)
      c_.report.lost.push_back(core::joined({"values of ", num_large_, " faces that are neither triangles nor quads"}));
    if (num_odd_)
      c_.report.lost.push_back(core::joined(
          {num_odd_,
           " marks of elements (\"corner\", \"required\", \"ridge\", \"entity\") that are neither 0 nor 1: written as 1"}));
  }

 private:
  void declare() {
    for (const char* const name : {"label", "corner", "required"}) c_.declare_stored<int>(element_kind::vert, name);
    for (const char* const name : {"label", "ridge", "required", "entity"})
      c_.declare_stored<int>(element_kind::edge, name);
    c_.declare_stored<int>(element_kind::poly, "label");
    c_.declare_stored<vec3>(element_kind::vert, "normal");
    if (m_.dimension == 2) c_.declare_stored<int>(element_kind::poly, "required");
    else
      for (const char* const name : {"label", "required", "entity"}) c_.declare_stored<int>(element_kind::face, name);
  }

  void add_poly(std::size_t section, const vert_id* v) {
    section_.push_back(static_cast<std::uint8_t>(section));
    verts_.insert(verts_.end(), v, v + medit_sections[section].arity);
    ++num_of_[section];
    c_.report_progress();
  }

  void collect_polys() {
    if (m_.dimension == 3) {
      for_each_cell(m_, [&](std::size_t p, cell_shape s, const vert_id* v) {
        if (s == cell_shape::general) throw_general_cell(c_, m_, p, ".mesh");
        add_poly(2 + static_cast<std::size_t>(s), v);
      });
      return;
    }
    for (std::size_t p = 0; p < m_.num_polys; ++p) {
      const std::span<const vert_id> v = m_.poly_verts[p];
      if (v.size() != 3 && v.size() != 4)
        c_.throw_cannot_hold(".mesh", {"poly ", m_.poly_index(p), ", a polygon of ", v.size(), " verts"}, ".obj");
      add_poly(v.size() - 3, v.data());
    }
  }

  /// Whether an element has a value other than 0 in one of the properties.
  static bool has_value(std::initializer_list<flat_values<int>> properties, std::size_t i) {
    for (const flat_values<int>& p : properties)
      if (p && p[i] != 0) return true;
    return false;
  }

  void collect_listed() {
    const flat_values<int> edge[] = {m_.edge_values<int>("label"), m_.edge_values<int>("ridge"),
                                     m_.edge_values<int>("required"), m_.edge_values<int>("entity")};
    if (edge[0] || edge[1] || edge[2] || edge[3])
      for (std::size_t e = 0; e < m_.edge_verts().size(); ++e)
        if (has_value({edge[0], edge[1], edge[2], edge[3]}, e)) edges_.push_back(static_cast<std::uint32_t>(e));
    const flat_values<int> face[] = {m_.face_values<int>("label"), m_.face_values<int>("required"),
                                     m_.face_values<int>("entity")};
    if (face[0] || face[1] || face[2])
      for (std::size_t f = 0; f < m_.polyhedra().face_verts.size(); ++f)
        if (has_value({face[0], face[1], face[2]}, f)) {
          const std::size_t n = m_.polyhedra().face_verts[f].size();
          if (n == 3 || n == 4) faces_[n - 3].push_back(static_cast<std::uint32_t>(f));
          else ++num_large_;
        }
    if (const auto normal = m_.vert_values<vec3>("normal"))
      for (std::size_t v = 0; v < m_.points.size(); ++v) {
        const vec3& n = normal[v];
        const bool is_listed = has_direction(n.x) || has_direction(n.y) || has_direction(n.z);
        if (is_listed) normals_.push_back(static_cast<std::uint32_t>(v));
        else c_.finite(n.x), c_.finite(n.y), c_.finite(n.z);  // reports numbers that are not finite
      }
  }

  /// Whether a component of a normal is written as a number other than 0.
  static bool has_direction(double x) { return x != 0 && std::isfinite(x); }

  /// Calls f(number in the file) for the elements that a section marks.
  template<class F>
  void for_each_marked(const medit_section& s, const F& f) {
    const auto each = [&](const flat_values<int>& marks, std::size_t n, const auto& element) {
      for (std::size_t i = 0; marks && i < n; ++i)
        if (const int x = marks[element(i)]; x != 0) f(i, x);
    };
    const auto same = [](std::size_t i) { return i; };
    if (s.rows == medit_rows::marked_verts) return each(m_.vert_values<int>(s.mark), m_.points.size(), same);
    if (s.rows == medit_rows::marked_edges)
      return each(m_.edge_values<int>(s.mark), edges_.size(), [&](std::size_t i) { return edges_[i]; });
    const std::size_t kind = s.code == 18;
    if (m_.dimension == 3)
      return each(m_.face_values<int>(s.mark), faces_[kind].size(), [&](std::size_t i) { return faces_[kind][i]; });
    if (const auto marks = m_.poly_values<int>(s.mark)) {
      std::size_t row = 0;
      for (std::size_t p = 0; p < m_.num_polys; ++p)
        if (section_[p] == kind) {
          if (marks[p] != 0) f(row, marks[p]);
          ++row;
        }
    }
  }

  void announce() {
    out_.announce(nullptr, m_.points.size());
    for (std::size_t k = 0; k < std::size(medit_sections); ++k) {
      const medit_section& s = medit_sections[k];
      std::uint64_t n = 0;
      if (k < num_shapes) n = num_of_[k] + (k < 2 ? faces_[k].size() : 0);
      else if (s.rows == medit_rows::edges) n = edges_.size();
      else if (!s.mark) n = normals_.size();
      else
        for_each_marked(s, [&](std::size_t, int x) {
          ++n;
          num_odd_ += x != 1;
        });
      out_.announce(&s, n);
    }
  }

  void write_section(const medit_section* s) {
    if (!s) return write_vertices();
    const auto k = static_cast<std::size_t>(s - medit_sections);
    if (k < 2 && m_.dimension == 3) return write_faces(k);
    if (k < num_shapes) return write_polys(k);
    if (s->rows == medit_rows::edges) return write_edges();
    if (s->mark)
      return for_each_marked(*s, [&](std::size_t i, int) {
        out_.index(i);
        out_.end_row();
      });
    write_normals(s->rows == medit_rows::normals);
  }

  void write_point(const vec3& p) { out_.real(p.x), out_.real(p.y), out_.real(p.z); }

  void write_vertices() {
    const flat_values<int> label = m_.vert_values<int>("label");
    for (std::size_t v = 0; v < m_.points.size(); ++v) {
      write_point(m_.points[v]);
      out_.integer(label ? label[v] : 0);
      out_.end_row();
      c_.report_progress();
    }
  }

  void write_polys(std::size_t section) {
    const flat_values<int> label = m_.poly_values<int>("label");
    const vert_id* v = verts_.data();
    for (std::size_t p = 0; p < section_.size(); ++p) {
      const std::size_t n = medit_sections[section_[p]].arity;
      if (section_[p] == section) {
        for (std::size_t i = 0; i < n; ++i) out_.index(v[i].raw());
        out_.integer(label ? label[p] : 0);
        out_.end_row();
      }
      v += n;
    }
  }

  void write_faces(std::size_t kind) {
    const flat_values<int> label = m_.face_values<int>("label");
    for (const std::uint32_t f : faces_[kind]) {
      for (const vert_id v : m_.polyhedra().face_verts[f]) out_.index(v.raw());
      out_.integer(label ? label[f] : 0);
      out_.end_row();
    }
  }

  void write_edges() {
    const flat_values<int> label = m_.edge_values<int>("label");
    for (const std::uint32_t e : edges_) {
      for (const vert_id v : m_.edge_verts()[e]) out_.index(v.raw());
      out_.integer(label ? label[e] : 0);
      out_.end_row();
    }
  }

  void write_normals(bool vectors) {
    const flat_values<vec3> normal = m_.vert_values<vec3>("normal");
    for (std::size_t i = 0; i < normals_.size(); ++i) {
      const vec3& n = normal[normals_[i]];
      if (vectors) write_point({c_.finite(n.x), c_.finite(n.y), c_.finite(n.z)});
      else out_.index(normals_[i]), out_.index(i);
      out_.end_row();
    }
  }
};

/// Whether a path ends in .meshb, in upper or lower case.
inline bool is_meshb(std::string_view path) {
  constexpr std::string_view extension = ".meshb";
  if (path.size() < extension.size()) return false;
  for (std::size_t i = 0; i < extension.size(); ++i)
    if (const char c = path[path.size() - extension.size() + i]; c != extension[i] && (c | 0x20) != extension[i])
      return false;
  return true;
}

}  // namespace concino::detail

namespace concino {

inline void medit_format::write(write_context& c, flat_mesh& m) {
  detail::medit_writer(c, m, c.options.binary || detail::is_meshb(c.path)).write();
}

}  // namespace concino
