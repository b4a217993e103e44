// All adjacencies of a surface in flat arrays, built from lists of verts in linear time. This is what the library's own surfaces hold, and
// what any mesh that has only face-vertex lists can keep beside them (see indexed_base.hpp).
#pragma once

#include <concino/core/message.hpp>
#include <concino/mesh/detail/checks.hpp>
#include <concino/mesh/detail/live.hpp>
#include <concino/mesh/detail/sides.hpp>
#include <concino/mesh/detail/stars.hpp>

namespace concino {

/// Arity: verts of every polygon, or 0 where polygons differ. Lists: where the verts of polygons are read; rows of these tables' own, which
/// can be edited, or lists in somebody else's array.
template<unsigned Arity, class Lists = detail::rows<vert_id, Arity>>
class surface_tables {
  template<unsigned, class> friend class surface_tables;
  template<class T> using per_poly = detail::rows<T, Arity>;
  template<class T> using ragged = detail::rows<T, 0>;

  detail::live<vert_id> verts_;
  detail::live<edge_id> edges_;
  detail::live<poly_id> polys_;
  Lists p2v_;
  detail::sides<edge_id, Arity> sides_;
  detail::rows<vert_id, 2> e2v_;
  ragged<vert_id> v2v_;
  ragged<edge_id> v2e_;
  ragged<poly_id> v2p_;

 public:
  static constexpr unsigned arity = Arity;

  surface_tables() = default;
  surface_tables(const surface_tables&) = default;
  surface_tables(surface_tables&&) noexcept = default;
  surface_tables& operator=(const surface_tables& o) { return *this = surface_tables(o); }  // all or nothing
  surface_tables& operator=(surface_tables&&) noexcept = default;

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
  /// The same for polygons that are listed elsewhere, with what was built of a copy of those lists.
  surface_tables(surface_tables<Arity>&& built, Lists elsewhere)
    requires(!std::same_as<Lists, per_poly<vert_id>>)
      : verts_(std::move(built.verts_)), edges_(std::move(built.edges_)), polys_(std::move(built.polys_)), p2v_(std::move(elsewhere)),
        sides_(std::move(built.sides_)), e2v_(std::move(built.e2v_)), v2v_(std::move(built.v2v_)), v2e_(std::move(built.v2e_)),
        v2p_(std::move(built.v2p_)) {
    if constexpr (Arity == 0) p2v_.share_shape(built.p2v_);
  }

  const detail::live<vert_id>& verts() const { return verts_; }
  const detail::live<edge_id>& edges() const { return edges_; }
  const detail::live<poly_id>& polys() const { return polys_; }

  id_span<vert_id> adj_v2v(vert_id v) const { return v2v_[v.raw()]; }
  id_span<edge_id> adj_v2e(vert_id v) const { return v2e_[v.raw()]; }
  id_span<poly_id> adj_v2p(vert_id v) const { return v2p_[v.raw()]; }
  id_span<vert_id> adj_e2v(edge_id e) const { return e2v_[e.raw()]; }
  detail::polys_of_facet adj_e2p(edge_id e) const { return sides_.polys_of(e); }
  auto adj_p2v(poly_id p) const { return p2v_[p.raw()]; }
  id_span<edge_id> adj_p2e(poly_id p) const { return sides_.facets(p); }
  detail::polys_across adj_p2p(poly_id p) const { return sides_.polys(p); }

  // Edits find their memory first, which changes nothing, and then cannot fail: each is done as a whole or not at all. `grow` is called in
  // between, with the bounds of indices that the edit leads to; it may fail too.

  /// A vert without edges.
  template<class Grow = detail::nothing_else_grows>
  vert_id add_vert(const Grow& grow = {}) {
    detail::stage_star(v2v_, v2e_, v2p_);
    verts_.reserve(1);
    grow(detail::index_bounds{verts_.bound() + 1, edges_.bound(), 0, polys_.bound()});
    detail::add_star(v2v_, v2e_, v2p_);
    return verts_.add();
  }

