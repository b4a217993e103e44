// Which polys lie on the two sides of a facet, and which poly lies across each side of a poly. Facets are the edges of a surface and the
// faces of a volume; the table is the same for both, and it is what the dual graph is walked on.
#pragma once

#include <concino/core/sort_numbers.hpp>
#include <concino/mesh/detail/row_places.hpp>
#include <concino/mesh/detail/side_ranges.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// N sides a poly, or as many as each has (N = 0).
template<class Facet, unsigned N>
class sides {
  rows<Facet, N> facets_;        // per poly
  rows<across, N> across_;       // parallel to facets_
  core::flat_array<std::uint32_t> owner_;  // per facet: N > 0: the side N * poly + k that met it first; N = 0: that poly; ~0: none
  crowd_lists crowds_;
  row_places places_;  // of facets in polys of many sides

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
      return {o, local(o, f)};
    }
  }

  /// Which side of p is f; the number of its sides if none.
  std::uint32_t side_of(poly_id p, Facet f) const {
    const std::uint32_t n = facets_.length(p.raw());
    if (n > row_places::longest_scan) [[unlikely]] return places_.find(p.raw(), facets_[p.raw()], f);
    const Facet* const at = facets_.begin(p.raw());
    std::uint32_t k = 0;
    while (k < n && at[k] != f) ++k;
    return k;
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
  void set_facets(std::size_t n) { owner_ = core::flat_array<std::uint32_t>(n, ~0u); }

  /// Builds: side k of p is facet f.
  void link(std::uint32_t p, std::uint32_t k, Facet f) {
    facets_.begin(p)[k] = f;
    std::uint32_t& o = owner_[f.raw()];
    if (o == ~0u) {
      o = N > 0 ? N * p + k : p;
      across_.begin(p)[k] = {};
      return;
    }
    const side first = owner(f);
    const across before = across_.begin(first.poly)[first.k];
    join(first, p, k);
    if (!before.is_none() && !before.is_crowd()) across_.begin(before.poly())[local(before.poly(), f)] = across_.begin(p)[k];
  }
  /// The same where it is known which side met f first: looking that up takes long where polys have many sides. finish() must follow.
  void link(std::uint32_t p, std::uint32_t k, Facet f, side first) {
    facets_.begin(p)[k] = f;
    join(first, p, k);
  }

  /// Builds: after the last link, so that a poly met across two sides is listed once.
  void finish() {
    owner_.give_back_spare_room();
    if constexpr (N == 0) {
      places_ = row_places(facets_);
      tell_crowds();
      crowds_.list_crowds(across_, 8);
    }
    std::vector<std::uint32_t> met;
    for (std::uint32_t p = 0; p < num_polys(); ++p)
      if (may_repeat(p)) mark_repeats(p, met);
  }

  // Edits find their memory first, which changes nothing, and then cannot fail.

  /// Edits: the facets of a poly with n sides that is about to be added: given, or to be written, none where a facet is still to be made.
  Facet* stage_poly(std::uint32_t n, const Facet* facets = nullptr) {
    across_.stage_row(nullptr, n);
    return facets_.stage_row(facets, n);
  }
  /// Edits: memory for the links of the poly that was staged, `more` of whose facets are new. Returns what remark() works in.
  std::vector<std::uint64_t> reserve_links(const Facet* facets, std::uint32_t n, std::size_t more) {
    std::size_t crowds = 0;
    for (std::uint32_t k = 0; k < n; ++k) {
      if (facets[k].is_none() || !is_owned(facets[k])) continue;
      const side s = owner(facets[k]);
      const across x = across_.begin(s.poly)[s.k];
      if (x.is_crowd()) crowds_.reserve_in_row(x.crowd(), 1);
      else if (!x.is_none()) ++crowds;
    }
    if (crowds > 0) crowds_.reserve_rows(crowds, crowds * small_crowd);
    owner_.room_for(more);
    std::vector<std::uint64_t> scratch;
    if (n > few_sides) scratch.reserve(n);
    return scratch;
  }
  /// Edits: the poly that was staged; then add_facet() and link() its sides.
  void commit_poly(std::uint32_t n) {
    facets_.commit_row(n);
    across_.commit_row(n);
    std::fill_n(across_.begin(num_polys() - 1), n, across{});
  }

  /// Edits: after p, a new poly, was linked, sets right which sides of p and of the polys around it repeat a poly.
  void remark(std::uint32_t p, std::vector<std::uint64_t> scratch) {
    across* const s = across_.begin(p);
    const std::uint32_t n = facets_.length(p);
    if (n <= few_sides) {
      mark_among_few(p);
    } else {
      for (std::uint32_t k = 0; k < n; ++k)
        if (!s[k].is_none() && !s[k].is_crowd()) scratch.push_back(std::uint64_t{s[k].poly()} << 32 | k);
      core::sort_numbers(scratch.data(), scratch.data() + scratch.size());
      for (std::size_t i = 1; i < scratch.size(); ++i)
        if (scratch[i] >> 32 == scratch[i - 1] >> 32) s[static_cast<std::uint32_t>(scratch[i])].raw |= across::special;
    }
    mark_in_crowds(p);
    for (const Facet f : facets_[p]) {
      const polys_of_facet all = polys_of(f);
      if (all.size() == 3) {  // the others were neighbours across f before
        mark_sides_to(all[0].raw(), all[1].raw());
        mark_sides_to(all[1].raw(), all[0].raw());
      }
      for (const poly_id q : all)
        if (q.raw() != p) mark_repeats_of(p, q.raw());
    }
  }

  /// Edits: after this unlink() cannot fail.
  void reserve_removal() { crowds_.loosen(); }
  /// Edits: takes p off all its facets. Those that no poly has any more are left unowned.
  void unlink(std::uint32_t p) {
    for (std::uint32_t k = 0; k < facets_.length(p); ++k) {
      const Facet f = facets_.begin(p)[k];
      const across x = across_.begin(p)[k];
      if (x.is_none()) {
        owner_[f.raw()] = ~0u;
      } else if (!x.is_crowd()) {
        const std::uint32_t q = x.poly(), j = local(q, f);
        across_.begin(q)[j] = {};
        set_owner(f, q, j);
      } else {
        crowds_.remove(x.crowd(), poly_id{p});
        const id_span<poly_id> left = crowds_[x.crowd()];
        const std::uint32_t a = left[0].raw(), b = left[1].raw(), i = local(a, f), j = local(b, f);
        set_owner(f, a, i);
        if (left.size() > 2) continue;
        crowds_.clear_row(x.crowd());
        across_.begin(a)[i].raw = b;
        across_.begin(b)[j].raw = a;
        mark_if_in_crowd(a, i);
        mark_if_in_crowd(b, j);
      }
    }
  }

  /// The quick answer for nearly all polys.
  bool may_repeat(std::uint32_t p) const {
    const std::uint32_t n = facets_.length(p);
    if (n > few_sides) return true;
    const across* const s = across_.begin(p);
    bool may = false;
    for (std::uint32_t k = 0; k < n; ++k) {
      may |= s[k].is_crowd();
      for (std::uint32_t j = 0; j < k; ++j) may |= s[k].raw == s[j].raw && !s[k].is_none();
    }
    return may;
  }

  /// Marks the sides of p that lead where an earlier side or a crowd of p does.
  void mark_repeats(std::uint32_t p, std::vector<std::uint32_t>& met) {
    across* const s = across_.begin(p);
    const std::uint32_t n = facets_.length(p);
    if (n <= few_sides) {
      mark_among_few(p);
      return mark_in_crowds(p);
    }
    if (met.size() < num_polys()) met.assign(num_polys(), ~0u);
    std::size_t different = 0;
    bool crowded = false;
    for (std::uint32_t k = 0; k < n; ++k) {
      crowded = crowded || s[k].is_crowd();
      if (s[k].is_none() || s[k].is_crowd()) continue;
      const std::uint32_t q = s[k].poly();
      if (met[q] == p) s[k].raw |= across::special;
      else ++different;
      met[q] = p;
    }
    if (!crowded || different == 0) return;
    // met[q] becomes more than p where a crowd holds q. Of the crowd and the sides those are looked through that are fewer.
    for (std::uint32_t j = 0; j < n; ++j) {
      if (!s[j].is_crowd()) continue;
      const id_span<poly_id> crowd = crowds_[s[j].crowd()];
      if (crowd.size() <= 16 * different) {
        for (const poly_id q : crowd)
          if (met[q.raw()] == p) met[q.raw()] = p | across::special;
      } else {
        for (std::uint32_t k = 0; k < n; ++k)
          if (s[k].is_first() && crowds_.holds(s[j].crowd(), poly_id{s[k].poly()})) s[k].raw |= across::special;
      }
    }
    for (std::uint32_t k = 0; k < n; ++k)
      if (s[k].is_first() && met[s[k].poly()] == (p | across::special)) s[k].raw |= across::special;
  }

 private:
  static constexpr std::uint32_t few_sides = 24;  // among which comparing all is fastest
  static constexpr std::size_t small_crowd = 4;       // the room of a new crowd

  void mark_among_few(std::uint32_t p) {
    across* const s = across_.begin(p);
    for (std::uint32_t k = 1; k < facets_.length(p); ++k)
      if (!s[k].is_none() && !s[k].is_crowd())
        for (std::uint32_t j = 0; j < k; ++j)
          if (!s[j].is_none() && !s[j].is_crowd() && s[j].poly() == s[k].poly()) {
            s[k].raw |= across::special;
            break;
          }
  }

  /// Marks the sides of p that lead to a poly in one of its crowds.
  void mark_in_crowds(std::uint32_t p) {
    across* const s = across_.begin(p);
    const std::uint32_t n = facets_.length(p);
    for (std::uint32_t j = 0; j < n; ++j)
      if (s[j].is_crowd())
        for (std::uint32_t k = 0; k < n; ++k)
          if (s[k].is_first() && crowds_.holds(s[j].crowd(), poly_id{s[k].poly()})) s[k].raw |= across::special;
  }

  // A side that leads where an earlier one or a crowd does goes on doing so as long as the poly there lives, so marks are only added: at the
  // sides that lead to a new poly or to one that is in a crowd now, and at those that were in a crowd before.

  /// Marks the sides of q that lead to p, the last poly of each of its crowds, where a crowd or an earlier side of q does.
  void mark_repeats_of(std::uint32_t p, std::uint32_t q) {
    across* const s = across_.begin(q);
    const std::uint32_t n = facets_.length(q);
    bool met = false;
    for (std::uint32_t k = 0; k < n; ++k) met = met || (s[k].is_crowd() && *(crowds_.end(s[k].crowd()) - 1) == poly_id{p});
    for (std::uint32_t k = 0; k < n; ++k) {
      if (s[k].is_none() || s[k].is_crowd() || s[k].poly() != p) continue;
      if (met) s[k].raw |= across::special;
      met = true;
    }
  }
  /// Marks the sides of q across which lies p alone.
  void mark_sides_to(std::uint32_t p, std::uint32_t q) {
    across* const s = across_.begin(q);
    for (std::uint32_t k = 0; k < facets_.length(q); ++k)
      if (s[k].is_first() && s[k].poly() == p) s[k].raw |= across::special;
  }
  /// Marks side k of p, which leads to one poly, if a crowd of p does.
  void mark_if_in_crowd(std::uint32_t p, std::uint32_t k) {
    across* const s = across_.begin(p);
    for (std::uint32_t j = 0; j < facets_.length(p); ++j)
      if (s[j].is_crowd() && crowds_.holds(s[j].crowd(), poly_id{s[k].poly()})) {
        s[k].raw |= across::special;
        return;
      }
  }

  /// Tells the second poly of every facet that more than two have of the crowd: it was the only one across before.
  void tell_crowds() {
    if (crowds_.size() == 0) return;
    std::vector<std::uint32_t> crowd(num_facets(), across::none);
    const auto for_each_side = [&](auto&& visit) {
      for (std::uint32_t p = 0; p < num_polys(); ++p)
        for (std::uint32_t k = 0; k < facets_.length(p); ++k) visit(facets_.begin(p)[k], across_.begin(p)[k]);
    };
    for_each_side([&](Facet f, const across& x) {
      if (x.is_crowd()) crowd[f.raw()] = x.raw;
    });
    for_each_side([&](Facet f, across& x) {
      if (crowd[f.raw()] != across::none) x.raw = crowd[f.raw()];
    });
  }

  /// Which side of p is f, which is one of them.
  std::uint32_t local(std::uint32_t p, Facet f) const {
    const Facet* const at = facets_.begin(p);
    for (std::uint32_t k = 0; k < row_places::longest_scan; ++k)
      if (at[k] == f) [[likely]] return k;
    return places_.find(p, facets_[p], f);
  }

  void set_owner(Facet f, std::uint32_t p, std::uint32_t k) { owner_[f.raw()] = N > 0 ? N * p + k : p; }

  void join(side s, std::uint32_t p, std::uint32_t k) {
    across& first = across_.begin(s.poly)[s.k];
    if (first.is_none()) {
      first.raw = p;
      across_.begin(p)[k].raw = s.poly;
    } else {
      crowd_in(s, first, p, k);
    }
  }

  /// The side of the second poly still has to be told.
  void crowd_in(side s, across& first, std::uint32_t p, std::uint32_t k) {
    if (first.is_crowd()) {
      crowds_.push(first.crowd(), poly_id{p});
    } else {
      const poly_id three[] = {poly_id{s.poly}, poly_id{first.poly()}, poly_id{p}};
      const std::uint32_t raw = across::special | across::crowd_bit | static_cast<std::uint32_t>(crowds_.size());
      crowds_.add_row(three, three + 3, small_crowd);
      first.raw = raw;
    }
    across_.begin(p)[k].raw = first.raw;
  }
};

}  // namespace concino::detail
