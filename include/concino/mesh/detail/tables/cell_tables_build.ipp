// Construction of tables of tets and hexes; see cell_tables.hpp.
#pragma once

#include <concino/mesh/cell_tables.hpp>
#include <concino/mesh/detail/tables/visited_faces.hpp>

namespace concino {

/// The builder. Every edge and face gets its number at its smallest vert: verts are visited in order, and the polys at
/// each vert in order.
template<class Shape, class Lists>
class cell_tables<Shape, Lists>::builder {
  /// The number of polys at an edge, for edges with `many` or more.
  struct edge_use {
    std::uint32_t edge, polys;
  };

  static constexpr std::uint8_t many = 255;

  cell_tables& t_;
  const std::size_t vert_count_;
  const std::uint32_t poly_count_ = static_cast<std::uint32_t>(t_.p2v_.size());
  std::uint32_t edge_count_ = 0, face_count_ = 0;
  core::flat_array<std::uint32_t> edge_to_;  // at vert a: [b] is the edge between a and b if it was met at a already
  core::flat_array<vert_id> ends_, v2v_;
  core::flat_array<edge_id> v2e_;
  core::flat_array<std::uint8_t> uses_;  // number of polys of each edge; `many` means `many` or more
  std::vector<edge_use> used_often_;     // sorted by edge
  detail::offsets vert_offsets_;
  detail::visited_faces<Shape::face_verts> visited_faces_;  // at a

  /// The write positions for the next edge of a and its next neighbour.
  struct cursor {
    vert_id* end;
    vert_id* near;
    edge_id* near_edge;
    std::uint32_t edge_count;
  };

  /// Corner i of a poly, at a: the neighbours of a in the poly, and, for larger ones, the local number of the edge of a
  /// that leads there.
  struct corner {
    std::uint32_t poly, i;
    std::uint32_t far[valence], visited[valence];
  };

  void list_corners();
  void reserve();
  void visit(std::uint32_t a);
  void meet_edges(std::uint32_t a, std::uint32_t first_edge, corner& x, cursor& at);
  void meet_faces(std::uint32_t a, std::uint32_t first_face, const corner& x);
  void mark_edges_added_since(std::uint32_t first_edge, std::uint32_t a);
  void hand_over();
  void check_fans();

  /// The number of polys at edge e, of which `met` were counted.
  std::uint32_t polys_at(std::uint32_t e, std::uint8_t visited) const {
    if (visited != many) return visited;
    return std::lower_bound(used_often_.begin(), used_often_.end(), e,
                            [](const edge_use& x, std::uint32_t y) { return x.edge < y; })
        ->polys;
  }

 public:
  builder(cell_tables& t, std::size_t vert_count)
      : t_(t), vert_count_(vert_count), edge_to_(vert_count), vert_offsets_(vert_count + 1, 0) {}

