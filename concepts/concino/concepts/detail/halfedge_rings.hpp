// The ranges that halfedge_kernel returns: traversals around a vert or along a poly, computed lazily.
#pragma once

#include <concino/concepts/detail/border_halfedges.hpp>
#include <concino/concepts/mesh_traits.hpp>

namespace concino::detail {

enum class ring_kind { v2v, v2e, v2p, p2v, p2e };

/// The elements at the half-edges that leave a vert, or that go along a poly: far ends, edges or polys.
template<class M, class K, ring_kind Ring>
class halfedge_ring {
  using halfedge = typename K::halfedge;
  static constexpr bool at_vert = Ring == ring_kind::v2v || Ring == ring_kind::v2e || Ring == ring_kind::v2p;

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
      if constexpr (Ring == ring_kind::v2p) while (!done_ && K::is_border(*m_, at_)) step();
    }

   public:
    using value_type =
        std::conditional_t<Ring == ring_kind::v2v || Ring == ring_kind::p2v, typename K::vert,
                           std::conditional_t<Ring == ring_kind::v2p, typename K::poly, typename K::edge>>;
    using difference_type = std::ptrdiff_t;

    iterator() = default;
    iterator(const M* m, const halfedge& first, bool done) : m_(m), first_(first), at_(first), done_(done) {
      skip_border();
    }
    value_type operator*() const {
      if constexpr (Ring == ring_kind::v2v || Ring == ring_kind::p2v) return K::target(*m_, at_);
      else if constexpr (Ring == ring_kind::v2p) return K::poly_of(*m_, at_);
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
    friend bool operator==(const iterator& a, const iterator& b) {
      return a.done_ == b.done_ && (a.done_ || a.at_ == b.at_);
    }
  };

  template<class X>
  static halfedge_ring of(const M& m, const X& x) {
    halfedge_ring r;
    r.m_ = &m;
    if constexpr (at_vert) {
      if (K::is_isolated(m, x)) return r;
    }
    r.first_ = K::halfedge_of(m, x);
    if constexpr (Ring == ring_kind::p2e) r.first_ = K::next(m, r.first_);  // so that it leaves the first vert: SM7
    r.empty_ = false;
    return r;
  }
  /// Calls f(x) for all of them in the same order, as a plain loop without an iterator's state.
  template<class F>
  constexpr void for_each(F&& f) const {
    if (empty_) return;
    const M& m = *m_;
    const halfedge first = first_;
    halfedge h = first;
    do {
      if constexpr (Ring == ring_kind::v2v || Ring == ring_kind::p2v) f(K::target(m, h));
      else if constexpr (Ring == ring_kind::v2e || Ring == ring_kind::p2e) f(K::edge_of(m, h));
      else if (!K::is_border(m, h)) f(K::poly_of(m, h));
      if constexpr (at_vert) h = K::next(m, K::opposite(m, h));
      else h = K::next(m, h);
    } while (!(h == first));
  }
  iterator begin() const { return {m_, first_, empty_}; }
  iterator end() const { return {}; }
};

/// The polys behind the edges of a poly, each once and without the poly itself.
template<class M, class K>
class halfedge_neighbours {
  using halfedge = typename K::halfedge;
  using poly = typename K::poly;

  const M* m_;
  poly p_;

  static bool faces(const M& m, const halfedge& h, const poly& q) {
    const halfedge o = K::opposite(m, h);
    return !K::is_border(m, o) && K::poly_of(m, o) == q;
  }
  /// Whether q, the poly behind `at`, is also behind an edge of p from `first` up to `at`. It walks along p and around
  /// q at the same time and stops after the shorter walk, unless q is adjacent to p more than once. Not inlined and by
  /// value, so that loops around it keep their values in registers.
  static bool is_adjacent_between(const M& m, poly p, poly q, halfedge first, halfedge at) {
    const halfedge start = K::opposite(m, at);
    halfedge g = start;
    bool once = true;
    for (halfedge h = first; !(h == at); h = K::next(m, h)) {
      if (faces(m, h, q)) return true;
      if (!once) continue;
      g = K::next(m, g);
      if (g == start) return false;
      once = !faces(m, g, p);
    }
    return false;
  }

 public:
  class iterator {
    const M* m_ = nullptr;
    poly p_{}, q_{};
    halfedge first_{}, at_{};
    bool done_ = true;
    unsigned num_visited_ = 0;
    // The first polys found: enough to detect all repetitions in a triangle or quad. Constructed one by one, since a
    // descriptor's default constructor may be explicit.
    poly recent_[4] = {poly(), poly(), poly(), poly()};

    bool is_repeated() const {
      const unsigned known = num_visited_ < 4 ? num_visited_ : 4;
      for (unsigned i = 0; i < known; ++i)
        if (recent_[i] == q_) return true;
      return num_visited_ > 4 && is_adjacent_between(*m_, p_, q_, first_, at_);
    }
    void find() {
      for (; !done_; step()) {
        const halfedge o = K::opposite(*m_, at_);
        if (K::is_border(*m_, o)) continue;
        q_ = K::poly_of(*m_, o);
        if (q_ == p_ || is_repeated()) continue;
        if (num_visited_ < 4) recent_[num_visited_] = q_;
        ++num_visited_;
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
    iterator(const M& m, const poly& p) : m_(&m), p_(p), first_(K::halfedge_of(m, p)), at_(first_), done_(false) {
      find();
    }
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
    friend bool operator==(const iterator& a, const iterator& b) {
      return a.done_ == b.done_ && (a.done_ || a.at_ == b.at_);
    }
  };

  halfedge_neighbours(const M& m, const poly& p) : m_(&m), p_(p) {}
  /// Calls f(q) for all of them in the same order. f is called at one place only, so that compilers inline it. The last
  /// four polys found (p: none yet) are variables, not an array, so that they stay in registers; a triangle uses two of
  /// them.
  template<class F>
  constexpr void for_each(F&& f) const {
    const M& m = *m_;
    const poly p = p_;
    const halfedge first = K::halfedge_of(m, p);
    poly a = p, b = p, c = p, d = p;
    halfedge h = first;
    do {
      const halfedge at = h, o = K::opposite(m, h);
      h = K::next(m, h);
      if (K::is_border(m, o)) continue;
      const poly q = K::poly_of(m, o);
      if (q == p) continue;
      if (q == a) continue;
      if (q == b) continue;
      if (!(c == p)) {
        if (q == c || q == d) continue;
        if (!(d == p) && is_adjacent_between(m, p, q, first, at)) continue;
      }
      d = c;
      c = b;
      b = a;
      a = q;
      f(q);
    } while (!(h == first));
  }
  /// Calls f(q) for the poly behind each edge. A poly behind several edges is repeated, and p itself occurs if it is on
  /// both sides of an edge. For loops in which repetitions do no harm: they avoid the cost of finding them.
  template<class F>
  constexpr void for_each_with_repeats(F&& f) const {
    const M& m = *m_;
    const halfedge first = K::halfedge_of(m, p_);
    halfedge h = first;
    do {
      if (const halfedge o = K::opposite(m, h); !K::is_border(m, o)) f(K::poly_of(m, o));
      h = K::next(m, h);
    } while (!(h == first));
  }
  iterator begin() const { return {*m_, p_}; }
  iterator end() const { return {}; }
};

/// Zero, one or two elements, stored in the range itself.
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