  /// A polygon on verts that are there. Cost: its size times the edges and polys at its verts.
  /// Errors: invalid_mesh as in the constructor; nothing has changed then.
  template<class Grow = detail::nothing_else_grows>
  poly_id add_poly(std::span<const vert_id> corners, const Grow& grow = {}) {
    const poly_id p{polys_.bound()};
    if (Arity > 0 && corners.size() != Arity)
      core::throw_joined<invalid_mesh>({"poly ", p.raw(), " has ", corners.size(), " verts; every poly of this mesh has ", Arity});
    detail::check_new_verts(corners, verts_, "poly", p.raw());
    const auto n = static_cast<std::uint32_t>(corners.size());
    const vert_id* const c = p2v_.stage_row(corners.data(), n);  // corners may have lain in a row that moved
    edge_id* const e = sides_.stage_poly(n);
    std::size_t more = 0;
    for (std::uint32_t k = 0; k < n; ++k) {
      e[k] = detail::edge_between(v2v_, v2e_, c[k], c[k + 1 == n ? 0 : k + 1]);
      more += e[k].is_none();
    }
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t at_corner = (e[k].is_none() ? 1u : 0u) + (e[k == 0 ? n - 1 : k - 1].is_none() ? 1u : 0u);
      detail::reserve_edges_at(v2v_, v2e_, c[k], at_corner);
      v2p_.reserve_in_row(c[k].raw(), 1);
    }
    e2v_.reserve_rows(more);
    edges_.reserve(more);
    polys_.reserve(1);
    auto scratch = sides_.reserve_links(e, n, more);
    grow(detail::index_bounds{verts_.bound(), edges_.bound() + more, 0, polys_.bound() + 1});

    p2v_.commit_row(n);
    sides_.commit_poly(n);
    for (std::uint32_t k = 0; k < n; ++k) {
      edge_id side = e[k];
      if (side.is_none()) {
        side = detail::add_edge(edges_, e2v_, v2v_, v2e_, c[k], c[k + 1 == n ? 0 : k + 1]);
        sides_.add_facet();
      }
      sides_.link(p.raw(), k, side);
      v2p_.push(c[k].raw(), p);
    }
    sides_.remark(p.raw(), std::move(scratch));
    return polys_.add();
  }

  /// Finds the memory that removing these polys one after another, and verts that no poly has any more, takes: none of it can fail then.
  void reserve_removal(std::span<const poly_id>) {
    v2v_.loosen();
    v2e_.loosen();
    v2p_.loosen();
    sides_.reserve_removal();
    verts_.reserve_removal();
    edges_.reserve_removal();
    polys_.reserve_removal();
  }

  /// Takes p away, and with it the edges that no other poly has; verts stay. No other element changes its name.
  void remove_poly(poly_id p) {
    reserve_removal({&p, 1});
    sides_.unlink(p.raw());
    for (const edge_id e : sides_.facets(p))
      if (!sides_.is_owned(e)) detail::remove_edge(edges_, e2v_, v2v_, v2e_, e);
    for (const vert_id v : adj_p2v(p)) v2p_.remove(v.raw(), p);
    polys_.remove(p);
  }

  /// Takes away a vert that no poly has any more.
  void remove_vert(vert_id v) {
    assert(v2p_[v.raw()].empty());
    verts_.reserve_removal();
    verts_.remove(v);
  }

 private:
  void check(std::size_t vert_count) const {
    detail::check_counts(vert_count, p2v_.size(), p2v_.num_values());
    std::vector<std::uint32_t> met;
    for (std::size_t p = 0; p < p2v_.size(); ++p) detail::check_verts(p2v_[p], vert_count, "poly", p, met);
  }

