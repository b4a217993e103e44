// Filtered ranges and bit masks of elements, from which the views submesh and boundary are built.
#pragma once

#include <concino/concepts/views/forward.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace concino::detail {

/// The elements of a range for which `keep` returns true. It stores the range; iterators must not outlive it, as
/// ElementRange allows.
template<class R, class Keep>
class filtered_range {
  R base_;
  Keep keep_;
  using base_iterator = decltype(std::declval<const std::remove_reference_t<R>&>().begin());

 public:
  struct sentinel {};
  class iterator {
    const filtered_range* r_;
    base_iterator at_;
    void skip() { while (at_ != r_->base_.end() && !r_->keep_(*at_)) ++at_; }

   public:
    using value_type = std::remove_cvref_t<decltype(*std::declval<const base_iterator&>())>;
    explicit iterator(const filtered_range& r) : r_(&r), at_(r.base_.begin()) { skip(); }
    value_type operator*() const { return *at_; }
    iterator& operator++() {
      ++at_;
      skip();
      return *this;
    }
    bool operator!=(sentinel) const { return at_ != r_->base_.end(); }
  };

  template<class Make>
  filtered_range(const Make& make, const Keep& keep) : base_(make()), keep_(keep) {}
  filtered_range(const filtered_range&) = delete;

  iterator begin() const { return iterator(*this); }
  sentinel end() const { return {}; }
};

/// The range that make() returns, filtered.
template<class Make, class Keep>
auto filtered(const Make& make, const Keep& keep) { return filtered_range<decltype(make()), Keep>(make, keep); }

/// One bit per element of a kind, by index, and how many are set.
struct element_mask {
  std::vector<bool> bits;
  std::size_t count = 0;

  explicit element_mask(std::size_t bound) : bits(bound) {}
  bool operator[](std::size_t i) const { return i < bits.size() && bits[i]; }
  void set(std::size_t i) {
    count += !bits[i];
    bits[i] = true;
  }
};

/// The verts, edges and elements of higher dimension in a view, and the verts all of whose edges are visible.
struct visible_elements {
  element_mask verts, edges, faces, polys, whole_verts;
};

/// Marks the verts all of whose edges are visible: their adj_v2v needs no test of edges.
template<class M>
void mark_whole_verts(const M& m, visible_elements& s) {
  for (const auto v : verts(m)) {
    const std::size_t i = index_of(m, v);
    if (!s.verts[i]) continue;
    bool whole = true;
    for (const auto e : adj_v2e(m, v)) whole = whole && s.edges[index_of(m, e)];
    if (whole) s.whole_verts.set(i);
  }
}

/// Whether a visible edge joins v and w.
template<class M>
bool are_joined_by_visible_edge(const M& m, const visible_elements& s, const vert_t<M>& v, const vert_t<M>& w) {
  for (const auto e : adj_v2e(m, v)) {
    if (!s.edges[index_of(m, e)]) continue;
    for (const auto x : adj_e2v(m, e))
      if (x == w) return true;
  }
  return false;
}

}  // namespace concino::detail

namespace concino::views {

/// A mesh and its visible elements, which all copies of the view share.
template<class M>
class partial_view : public view_base<M> {
  std::shared_ptr<const detail::visible_elements> elements_;

 public:
  partial_view(const M& m, std::shared_ptr<const detail::visible_elements> elements)
      : view_base<M>(m), elements_(std::move(elements)) {}
  const detail::visible_elements& elements() const { return *elements_; }
};

}  // namespace concino::views

namespace concino::detail {

/// Verts, edges and points of a view V that shows a part of a mesh M. Descriptors and indices are those of M.
template<class V, class M>
struct partial_view_traits : forward_points<V, M>, forward_numbers<V, M> {
  using vert = vert_t<M>;
  using edge = edge_t<M>;
  static constexpr bool is_view = true;

  static std::size_t num_verts(const V& m) { return m.elements().verts.count; }
  static std::size_t num_edges(const V& m) { return m.elements().edges.count; }
  static bool contains(const V& m, const vert& x) { return is_visible(m, m.elements().verts, x); }
  static bool contains(const V& m, const edge& x) { return is_visible(m, m.elements().edges, x); }
  static std::size_t vert_index_bound(const V& m) { return concino::vert_index_bound(m.base()); }
  static std::size_t edge_index_bound(const V& m) { return concino::edge_index_bound(m.base()); }

  static auto verts(const V& m) {
    return filtered([&]() -> decltype(auto) { return traits<M>::verts(m.base()); }, visible_in(m, m.elements().verts));
  }
  static auto edges(const V& m) {
    return filtered([&]() -> decltype(auto) { return traits<M>::edges(m.base()); }, visible_in(m, m.elements().edges));
  }
  static decltype(auto) adj_e2v(const V& m, const edge& e) { return traits<M>::adj_e2v(m.base(), e); }
  static auto adj_v2e(const V& m, const vert& v) {
    return filtered([&]() -> decltype(auto) { return traits<M>::adj_v2e(m.base(), v); },
                    visible_in(m, m.elements().edges));
  }
  static auto adj_v2v(const V& m, const vert& v) {
    const visible_elements* s = &m.elements();
    const M* base = &m.base();
    const bool whole = s->whole_verts[concino::index_of(*base, v)];
    return filtered([&]() -> decltype(auto) { return traits<M>::adj_v2v(*base, v); },
                    [=](const vert& w) { return whole || are_joined_by_visible_edge(*base, *s, v, w); });
  }

 protected:
  /// Calls contains() first: the index of an element that is not in the mesh is meaningless.
  template<class X>
  static bool is_visible(const V& m, const element_mask& mask, const X& x) {
    return concino::contains(m.base(), x) && mask[concino::index_of(m.base(), x)];
  }
  static auto visible_in(const V& m, const element_mask& mask) {
    return [base = &m.base(), mask = &mask](const auto& x) { return (*mask)[concino::index_of(*base, x)]; };
  }
};

}  // namespace concino::detail
