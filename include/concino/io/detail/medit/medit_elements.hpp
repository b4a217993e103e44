// The elements of a mesh that a MEDIT file lists, by section: all polys, and what has values.
#pragma once

#include <concino/io/detail/cells/recognised_cells.hpp>
#include <concino/io/detail/medit/medit_sections.hpp>
#include <concino/io/detail/text/write_common.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace concino::detail {

/// Needs: collect() first.
class medit_elements {
  write_context& c_;
  flat_mesh& m_;

  void add_poly(std::size_t section, const vert_id* v) {
    sections.push_back(static_cast<std::uint8_t>(section));
    verts.insert(verts.end(), v, v + medit_sections[section].arity);
    ++num_polys[section];
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

  /// Whether a component of a normal is written as a number other than 0.
  static bool has_direction(double x) { return x != 0 && std::isfinite(x); }

  void collect_listed() {
    const flat_values<int> edge[] = {m_.edge_values<int>("label"), m_.edge_values<int>("ridge"),
                                     m_.edge_values<int>("required"), m_.edge_values<int>("entity")};
    if (edge[0] || edge[1] || edge[2] || edge[3])
      for (std::size_t e = 0; e < m_.edge_verts().size(); ++e)
        if (has_value({edge[0], edge[1], edge[2], edge[3]}, e)) edges.push_back(static_cast<std::uint32_t>(e));
    const flat_values<int> face[] = {m_.face_values<int>("label"), m_.face_values<int>("required"),
                                     m_.face_values<int>("entity")};
    if (face[0] || face[1] || face[2])
      for (std::size_t f = 0; f < m_.polyhedra().face_verts.size(); ++f)
        if (has_value({face[0], face[1], face[2]}, f)) {
          const std::size_t n = m_.polyhedra().face_verts[f].size();
          if (n == 3 || n == 4) faces[n - 3].push_back(static_cast<std::uint32_t>(f));
          else ++num_large_faces;
        }
    if (const auto normal = m_.vert_values<vec3>("normal"))
      for (std::size_t v = 0; v < m_.points.size(); ++v) {
        const vec3& n = normal[v];
        const bool is_listed = has_direction(n.x) || has_direction(n.y) || has_direction(n.z);
        if (is_listed) normals.push_back(static_cast<std::uint32_t>(v));
        else c_.finite(n.x), c_.finite(n.y), c_.finite(n.z);  // reports numbers that are not finite
      }
  }

 public:
  static constexpr std::size_t num_shapes = 6;  // the sections of polys, the first of the table
  using element_list = std::vector<std::uint32_t>;

  // the polys in the order of the mesh: the section of each, and its verts in the order of the format
  std::vector<std::uint8_t> sections;
  std::vector<vert_id> verts;
  std::size_t num_polys[num_shapes] = {};

  element_list edges, faces[2], normals;  // the elements that are listed: edges; triangles and quads of a volume; verts
                                          // with a normal
  std::uint64_t num_large_faces = 0;      // faces of more than four verts that have a value

  medit_elements(write_context& c, flat_mesh& m) : c_(c), m_(m) {}

  void collect() {
    collect_polys();
    collect_listed();
  }

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
      return each(m_.edge_values<int>(s.mark), edges.size(), [&](std::size_t i) { return edges[i]; });
    const std::size_t kind = s.code == 18;
    if (m_.dimension == 3)
      return each(m_.face_values<int>(s.mark), faces[kind].size(), [&](std::size_t i) { return faces[kind][i]; });
    if (const auto marks = m_.poly_values<int>(s.mark)) {
      std::size_t row = 0;
      for (std::size_t p = 0; p < m_.num_polys; ++p)
        if (sections[p] == kind) {
          if (marks[p] != 0) f(row, marks[p]);
          ++row;
        }
    }
  }
};

}  // namespace concino::detail
