// All adjacencies of a surface in flat arrays, built from lists of verts in linear time. This is what the library's own surfaces hold, and
// what any mesh that has only face-vertex lists can keep beside them (see indexed_base.hpp).
#pragma once

#include <concino/mesh/live.hpp>
#include <concino/mesh/sides.hpp>

#include <span>
#include <string>

namespace concino {

namespace detail {

/// Lists of N, or of any lengths; refuses arrays that are no such lists.
template<unsigned N, class T>
rows<T, N> checked_rows(std::vector<T> values, const char* what) {
  if (values.size() % N)
    throw invalid_mesh(std::string(what) + " " + std::to_string(values.size() / N) + " has " + std::to_string(values.size() % N) + " verts; it needs " + std::to_string(N));
  return rows<T, N>(std::move(values));
}
template<class T>
rows<T, 0> checked_rows(offsets first, std::vector<T> values, const char* what) {
  if (first.empty()) first.push_back(0);
  if (first.front() != 0) throw invalid_mesh("the offsets of " + std::string(what) + "s begin with " + std::to_string(first.front()) + "; they must begin with 0");
  for (std::size_t i = 1; i < first.size(); ++i)
    if (first[i] < first[i - 1]) throw invalid_mesh(std::string(what) + " " + std::to_string(i - 1) + " ends before it begins; offsets must not decrease");
  if (first.back() != values.size())
    throw invalid_mesh("the offsets of " + std::string(what) + "s end with " + std::to_string(first.back()) + ", but the lists have " + std::to_string(values.size()) + " entries");
  return {std::make_shared<const offsets>(std::move(first)), std::move(values)};
}

/// Refuses a list of verts that no polygon can have.
inline void check_verts(std::span<const vert_id> verts, std::size_t vert_count, const char* what, std::size_t which, std::vector<std::uint32_t>& met) {
  const auto name = [&] { return std::string(what) + " " + std::to_string(which); };
  if (verts.size() < 3) throw invalid_mesh(name() + " has " + std::to_string(verts.size()) + " verts; it needs at least 3");
  for (const vert_id v : verts)
    if (v.raw() >= vert_count)
      throw invalid_mesh(name() + " names vert " + (v.is_none() ? "-1 or beyond 2^32" : std::to_string(v.raw())) + ", but the mesh has " + std::to_string(vert_count) + " verts, numbered from 0");
  std::size_t twice = verts.size();
  if (verts.size() <= 16) {
    for (std::size_t i = 1; i < verts.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (verts[i] == verts[j]) twice = i;
  } else {
    if (met.size() < vert_count) met.resize(vert_count, ~0u);
    for (std::size_t i = 0; i < verts.size(); ++i) {
      if (met[verts[i].raw()] == which) twice = i;
      met[verts[i].raw()] = static_cast<std::uint32_t>(which);
    }
  }
  if (twice != verts.size()) throw invalid_mesh(name() + " has vert " + std::to_string(verts[twice].raw()) + " twice; its verts must differ");
}

inline void check_counts(std::size_t vert_count, std::size_t poly_count, std::size_t corner_count) {
  if (poly_count >= across::mask) throw unsupported("the mesh has " + std::to_string(poly_count) + " polys; at most 2^30 fit");
  if (vert_count >= ~0u || corner_count >= ~0u) throw unsupported("the mesh has more than 2^32 verts or corners");
}

}  // namespace detail

/// Arity: verts of every polygon, or 0 where polygons differ.
template<unsigned Arity>
class surface_tables {
  template<class T> using per_poly = detail::rows<T, Arity>;
  template<class T> using ragged = detail::rows<T, 0>;

  detail::live<vert_id> verts_;
  detail::live<edge_id> edges_;
  detail::live<poly_id> polys_;
  per_poly<vert_id> p2v_;
  detail::sides<edge_id, Arity> sides_;
  detail::rows<vert_id, 2> e2v_;
  ragged<vert_id> v2v_;
  ragged<edge_id> v2e_;
  ragged<poly_id> v2p_;

 public:
  surface_tables() = default;

  /// From the verts of every polygon, in cyclic order. Linear in time and memory.
  /// Errors: invalid_mesh that names the polygon with a bad vert, a repeated vert or fewer than 3.
  surface_tables(std::size_t vert_count, std::vector<vert_id> polys)
    requires(Arity > 0)
      : p2v_(detail::checked_rows<Arity>(std::move(polys), "poly")) {
    check(vert_count);
    build(vert_count);
  }
  /// The same for polygons of any size: poly p's verts are verts[first[p]] .. verts[first[p+1]-1].
  surface_tables(std::size_t vert_count, std::vector<std::uint32_t> first, std::vector<vert_id> verts)
    requires(Arity == 0)
      : p2v_(detail::checked_rows(std::move(first), std::move(verts), "poly")) {
    check(vert_count);
    build(vert_count);
  }

  const detail::live<vert_id>& verts() const { return verts_; }
  const detail::live<edge_id>& edges() const { return edges_; }
  const detail::live<poly_id>& polys() const { return polys_; }

