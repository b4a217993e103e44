// What some crossed cells consist of, in flat arrays.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/core/vec3.hpp>
#include <concino/level_sets/detail/level_states.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// Reads a few cells that lie far apart in memory. Each step reads one thing of all cells in a short loop, so that the processor waits for the
/// memory of several cells at once.
template<class M>
class crossed_cells {
 public:
  static constexpr std::size_t max_size = 32;

  struct edge {
    edge_t<M> edge;
    std::uint32_t first, second;  // the indices of its ends
  };
  struct face {
    face_t<M> face;
    std::uint32_t first_corner, last_corner;
    std::uint32_t first_point;  // of its corners, if it is crossed and has more than three
    unsigned char joint_states;
    bool is_outward;
    bool has_two_polys;  // if it is crossed and has more than three corners
  };
  struct cell {
    std::uint32_t first_edge, last_edge, first_face, last_face, first_vert, num_verts;
    std::uint32_t first_point;  // of a hex that is inside
    bool is_inside;  // of a hex: each face has two cells
  };

  std::vector<cell> cells;
  std::vector<edge> edges;
  std::vector<std::uint32_t> verts;  // of tets and hexes: their indices
  std::vector<vec3> vert_points;     // of hexes that are inside
  std::vector<face> faces;           // of other cells than tets and hexes that are inside
  std::vector<std::uint32_t> corners;  // of faces: indices of verts
  std::vector<vec3> points;

 private:
  static constexpr bool is_tet = arity_v<M> == 4, is_hex = arity_v<M> == 8;
  std::vector<vert_t<M>> vert_names_;

 public:
  /// Needs: at most max_size polys.
  void read(const M& m, const unsigned char* states, std::span<const poly_t<M>> polys) {
    cells.clear(), edges.clear(), verts.clear(), vert_points.clear(), faces.clear(), corners.clear(), points.clear();
    vert_names_.clear();
    for (const poly_t<M>& p : polys) first_read(m, p);
    if constexpr (is_hex)
      for (std::size_t i = 0; i < cells.size(); ++i) cells[i].is_inside = each_face_has_two_polys(m, polys[i]);
    for (std::size_t i = 0; i < cells.size(); ++i) read_lists(m, polys[i], cells[i]);
    if constexpr (!is_tet) {
      read_faces(m, polys);
      read_ends(m);
      read_corners(m, states, polys);
      read_neighbours(m, polys);
      read_points(m);
    }
  }