  void run() {
    list_corners();
    reserve();
    for (std::uint32_t a = 0; a < vert_count_; ++a) visit(a);
    hand_over();
    check_fans();
    t_.list_polys_of_edges();
  }
};

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::build(std::size_t vert_count) { builder(*this, vert_count).run(); }

/// Lists the corners at each vert; visit() replaces them by polys.
template<class Shape, class Lists>
void cell_tables<Shape, Lists>::builder::list_corners() {
  const vert_id* const corner_vert = t_.p2v_.begin(0);
  detail::offsets counts(vert_count_ + 1, 0);
  for (std::uint32_t p = 0; p < poly_count_; ++p) {
    if (!detail::are_distinct_verts<Shape::verts>(t_.p2v_.begin(p), vert_count_)) {
      std::vector<std::uint32_t> visited;
      detail::check_verts(t_.p2v_[p], vert_count_, "cell_tables: poly", p, visited);
    }
    for (unsigned i = 0; i < Shape::verts; ++i) ++counts[t_.p2v_.begin(p)[i].raw() + 1];
  }
  t_.v2p_ = detail::make_jagged_array<poly_id>(std::move(counts));
  std::uint32_t* const next = edge_to_.data();
  std::copy_n(t_.v2p_.shared_offsets()->begin(), vert_count_, next);
  poly_id* const corners = t_.v2p_.begin(0);
  for (std::size_t c = 0; c < t_.p2v_.num_values(); ++c) corners[next[corner_vert[c].raw()]++] = poly_id{c};
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::builder::reserve() {
  const std::size_t n = poly_count_;
  t_.p2e_ = detail::jagged_array<edge_id, Shape::edges>(poly_count_, edge_id{});
  t_.facet_adjacency_ = {detail::jagged_array<face_id, Shape::faces>(poly_count_, face_id{}),
                         detail::jagged_array<detail::encoded_neighbour, Shape::faces>(poly_count_)};
  std::fill_n(edge_to_.data(), vert_count_, ~0u);
  const std::size_t guess = std::min(vert_count_ + (Shape::faces / 2 - 1) * n + n / 8 + 64, n * Shape::edges);
  ends_.reserve(2 * guess);
  v2v_.reserve(2 * guess);
  v2e_.reserve(2 * guess);
  t_.e2p_.reserve(guess);
  uses_.reserve(guess);
  t_.facet_adjacency_.reserve_facets(Shape::faces / 2 * n + n / 8 + 64);
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::builder::visit(std::uint32_t a) {
  const std::uint32_t first_edge = edge_count_, first_face = face_count_;
  visited_faces_.clear();
  const std::size_t most = std::size_t{valence} * t_.v2p_.length(a);
  cursor at{ends_.reserve_back(2 * most), v2v_.reserve_back(most), v2e_.reserve_back(most), edge_count_};
  t_.e2p_.reserve_back(most);
  uses_.reserve_back(most);
  for (poly_id *c = t_.v2p_.begin(a), *last = c + t_.v2p_.length(a); c != last; ++c) {
    corner x{c->raw() / Shape::verts, c->raw() % Shape::verts, {}, {}};
    meet_edges(a, first_edge, x, at);
    meet_faces(a, first_face, x);
    *c = poly_id{x.poly};
  }
  edge_count_ = at.edge_count;
  ends_.resize(2 * std::size_t{edge_count_});
  t_.e2p_.resize(edge_count_);
  uses_.resize(edge_count_);
  v2v_.resize(static_cast<std::size_t>(at.near - v2v_.data()));
  v2e_.resize(v2v_.size());
  if (v2v_.size() >= ~0u) throw unsupported("cell_tables: the mesh has more than 2^32 adjacencies of one kind");
  vert_offsets_[a + 1] = static_cast<std::uint32_t>(v2v_.size());
  mark_edges_added_since(first_edge, a);
}

template<class Shape, class Lists>
inline void cell_tables<Shape, Lists>::builder::meet_edges(std::uint32_t a, std::uint32_t first_edge, corner& x,
                                                           cursor& at) {
  const vert_id* const pv = t_.p2v_.begin(x.poly);
  edge_id* const pe = t_.p2e_.begin(x.poly);
  for (unsigned j = 0; j < valence; ++j) {
    const std::uint32_t b = x.far[j] = pv[shape.vert_far[x.i][j]].raw();
    edge_id& named = pe[shape.vert_edge[x.i][j]];
    std::uint32_t e = edge_to_[b];
    if (b < a) {
      if (e == named.raw()) continue;
      e = edge_to_[b] = named.raw();
    } else if (e - first_edge < at.edge_count - first_edge) {
      x.visited[j] = e - first_edge;
      named = edge_id{e};
      uses_.data()[e] += uses_.data()[e] < many;
      continue;
    } else {
      e = edge_to_[b] = at.edge_count++;
      x.visited[j] = e - first_edge;
      named = edge_id{e};
      *at.end++ = vert_id{a};
      *at.end++ = vert_id{b};
      t_.e2p_.data()[e] = x.poly;
      uses_.data()[e] = 1;
      visited_faces_.add_edge();
    }
    *at.near++ = vert_id{b};
    *at.near_edge++ = edge_id{e};
  }
}

/// Finds or adds each face at the corner. It is searched among the faces at the edge from a to the smaller of its two
/// neighbours.
template<class Shape, class Lists>
inline void cell_tables<Shape, Lists>::builder::meet_faces(std::uint32_t a, std::uint32_t first_face,
                                                           const corner& at) {
  const vert_id* const pv = t_.p2v_.begin(at.poly);
  for (unsigned k = 0; k < valence; ++k) {
    // The neighbours of a in the face, the smaller first, and the verts between them: the same for every poly at the
    // face.
    const std::uint8_t* const along = shape.vert_face_vert[at.i][k];
    unsigned x = shape.vert_face_edge[at.i][k][0], y = shape.vert_face_edge[at.i][k][1];
    if (at.far[x] < a || at.far[y] < a) continue;
    if constexpr (Shape::face_verts == 4)
      if (pv[along[1]].raw() < a) continue;
    if (at.far[x] > at.far[y]) std::swap(x, y);
    typename detail::visited_faces<Shape::face_verts>::face wanted;
    wanted.other[0] = at.far[y];
    if constexpr (Shape::face_verts == 4) wanted.other[1] = pv[along[1]].raw();
    const auto [f, is_new] = visited_faces_.find_or_add(at.visited[x], wanted);
    if (is_new) t_.facet_adjacency_.add_facet(at.poly, shape.vert_face[at.i][k], face_id{face_count_++});
    else t_.facet_adjacency_.link(at.poly, shape.vert_face[at.i][k], face_id{first_face + f});
  }
}

/// Marks those edges of a, met since `first_edge`, around which a walk would not meet all polys. All faces at these
/// edges are linked already: the smallest vert of each face is a or was visited before a.
template<class Shape, class Lists>
inline void cell_tables<Shape, Lists>::builder::mark_edges_added_since(std::uint32_t first_edge, std::uint32_t a) {
  if (std::find(uses_.begin() + first_edge, uses_.end(), many) != uses_.end()) {
    std::vector<std::uint32_t> uses_since(edge_count_ - first_edge);
    for (const poly_id p : t_.v2p_[a])
      for (const edge_id e : t_.adj_p2e(p))
        if (e.raw() - first_edge < uses_since.size()) ++uses_since[e.raw() - first_edge];
    for (std::uint32_t e = first_edge; e < edge_count_; ++e)
      if (uses_[e] == many) used_often_.push_back({e, uses_since[e - first_edge]});
  }
  for (std::uint32_t e = first_edge; e < edge_count_; ++e)
    if (uses_[e] > 5 && t_.closes_early(edge_id{e}, polys_at(e, uses_[e])))
      t_.e2p_[e] = detail::encoded_neighbour::special;
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::builder::hand_over() {
  ends_.shrink_to_fit();
  v2v_.shrink_to_fit();
  v2e_.shrink_to_fit();
  t_.e2p_.shrink_to_fit();
  t_.e2v_ = detail::jagged_array<vert_id, 2>(std::move(ends_));
  t_.incident_edges_ = {std::make_shared<const detail::offsets>(std::move(vert_offsets_)), std::move(v2v_),
                        std::move(v2e_)};
  t_.verts_ = detail::alive_elements<vert_id>(vert_count_);
  t_.edges_ = detail::alive_elements<edge_id>(edge_count_);
  t_.faces_ = detail::alive_elements<face_id>(face_count_);
  t_.polys_ = detail::alive_elements<poly_id>(poly_count_);
}

/// Checks the edges for which the assumptions of closes_early() do not hold: at the boundary, at non-manifold facets,
/// and at polys that share two faces. Each edge is checked once, though it has many faces.
template<class Shape, class Lists>
void cell_tables<Shape, Lists>::builder::check_fans() {
  const auto check = [&](edge_id e) {
    const std::uint8_t visited = std::exchange(uses_.data()[e.raw()], 0);
    if (visited > 0 && !t_.is_non_manifold(e)) t_.check_fan(e, polys_at(e.raw(), visited));
  };
  t_.facet_adjacency_.finish();
  for (std::uint32_t f = 0; f < face_count_; ++f)
    if (!t_.facet_adjacency_.has_two_polys_once(face_id{f}))
      for (const edge_id e : t_.adj_f2e(face_id{f})) check(e);
}

}  // namespace concino
