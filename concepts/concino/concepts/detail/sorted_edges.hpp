// Sorts the edges of a polygon, or of a tet, into the order that the laws require, for models that declare
// edges_in_order = false.
#pragma once

#include <concino/concepts/mesh_traits.hpp>

namespace concino::detail {

/// True for models that declare that their lists have another order: static constexpr bool edges_in_order = false;
template<class M> concept lists_edges_unordered = requires { requires !traits<M>::edges_in_order; };

/// The adjacencies used for polygons that are polys, and for those that are faces.
template<class M>
struct edges_of_polys {
  using type = poly_t<M>;
  static decltype(auto) verts(const M& m, const type& p) { return traits<M>::adj_p2v(m, p); }
  static decltype(auto) edges(const M& m, const type& p) { return traits<M>::adj_p2e(m, p); }
  static decltype(auto) owners(const M& m, const edge_t<M>& e) { return traits<M>::adj_e2p(m, e); }
};
template<class M>
struct edges_of_faces {
  using type = face_t<M>;
  static decltype(auto) verts(const M& m, const type& f) { return traits<M>::adj_f2v(m, f); }
  static decltype(auto) edges(const M& m, const type& f) { return traits<M>::adj_f2e(m, f); }
  static decltype(auto) owners(const M& m, const edge_t<M>& e) { return traits<M>::adj_e2f(m, e); }
};

/// Finds an edge of x by its ends.
template<class M, class Of>
class edge_finder {
  using vert = vert_t<M>;
  using edge = edge_t<M>;
  using owner = typename Of::type;
  using list = decltype(Of::edges(std::declval<const M&>(), std::declval<const owner&>()));

  const M* m_;
  owner x_;
  list listed_;

  bool joins(const edge& e, const vert& a, const vert& b) const {
    const auto& ends = traits<M>::adj_e2v(*m_, e);
    auto it = ends.begin();
    if (!(it != ends.end())) return false;  // the edge may violate the law that it has two verts
    const vert c = *it;
    ++it;
    if (!(it != ends.end())) return false;
    const vert d = *it;
    return (c == a && d == b) || (c == b && d == a);
  }
  bool is_of_owner(const edge& e) const {
    for (const owner y : Of::owners(*m_, e))
      if (y == x_) return true;
    return false;
  }

 public:
  static constexpr std::size_t max_compared = 8;  // with more edges, each is searched at its ends

  edge_finder(const M& m, const owner& x) : m_(&m), x_(x), listed_(Of::edges(m, x)) {}

  /// The edge of x between a and b; if there is none, which violates a law, some edge of x.
  edge among_all(const vert& a, const vert& b) const {
    edge some{};
    for (const edge e : listed_) {
      if (joins(e, a, b)) return e;
      some = e;
    }
    return some;
  }
  /// The same by a simultaneous walk over the edges at a and those at b; it ends with the shorter of the two.
  edge at_ends(const vert& a, const vert& b) const {
    const auto& from_a = traits<M>::adj_v2e(*m_, a);
    const auto& from_b = traits<M>::adj_v2e(*m_, b);
    auto i = from_a.begin();
    auto j = from_b.begin();
    while (i != from_a.end() && j != from_b.end()) {
      if (const edge e = *i; joins(e, a, b) && is_of_owner(e)) return e;
      if (const edge e = *j; joins(e, a, b) && is_of_owner(e)) return e;
      ++i;
      ++j;
    }
    return among_all(a, b);
  }
};

/// The sorted edges of a polygon: edge k joins the verts k and k + 1; the last edge joins the last vert and the first.
template<class M, class Of>
class edges_along_ring {
  using vert = vert_t<M>;
  using edge = edge_t<M>;
  using owner = typename Of::type;
  using ring = decltype(Of::verts(std::declval<const M&>(), std::declval<const owner&>()));
  using base_iterator = decltype(std::declval<const std::remove_reference_t<ring>&>().begin());

  ring ring_;
  edge_finder<M, Of> find_;
  bool is_long_ = false;

 public:
  struct sentinel {};
  class iterator {
    const edges_along_ring* r_;
    base_iterator at_;
    vert first_{};

   public:
    explicit iterator(const edges_along_ring& r) : r_(&r), at_(r.ring_.begin()) {
      if (*this != sentinel()) first_ = *at_;
    }
    edge operator*() const {
      const vert from = *at_;
      base_iterator next = at_;
      ++next;
      vert to = first_;
      if (next != r_->ring_.end()) to = *next;
      return r_->is_long_ ? r_->find_.at_ends(from, to) : r_->find_.among_all(from, to);
    }
    iterator& operator++() {
      ++at_;
      return *this;
    }
    bool operator!=(sentinel) const { return at_ != r_->ring_.end(); }
  };

  edges_along_ring(const M& m, const owner& x) : ring_(Of::verts(m, x)), find_(m, x) {
    std::size_t n = 0;
    for (auto it = ring_.begin(); it != ring_.end() && !is_long_; ++it)
      is_long_ = ++n > edge_finder<M, Of>::max_compared;
  }
  edges_along_ring(const edges_along_ring&) = delete;

