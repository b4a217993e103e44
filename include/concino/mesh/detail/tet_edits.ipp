// The collapse of an edge of tets by direct changes of the tables; see cell_tables.hpp. It changes what rewire would change, in the same order, but knows the
// edit: the polys at the removed end only have another vert, so that most faces and edges stay as they are. What is not regular is left to rewire.
#pragma once

#include <concino/mesh/cell_tables.hpp>
#include <concino/mesh/detail/cavity_changes.hpp>

#include <array>

namespace concino {

/// The collapse of the edge e = ab of which b is removed. The polys at b have local numbers.
template<class Shape, class Lists>
class cell_tables<Shape, Lists>::collapse {
  static constexpr std::uint32_t max_polys = 96, num_slots = 256, none = Shape::verts;
  static constexpr std::size_t max_pairs = 4096;  // of new and old faces: up to here rewire gives a face the descriptor of the one from which it comes

  /// A vert of the link of e.
  struct ring_vert {
    vert_id v;
    edge_id to_a, to_b;
  };

  cell_tables& t_;
  const edge_id e_;
  const vert_id a_ = t_.e2v_[e_.raw()][0], b_ = t_.e2v_[e_.raw()][1];
  std::uint32_t n_ = 0;
  poly_id polys_[max_polys];                       // at b, as its list has them
  std::uint8_t at_a_[max_polys], at_b_[max_polys];  // which corner of each is a or b; none if it is not at e
  std::uint8_t behind_[max_polys][Shape::faces];   // the poly behind each of its faces at b
  std::uint8_t slots_[num_slots] = {};             // a hash table of the numbers of polys plus 1
  core::small_array<poly_id, 16> at_edge_;         // the polys at e, as walks around it meet them
  core::small_array<ring_vert, 16> ring_;

  static constexpr std::uint32_t edge_between(std::uint32_t i, std::uint32_t j) {
    for (std::uint32_t k = 0; k < Shape::edges; ++k)
      if ((Shape::edge_vert[k][0] == i && Shape::edge_vert[k][1] == j) || (Shape::edge_vert[k][0] == j && Shape::edge_vert[k][1] == i)) return k;
    return Shape::edges;
  }
  /// The face without vert i.
  static constexpr std::uint32_t opposite(std::uint32_t i) { return Shape::verts - 1 - i; }

  std::uint32_t slot(std::uint32_t p) const {
    std::uint32_t i = p * 0x9e3779b1u >> 24;
    while (slots_[i] != 0 && polys_[slots_[i] - 1].raw() != p) i = (i + 1) % num_slots;
    return i;
  }
  /// The number of poly p; max_polys or more if it is not at b.
  std::uint32_t number(std::uint32_t p) const {
    const std::uint32_t plus_one = slots_[slot(p)];
    return plus_one - 1;
  }
  std::uint32_t corner(const vert_id* v, vert_id x) const {
    std::uint32_t i = 0;
    while (i < none && v[i] != x) ++i;
    return i;
  }
  const ring_vert* ring_vert_at(vert_id v) const {
    const ring_vert* x = ring_.begin();
    while (x != ring_.end() && x->v != v) ++x;
    return x == ring_.end() ? nullptr : x;
  }
  void add_to_ring(vert_id v, edge_id to_a, edge_id to_b) {
    if (!ring_vert_at(v)) ring_.push_back({v, to_a, to_b});
  }

  bool find_polys();
  bool is_sphere();
  void find_ring();
  bool have_common_edge(vert_id x, vert_id y) const;
  bool has_face(edge_id e, vert_id v) const;
  bool link_condition_holds() const;
  void reserve();
  void remove_polys_at_edge();
  void move_edges();
  void change_poly(std::uint32_t k);

