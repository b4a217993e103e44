// Reads the polys of any volume that a level set cuts in two parts.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/core/large_pages.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/level_sets/detail/level_place.hpp>
#include <concino/level_sets/detail/level_states.hpp>
#include <concino/level_sets/detail/simple_cells.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// Reads polys without the flat arrays of crossed_volume_reader, as long as they are simple.
template<class M>
class simple_cell_reader {
  static constexpr std::uint32_t none = ~0u;

  struct crossed_edge {
    std::uint32_t below, above;  // the indices of its ends
    std::uint32_t index;
  };

  const M& m_;
  const unsigned char* states_;  // of verts, by index
  core::local_numbers place_numbers_;
  simple_cells::cell_verts verts_;
  std::vector<vert_t<M>> names_;  // of verts_
  std::vector<crossed_edge> edges_;
  std::size_t num_edges_ = 0;

 public:
  simple_cells cells;
  std::vector<level_place> places;
  place_ends ends;

  /// number_of_face: see simple_cells.
  simple_cell_reader(const M& m, const unsigned char* states, std::uint32_t* number_of_face) : m_(m), states_(states), cells(number_of_face) {}

  /// Returns false if one of the polys is unusual, or many are difficult; the arrays are of no use then. poly_states: see poly_states().
  template<class U>
  bool read(const U& u, std::span<const poly_t<M>> polys, const unsigned char* poly_states) {
    if (vert_index_bound(m_) >= part_lists::of_mesh || face_index_bound(m_) >= part_lists::of_mesh) return false;
    std::size_t num_difficult = 0;
    for (const poly_t<M>& p : polys) num_difficult += (poly_states[index_of(m_, p)] & on_level) != 0;
    const auto are_many = [&] { return num_difficult > 64 && num_difficult > polys.size() / 8; };
    if (are_many()) return false;
    reserve(polys.size());
    num_difficult = 0;
    for (const poly_t<M>& p : polys) {
      if (!read_poly(u, p, poly_states)) return false;
      num_difficult += cells.is_difficult(cells.num_cells() - 1);
      if (are_many()) return false;
    }
    return !cells.has_equal_faces();
  }

  /// The number of the place on an edge, or none.
  std::uint32_t place_on_edge(std::uint32_t index) const { return place_numbers_.find(index); }

 private:
  void reserve(std::size_t num_polys) {
    cells.reserve(num_polys);
    place_numbers_.reserve(2 * num_polys);
    const std::size_t num_places = num_polys + num_polys / 8;  // a layer of hexes has about as many as polys, and one of tets fewer
    core::reserve_pages(places, num_places), core::reserve_pages(ends.vert_indices, 2 * num_places);
    core::reserve_pages(ends.points, 2 * num_places), core::reserve_pages(ends.values, 2 * num_places);
  }

  template<class U>
  bool read_poly(const U& u, const poly_t<M>& p, const unsigned char* poly_states) {
    const auto index = static_cast<std::uint32_t>(index_of(m_, p));
    read_verts_and_edges(p);
    cells.start_cell((poly_states[index] & on_level) != 0);
    for (const face_t<M> f : adj_p2f(m_, p)) {
      const std::size_t face_index = index_of(m_, f);
      const std::uint32_t number = cells.number_of_face(face_index);
      const bool is_new = cells.is_new(number);
      if (is_new) {
        cells.start_face(static_cast<std::uint32_t>(face_index));
        for (const vert_t<M> v : adj_f2v(m_, f)) cells.add_corner(static_cast<std::uint32_t>(index_of(m_, v)));
      }
      if (!cells.read_corners(number, is_new, verts_)) return false;
      if (is_new ? cells.face_of(number).is_crossed && !set_chord(u, f, index, cells.face_of(number)) : num_elements(adj_f2p(m_, f)) != 2) return false;
      cells.add_face(number, face_is_outward(m_, p, f), index, verts_);
    }
    cells.end_cell(arity_v<M> > 0, verts_.indices.size(), num_edges_);  // cells of fixed arity are spheres
    return true;
  }

  void read_verts_and_edges(const poly_t<M>& p) {
    verts_.clear(), names_.clear(), edges_.clear();
    for (const vert_t<M> v : adj_p2v(m_, p)) {
      const std::size_t index = index_of(m_, v);
      names_.push_back(v);
      verts_.indices.push_back(static_cast<std::uint32_t>(index));
      verts_.points.push_back(to_vec3(point(m_, v)));
      verts_.above.push_back(states_[index] != below_level);
    }
    num_edges_ = 0;
    for (const edge_t<M> e : adj_p2e(m_, p)) {
      ++num_edges_;
      const auto ends_of = end_verts(m_, e);
      const auto a = static_cast<std::uint32_t>(index_of(m_, ends_of.first)), b = static_cast<std::uint32_t>(index_of(m_, ends_of.second));
      const bool above = states_[a] != below_level;
      if (above == (states_[b] != below_level)) continue;
      edges_.push_back({above ? b : a, above ? a : b, static_cast<std::uint32_t>(index_of(m_, e))});
    }
  }

  /// Returns false if the face has more than two polys, or one of its edges the same ends as another.
  template<class U>
  bool set_chord(const U& u, const face_t<M>& f, std::uint32_t poly, simple_cells::face& face) {
    std::uint32_t other = none;
    unsigned n = 0;
    for (const poly_t<M> q : adj_f2p(m_, f)) {
      ++n;
      if (const auto index = static_cast<std::uint32_t>(index_of(m_, q)); index != poly) other = index;
    }
    if (n > 2 || (n == 2 && other == none)) return false;
    if (n == 1) face.is_simple = face.is_simple && cells.is_planar(verts_);
    if (!face.is_simple) return true;
    const std::uint32_t first = place_of(u, 0), second = first == none ? none : place_of(u, 1);
    if (second == none) return false;
    cells.set_chord(first, second, poly, other);
    return true;
  }

  /// The place of crossed edge k of the current face; none if no edge, or more than one, joins its ends.
  template<class U>
  std::uint32_t place_of(const U& u, unsigned k) {
    std::uint32_t below = cells.before(k), above = cells.behind(k), found = none;
    if (verts_.above[below]) std::swap(below, above);
    for (const crossed_edge& e : edges_) {
      if (e.below != verts_.indices[below] || e.above != verts_.indices[above]) continue;
      if (found != none) return none;
      found = e.index;
    }
    if (found == none) return none;
    const std::uint32_t number = place_numbers_.add(found);
    if (number == places.size()) {
      const auto first = static_cast<std::uint32_t>(ends.points.size());
      places.push_back({level_place::edge, found, first, first + 1});
      for (const std::uint32_t end : {below, above}) {
        ends.vert_indices.push_back(verts_.indices[end]);
        ends.points.push_back(verts_.points[end]);
        ends.values.push_back(static_cast<double>(u[names_[end]]));
      }
    }
    return number;
  }
};

}  // namespace concino::detail
