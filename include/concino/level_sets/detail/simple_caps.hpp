// The caps of cells that a level set cuts simply, without flat arrays of their facets: the fast way, for most cells of a smooth function.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/level_sets/detail/cell_surface.hpp>
#include <concino/level_sets/detail/crossed_cells.hpp>
#include <concino/level_sets/detail/hex_caps.hpp>
#include <concino/level_sets/detail/polygon_crossings.hpp>
#include <concino/level_sets/detail/simple_cap_list.hpp>
#include <concino/level_sets/detail/tet_caps.hpp>
#include <concino/mesh/standard_cells.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// Finds the caps of cells. A cell is difficult if a crossed facet has more than one chord, is not convex, or is on the boundary and not planar, and if its
/// surface may not be a sphere.
template<class M>
class simple_cap_reader {
  using edge_key = std::uint64_t;  // the indices of the vert below and of the one above
  struct chord {
    edge_key from, to;
  };
  struct crossed_edge {
    edge_key key;
    edge_t<M> edge;
  };
  using cell_data = typename crossed_cells<M>::cell;

  const M& m_;
  const unsigned char* states_;
  crossed_cells<M> read_;
  std::vector<chord> chords_;
  std::vector<crossed_edge> edges_;
  cell_surface surface_;

 public:
  simple_cap_reader(const M& m, const unsigned char* states) : m_(m), states_(states) {}

  /// Adds the caps of some cells; `number` is that of the first.
  void read(std::span<const poly_t<M>> polys, std::uint32_t number, simple_cap_list<M>& list) {
    while (!polys.empty() && !list.meets_verts) {
      const std::size_t n = std::min(polys.size(), crossed_cells<M>::max_size);
      read_.read(m_, states_, polys.first(n));
      for (const cell_data& c : read_.cells) read_cell(c, number++, list);
      polys = polys.subspan(n);
    }
  }

 private:
  void read_cell(const cell_data& c, std::uint32_t cell, simple_cap_list<M>& list) {
    if constexpr (arity_v<M> == 4) {  // faster: tets have one cap each, which follows from their signs
      read_tet(c, cell, list);
    } else {
      bool is_simple = false;
      if constexpr (arity_v<M> == 8)  // faster: the faces follow from the order of the verts, and the caps of a hex inside from its signs
        is_simple = c.is_inside ? read_hex(c, cell, list) : find_chords(c, list) && chain(c, cell, list);
      else is_simple = find_chords(c, list) && chain(c, cell, list);
      if (!is_simple) list.difficult.push_back(cell);
    }
  }

  void read_tet(const cell_data& c, std::uint32_t cell, simple_cap_list<M>& list) {
    unsigned signs = 0;
    for (unsigned k = 0; k < 4; ++k) {
      const unsigned char s = states_[read_.verts[c.first_vert + k]];
      if (s == on_level) list.meets_verts = true;
      signs |= unsigned{s != below_level} << k;
    }
    const tet_cap& cap = tet_caps[signs];
    for (unsigned i = 0; i < cap.size; ++i) list.corners.push_back(read_.edges[c.first_edge + cap.edges[i]].edge);
    end_cap(cell, list);
  }
  static void end_cap(std::uint32_t cell, simple_cap_list<M>& list) {
    list.ends.push_back(static_cast<std::uint32_t>(list.corners.size()));
    list.cells.push_back(cell);
  }

  bool read_hex(const cell_data& c, std::uint32_t cell, simple_cap_list<M>& list) {
    constexpr const standard_cell& hex = standard_cell_of(cell_shape::hex);
    const std::uint32_t* const verts = read_.verts.data() + c.first_vert;
    const vec3* const points = read_.vert_points.data() + c.first_point;
    unsigned char joint = 0;
    unsigned signs = 0;
    for (unsigned k = 0; k < 8; ++k) {
      joint |= states_[verts[k]];
      signs |= unsigned{states_[verts[k]] != below_level} << k;
    }
    if (joint & on_level) list.meets_verts = true;
    const hex_cap_list& caps = hex_caps(signs);
    if (!caps.is_simple) return false;
    for (const auto& face : hex.face_vert) {
      const bool first = signs >> face[0] & 1u;
      if (first == (signs >> face[1] & 1u) && first == (signs >> face[2] & 1u) && first == (signs >> face[3] & 1u)) continue;
      const vec3 corners[4] = {points[face[0]], points[face[1]], points[face[2]], points[face[3]]};
      if (!is_convex_polygon(corners)) return false;
    }
    list_crossed_edges(c);
    const std::size_t num_corners = list.corners.size(), num_caps = list.ends.size();
    bool closes = true;
    for (unsigned i = 0, k = 0; i < caps.num_caps; ++i) {
      for (; k < caps.ends[i]; ++k) closes = add_corner(edge_key{verts[caps.corners[k].below]} << 32 | verts[caps.corners[k].above], list) && closes;
      end_cap(cell, list);
    }
    if (!closes) list.truncate(num_corners, num_caps);
    return closes;
  }