  void build(std::size_t vert_count) {
    const auto poly_count = static_cast<std::uint32_t>(p2v_.size());
    const std::size_t corner_count = p2v_.num_values();
    const vert_id* const corner_vert = p2v_.begin(0);

    // Polys by vert, in which the vert is looked up later; but where some polygon is long, that would take too long: then corners by vert
    // (as always where all polygons have as many), and poly_of says which poly a corner is of.
    detail::offsets poly_of;
    if constexpr (Arity == 0) {
      std::uint32_t longest = 0;
      for (std::uint32_t p = 0; p < poly_count; ++p) longest = std::max(longest, p2v_.length(p));
      if (longest > 32) {
        poly_of.reserve(corner_count);
        for (std::uint32_t p = 0; p < poly_count; ++p) poly_of.insert(poly_of.end(), p2v_.length(p), p);
      }
    }
    detail::offsets counts(vert_count + 1, 0);
    for (std::size_t c = 0; c < corner_count; ++c) ++counts[corner_vert[c].raw() + 1];
    v2p_ = detail::make_rows<poly_id>(std::move(counts));
    core::flat_array<std::uint32_t> fill(vert_count);
    for (std::size_t v = 0; v < vert_count; ++v) fill[v] = static_cast<std::uint32_t>(v2p_.begin(v) - v2p_.begin(0));
    poly_id* const corners = v2p_.begin(0);
    if (Arity > 0 || !poly_of.empty()) {
      for (std::size_t c = 0; c < corner_count; ++c) corners[fill[corner_vert[c].raw()]++] = poly_id{c};
    } else {
      for (std::uint32_t p = 0; p < poly_count; ++p)
        for (const vert_id v : p2v_[p]) corners[fill[v.raw()]++] = poly_id{p};
    }

    // Every edge is met at its smaller vert a; edge_to[b] is the edge from a to b if it is at least the first edge of a.
    if constexpr (Arity == 0) sides_ = {{p2v_.shape(), core::flat_array<edge_id>(corner_count, edge_id{})}, {p2v_.shape(), core::flat_array<detail::across>(corner_count)}};
    else sides_ = {per_poly<edge_id>(poly_count, edge_id{}), per_poly<detail::across>(poly_count)};
    core::flat_array<std::uint32_t>& edge_to = fill;
    std::fill_n(edge_to.data(), vert_count, ~0u);
    core::flat_array<vert_id> ends;
    const std::size_t guess = vert_count + poly_count + poly_count / 64 + 16;
    ends.reserve(2 * std::min(guess, corner_count));
    sides_.reserve_facets(std::min(guess, corner_count));
    detail::offsets degrees(vert_count + 1, 0);
    std::uint32_t edge_count = 0;
    std::vector<typename detail::sides<edge_id, Arity>::side> met_first;  // per edge of a, where polygons may be long
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
        if constexpr (Arity == 0) met_first.push_back({p, k});
      } else if constexpr (Arity == 0) {
        return sides_.link(p, k, edge_id{e}, met_first[e - first_edge]);
      }
      sides_.link(p, k, edge_id{e});
    };
    for (std::uint32_t a = 0; a < vert_count; ++a) {
      const std::uint32_t first_edge = edge_count;
      met_first.clear();
      for (poly_id *c = v2p_.begin(a), *last = c + v2p_.length(a); c != last; ++c) {
        std::uint32_t p = 0, k = 0, n = Arity;
        if constexpr (Arity > 0) {
          p = c->raw() / Arity;
          k = c->raw() % Arity;
        } else if (poly_of.empty()) {
          p = c->raw();
          n = p2v_.length(p);
          for (const vert_id* v = p2v_.begin(p); v[k].raw() != a;) ++k;
        } else {
          p = poly_of[c->raw()];
          n = p2v_.length(p);
          k = c->raw() - static_cast<std::uint32_t>(p2v_.begin(p) - corner_vert);
        }
        const vert_id* const pv = p2v_.begin(p);
        const std::uint32_t next = k + 1 == n ? 0 : k + 1, previous = k == 0 ? n - 1 : k - 1;
        visit(a, pv[next], first_edge, p, k);
        visit(a, pv[previous], first_edge, p, previous);
        *c = poly_id{p};
      }
    }
    sides_.finish();
    ends.give_back_spare_room();
    e2v_ = detail::rows<vert_id, 2>(std::move(ends));

    detail::fill_stars(std::move(degrees), e2v_, fill, v2v_, v2e_);
    if (*v2p_.shape() == *v2v_.shape()) v2p_.share_shape(v2v_);
    verts_ = detail::live<vert_id>(vert_count);
    edges_ = detail::live<edge_id>(edge_count);
    polys_ = detail::live<poly_id>(poly_count);
  }
};

}  // namespace concino
