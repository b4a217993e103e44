// Collects the cavity of an edit of simplices: old polys, and new ones that differ from old ones in one vert.
#pragma once

#include <concino/concepts/editable.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/small_array.hpp>
#include <concino/core/vec3.hpp>
#include <concino/edit/permission.hpp>

namespace concino::detail {

template<class M>
class cavity_builder {
  static constexpr unsigned simplex_size = dimension_v<M> + 1;

  core::small_array<poly_t<M>, 16> polys_;
  core::small_array<vert_t<M>, 24> verts_;
  core::small_array<vec3, 2> points_;
  core::small_array<unsigned, 96> corners_;  // of old polys, one after another
  core::small_array<unsigned, 96> new_corners_;
  core::small_array<unsigned, 32> ends_;
  core::small_array<poly_t<M>, 32> new_polys_;
  vert_t<M> new_vert_{};
  std::size_t kept_ = 0, removed_ = 0;

  template<class T>
  static id_span<T> span(const T* first, std::size_t n) { return {first, first + n}; }

 public:
  static constexpr unsigned none = ~0u;
  static constexpr unsigned size = simplex_size;

  unsigned find(const vert_t<M>& v) const {
    for (unsigned i = 0; i < verts_.size(); ++i)
      if (verts_[i] == v) return i;
    return none;
  }
  unsigned vert(const vert_t<M>& v) {
    const unsigned i = find(v);
    if (i != none) return i;
    verts_.push_back(v);
    return static_cast<unsigned>(verts_.size() - 1);
  }

  /// Adds an old poly. Returns false if it is not a simplex.
  bool add_old(const M& m, const poly_t<M>& p) {
    unsigned n = 0;
    for (const vert_t<M> v : adj_p2v(m, p)) {
      if (++n > size) return false;
      corners_.push_back(vert(v));
    }
    polys_.push_back(p);
    return n == size;
  }
  unsigned num_old() const { return static_cast<unsigned>(polys_.size()); }
  unsigned num_verts() const { return static_cast<unsigned>(verts_.size()); }
  const unsigned* old(unsigned k) const { return corners_.data() + k * size; }
  const poly_t<M>& old_poly(unsigned k) const { return polys_[k]; }
  const vert_t<M>& vert_at(unsigned i) const { return verts_[i]; }
  bool old_has(unsigned k, unsigned v) const { return std::find(old(k), old(k) + size, v) != old(k) + size; }

  /// Adds the new vert, and returns its number. No other existing vert may follow.
  unsigned add_point(const vec3& x) {
    points_.push_back(x);
    return num_verts();
  }
  /// Adds a new poly: old poly k with vert `by` instead of `v`.
  void add_new(unsigned k, unsigned v, unsigned by) {
    for (unsigned i = 0; i < size; ++i) new_corners_.push_back(old(k)[i] == v ? by : old(k)[i]);
    ends_.push_back(static_cast<unsigned>(new_corners_.size()));
  }
  void add_new(const unsigned* corners) {
    for (unsigned i = 0; i < size; ++i) new_corners_.push_back(corners[i]);
    ends_.push_back(static_cast<unsigned>(new_corners_.size()));
  }
  /// The first n new polys have the descriptors of the first n old ones.
  void keep(std::size_t n) { kept_ = n; }
  /// Removes v, which must be the last vert: see move_to_end().
  void remove_last_vert() { removed_ = 1; }

  const vert_t<M>& new_vert() const { return new_vert_; }

  void apply(M& m) {
    new_polys_.resize(ends_.size(), poly_t<M>{});
    const cavity<M> c{span(polys_.data(), polys_.size()), span(verts_.data(), verts_.size()), span(points_.data(), points_.size()),
                      span(new_corners_.data(), new_corners_.size()), span(ends_.data(), ends_.size()), {}, kept_, removed_};
    rewire(m, c, cavity_result<M>{&new_vert_, new_polys_.data()});
  }
};

/// Errors: invalid_mesh if x is not an element of m.
template<class M, class X>
void check_element(const M& m, const X& x, const char* edit, const char* kind) {
  if (!contains(m, x)) core::throw_joined<invalid_mesh>({edit, ": ", kind, " ", index_of(m, x), " is not ", *kind == 'e' ? "an " : "a ", kind, " of the mesh"});
}

inline constexpr permission not_simplices{refusal::not_simplices, "a poly at the element is not a triangle or a tet"};

}  // namespace concino::detail
