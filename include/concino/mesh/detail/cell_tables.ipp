// Construction and editing of tables of tets and hexes; see cell_tables.hpp.
#pragma once

#include <concino/mesh/cell_tables.hpp>

namespace concino {

template<class Shape, class Lists>
vert_id cell_tables<Shape, Lists>::add_vert(function_ref<void(const detail::index_bounds&)> grow) {
  detail::stage_vertex_incidence(v2v_, v2e_, v2p_);
  verts_.reserve(1);
  if (grow) grow(detail::index_bounds{verts_.bound() + 1, edges_.bound(), faces_.bound(), polys_.bound(), p2v_.num_values()});
  detail::commit_vertex_incidence(v2v_, v2e_, v2p_);
  return verts_.add();
}

template<class Shape, class Lists>
poly_id cell_tables<Shape, Lists>::add_poly(std::span<const vert_id> corners, function_ref<void(const detail::index_bounds&)> grow) {
  const poly_id p{polys_.bound()};
  if (corners.size() != Shape::verts)
    core::throw_joined<invalid_mesh>({"add_poly: poly ", p.raw(), " has ", corners.size(), " verts; every poly of this mesh has ", Shape::verts});
  detail::check_new_verts({corners.data(), corners.data() + corners.size()}, verts_, "add_poly: poly", p.raw());
  vert_id c[Shape::verts];
  std::copy_n(corners.begin(), Shape::verts, c);
  edges_of_new_poly at = find_edges(c);
  edge_id* const e = at.edges;
  face_id* const f = facet_adjacency_.stage_poly(Shape::faces);
  std::uint32_t more_faces = 0;
  for (unsigned k = 0; k < Shape::faces; ++k) {
    f[k] = face_on(c, k);
    more_faces += f[k].is_none();
  }
  for (unsigned i = 0; i < Shape::verts; ++i) {
    detail::reserve_edges_at(v2v_, v2e_, c[i], at.more_at[i]);
    v2p_.reserve_in_row(c[i].raw(), 1);
  }
  p2v_.reserve_rows(1);
  p2e_.reserve_rows(1);
  e2v_.reserve_rows(at.more);
  e2p_.reserve_back(at.more);
  reserve_poly_lists_at(at);
  edges_.reserve(at.more);
  faces_.reserve(more_faces);
  polys_.reserve(1);
  auto scratch = facet_adjacency_.reserve_links(f, Shape::faces, more_faces);
  if (grow)
    grow(detail::index_bounds{verts_.bound(), edges_.bound() + at.more, faces_.bound() + more_faces, polys_.bound() + 1, p2v_.num_values() + Shape::verts});

  for (unsigned j = 0; j < Shape::edges; ++j)
    if (e[j].is_none()) {
      e[j] = detail::add_edge(edges_, e2v_, v2v_, v2e_, c[Shape::edge_vert[j][0]], c[Shape::edge_vert[j][1]]);
      e2p_.push_back(p.raw());
    }
  p2v_.add_row(c, c + Shape::verts);
  p2e_.add_row(e, e + Shape::edges);
  facet_adjacency_.commit_poly(Shape::faces);
  for (unsigned k = 0; k < Shape::faces; ++k) {
    face_id face = f[k];
    if (face.is_none()) {
      face = faces_.add();
      facet_adjacency_.add_facet();
    }
    facet_adjacency_.link(p.raw(), k, face);
  }
  facet_adjacency_.update_marks(p.raw(), std::move(scratch));
  for (const vert_id v : c) v2p_.push(v.raw(), p);
  const poly_id added = polys_.add();
  for (unsigned j = 0; j < Shape::edges; ++j) update_fan(e[j], at.num_polys[j]);
  return added;
}

template<class Shape, class Lists>
auto cell_tables<Shape, Lists>::find_edges(const vert_id* corners) const -> edges_of_new_poly {
  edges_of_new_poly at;
  for (unsigned j = 0; j < Shape::edges; ++j) {
    const unsigned a = Shape::edge_vert[j][0], b = Shape::edge_vert[j][1];
    at.edges[j] = detail::edge_between(v2v_, v2e_, corners[a], corners[b]);
    at.num_polys[j] = 1;
    if (at.edges[j].is_none()) ++at.more, ++at.more_at[a], ++at.more_at[b];
    else at.num_polys[j] += count_polys(at.edges[j]);
  }
  return at;
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::reserve_poly_lists_at(const edges_of_new_poly& at) {
  std::uint32_t more = 0;
  std::size_t polys = 0;
  poly_lists_.make_editable();
  for (unsigned j = 0; j < Shape::edges; ++j) {
    if (at.edges[j].is_none()) continue;
    if (is_non_manifold(at.edges[j])) poly_lists_.reserve_in_row(poly_list_number(at.edges[j]), 1);
    else ++more, polys += at.num_polys[j];
  }
  if (more > 0) poly_lists_.reserve_rows(more, polys);
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::reserve_removal(std::span<const poly_id> polys) {
  v2v_.make_editable();
  v2e_.make_editable();
  v2p_.make_editable();
  poly_lists_.make_editable();
  facet_adjacency_.reserve_removal();
  verts_.reserve_removal();
  edges_.reserve_removal();
  faces_.reserve_removal();
  polys_.reserve_removal();
  std::size_t num_poly_lists = 0, num_listed = 0;
  for (const poly_id p : polys)
    for (const edge_id e : adj_p2e(p)) ++num_poly_lists, num_listed += count_polys(e) - 1;
  if (num_poly_lists > 0) poly_lists_.reserve_rows(num_poly_lists, num_listed);
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::remove_poly(poly_id p) {
  std::uint32_t left[Shape::edges];
  std::size_t num_listed = 0;
  for (unsigned j = 0; j < Shape::edges; ++j) num_listed += left[j] = count_polys(adj_p2e(p)[j]) - 1;
  reserve_removal({});
  poly_lists_.reserve_rows(Shape::edges, num_listed);
  facet_adjacency_.unlink(p.raw());
  for (const face_id f : facet_adjacency_.facets(p))
    if (!facet_adjacency_.is_owned(f)) faces_.remove(f);
  for (const vert_id v : adj_p2v(p)) v2p_.remove(v.raw(), p);
  polys_.remove(p);
  for (unsigned j = 0; j < Shape::edges; ++j) update_fan(adj_p2e(p)[j], left[j]);
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::remove_vert(vert_id v) {
  assert(v2p_[v.raw()].empty());
  verts_.reserve_removal();
  verts_.remove(v);
}

template<class Shape, class Lists>
face_id cell_tables<Shape, Lists>::face_on(std::span<const vert_id> corners, unsigned k) const {
  constexpr unsigned n = Shape::face_verts;
  const auto corner = [&](unsigned i) { return corners[Shape::face_vert[k][i % n]]; };
  for (const poly_id q : adj_v2p(corner(0)))
    for (unsigned j = 0; j < Shape::faces; ++j) {
      const auto other = [&](unsigned i) { return p2v_.begin(q.raw())[Shape::face_vert[j][i % n]]; };
      unsigned at = 0;
      while (at < n && other(at) != corner(0)) ++at;
      if (at == n) continue;
      bool along = true, against = true;
      for (unsigned i = 1; i < n; ++i) {
        along = along && corner(i) == other(at + i);
        against = against && corner(i) == other(at + n - i);
      }
      if (along || against) return adj_p2f(q)[j];
    }
  return {};
}

template<class Shape, class Lists>
std::uint32_t cell_tables<Shape, Lists>::count_polys(edge_id e) const {
  std::uint32_t n = 0;
  for_each_poly_at(e, [&](poly_id) { ++n; });
  return n;
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::update_fan(edge_id e, std::uint32_t n) {
  const bool was_non_manifold = is_non_manifold(e);
  const std::size_t poly_list = was_non_manifold ? poly_list_number(e) : poly_lists_.size();
  if (was_non_manifold) poly_lists_.clear_row(poly_list);
  if (n == 0) {
    detail::remove_edge(edges_, e2v_, v2v_, v2e_, e);
    return;
  }
  poly_id first;
  for_each_poly_at(e, [&](poly_id p) { first = first.is_none() ? p : first; });
  e2p_[e.raw()] = first.raw();
  check_fan(e, n);
  if (e2p_[e.raw()] != detail::encoded_neighbour::special) return;
  e2p_[e.raw()] |= static_cast<std::uint32_t>(poly_list);
  if (!was_non_manifold) poly_lists_.add_row(&first, &first, n);
  for_each_poly_at(e, [&](poly_id p) { poly_lists_.push(poly_list, p); });
}

/// The builder. Every edge and face gets its number at its smallest vert: verts are visited in order, and the polys at each vert in order.
template<class Shape, class Lists>
class cell_tables<Shape, Lists>::builder {
  /// A face found at its smallest vert a: its other verts, except the smaller neighbour of a, and the next face with the same smaller
  /// neighbour.
  struct met_face {
    std::uint32_t other[Shape::face_verts - 2];
    std::uint32_t next;
  };
  static constexpr std::uint32_t longest_list = 24;  // of faces at an edge that are searched one by one

  /// A hash table of the faces at a vert beyond `longest_list` per edge, so that the number of faces at an edge does not matter.
  class further_faces {
    struct slot {
      std::uint32_t edge = 0, face = ~0u;
    };
    std::vector<slot> slots_;
    std::size_t used_ = 0;

    static std::size_t hash(std::uint32_t edge, const met_face& f) {
      std::uint64_t x = edge;
      for (const std::uint32_t v : f.other) {
        x = (x + 1) * 0x9e3779b97f4a7c15u;
        x ^= (x >> 32) ^ v;
      }
      x *= 0x9e3779b97f4a7c15u;
      x ^= x >> 32;
      return static_cast<std::size_t>(x);
    }
    std::size_t find_slot(std::uint32_t edge, const met_face& wanted, const std::vector<met_face>& all) const {
      std::size_t i = hash(edge, wanted) & (slots_.size() - 1);
      while (slots_[i].face != ~0u && !(slots_[i].edge == edge && std::equal(wanted.other, std::end(wanted.other), all[slots_[i].face].other)))
        i = (i + 1) & (slots_.size() - 1);
      return i;
    }

   public:
    void clear() {
      slots_.clear();
      used_ = 0;
    }
    std::uint32_t find(std::uint32_t edge, const met_face& wanted, const std::vector<met_face>& all) const {
      return slots_.empty() ? ~0u : slots_[find_slot(edge, wanted, all)].face;
    }
    /// Adds the last face of `all`, which find() does not find.
    void add(std::uint32_t edge, const std::vector<met_face>& all) {
      if (2 * ++used_ > slots_.size()) {
        const std::vector<slot> old = std::exchange(slots_, std::vector<slot>(std::max<std::size_t>(64, 2 * slots_.size())));
        for (const slot& s : old)
          if (s.face != ~0u) slots_[find_slot(s.edge, all[s.face], all)] = s;
      }
      slots_[find_slot(edge, all.back(), all)] = {edge, static_cast<std::uint32_t>(all.size() - 1)};
    }
  };

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
  std::vector<std::uint32_t> faces_to_;  // per edge of a: the first of the faces met there whose smaller neighbour is the other end
  std::vector<met_face> met_faces_;      // faces met at a
  further_faces further_;                // more faces met at a

  /// The write positions for the next edge of a and its next neighbour.
  struct cursor {
    vert_id* end;
    vert_id* near;
    edge_id* near_edge;
    std::uint32_t edge_count;
  };

  /// Corner i of a poly, at a: the neighbours of a in the poly, and, for larger ones, the local number of the edge of a that leads there.
  struct corner {
    std::uint32_t poly, i;
    std::uint32_t far[valence], met[valence];
  };

  void list_corners();
  void reserve();
  void visit(std::uint32_t a);
  void meet_edges(std::uint32_t a, std::uint32_t first_edge, corner& x, cursor& at);
  void meet_faces(std::uint32_t a, std::uint32_t first_face, const corner& x);
  void mark_edges_met_since(std::uint32_t first_edge, std::uint32_t a);
  void hand_over();
  void check_fans();

  static bool are_distinct_verts(const vert_id* v, std::size_t vert_count) {
    bool good = v[0].raw() < vert_count;
    for (unsigned i = 1; i < Shape::verts; ++i) {
      good &= v[i].raw() < vert_count;
      for (unsigned j = 0; j < i; ++j) good &= v[i] != v[j];
    }
    return good;
  }

  /// The number of polys at edge e, of which `met` were counted.
  std::uint32_t polys_at(std::uint32_t e, std::uint8_t met) const {
    if (met != many) return met;
    return std::lower_bound(used_often_.begin(), used_often_.end(), e, [](const edge_use& x, std::uint32_t y) { return x.edge < y; })->polys;
  }

 public:
  builder(cell_tables& t, std::size_t vert_count) : t_(t), vert_count_(vert_count), edge_to_(vert_count), vert_offsets_(vert_count + 1, 0) {}

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
    if (!are_distinct_verts(t_.p2v_.begin(p), vert_count_)) {
      std::vector<std::uint32_t> met;
      detail::check_verts(t_.p2v_[p], vert_count_, "cell_tables: poly", p, met);
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
  t_.facet_adjacency_ = {detail::jagged_array<face_id, Shape::faces>(poly_count_, face_id{}), detail::jagged_array<detail::encoded_neighbour, Shape::faces>(poly_count_)};
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
  faces_to_.clear();
  met_faces_.clear();
  further_.clear();
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
  if (v2v_.size() >= ~0u) throw unsupported("the mesh has more than 2^32 adjacencies of one kind");
  vert_offsets_[a + 1] = static_cast<std::uint32_t>(v2v_.size());
  mark_edges_met_since(first_edge, a);
}

template<class Shape, class Lists>
[[gnu::always_inline]] inline void cell_tables<Shape, Lists>::builder::meet_edges(std::uint32_t a, std::uint32_t first_edge, corner& x, cursor& at) {
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
      x.met[j] = e - first_edge;
      named = edge_id{e};
      uses_.data()[e] += uses_.data()[e] < many;
      continue;
    } else {
      e = edge_to_[b] = at.edge_count++;
      x.met[j] = e - first_edge;
      named = edge_id{e};
      *at.end++ = vert_id{a};
      *at.end++ = vert_id{b};
      t_.e2p_.data()[e] = x.poly;
      uses_.data()[e] = 1;
      faces_to_.push_back(~0u);
    }
    *at.near++ = vert_id{b};
    *at.near_edge++ = edge_id{e};
  }
}

/// Finds or adds each face at the corner. It is searched among the faces at the edge from a to the smaller of its two neighbours.
template<class Shape, class Lists>
[[gnu::always_inline]] inline void cell_tables<Shape, Lists>::builder::meet_faces(std::uint32_t a, std::uint32_t first_face, const corner& at) {
  const vert_id* const pv = t_.p2v_.begin(at.poly);
  for (unsigned k = 0; k < valence; ++k) {
    // The neighbours of a in the face, the smaller first, and the verts between them: the same for every poly at the face.
    const std::uint8_t* const along = shape.vert_face_vert[at.i][k];
    unsigned x = shape.vert_face_edge[at.i][k][0], y = shape.vert_face_edge[at.i][k][1];
    if (at.far[x] < a || at.far[y] < a) continue;
    if constexpr (Shape::face_verts == 4)
      if (pv[along[1]].raw() < a) continue;
    if (at.far[x] > at.far[y]) std::swap(x, y);
    met_face wanted;
    wanted.other[0] = at.far[y];
    if constexpr (Shape::face_verts == 4) wanted.other[1] = pv[along[1]].raw();
    std::uint32_t& first = faces_to_[at.met[x]];
    std::uint32_t f = first, listed = 0;
    for (; f != ~0u && !std::equal(wanted.other, std::end(wanted.other), met_faces_[f].other); ++listed) f = met_faces_[f].next;
    if (f == ~0u && listed == longest_list) f = further_.find(at.met[x], wanted, met_faces_);
    if (f == ~0u) {
      wanted.next = first;
      if (listed < longest_list) first = static_cast<std::uint32_t>(met_faces_.size());
      met_faces_.push_back(wanted);
      if (listed == longest_list) further_.add(at.met[x], met_faces_);
      t_.facet_adjacency_.add_facet(at.poly, shape.vert_face[at.i][k], face_id{face_count_++});
    } else {
      t_.facet_adjacency_.link(at.poly, shape.vert_face[at.i][k], face_id{first_face + f});
    }
  }
}

/// Marks those edges of a, met since `first_edge`, around which a walk would not meet all polys. All faces at these edges are linked already: the
/// smallest vert of each face is a or was visited before a.
template<class Shape, class Lists>
[[gnu::always_inline]] inline void cell_tables<Shape, Lists>::builder::mark_edges_met_since(std::uint32_t first_edge, std::uint32_t a) {
  if (std::find(uses_.begin() + first_edge, uses_.end(), many) != uses_.end()) {
    std::vector<std::uint32_t> uses_since(edge_count_ - first_edge);
    for (const poly_id p : t_.v2p_[a])
      for (const edge_id e : t_.adj_p2e(p))
        if (e.raw() - first_edge < uses_since.size()) ++uses_since[e.raw() - first_edge];
    for (std::uint32_t e = first_edge; e < edge_count_; ++e)
      if (uses_[e] == many) used_often_.push_back({e, uses_since[e - first_edge]});
  }
  for (std::uint32_t e = first_edge; e < edge_count_; ++e)
    if (uses_[e] > 5 && t_.closes_early(edge_id{e}, polys_at(e, uses_[e]))) t_.e2p_[e] = detail::encoded_neighbour::special;
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::builder::hand_over() {
  ends_.shrink_to_fit();
  v2v_.shrink_to_fit();
  v2e_.shrink_to_fit();
  t_.e2p_.shrink_to_fit();
  t_.e2v_ = detail::jagged_array<vert_id, 2>(std::move(ends_));
  t_.v2v_ = {std::make_shared<const detail::offsets>(std::move(vert_offsets_)), std::move(v2v_)};
  t_.v2e_ = {t_.v2v_.shared_offsets(), std::move(v2e_)};
  t_.verts_ = detail::alive_elements<vert_id>(vert_count_);
  t_.edges_ = detail::alive_elements<edge_id>(edge_count_);
  t_.faces_ = detail::alive_elements<face_id>(face_count_);
  t_.polys_ = detail::alive_elements<poly_id>(poly_count_);
}

/// Checks the edges for which the assumptions of closes_early() do not hold: at the boundary, at non-manifold facets, and at polys that share two
/// faces. Each edge is checked once, though it has many faces.
template<class Shape, class Lists>
void cell_tables<Shape, Lists>::builder::check_fans() {
  const auto check = [&](edge_id e) {
    const std::uint8_t met = std::exchange(uses_.data()[e.raw()], 0);
    if (met > 0 && !t_.is_non_manifold(e)) t_.check_fan(e, polys_at(e.raw(), met));
  };
  t_.facet_adjacency_.finish();
  for (std::uint32_t f = 0; f < face_count_; ++f)
    if (!t_.facet_adjacency_.has_two_polys_once(face_id{f}))
      for (const edge_id e : t_.adj_f2e(face_id{f})) check(e);
}

template<class Shape, class Lists>
bool cell_tables<Shape, Lists>::closes_early(edge_id e, std::uint32_t n) const {
  const poly_id first = first_poly(e);
  poly_id p = first;
  std::uint32_t by = faces_at(p, e)[0];
  for (std::uint32_t steps = 3; steps < n; ++steps) {
    const poly_id next = neighbour_at_face(p, by);
    if (next.is_none()) return false;
    if (next == first) return true;
    const face_id f = adj_p2f(p)[by];
    const auto two = faces_at(next, e);
    by = adj_p2f(next)[two[0]] == f ? two[1] : two[0];
    p = next;
  }
  return neighbour_at_face(p, by) == first;
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::check_fan(edge_id e, std::uint32_t uses) {
  std::uint32_t n = 0;
  const auto around = adj_e2p(e);
  for (auto it = around.begin(), last = around.end(); it != last; ++it) ++n;
  if (n != uses) e2p_[e.raw()] = detail::encoded_neighbour::special;
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::list_polys_of_edges() {
  std::uint32_t num = 0;
  for (std::uint32_t *e = e2p_.data(), *last = e + e2p_.size(); e != last; ++e)
    if (*e & detail::encoded_neighbour::special) *e = detail::encoded_neighbour::special | num++;
  if (num == 0) return;
  const auto for_each_use = [&](auto&& use) {
    for (std::size_t p = 0; p < p2e_.size(); ++p)
      for (const edge_id e : p2e_[p])
        if (is_non_manifold(e)) use(poly_list_number(e), poly_id{p});
  };
  detail::offsets sizes(num + std::size_t{1}, 0);
  for_each_use([&](std::size_t poly_list, poly_id) { ++sizes[poly_list + 1]; });
  poly_lists_ = detail::make_jagged_array<poly_id>(std::move(sizes));
  detail::offsets next(poly_lists_.shared_offsets()->begin(), poly_lists_.shared_offsets()->end() - 1);
  poly_id* const polys = poly_lists_.begin(0);
  for_each_use([&](std::size_t poly_list, poly_id p) { polys[next[poly_list]++] = p; });
}

#ifdef CONCINO_COMPILED
#define CONCINO_DEFINE_CELL_TABLES(TABLES)                                                                         \
  template vert_id TABLES::add_vert(function_ref<void(const detail::index_bounds&)>);                              \
  template poly_id TABLES::add_poly(std::span<const vert_id>, function_ref<void(const detail::index_bounds&)>);    \
  template void TABLES::reserve_removal(std::span<const poly_id>);                                                 \
  template void TABLES::remove_poly(poly_id);                                                                      \
  template void TABLES::remove_vert(vert_id);                                                                      \
  template void TABLES::build(std::size_t)
CONCINO_DEFINE_CELL_TABLES(cell_tables<detail::tet_shape>);
CONCINO_DEFINE_CELL_TABLES(cell_tables<detail::hex_shape>);
#undef CONCINO_DEFINE_CELL_TABLES
#endif

}  // namespace concino