 private:
  /// Reads the first of each list, so that the others are near.
  void first_read(const M& m, const poly_t<M>& p) {
    cell c{};
    for (const edge_t<M> e : adj_p2e(m, p)) {
      c.last_edge = static_cast<std::uint32_t>(index_of(m, e));
      break;
    }
    if constexpr (is_tet || is_hex) {
      for (const vert_t<M> v : adj_p2v(m, p)) {
        c.first_vert = static_cast<std::uint32_t>(index_of(m, v));
        break;
      }
    } else {
      c.num_verts = static_cast<std::uint32_t>(num_elements(adj_p2v(m, p)));
      for (const face_t<M> f : adj_p2f(m, p)) {
        c.last_face = static_cast<std::uint32_t>(index_of(m, f));
        break;
      }
    }
    cells.push_back(c);
  }
  void read_lists(const M& m, const poly_t<M>& p, cell& c) {
    c.first_edge = static_cast<std::uint32_t>(edges.size());
    for (const edge_t<M> e : adj_p2e(m, p)) edges.push_back({e, 0, 0});
    c.last_edge = static_cast<std::uint32_t>(edges.size());
    if constexpr (is_tet || is_hex) {
      c.first_vert = static_cast<std::uint32_t>(verts.size());
      for (const vert_t<M> v : adj_p2v(m, p)) {
        verts.push_back(static_cast<std::uint32_t>(index_of(m, v)));
        if constexpr (is_hex) vert_names_.push_back(v);
      }
    }
  }
  void read_faces(const M& m, std::span<const poly_t<M>> polys) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      cell& c = cells[i];
      c.first_face = static_cast<std::uint32_t>(faces.size());
      if (!is_hex || !c.is_inside)
        for (const face_t<M> f : adj_p2f(m, polys[i])) faces.push_back({f, 0, 0, 0, 0, false, false});
      c.last_face = static_cast<std::uint32_t>(faces.size());
    }
  }
  static bool each_face_has_two_polys(const M& m, const poly_t<M>& p) {
    for (const face_t<M> f : adj_p2f(m, p))
      if (num_elements(other_polys(m, p, f)) != 1) return false;
    return true;
  }
  void read_ends(const M& m) {
    for (edge& e : edges) {
      const auto ends = end_verts(m, e.edge);
      e.first = static_cast<std::uint32_t>(index_of(m, ends.first));
      e.second = static_cast<std::uint32_t>(index_of(m, ends.second));
    }
  }
  void read_corners(const M& m, const unsigned char* states, std::span<const poly_t<M>> polys) {
    for (std::size_t i = 0; i < cells.size(); ++i)  // the first face of each, then all
      if (const std::uint32_t k = cells[i].first_face; k < cells[i].last_face) faces[k].is_outward = face_is_outward(m, polys[i], faces[k].face);
    for (std::size_t i = 0; i < cells.size(); ++i)
      for (std::uint32_t k = cells[i].first_face; k < cells[i].last_face; ++k) faces[k].is_outward = face_is_outward(m, polys[i], faces[k].face);
    std::uint32_t num_corners = 0;
    for (face& f : faces) {
      f.first_corner = num_corners;
      num_corners += static_cast<std::uint32_t>(num_elements(adj_f2v(m, f.face)));
      f.last_corner = num_corners;
    }
    corners.resize(num_corners);
    for (const face& f : faces)  // the first corner of each, then all
      for (const vert_t<M> v : adj_f2v(m, f.face)) {
        corners[f.first_corner] = static_cast<std::uint32_t>(index_of(m, v));
        break;
      }
    for (const face& f : faces) {
      std::uint32_t* to = corners.data() + f.first_corner;
      for (const vert_t<M> v : adj_f2v(m, f.face)) *to++ = static_cast<std::uint32_t>(index_of(m, v));
    }
    for (face& f : faces)
      for (std::uint32_t k = f.first_corner; k < f.last_corner; ++k) f.joint_states |= states[corners[k]];
  }
  /// Whether it depends on the points of a face how it is crossed.
  static bool has_polygon(const face& f) { return is_crossed(f.joint_states) && f.last_corner - f.first_corner > 3; }
  void read_neighbours(const M& m, std::span<const poly_t<M>> polys) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      for (std::uint32_t k = cells[i].first_face; k < cells[i].last_face; ++k)
        if (has_polygon(faces[k])) faces[k].has_two_polys = num_elements(other_polys(m, polys[i], faces[k].face)) == 1;
  }
  void read_points(const M& m) {
    if constexpr (is_hex)
      for (cell& c : cells) {
        c.first_point = static_cast<std::uint32_t>(vert_points.size());
        if (c.is_inside)
          for (std::uint32_t k = 0; k < 8; ++k) vert_points.push_back(to_vec3(point(m, vert_names_[c.first_vert + k])));
      }
    std::uint32_t num_points = 0;
    for (face& f : faces) {
      f.first_point = num_points;
      if (has_polygon(f)) num_points += f.last_corner - f.first_corner;
    }
    points.resize(num_points);
    for (const face& f : faces) {
      if (!has_polygon(f)) continue;
      vec3* to = points.data() + f.first_point;
      for (const vert_t<M> v : adj_f2v(m, f.face)) *to++ = to_vec3(point(m, v));
    }
  }
};

}  // namespace concino::detail
