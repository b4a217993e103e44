// Derived adjacencies, for every mesh: adj_e2e, the edges that share a vert with an edge, and in volumes adj_f2f, the
// faces that share an edge with a face.
#pragma once

#include <concino/concepts/mesh.hpp>

namespace concino {

namespace detail {

struct end_sentinel {};

/// The edges at one end of an edge, then those at the other end, without the edge itself and without repetition.
template<class M>
class edges_of_edge {
  using edge = edge_t<M>;
  using vert = vert_t<M>;
  using ring = decltype(adj_v2e(std::declval<const M&>(), std::declval<vert>()));
  using base_iterator = decltype(std::declval<const std::remove_reference_t<ring>&>().begin());

  const M* m_;
  edge e_;
  vert a_;
  ring at_a_, at_b_;

  static vert end_of(const M& m, const edge& e, int which) {
    auto&& ends = adj_e2v(m, e);
    auto it = ends.begin();
    if (which == 1) ++it;
    return *it;
  }
  bool meets_a(const edge& x) const { return end_of(*m_, x, 0) == a_ || end_of(*m_, x, 1) == a_; }

 public:
  class iterator {
    const edges_of_edge* r_;
    base_iterator a_, b_;

    void skip() {
      while (a_ != r_->at_a_.end() && *a_ == r_->e_) ++a_;
      if (a_ != r_->at_a_.end()) return;
      while (b_ != r_->at_b_.end() && (*b_ == r_->e_ || r_->meets_a(*b_))) ++b_;
    }

   public:
    explicit iterator(const edges_of_edge& r) : r_(&r), a_(r.at_a_.begin()), b_(r.at_b_.begin()) { skip(); }
    edge operator*() const { return a_ != r_->at_a_.end() ? *a_ : *b_; }
    iterator& operator++() {
      if (a_ != r_->at_a_.end()) ++a_;
      else ++b_;
      skip();
      return *this;
    }
    bool operator!=(end_sentinel) const { return a_ != r_->at_a_.end() || b_ != r_->at_b_.end(); }
  };

  edges_of_edge(const M& m, const edge& e)
      : m_(&m), e_(e), a_(end_of(m, e, 0)), at_a_(adj_v2e(m, a_)), at_b_(adj_v2e(m, end_of(m, e, 1))) {}
  edges_of_edge(const edges_of_edge&) = delete;

  iterator begin() const { return iterator(*this); }
  end_sentinel end() const { return {}; }
};

/// The faces at each edge of a face, without the face itself and without those at an earlier edge. The position at the
/// edge is stored as a number: an iterator must be copyable, so it cannot store a ring of the mesh.
template<class M>
class faces_of_face {
  using edge = edge_t<M>;
  using face = face_t<M>;
  using ring = decltype(adj_f2e(std::declval<const M&>(), std::declval<face>()));
  using base_iterator = decltype(std::declval<const std::remove_reference_t<ring>&>().begin());

  const M* m_;
  face f_;
  ring face_edges_;

  bool is_at(const face& x, const edge& e) const {
    auto&& face_edges = adj_f2e(*m_, x);
    for (auto it = face_edges.begin(); it != face_edges.end(); ++it)
      if (*it == e) return true;
    return false;
  }

 public:
  class iterator {
    const faces_of_face* r_;
    base_iterator e_;
    std::size_t edges_ = 0, faces_ = 0;  // number of edges before e_, and of faces before x_ at e_
    face x_{};

    bool is_repeated(const face& x) const {
      auto it = r_->face_edges_.begin();
      for (std::size_t i = 0; i < edges_; ++i, ++it)
        if (r_->is_at(x, *it)) return true;
      return false;
    }
    /// Moves to the next face to list, from number faces_ on at this edge, or at a later edge.
    void find() {
      for (; e_ != r_->face_edges_.end(); ++e_, ++edges_, faces_ = 0) {
        auto&& fan = adj_e2f(*r_->m_, *e_);
        std::size_t i = 0;
        for (auto it = fan.begin(); it != fan.end(); ++it, ++i) {
          if (i < faces_) continue;
          x_ = *it;
          if (x_ == r_->f_ || is_repeated(x_)) continue;
          faces_ = i;
          return;
        }
      }
    }

   public:
    explicit iterator(const faces_of_face& r) : r_(&r), e_(r.face_edges_.begin()) { find(); }
    face operator*() const { return x_; }
    iterator& operator++() {
      ++faces_;
      find();
      return *this;
    }
    bool operator!=(end_sentinel) const { return e_ != r_->face_edges_.end(); }
  };

  faces_of_face(const M& m, const face& f) : m_(&m), f_(f), face_edges_(adj_f2e(m, f)) {}
  faces_of_face(const faces_of_face&) = delete;

  iterator begin() const { return iterator(*this); }
  end_sentinel end() const { return {}; }
};

}  // namespace detail

/// The edges that share a vert with e, each once.
/// Needs:  AnyMesh M; e is an edge of m.
/// Result: a range of edges without e: those at one end, then those at the other.
/// Cost:   proportional to the edges at the ends of e; nothing is allocated.
/// Errors: none.
inline constexpr struct adj_e2e_verb : detail::verb {
  using verb::operator();
  template<AnyMesh M>
  constexpr auto operator()(const M& m, edge_t<M> e) const {
    return detail::edges_of_edge<M>(m, e);
  }
} adj_e2e{};

/// The faces of a volume that share an edge with f, each once.
/// Needs:  VolumeMesh M; f is a face of m.
/// Result: a range of faces without f, in the order of the edges of f.
/// Cost:   proportional to the edges of f, times the faces at an edge squared, times the edges of a face; nothing is
///         allocated.
/// Errors: none.
inline constexpr struct adj_f2f_verb : detail::verb {
  using verb::operator();
  template<VolumeMesh M>
  constexpr auto operator()(const M& m, face_t<M> f) const {
    return detail::faces_of_face<M>(m, f);
  }
} adj_f2f{};

}  // namespace concino
