// The rings that halfedge_kernel gives: walks around a vert or along a poly, computed as they are walked.
#pragma once

#include <concino/concepts/mesh_traits.hpp>

namespace concino::detail {

enum class around { v2v, v2e, v2p, p2v, p2e };

/// What the half-edges that leave a vert, or go along a poly, show: their far ends, edges or polys.
template<class M, class K, around Ring>
class halfedge_ring {
  using halfedge = typename K::halfedge;
  static constexpr bool at_vert = Ring == around::v2v || Ring == around::v2e || Ring == around::v2p;

  const M* m_ = nullptr;
  halfedge first_{};
  bool empty_ = true;

 public:
  class iterator {
    const M* m_ = nullptr;
    halfedge first_{}, at_{};
    bool done_ = true;

    void step() {
      if constexpr (at_vert) at_ = K::next(*m_, K::opposite(*m_, at_));
      else at_ = K::next(*m_, at_);
      done_ = at_ == first_;
    }
    void skip_border() {
      if constexpr (Ring == around::v2p) while (!done_ && K::is_border(*m_, at_)) step();
    }

   public:
    using value_type = std::conditional_t<Ring == around::v2v || Ring == around::p2v, typename K::vert,
                                          std::conditional_t<Ring == around::v2p, typename K::poly, typename K::edge>>;
    using difference_type = std::ptrdiff_t;

    iterator() = default;
    iterator(const M* m, const halfedge& first, bool done) : m_(m), first_(first), at_(first), done_(done) { skip_border(); }
    value_type operator*() const {
      if constexpr (Ring == around::v2v || Ring == around::p2v) return K::target(*m_, at_);
      else if constexpr (Ring == around::v2p) return K::poly_of(*m_, at_);
      else return K::edge_of(*m_, at_);
    }
    iterator& operator++() {
      step();
      skip_border();
      return *this;
    }
    iterator operator++(int) {
      iterator old = *this;
      ++*this;
      return old;
    }
    friend bool operator==(const iterator& a, const iterator& b) { return a.done_ == b.done_ && (a.done_ || a.at_ == b.at_); }
  };

  template<class X>
  static halfedge_ring of(const M& m, const X& x) {
    halfedge_ring r;
    r.m_ = &m;
    if constexpr (at_vert) {
      if (K::is_isolated(m, x)) return r;
    }
    r.first_ = K::halfedge_of(m, x);
    if constexpr (Ring == around::p2e) r.first_ = K::next(m, r.first_);  // so that it leaves the first vert: edges_in_order
    r.empty_ = false;
    return r;
  }
  iterator begin() const { return {m_, first_, empty_}; }
  iterator end() const { return {}; }
};

/// The polys across the edges of a poly, each once and without the poly itself.
template<class M, class K>
class halfedge_neighbours {
  using halfedge = typename K::halfedge;
  using poly = typename K::poly;

  const M* m_;
  poly p_;

 public:
  class iterator {
    const M* m_ = nullptr;
    poly p_{}, q_{};
    halfedge first_{}, at_{};
    bool done_ = true;
    unsigned shown_ = 0;
    // The first polys that were shown: enough to know all of a triangle's or quad's. Named one by one, since a descriptor's default
    // constructor may be explicit.
    poly recent_[4] = {poly(), poly(), poly(), poly()};

    /// Whether an edge before at_ has shown q_. Walks back along p and around q at once: the shorter way decides, except where q borders p
    /// more than once.
    bool shown_before() const {
      const unsigned known = shown_ < 4 ? shown_ : 4;
      for (unsigned i = 0; i < known; ++i)
        if (recent_[i] == q_) return true;
      if (shown_ <= 4) return false;
      const halfedge start = K::opposite(*m_, at_);
      halfedge g = start;
      bool around_q = true, once = true;
      for (halfedge h = first_; !(h == at_); h = K::next(*m_, h)) {
        if (faces_q(h)) return true;
        if (!around_q || !once) continue;
        g = K::next(*m_, g);
        around_q = !(g == start);
        if (!around_q) return false;
        const halfedge o = K::opposite(*m_, g);
        once = K::is_border(*m_, o) || !(K::poly_of(*m_, o) == p_);
      }
      return false;
    }
    bool faces_q(const halfedge& h) const {
      const halfedge o = K::opposite(*m_, h);
      return !K::is_border(*m_, o) && K::poly_of(*m_, o) == q_;
    }
    void find() {
      for (; !done_; step()) {
        const halfedge o = K::opposite(*m_, at_);
        if (K::is_border(*m_, o)) continue;
        q_ = K::poly_of(*m_, o);
        if (q_ == p_ || shown_before()) continue;
        if (shown_ < 4) recent_[shown_] = q_;
        ++shown_;
        return;
      }
    }
    void step() {
      at_ = K::next(*m_, at_);
      done_ = at_ == first_;
    }

   public:
    using value_type = poly;
    using difference_type = std::ptrdiff_t;

    iterator() = default;
    iterator(const M& m, const poly& p) : m_(&m), p_(p), first_(K::halfedge_of(m, p)), at_(first_), done_(false) { find(); }
    poly operator*() const { return q_; }
    iterator& operator++() {
      step();
      find();
      return *this;
    }
    iterator operator++(int) {
      iterator old = *this;
      ++*this;
      return old;
    }
    friend bool operator==(const iterator& a, const iterator& b) { return a.done_ == b.done_ && (a.done_ || a.at_ == b.at_); }
  };

  halfedge_neighbours(const M& m, const poly& p) : m_(&m), p_(p) {}
  iterator begin() const { return {*m_, p_}; }
  iterator end() const { return {}; }
};

/// None, one or two elements, held in the range itself.
template<class T>
class up_to_two {
  T x_[2] = {T(), T()};
  unsigned n_ = 0;

 public:
  constexpr up_to_two() = default;
  constexpr explicit up_to_two(const T& a) : x_{a, T()}, n_(1) {}
  constexpr up_to_two(const T& a, const T& b) : x_{a, b}, n_(2) {}
  constexpr const T* begin() const { return x_; }
  constexpr const T* end() const { return x_ + n_; }
};

}  // namespace concino::detail
