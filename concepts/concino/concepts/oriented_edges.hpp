// oriented_edges(m, p): the edges of a polygon in cyclic order, each with its start and end vert.
#pragma once

#include <concino/concepts/mesh.hpp>

namespace concino {

/// An edge with a direction.
template<class M>
struct oriented_edge {
  edge_t<M> edge;
  vert_t<M> from, to;
};

namespace detail {

/// Iterates over the edges and verts of a polygon at the same time, which the laws SM7 and VM8 allow.
template<class M, class X, class Verts, class Edges>
class oriented_ring {
  using vert = vert_t<M>;
  using vert_ring = decltype(std::declval<const Verts&>()(std::declval<const M&>(), std::declval<const X&>()));
  using edge_ring = decltype(std::declval<const Edges&>()(std::declval<const M&>(), std::declval<const X&>()));
  using vert_iterator = decltype(std::declval<const std::remove_reference_t<vert_ring>&>().begin());
  using edge_iterator = decltype(std::declval<const std::remove_reference_t<edge_ring>&>().begin());

  vert_ring verts_;
  edge_ring edges_;

 public:
  struct sentinel {};
  class iterator {
    const oriented_ring* r_;
    edge_iterator edge_;
    vert_iterator next_;
    vert first_{}, from_{};

    void step() {
      if (!(next_ != r_->verts_.end())) return;
      from_ = *next_;
      ++next_;
    }

   public:
    explicit iterator(const oriented_ring& r) : r_(&r), edge_(r.edges_.begin()), next_(r.verts_.begin()) {
      step();
      first_ = from_;
    }
    oriented_edge<M> operator*() const {
      if (next_ != r_->verts_.end()) return {*edge_, from_, *next_};
      return {*edge_, from_, first_};
    }
    iterator& operator++() {
      ++edge_;
      step();
      return *this;
    }
    bool operator!=(sentinel) const { return edge_ != r_->edges_.end(); }
  };

  oriented_ring(const M& m, const X& x, const Verts& verts_of, const Edges& edges_of)
      : verts_(verts_of(m, x)), edges_(edges_of(m, x)) {}
  oriented_ring(const oriented_ring&) = delete;

  iterator begin() const { return iterator(*this); }
  sentinel end() const { return {}; }
};

}  // namespace detail

/// The edges of poly p of a surface, or of face f of a volume, in cyclic order:
/// for (const auto& [e, from, to] : oriented_edges(m, p)).
/// Needs:  SurfaceMesh (poly) or VolumeMesh (face).
/// Result: a range of oriented_edge<M>: the k-th goes from the k-th vert of adj_p2v or adj_f2v to the next one, the
///         last to the first.
/// Cost:   that of adj_p2v and adj_p2e, or of adj_f2v and adj_f2e; nothing is allocated.
/// Errors: none.
inline constexpr struct oriented_edges_verb : detail::verb {
  using verb::operator();
  template<SurfaceMesh M>
  constexpr auto operator()(const M& m, poly_t<M> p) const {
    return detail::oriented_ring<M, poly_t<M>, adj_p2v_verb, adj_p2e_verb>(m, p, adj_p2v, adj_p2e);
  }
  template<VolumeMesh M>
  constexpr auto operator()(const M& m, face_t<M> f) const {
    return detail::oriented_ring<M, face_t<M>, adj_f2v_verb, adj_f2e_verb>(m, f, adj_f2v, adj_f2e);
  }
} oriented_edges{};

}  // namespace concino