  bool find_chords(const cell_data& c, simple_cap_list<M>& list) {
    chords_.clear();
    surface_.clear();
    for (std::uint32_t k = c.first_face; k < c.last_face; ++k) {
      const auto& f = read_.faces[k];
      const std::uint32_t *const corners = read_.corners.data() + f.first_corner, n = f.last_corner - f.first_corner;
      if (f.joint_states & on_level) list.meets_verts = true;
      if (is_crossed(f.joint_states) && !(add_chord(corners, n, f.is_outward) == 2 && (n == 3 || is_flat(f)))) return false;
      if constexpr (arity_v<M> == 0) {  // cells of fixed arity are spheres
        for (std::uint32_t i = 0; i < n; ++i) surface_.add_corner(corners[i]);
        surface_.end_facet(f.is_outward);
      }
    }
    if constexpr (arity_v<M> == 0) return surface_.is_sphere(c.num_verts, c.last_edge - c.first_edge);  // the same
    else return true;
  }

  /// Adds the chord of a face, if there is one. Returns how many of its edges are crossed.
  unsigned add_chord(const std::uint32_t* facet, std::size_t n, bool outward) {
    unsigned crossings = 0;
    chord c{};
    edge_key a = facet[n - 1];
    bool above = states_[a] != below_level;
    for (std::size_t k = 0; k < n; ++k) {
      const edge_key b = facet[k];
      const bool next_above = states_[b] != below_level;
      if (above != next_above) {
        ++crossings;
        (next_above == outward ? c.to : c.from) = above ? b << 32 | a : a << 32 | b;
      }
      a = b;
      above = next_above;
    }
    if (crossings > 0) chords_.push_back(c);
    return crossings;
  }
  /// Whether a face is convex and, if it is on the boundary, planar.
  bool is_flat(const typename crossed_cells<M>::face& f) const {
    const std::span<const vec3> corners(read_.points.data() + f.first_point, f.last_corner - f.first_corner);
    return is_convex_polygon(corners) && (f.has_two_polys || is_planar_polygon(corners));
  }

  void list_crossed_edges(const cell_data& c) {
    edges_.clear();
    for (std::uint32_t k = c.first_edge; k < c.last_edge; ++k) {
      const auto& e = read_.edges[k];
      const edge_key a = e.first, b = e.second;
      const bool above = states_[a] != below_level;
      if (above == (states_[b] != below_level)) continue;
      edges_.push_back({above ? b << 32 | a : a << 32 | b, e.edge});
    }
  }

  /// Joins the chords to cycles of edges. Returns false if they do not close.
  bool chain(const cell_data& c, std::uint32_t cell, simple_cap_list<M>& list) {
    list_crossed_edges(c);
    const std::size_t corners = list.corners.size(), caps = list.ends.size();
    std::size_t left = chords_.size();
    bool closes = left == edges_.size();
    while (closes && left > 0) {
      const edge_key start = chords_[left - 1].from;
      edge_key at = chords_[--left].to;
      closes = add_corner(start, list);
      while (closes && at != start) {
        std::size_t k = 0;
        while (k < left && chords_[k].from != at) ++k;
        closes = k < left && add_corner(at, list);
        if (!closes) break;
        at = chords_[k].to;
        chords_[k] = chords_[--left];
      }
      end_cap(cell, list);
    }
    if (!closes) list.truncate(corners, caps);
    return closes;
  }
  bool add_corner(edge_key key, simple_cap_list<M>& list) {
    for (const crossed_edge& e : edges_)
      if (e.key == key) {
        list.corners.push_back(e.edge);
        return true;
      }
    return false;
  }
};

}  // namespace concino::detail