 public:
  collapse(cell_tables& t, edge_id e) : t_(t), e_(e) {}
  direct_edit run();
};

/// Lists the polys at b. Returns false if one of them is not regular, or if there are too many.
template<class Shape, class Lists>
bool cell_tables<Shape, Lists>::collapse::find_polys() {
  const id_span<poly_id> all = t_.v2p_[b_.raw()];
  if (all.size() > max_polys) return false;
  for (const poly_id p : all) {
    if (t_.facet_adjacency_.is_marked(p.raw())) return false;
    const edge_id* const e = t_.p2e_.begin(p.raw());
    for (std::uint32_t j = 0; j < Shape::edges; ++j)
      if (t_.is_non_manifold(e[j])) return false;
    const vert_id* const v = t_.p2v_.begin(p.raw());
    at_a_[n_] = static_cast<std::uint8_t>(corner(v, a_)), at_b_[n_] = static_cast<std::uint8_t>(corner(v, b_));
    polys_[n_++] = p;
    slots_[slot(p.raw())] = static_cast<std::uint8_t>(n_);
  }
  return true;
}

/// Whether the link of b is a sphere: its triangles are connected, each edge has two, and the Euler characteristic is that of a sphere.
template<class Shape, class Lists>
bool cell_tables<Shape, Lists>::collapse::is_sphere() {
  if (2 * t_.incident_edges_.num_edges(b_) != n_ + 4) return false;
  std::uint8_t found[max_polys];
  bool is_found[max_polys] = {true};
  found[0] = 0;
  std::uint32_t num_found = 1;
  for (std::uint32_t i = 0; i < num_found; ++i) {
    const std::uint32_t k = found[i];
    for (std::uint32_t j = 0; j < Shape::faces; ++j) {
      if (j == opposite(at_b_[k])) continue;
      const detail::encoded_neighbour x = t_.facet_adjacency_.neighbour(polys_[k], j);
      if (x.is_none()) return false;
      const std::uint32_t other = number(x.poly());
      behind_[k][j] = static_cast<std::uint8_t>(other);
      if (!is_found[other]) is_found[other] = true, found[num_found++] = static_cast<std::uint8_t>(other);
    }
  }
  return num_found == n_;
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::collapse::find_ring() {
  for (const poly_id p : t_.adj_e2p(e_)) {
    at_edge_.push_back(p);
    const std::uint32_t k = number(p.raw());
    const vert_id* const v = t_.p2v_.begin(p.raw());
    const edge_id* const e = t_.p2e_.begin(p.raw());
    for (std::uint32_t i = 0; i < Shape::verts; ++i)
      if (i != at_a_[k] && i != at_b_[k]) add_to_ring(v[i], e[edge_between(i, at_a_[k])], e[edge_between(i, at_b_[k])]);
  }
}

template<class Shape, class Lists>
bool cell_tables<Shape, Lists>::collapse::have_common_edge(vert_id x, vert_id y) const {
  if (t_.incident_edges_.num_edges(y) < t_.incident_edges_.num_edges(x)) std::swap(x, y);
  for (const vert_id v : t_.incident_edges_.verts(x))
    if (v == y) return true;
  return false;
}

/// Whether a poly at e has v.
template<class Shape, class Lists>
bool cell_tables<Shape, Lists>::collapse::has_face(edge_id e, vert_id v) const {
  for (const poly_id p : t_.adj_e2p(e))
    if (corner(t_.p2v_.begin(p.raw()), v) != none) return true;
  return false;
}

/// Whether the common simplices of the links of a and b are those of the link of e. As b is inside a manifold, this is enough.
template<class Shape, class Lists>
bool cell_tables<Shape, Lists>::collapse::link_condition_holds() const {
  for (const vert_id x : t_.incident_edges_.verts(b_))
    if (x != a_ && !ring_vert_at(x) && have_common_edge(x, a_)) return false;
  for (std::uint32_t k = 0; k < n_; ++k) {
    if (at_a_[k] != none) continue;
    const poly_id p = polys_[k];
    const vert_id* const v = t_.p2v_.begin(p.raw());
    const ring_vert* in_ring[Shape::verts] = {};
    std::uint32_t num_in_ring = 0;
    for (std::uint32_t i = 0; i < Shape::verts; ++i)
      if (i != at_b_[k] && (in_ring[i] = ring_vert_at(v[i])) != nullptr) ++num_in_ring;
    if (num_in_ring < 2) continue;
    for (std::uint32_t i = 0; i < Shape::verts; ++i)
      for (std::uint32_t j = 0; j < i; ++j) {
        if (!in_ring[i] || !in_ring[j]) continue;
        const std::uint32_t third = 6 - at_b_[k] - i - j;
        if (at_a_[behind_[k][opposite(third)]] == none && has_face(in_ring[i]->to_a, v[j])) return false;
      }
    if (num_in_ring < 3) continue;
    const detail::encoded_neighbour x = t_.facet_adjacency_.neighbour(p, opposite(at_b_[k]));
    if (!x.is_none() && corner(t_.p2v_.begin(x.poly()), a_) != none) return false;
  }
  return true;
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::collapse::reserve() {
  const auto at_edge = static_cast<std::uint32_t>(at_edge_.size()), moved = n_ - at_edge;
  const std::uint32_t fresh = t_.incident_edges_.num_edges(b_) - 1 - at_edge;
  detail::reserve_lists_of_verts(t_.incident_edges_, t_.v2p_, std::array{detail::vert_change{at_edge, moved, 1, fresh}}, 1, [this](unsigned) { return a_; });
  t_.verts_.reserve_change(1, 0);
  t_.edges_.reserve_change(1 + at_edge, 0);
  t_.faces_.reserve_change(2 * at_edge, 0);
  t_.polys_.reserve_change(at_edge, 0);
}

/// Removes the polys at e and the edges and faces that vanish with them.
template<class Shape, class Lists>
void cell_tables<Shape, Lists>::collapse::remove_polys_at_edge() {
  const auto remove_edge_at = [this](vert_id v, edge_id e) {
    t_.incident_edges_.replace_by_last(v, e);
  };
  for (const poly_id p : at_edge_) {
    const std::uint32_t k = number(p.raw());
    for (std::uint32_t i = 0; i < Shape::verts; ++i) {
      const std::size_t v = t_.p2v_.begin(p.raw())[i].raw();
      if (i == at_b_[k]) continue;
      t_.v2p_.remove_at(v, t_.v2p_.find_in_row(v, p));
      t_.faces_.remove(t_.facet_adjacency_.facets(p)[opposite(i)]);
    }
    t_.polys_.remove(p);
  }
  remove_edge_at(a_, e_);
  t_.edges_.remove(e_);
  for (const ring_vert& x : ring_) {
    remove_edge_at(x.v, x.to_b);
    t_.edges_.remove(x.to_b);
  }
}

/// Appends the polys and edges that move from b to a to the lists of a.
template<class Shape, class Lists>
void cell_tables<Shape, Lists>::collapse::move_edges() {
  for (std::uint32_t k = 0; k < n_; ++k) {
    if (at_a_[k] != none) continue;
    t_.v2p_.push_reserved(a_.raw(), polys_[k]);
    for (const std::uint32_t j : shape.vert_edge[at_b_[k]]) {
      const edge_id e = t_.p2e_.begin(polys_[k].raw())[j];
      vert_id* const ends = t_.e2v_.begin(e.raw());
      if ((ends[0] != b_ && ends[1] != b_) || !t_.edges_.contains(e)) continue;
      const vert_id v = ends[0] == b_ ? ends[1] : ends[0];
      ends[0] = std::min(a_, v), ends[1] = std::max(a_, v);
      t_.incident_edges_.set_other_end(v, e, a_);
      t_.incident_edges_.push(a_, v, e);
    }
  }
}

/// Gives poly k the vert a instead of b. It becomes the first poly of its edges and faces that belong to a poly at b first, so the last poly comes first.
template<class Shape, class Lists>
void cell_tables<Shape, Lists>::collapse::change_poly(std::uint32_t k) {
  detail::facet_adjacency<face_id, Shape::faces>& all = t_.facet_adjacency_;
  const poly_id p = polys_[k];
  for (std::uint32_t j = 0; j < Shape::faces; ++j) {
    const face_id f = all.facets(p)[j];
    if (j == opposite(at_b_[k])) {
      const detail::encoded_neighbour outside = all.neighbour(p, j);
      if (!outside.is_none() && all.owner(f).poly == p.raw()) all.put(p, j, f, outside);
    } else if (const std::uint32_t other = behind_[k][j]; at_a_[other] == none) {
      all.set_first(f, p, j);
    } else {
      const std::uint32_t i = opposite(at_b_[other]);
      all.put(p, j, all.facets(polys_[other])[i], all.neighbour(polys_[other], i));
    }
  }
  vert_id* const v = t_.p2v_.begin(p.raw());
  edge_id* const e = t_.p2e_.begin(p.raw());
  for (std::uint32_t j = 0; j < Shape::edges; ++j) {
    const std::uint32_t i = Shape::edge_vert[j][0], other = Shape::edge_vert[j][1];
    if (i == at_b_[k] || other == at_b_[k])
      if (const ring_vert* const x = ring_vert_at(v[i == at_b_[k] ? other : i])) e[j] = x->to_a;
    std::uint32_t& first = t_.e2p_[e[j].raw()];
    if (number(first) < n_) first = p.raw();
  }
  v[at_b_[k]] = a_;
}

template<class Shape, class Lists>
direct_edit cell_tables<Shape, Lists>::collapse::run() {
  if (!find_polys() || !is_sphere()) return direct_edit::left_to_rewire;
  find_ring();
  const std::size_t faces_at_b = n_ + n_ / 2;
  if (faces_at_b * (faces_at_b - 2 * at_edge_.size()) > max_pairs) return direct_edit::left_to_rewire;
  if (!link_condition_holds()) return direct_edit::refused;
  reserve();
  remove_polys_at_edge();
  move_edges();
  for (std::uint32_t k = n_; k-- > 0;)
    if (at_a_[k] == none) change_poly(k);
  t_.incident_edges_.clear(b_), t_.v2p_.clear_row(b_.raw());
  t_.verts_.remove(b_);
  return direct_edit::done;
}

template<class Shape, class Lists>
direct_edit cell_tables<Shape, Lists>::collapse_edge(edge_id e)
  requires(Shape::verts == 4)
{
  return collapse(*this, e).run();
}

}  // namespace concino