  id_span<vert_id> adj_v2v(vert_id v) const { return v2v_[v.raw()]; }
  id_span<edge_id> adj_v2e(vert_id v) const { return v2e_[v.raw()]; }
  id_span<poly_id> adj_v2p(vert_id v) const { return v2p_[v.raw()]; }
  id_span<vert_id> adj_e2v(edge_id e) const { return e2v_[e.raw()]; }
  detail::polys_of_facet adj_e2p(edge_id e) const { return sides_.polys_of(e); }
  id_span<vert_id> adj_p2v(poly_id p) const { return p2v_[p.raw()]; }
  id_span<edge_id> adj_p2e(poly_id p) const { return sides_.facets(p); }
  detail::polys_across adj_p2p(poly_id p) const { return sides_.polys(p); }

 private:
  void check(std::size_t vert_count) const {
    detail::check_counts(vert_count, p2v_.size(), p2v_.num_values());
    std::vector<std::uint32_t> met;
    for (std::size_t p = 0; p < p2v_.size(); ++p) detail::check_verts({p2v_.begin(p), p2v_.end(p)}, vert_count, "poly", p, met);
  }

  void build(std::size_t vert_count) {
    const auto poly_count = static_cast<std::uint32_t>(p2v_.size());
    const std::size_t corner_count = p2v_.num_values();
    const vert_id* const corner_vert = p2v_.begin(0);

    // Where poly p's corners begin and, for polygons of any size, which poly a corner is of.
    detail::offsets poly_of;
    if constexpr (Arity == 0) {
      poly_of.resize(corner_count);
      std::uint32_t c = 0;
      for (std::uint32_t p = 0; p < poly_count; ++p)
        for (std::uint32_t k = p2v_.length(p); k > 0; --k) poly_of[c++] = p;
    }

    // Corners by vert; they become the polys of the vert at the end.
    detail::offsets counts(vert_count + 1, 0);
    for (std::size_t c = 0; c < corner_count; ++c) ++counts[corner_vert[c].raw() + 1];
    v2p_ = detail::make_rows<poly_id>(std::move(counts));
    std::vector<std::uint32_t> fill(vert_count);
    for (std::size_t v = 0; v < vert_count; ++v) fill[v] = static_cast<std::uint32_t>(v2p_.begin(v) - v2p_.begin(0));
    poly_id* const corners = v2p_.begin(0);
    for (std::size_t c = 0; c < corner_count; ++c) corners[fill[corner_vert[c].raw()]++] = poly_id{c};

    // Every edge is met at its smaller vert a; edge_to[b] is the edge from a to b if it is at least the first edge of a.
    if constexpr (Arity == 0) sides_ = {{p2v_.shape(), std::vector<edge_id>(corner_count)}, {p2v_.shape(), std::vector<detail::across>(corner_count)}};
    else sides_ = {per_poly<edge_id>(poly_count, edge_id{}), per_poly<detail::across>(poly_count, detail::across{})};
    std::vector<std::uint32_t>& edge_to = fill;
    std::fill(edge_to.begin(), edge_to.end(), ~0u);
    std::vector<vert_id> ends;
    const std::size_t guess = vert_count + poly_count + poly_count / 64 + 16;
    ends.reserve(2 * std::min(guess, corner_count));
    sides_.reserve_facets(std::min(guess, corner_count));
    detail::offsets degrees(vert_count + 1, 0);
    std::uint32_t edge_count = 0;
    const auto visit = [&](std::uint32_t a, vert_id b, std::uint32_t first_edge, std::uint32_t p, std::uint32_t k) {
      if (b.raw() < a) return;
      std::uint32_t e = edge_to[b.raw()];
      if (e == ~0u || e < first_edge) {
        edge_to[b.raw()] = e = edge_count++;
        ends.push_back(vert_id{a});
        ends.push_back(b);
        ++degrees[a + 1];
        ++degrees[b.raw() + 1];
        sides_.add_facet();
      }
      sides_.link(p, k, edge_id{e});
    };
    for (std::uint32_t a = 0; a < vert_count; ++a) {
      const std::uint32_t first_edge = edge_count;
      for (poly_id *c = v2p_.begin(a), *last = c + v2p_.length(a); c != last; ++c) {
        std::uint32_t p = 0, k = 0, n = Arity;
        if constexpr (Arity > 0) {
          p = c->raw() / Arity;
          k = c->raw() % Arity;
        } else {
          p = poly_of[c->raw()];
          k = c->raw() - static_cast<std::uint32_t>(p2v_.begin(p) - corner_vert);
          n = p2v_.length(p);
        }
        const vert_id* const pv = p2v_.begin(p);
        const std::uint32_t next = k + 1 == n ? 0 : k + 1, previous = k == 0 ? n - 1 : k - 1;
        visit(a, pv[next], first_edge, p, k);
        visit(a, pv[previous], first_edge, p, previous);
        *c = poly_id{p};
      }
    }
    sides_.finish();
    if (ends.capacity() > ends.size() + ends.size() / 32) ends.shrink_to_fit();
    e2v_ = detail::rows<vert_id, 2>(std::move(ends));

    detail::fill_stars(std::move(degrees), e2v_, fill, v2v_, v2e_);
    if (*v2p_.shape() == *v2v_.shape()) v2p_.share_shape(v2v_);
    verts_ = detail::live<vert_id>(vert_count);
    edges_ = detail::live<edge_id>(edge_count);
    polys_ = detail::live<poly_id>(poly_count);
  }
};

}  // namespace concino
