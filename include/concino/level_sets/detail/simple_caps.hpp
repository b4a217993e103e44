// The caps of cells that a level set cuts simply, without flat arrays of their facets: the fast way, for most cells of a smooth function.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/core/parallel.hpp>
#include <concino/level_sets/detail/cell_surface.hpp>
#include <concino/level_sets/detail/level_states.hpp>
#include <concino/level_sets/detail/polygon_crossings.hpp>
#include <concino/level_sets/detail/tet_caps.hpp>
#include <concino/mesh/standard_cells.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Caps of some cells, as cycles of crossed edges, counter-clockwise seen from above.
template<class M>
struct simple_cap_list {
  std::vector<edge_t<M>> corners;
  std::vector<std::uint32_t> ends;       // by cap: where its corners end
  std::vector<std::uint32_t> cells;      // by cap
  std::vector<std::uint32_t> difficult;  // cells without caps, which are cut in another way
  bool meets_verts = false;              // some cell has a vert on the level set
};

/// Finds the caps of one cell after another. A cell is difficult if a crossed facet has more than one chord, is not convex, or is on the boundary and not
/// planar, and if its surface may not be a sphere.
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
  std::vector<vec3> points_;
  cell_surface surface_;
  bool is_inside_ = false;  // each face of the cell leads to another cell of its own, which is faster to see than the cells of each face

 public:
  simple_cap_reader(const M& m, const unsigned char* states) : m_(m), states_(states) {}

  void read(const poly_t<M>& p, std::uint32_t cell, simple_cap_list<M>& list) {
    if constexpr (arity_v<M> == 4) {  // faster: tets have one cap each, which follows from their signs
      read_tet(p, cell, list);
    } else {
      is_inside_ = num_elements(adj_p2p(m_, p)) == num_elements(adj_p2f(m_, p));
      if (!find_chords(p, list) || !chain(p, cell, list)) list.difficult.push_back(cell);
    }
  }

 private:
  void read_tet(const poly_t<M>& p, std::uint32_t cell, simple_cap_list<M>& list) {
    unsigned signs = 0, k = 0;
    for (const vert_t<M> v : adj_p2v(m_, p)) {
      const unsigned char s = states_[index_of(m_, v)];
      if (s == on_level) list.meets_verts = true;
      signs |= unsigned{s != below_level} << k++;
    }
    edge_t<M> edges[6];
    k = 0;
    for (const edge_t<M> e : adj_p2e(m_, p)) edges[k++] = e;
    const tet_cap& cap = tet_caps[signs];
    for (unsigned i = 0; i < cap.size; ++i) list.corners.push_back(edges[cap.edges[i]]);
    list.ends.push_back(static_cast<std::uint32_t>(list.corners.size()));
    list.cells.push_back(cell);
  }

  bool find_chords(const poly_t<M>& p, simple_cap_list<M>& list) {
    chords_.clear();
    if constexpr (arity_v<M> == 8)  // faster: the faces follow from the order of the verts
      if (is_inside_) return find_chords_of_hex(p, list);
    surface_.clear();
    for (const face_t<M> f : adj_p2f(m_, p)) {
      unsigned char joint = 0;
      std::size_t n = 0;
      for (const vert_t<M> v : adj_f2v(m_, f)) {
        const std::size_t i = index_of(m_, v);
        joint |= states_[i];
        surface_.add_corner(static_cast<std::uint32_t>(i));
        ++n;
      }
      const bool outward = face_is_outward(m_, p, f);
      surface_.end_facet(outward);
      if (joint & on_level) list.meets_verts = true;
      if (is_crossed(joint) && !(add_chord(surface_.last_corners(n), n, outward) == 2 && (n == 3 || is_flat(f)))) return false;
    }
    if constexpr (arity_v<M> == 0) return surface_.is_sphere(num_elements(adj_p2v(m_, p)), num_elements(adj_p2e(m_, p)));  // cells of fixed arity are spheres
    else return true;
  }

  /// The same for a hex that has a neighbour behind each of its faces.
  bool find_chords_of_hex(const poly_t<M>& p, simple_cap_list<M>& list) {
    constexpr const standard_cell& hex = standard_cell_of(cell_shape::hex);
    std::uint32_t verts[8], ring[4];
    vec3 points[8];
    points_.resize(4);
    unsigned char joint = 0;
    unsigned k = 0;
    for (const vert_t<M> v : adj_p2v(m_, p)) {
      verts[k] = static_cast<std::uint32_t>(index_of(m_, v));
      joint |= states_[verts[k]];
      points[k++] = to_vec3(point(m_, v));
    }
    if (joint & on_level) list.meets_verts = true;
    for (unsigned f = 0; f < 6; ++f) {
      for (unsigned i = 0; i < 4; ++i) {
        ring[i] = verts[hex.face_vert[f][i]];
        points_[i] = points[hex.face_vert[f][i]];
      }
      const unsigned crossings = add_chord(ring, 4, true);
      if (crossings > 2 || (crossings == 2 && !is_convex_polygon(points_))) return false;
    }
    return true;
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
  bool is_flat(const face_t<M>& f) {
    points_.clear();
    for (const vert_t<M> v : adj_f2v(m_, f)) points_.push_back(to_vec3(point(m_, v)));
    return is_convex_polygon(points_) && (is_inside_ || num_elements(adj_f2p(m_, f)) == 2 || is_planar_polygon(points_));
  }

  /// Joins the chords to cycles of edges. Returns false if they do not close.
  bool chain(const poly_t<M>& p, std::uint32_t cell, simple_cap_list<M>& list) {
    edges_.clear();
    for (const edge_t<M> e : adj_p2e(m_, p)) {
      const auto ends = end_verts(m_, e);
      const edge_key a = index_of(m_, ends.first), b = index_of(m_, ends.second);
      const bool above = states_[a] != below_level;
      if (above == (states_[b] != below_level)) continue;
      edges_.push_back({above ? b << 32 | a : a << 32 | b, e});
    }
    const std::size_t corners = list.corners.size(), ends = list.ends.size();
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
      list.ends.push_back(static_cast<std::uint32_t>(list.corners.size()));
      list.cells.push_back(cell);
    }
    if (!closes) list.corners.resize(corners), list.ends.resize(ends), list.cells.resize(ends);
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
