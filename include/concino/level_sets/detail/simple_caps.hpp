// The caps of cells that a level set cuts simply, without flat arrays of their facets: the fast way, for most cells of a smooth function.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/core/vec3.hpp>
#include <concino/level_sets/detail/cell_surface.hpp>
#include <concino/level_sets/detail/hex_caps.hpp>
#include <concino/level_sets/detail/level_states.hpp>
#include <concino/level_sets/detail/polygon_crossings.hpp>
#include <concino/level_sets/detail/requested_cells.hpp>
#include <concino/level_sets/detail/simple_cap_list.hpp>
#include <concino/level_sets/detail/tet_caps.hpp>
#include <concino/mesh/standard_cells.hpp>

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

  const M& m_;
  const unsigned char* states_;
  std::vector<chord> chords_;
  std::vector<crossed_edge> edges_;
  std::size_t num_edges_ = 0;  // all of them
  std::vector<std::uint32_t> corners_;
  std::vector<vec3> points_;
  cell_surface surface_;

 public:
  simple_cap_reader(const M& m, const unsigned char* states) : m_(m), states_(states) {}

  /// Adds the caps of some cells; `number` is that of the first.
  void read(std::span<const poly_t<M>> polys, std::uint32_t number, simple_cap_list<M>& list) {
    read_requested(m_, polys, [&](const poly_t<M>& p) {
      read_cell(p, number++, list);
      return !list.meets_verts;
    });
  }

 private:
  void read_cell(const poly_t<M>& p, std::uint32_t cell, simple_cap_list<M>& list) {
    if constexpr (arity_v<M> == 4) {  // faster: tets have one cap each, which follows from their signs
      read_tet(p, cell, list);
    } else {
      bool is_simple = false;
      if constexpr (arity_v<M> == 8)  // faster: the faces follow from the order of the verts, and the caps of a hex inside from its signs
        is_simple = is_inside(p) ? read_hex(p, cell, list) : find_chords(p, list) && chain(cell, list);
      else is_simple = find_chords(p, list) && chain(cell, list);
      if (!is_simple) list.difficult.push_back(cell);
    }
  }

  void read_tet(const poly_t<M>& p, std::uint32_t cell, simple_cap_list<M>& list) {
    unsigned signs = 0, k = 0;
    for (const vert_t<M> v : adj_p2v(m_, p)) {
      const unsigned char s = states_[index_of(m_, v)];
      if (s == on_level) list.meets_verts = true;
      signs |= unsigned{s != below_level} << k++;
    }
    edge_t<M> edges[6], *to = edges;
    for (const edge_t<M> e : adj_p2e(m_, p)) *to++ = e;
    const tet_cap& cap = tet_caps[signs];
    for (unsigned i = 0; i < cap.size; ++i) list.corners.push_back(edges[cap.edges[i]]);
    end_cap(cell, list);
  }
  static void end_cap(std::uint32_t cell, simple_cap_list<M>& list) {
    list.ends.push_back(static_cast<std::uint32_t>(list.corners.size()));
    list.cells.push_back(cell);
  }

  /// Whether each face has two cells.
  bool is_inside(const poly_t<M>& p) const {
    for (const face_t<M> f : adj_p2f(m_, p))
      if (num_elements(other_polys(m_, p, f)) != 1) return false;
    return true;
  }

  bool read_hex(const poly_t<M>& p, std::uint32_t cell, simple_cap_list<M>& list) {
    constexpr const standard_cell& hex = standard_cell_of(cell_shape::hex);
    edge_key verts[8];
    vec3 points[8];
    unsigned char joint = 0;
    unsigned signs = 0, k = 0;
    for (const vert_t<M> v : adj_p2v(m_, p)) {
      verts[k] = index_of(m_, v);
      points[k] = to_vec3(point(m_, v));
      const unsigned char s = states_[verts[k]];
      joint |= s;
      signs |= unsigned{s != below_level} << k++;
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
    list_crossed_edges(p);
    const std::size_t num_corners = list.corners.size(), num_caps = list.ends.size();
    bool closes = true;
    k = 0;
    for (unsigned i = 0; i < caps.num_caps; ++i) {
      for (; k < caps.ends[i]; ++k) closes = add_corner(verts[caps.corners[k].below] << 32 | verts[caps.corners[k].above], list) && closes;
      end_cap(cell, list);
    }
    if (!closes) list.truncate(num_corners, num_caps);
    return closes;
  }

  bool find_chords(const poly_t<M>& p, simple_cap_list<M>& list) {
    chords_.clear();
    const auto& faces = adj_p2f(m_, p);
    const bool are_few = num_elements(faces) <= few_facets::max_size;
    few_facets few;
    surface_.clear();
    for (const face_t<M> f : faces) {
      const auto& verts = adj_f2v(m_, f);
      const std::size_t n = num_elements(verts);
      if (corners_.size() < n) corners_.resize(n);
      std::uint32_t* to = corners_.data();
      for (const vert_t<M> v : verts) *to++ = static_cast<std::uint32_t>(index_of(m_, v));
      const std::span<const std::uint32_t> corners(corners_.data(), n);
      const bool is_outward = face_is_outward(m_, p, f);
      const face_crossing x = crossing_of(corners, is_outward);
      if (x.joint_states & on_level) list.meets_verts = true;
      if (x.num_ends > 0) {
        if (x.num_ends > 2 || (n > 3 && !is_flat(p, f, n))) return false;
        chords_.push_back(x.piece);
      }
      if constexpr (arity_v<M> == 0) {  // cells of fixed arity are spheres
        if (are_few) few.add_facet(corners, is_outward);
        else surface_.add_facet(corners, is_outward);
      }
    }
    list_crossed_edges(p);
    if constexpr (arity_v<M> > 0) return true;  // the same
    const std::size_t num_verts = num_elements(adj_p2v(m_, p));
    return are_few ? few.is_sphere(num_verts, num_edges_) : surface_.is_sphere(num_verts, num_edges_);
  }

  struct face_crossing {
    unsigned char joint_states = 0;
    unsigned num_ends = 0;  // crossed edges
    chord piece;            // if there are two
  };
  /// Without branches on states, which processors would predict wrongly.
  face_crossing crossing_of(std::span<const std::uint32_t> corners, bool is_outward) const {
    face_crossing x;
    edge_key ends[3] = {};  // where the level set leaves the face and where it enters it, seen with the corners; the third one is of no use
    edge_key a = corners.back();
    bool above = states_[a] != below_level;
    for (const edge_key b : corners) {
      const unsigned char state = states_[b];
      const bool next_above = state != below_level, is_end = above != next_above;
      x.joint_states = static_cast<unsigned char>(x.joint_states | state);
      x.num_ends += is_end;
      ends[is_end ? unsigned{next_above} : 2] = above ? b << 32 | a : a << 32 | b;
      a = b;
      above = next_above;
    }
    x.piece = {ends[is_outward ? 0 : 1], ends[is_outward ? 1 : 0]};
    return x;
  }
  /// Whether a face of n > 3 verts is convex and, if it is on the boundary, planar.
  bool is_flat(const poly_t<M>& p, const face_t<M>& f, std::size_t n) {
    if (points_.size() < n) points_.resize(n);
    vec3* to = points_.data();
    for (const vert_t<M> v : adj_f2v(m_, f)) *to++ = to_vec3(point(m_, v));
    const std::span<const vec3> points(points_.data(), n);
    return is_convex_polygon(points) && (num_elements(other_polys(m_, p, f)) == 1 || is_planar_polygon(points));
  }

  void list_crossed_edges(const poly_t<M>& p) {
    const auto& all = adj_p2e(m_, p);
    num_edges_ = num_elements(all);
    edges_.resize(num_edges_);
    crossed_edge* to = edges_.data();
    for (const edge_t<M> e : all) {
      const auto ends = end_verts(m_, e);
      const edge_key a = index_of(m_, ends.first), b = index_of(m_, ends.second);
      const bool above = states_[a] != below_level;
      *to = {above ? b << 32 | a : a << 32 | b, e};
      to += above != (states_[b] != below_level);
    }
    edges_.resize(static_cast<std::size_t>(to - edges_.data()));
  }

  /// Joins the chords to cycles of edges. Returns false if they do not close.
  bool chain(std::uint32_t cell, simple_cap_list<M>& list) {
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