  iterator begin() const { return iterator(*this); }
  sentinel end() const { return {}; }
};

/// The sorted edges of a tet: 01 02 03 12 13 23.
template<class M>
class edges_of_tet {
  using vert = vert_t<M>;
  using edge = edge_t<M>;

  vert corner_[4] = {vert(), vert(), vert(), vert()};
  edge_finder<M, edges_of_polys<M>> find_;

 public:
  struct sentinel {};
  class iterator {
    const edges_of_tet* r_;
    unsigned i_ = 0, j_ = 1;

   public:
    explicit iterator(const edges_of_tet& r) : r_(&r) {}
    edge operator*() const { return r_->find_.among_all(r_->corner_[i_], r_->corner_[j_]); }
    iterator& operator++() {
      if (++j_ == 4) j_ = ++i_ + 1;
      return *this;
    }
    bool operator!=(sentinel) const { return i_ != 3; }
  };

  edges_of_tet(const M& m, const poly_t<M>& p) : find_(m, p) {
    unsigned n = 0;
    for (const vert v : traits<M>::adj_p2v(m, p))
      if (n < 4) corner_[n++] = v;
  }
  edges_of_tet(const edges_of_tet&) = delete;

  iterator begin() const { return iterator(*this); }
  sentinel end() const { return {}; }
};

template<class M, int = dimension_v<M>>
struct sorted_edges_of_poly {
  using type = edges_along_ring<M, edges_of_polys<M>>;
};
template<class M> struct sorted_edges_of_poly<M, 3> { using type = edges_of_tet<M>; };

/// Whether the verbs sort. The order is defined for the polys of surfaces and for tets, and for all faces. If the
/// member does not return a range of edges, the verbs do not sort, so that explain_...() can say what is wrong with it.
template<class M>
struct order_of_edges {
  static constexpr bool sorts_those_of_polys = lists_edges_unordered<M> &&
                                               (dimension_v<M> == 2 || (dimension_v<M> == 3 && arity_v<M> == 4)) &&
                                               requires(const M& m, poly_t<M> p) {
    { traits<M>::adj_p2e(m, p) } -> ElementRange<edge_t<M>>;
  };
  static constexpr bool sorts_those_of_faces = lists_edges_unordered<M> && dimension_v<M> == 3 &&
      requires(const M& m, face_t<M> f) { { traits<M>::adj_f2e(m, f) } -> ElementRange<edge_t<M>>; };
  using of_poly = typename sorted_edges_of_poly<M>::type;
  using of_face = edges_along_ring<M, edges_of_faces<M>>;
};

}  // namespace concino::detail

namespace concino::requirement {

// What sorting uses: the ends of edges; for polygons with many edges, so not for tets, also the edges at verts.
template<class M> concept has_edges_by_ends = requires(const M& m, edge_t<M> e) {
  { traits<M>::adj_e2v(m, e) } -> ElementRange<vert_t<M>>;
};
template<class M> concept has_polys_edges_by_ends = has_edges_by_ends<M> && requires(const M& m, poly_t<M> p) {
  { traits<M>::adj_p2v(m, p) } -> ElementRange<vert_t<M>>;
};
template<class M> concept has_edges_at_verts = requires(const M& m, vert_t<M> v) {
  { traits<M>::adj_v2e(m, v) } -> ElementRange<edge_t<M>>;
};

/// The edges of polys (of faces) need no sorting, or the traits have all that sorting needs.
template<class M>
concept can_sort_edges_of_polys =
    !concino::detail::order_of_edges<M>::sorts_those_of_polys || (dimension_v<M> == 3 && has_polys_edges_by_ends<M>) ||
    (has_polys_edges_by_ends<M> && has_edges_at_verts<M> && requires(const M& m, edge_t<M> e) {
      { traits<M>::adj_e2p(m, e) } -> ElementRange<poly_t<M>>;
    });
template<class M>
concept can_sort_edges_of_faces = !concino::detail::order_of_edges<M>::sorts_those_of_faces ||
    (has_edges_by_ends<M> && has_edges_at_verts<M> && requires(const M& m, edge_t<M> e, face_t<M> f) {
      { traits<M>::adj_f2v(m, f) } -> ElementRange<vert_t<M>>;
      { traits<M>::adj_e2f(m, e) } -> ElementRange<face_t<M>>;
    });

}  // namespace concino::requirement

namespace concino::mistake {

inline constexpr sentence give_edge_order_of_polys("mesh_traits<M> says edges_in_order = false: to sort, adj_p2e needs adj_p2v and adj_e2v, on a surface adj_v2e and adj_e2p too");
inline constexpr sentence give_edge_order_of_faces("mesh_traits<M> says edges_in_order = false: to sort, adj_f2e needs adj_f2v, adj_e2v, adj_v2e and adj_e2f");

}  // namespace concino::mistake
