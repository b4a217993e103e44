// Which polys lie on the two sides of a facet, and which poly lies across each side of a poly. Facets are the edges of a surface and the
// faces of a volume; the table is the same for both, and it is what the dual graph is walked on.
#pragma once

#include <concino/mesh/side_ranges.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// N sides a poly, or as many as each has (N = 0).
template<class Facet, unsigned N>
class sides {
  rows<Facet, N> facets_;        // per poly
  rows<across, N> across_;       // parallel to facets_
  flat_array<std::uint32_t> owner_;  // per facet: N > 0: the side N * poly + k that met it first; N = 0: that poly; ~0: none
  rows<poly_id, 0> crowds_;

 public:
  struct side {
    std::uint32_t poly, k;
  };

  sides() = default;
  /// Begins without facets; what lies across each side is unwritten. link() each side once.
  sides(rows<Facet, N> facets, rows<across, N> unwritten) : facets_(std::move(facets)), across_(std::move(unwritten)) {}

  std::size_t num_polys() const { return facets_.size(); }
  std::size_t num_facets() const { return owner_.size(); }
  id_span<Facet> facets(poly_id p) const { return facets_[p.raw()]; }
  const across* across_sides(poly_id p) const { return across_.begin(p.raw()); }
  polys_across polys(poly_id p) const { return {across_.begin(p.raw()), across_.end(p.raw()), &crowds_, p}; }
  /// Of a facet that some poly has: whether there are two, and the one that met it first has not met the other across an earlier side.
  bool has_two_polys_once(Facet f) const {
    const side s = owner(f);
    return across_.begin(s.poly)[s.k].is_first();
  }
  bool is_owned(Facet f) const { return owner_[f.raw()] != ~0u; }

  /// The side that met f first.
  side owner(Facet f) const {
    const std::uint32_t o = owner_[f.raw()];
    if constexpr (N > 0) {
      return {o / N, o % N};
    } else {
      const Facet* at = facets_.begin(o);
      std::uint32_t k = 0;
      while (at[k] != f) ++k;
      return {o, k};
    }
  }

  polys_of_facet polys_of(Facet f) const {
    if (!is_owned(f)) return {};
    const side s = owner(f);
    const across x = across_.begin(s.poly)[s.k];
    if (x.is_none()) return polys_of_facet{poly_id{s.poly}};
    if (x.is_crowd()) return {crowds_.begin(x.crowd()), crowds_.end(x.crowd())};
    return {poly_id{s.poly}, poly_id{x.poly()}};
  }

  /// Builds: a facet that no side has met yet.
  void add_facet() { owner_.push_back(~0u); }
  /// Builds: the next facet, which is side k of p and no other so far.
  void add_facet(std::uint32_t p, std::uint32_t k, Facet f)
    requires(N > 0)
  {
    facets_.begin(p)[k] = f;
    across_.begin(p)[k] = {};
    owner_.push_back(N * p + k);
  }
  void reserve_facets(std::size_t n) { owner_.reserve(n); }
  /// Builds: n facets that no side has met yet.
  void set_facets(std::size_t n) { owner_ = flat_array<std::uint32_t>(n, ~0u); }

  /// Builds: side k of p is facet f.
  void link(std::uint32_t p, std::uint32_t k, Facet f) {
    facets_.begin(p)[k] = f;
    std::uint32_t& o = owner_[f.raw()];
    if (o == ~0u) {
      o = N > 0 ? N * p + k : p;
      across_.begin(p)[k] = {};
      return;
    }
    join(owner(f), p, k);
  }
  /// The same where it is known which side met f first: looking that up takes long where polys have many sides.
  void link(std::uint32_t p, std::uint32_t k, Facet f, side first) {
    facets_.begin(p)[k] = f;
    join(first, p, k);
  }

  /// Builds: after the last link, so that a poly met across two sides is listed once.
  void finish() {
    owner_.give_back_spare_room();
    std::vector<std::uint32_t> met;
    for (std::uint32_t p = 0; p < num_polys(); ++p)
      if (may_repeat(p)) mark_repeats(p, met);
  }

  /// Edits: a poly with n sides that are still to be linked; their facets, if they are known.
  void add_poly(std::uint32_t n, const Facet* facets = nullptr) {
    const std::vector<Facet> unknown(facets ? 0 : n);
    const std::vector<across> open(n);
    if (!facets) facets = unknown.data();
    facets_.add_row(facets, facets + n);
    across_.add_row(open.begin(), open.end());
  }

  /// Edits: after p was linked, sets right which sides of p and of the polys around it repeat a poly.
  void remark(std::uint32_t p) {
    remark_one(p);
    for (const Facet f : facets_[p])
      for (const poly_id q : polys_of(f))
        if (q.raw() != p) remark_one(q.raw());
  }

  /// Edits: takes p off all its facets. Those that no poly has any more are left unowned.
  void unlink(std::uint32_t p) {
    std::vector<std::uint32_t> around;
    std::vector<poly_id> rest;
    for (const Facet f : facets_[p]) {
      rest.clear();
      for (const poly_id q : polys_of(f))
        if (q.raw() != p) rest.push_back(q), around.push_back(q.raw());
      relink(f, rest);
    }
    for (const std::uint32_t q : around) remark_one(q);
  }

  /// The quick answer for nearly all polys.
  bool may_repeat(std::uint32_t p) const {
    const std::uint32_t n = facets_.length(p);
    if (n > 24) return true;
    const across* const s = across_.begin(p);
    bool may = false;
    for (std::uint32_t k = 0; k < n; ++k) {
      may |= s[k].is_crowd();
      for (std::uint32_t j = 0; j < k; ++j) may |= s[k].raw == s[j].raw && !s[k].is_none();
    }
    return may;
  }

  /// Marks the sides of p that lead where an earlier side does.
  void mark_repeats(std::uint32_t p, std::vector<std::uint32_t>& met) {
    across* const s = across_.begin(p);
    const std::uint32_t n = facets_.length(p);
    bool crowded = false;
    if (n <= 24) {
      for (std::uint32_t k = 1; k < n; ++k)
        if (!s[k].is_none() && !s[k].is_crowd())
          for (std::uint32_t j = 0; j < k; ++j)
            if (!s[j].is_none() && !s[j].is_crowd() && s[j].poly() == s[k].poly()) {
              s[k].raw |= across::special;
              break;
            }
    } else {
      if (met.size() < num_polys()) met.resize(num_polys(), ~0u);
      for (std::uint32_t k = 0; k < n; ++k)
        if (!s[k].is_none() && !s[k].is_crowd()) {
          if (met[s[k].poly()] == p) s[k].raw |= across::special;
          met[s[k].poly()] = p;
        }
    }
    for (std::uint32_t k = 0; k < n; ++k) crowded = crowded || s[k].is_crowd();
    if (!crowded) return;
    for (std::uint32_t k = 1; k < n; ++k)
      if (s[k].is_first())
        for (std::uint32_t j = 0; j < k && s[k].is_first(); ++j)
          if (s[j].is_crowd())
            for (poly_id q : crowds_[s[j].crowd()])
              if (q.raw() == s[k].poly()) s[k].raw |= across::special;
  }

 private:
  /// A side that leads where an earlier one does goes on doing so as long as the poly there lives, so marks are only added.
  void remark_one(std::uint32_t p) {
    std::vector<std::uint32_t> met;
    mark_repeats(p, met);
  }

  std::uint32_t local(std::uint32_t p, Facet f) const {
    const Facet* const at = facets_.begin(p);
    std::uint32_t k = 0;
    while (at[k] != f) ++k;
    return k;
  }

  /// Makes `polys` the polys of f; all of them have it among their facets.
  void relink(Facet f, const std::vector<poly_id>& polys) {
    if (polys.empty()) {
      owner_[f.raw()] = ~0u;
      return;
    }
    const std::uint32_t first = polys[0].raw(), k = local(first, f);
    across& x = across_.begin(first)[k];
    const across before = x;
    owner_[f.raw()] = N > 0 ? N * first + k : first;
    if (polys.size() == 1) {
      x = {};
    } else if (polys.size() == 2) {
      x.raw = polys[1].raw();
      across_.begin(polys[1].raw())[local(polys[1].raw(), f)].raw = first;
    } else {
      crowds_.clear_row(before.crowd());
      for (const poly_id q : polys) crowds_.push(before.crowd(), q);
    }
  }

  void join(side s, std::uint32_t p, std::uint32_t k) {
    across& first = across_.begin(s.poly)[s.k];
    if (first.is_none()) {
      first.raw = p;
      across_.begin(p)[k].raw = s.poly;
    } else {
      crowd_in(s, first, p, k);
    }
  }

  void crowd_in(side s, across& first, std::uint32_t p, std::uint32_t k) {
    if (!first.is_crowd()) {
      const std::uint32_t other = first.poly();
      const poly_id two[] = {poly_id{s.poly}, poly_id{other}};
      const Facet f = facets_.begin(s.poly)[s.k];
      const std::uint32_t raw = across::special | across::crowd_bit | static_cast<std::uint32_t>(crowds_.size());
      crowds_.add_row(two, two + 2);
      first.raw = raw;
      std::uint32_t j = 0;
      while (facets_.begin(other)[j] != f) ++j;
      across_.begin(other)[j].raw = raw;
    }
    across_.begin(p)[k].raw = first.raw;
    crowds_.push(first.crowd(), poly_id{p});
  }
};

}  // namespace concino::detail
