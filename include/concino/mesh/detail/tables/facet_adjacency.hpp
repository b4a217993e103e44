// Incidence of polys and facets: the facets of each poly, the polys of each facet, and the neighbour of each poly
// behind each of its facets. Facets are the edges of a surface and the faces of a volume. The dual graph is traversed
// in this table.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/mesh/detail/rows/row_lookup.hpp>
#include <concino/mesh/detail/tables/facet_adjacency_ranges.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// N facets per poly, or any number (N = 0). The pair (p, k) is the incidence of poly p and its facet k.
template<class Facet, unsigned N>
class facet_adjacency {
  jagged_array<Facet, N> facets_;        // per poly
  jagged_array<encoded_neighbour, N> neighbours_;       // parallel to facets_
  core::flat_array<std::uint32_t> owner_;  // per facet: if N > 0, its first incidence, N * poly + k; if N = 0, the poly
                                           // of that; ~0 if none
  non_manifold_facets poly_lists_;
  row_lookup facet_lookup_;  // of facets in polys with many facets

 public:
  struct incidence {
    std::uint32_t poly, k;
  };

  facet_adjacency() = default;
  /// Starts without facets and with uninitialised neighbours. Call link() once for each incidence.
  facet_adjacency(jagged_array<Facet, N> facets, jagged_array<encoded_neighbour, N> unwritten)
      : facets_(std::move(facets)), neighbours_(std::move(unwritten)) {}
  std::size_t num_polys() const { return facets_.size(); }
  std::size_t num_facets() const { return owner_.size(); }
  id_span<Facet> facets(poly_id p) const { return facets_[p.raw()]; }
  const encoded_neighbour* neighbours_of(poly_id p) const { return neighbours_.begin(p.raw()); }
  adjacent_polys polys(poly_id p) const {
    return {neighbours_.begin(p.raw()), neighbours_.end(p.raw()), &poly_lists_, p};
  }
  /// Whether f has two polys, and its owner is not adjacent to the other through an earlier facet. Needs: f has a poly.
  bool has_two_polys_once(Facet f) const {
    const incidence s = owner(f);
    return neighbours_.begin(s.poly)[s.k].is_first_occurrence();
  }
  const jagged_array<Facet, N>& facet_rows() const { return facets_; }
  /// The same with new numbers; removed facets and polys are left out.
  facet_adjacency compacted(const compact_numbers<Facet>& kept_facets, const compact_numbers<poly_id>& kept) const;
  bool is_owned(Facet f) const { return owner_[f.raw()] != ~0u; }

  /// The incidence that was linked to f first.
  incidence owner(Facet f) const {
    const std::uint32_t o = owner_[f.raw()];
    if constexpr (N > 0) {
      return {o / N, o % N};
    } else {
      return {o, local(o, f)};
    }
  }

  /// The k with facet k of p equal to f; the number of facets of p if there is none.
  std::uint32_t position_of(poly_id p, Facet f) const {
    const std::uint32_t n = facets_.length(p.raw());
    if (n > row_lookup::longest_scan) return facet_lookup_.find(p.raw(), facets_[p.raw()], f);
    const Facet* const at = facets_.begin(p.raw());
    std::uint32_t k = 0;
    while (k < n && at[k] != f) ++k;
    return k;
  }

  polys_of_facet polys_of(Facet f) const {
    if (!is_owned(f)) return {};
    const incidence s = owner(f);
    const encoded_neighbour x = neighbours_.begin(s.poly)[s.k];
    if (x.is_none()) return polys_of_facet{poly_id{s.poly}};
    if (x.is_non_manifold()) return {poly_lists_.begin(x.poly_list()), poly_lists_.end(x.poly_list())};
    return {poly_id{s.poly}, poly_id{x.poly()}};
  }

  /// Adds a facet without polys.
  void add_facet() { owner_.push_back(~0u); }
  /// Construction: adds the next facet, which is facet k of p and of no other poly so far.
  void add_facet(std::uint32_t p, std::uint32_t k, Facet f)
    requires(N > 0)
  {
    facets_.begin(p)[k] = f;
    neighbours_.begin(p)[k] = {};
    owner_.push_back(N * p + k);
  }
  void reserve_facets(std::size_t n) { owner_.reserve(n); }
  /// Construction: sets n facets without polys.
  void set_facets(std::size_t n) { owner_ = core::flat_array<std::uint32_t>(n, ~0u); }

  /// Construction: makes f facet k of p.
  void link(std::uint32_t p, std::uint32_t k, Facet f);
  /// The same if the owner of f is known: the search takes long if polys have many facets. finish() must follow.
  void link(std::uint32_t p, std::uint32_t k, Facet f, incidence first) {
    facets_.begin(p)[k] = f;
    join(first, p, k);
  }

  /// Construction: call it after the last link, so that a neighbour behind two facets is listed once.
  void finish();
  // Edits allocate their memory first, which changes nothing, and cannot fail afterwards.

  /// Edits: stages the n facets of a poly that will be added. They are copied, or the caller writes them; none for a
  /// facet that does not exist yet.
  Facet* stage_poly(std::uint32_t n, const Facet* facets = nullptr) {
    neighbours_.stage_row(nullptr, n);
    return facets_.stage_row(facets, n);
  }
  /// Edits: allocates memory for the links of the staged poly, which has `more` new facets. Returns scratch memory for
  /// update_marks().
  std::vector<std::uint64_t> reserve_links(const Facet* facets, std::uint32_t n, std::size_t more) {
    std::size_t num_poly_lists = 0;
    for (std::uint32_t k = 0; k < n; ++k) {
      if (facets[k].is_none() || !is_owned(facets[k])) continue;
      const incidence s = owner(facets[k]);
      const encoded_neighbour x = neighbours_.begin(s.poly)[s.k];
      if (x.is_non_manifold()) poly_lists_.reserve_in_row(x.poly_list(), 1);
      else if (!x.is_none()) ++num_poly_lists;
    }
    if (num_poly_lists > 0) poly_lists_.reserve_rows(num_poly_lists, num_poly_lists * min_list_capacity);
    owner_.reserve_back(more);
    std::vector<std::uint64_t> scratch;
    if (n > max_scanned_facets) scratch.reserve(n);
    return scratch;
  }
  /// Edits: adds the staged poly; add_facet() and link() of its facets must follow.
  void commit_poly(std::uint32_t n) {
    facets_.commit_row(n);
    neighbours_.commit_row(n);
    std::fill_n(neighbours_.begin(num_polys() - 1), n, encoded_neighbour{});
  }

  /// Edits: updates which incidences of p and of its neighbours repeat a neighbour. p is a new poly that was linked.
  void update_marks(std::uint32_t p, std::vector<std::uint64_t> scratch);

  /// Edits: after this call unlink() cannot fail.
  void reserve_removal() { poly_lists_.make_editable(); }
  /// Edits: removes p from all its facets. Those without other polys have no owner afterwards.
  void unlink(std::uint32_t p) {
    for (std::uint32_t k = 0; k < facets_.length(p); ++k) {
      const Facet f = facets_.begin(p)[k];
      const encoded_neighbour x = neighbours_.begin(p)[k];
      if (x.is_none()) {
        owner_[f.raw()] = ~0u;
      } else if (!x.is_non_manifold()) {
        const std::uint32_t q = x.poly(), j = local(q, f);
        neighbours_.begin(q)[j] = {};
        set_owner(f, q, j);
      } else {
        poly_lists_.remove(x.poly_list(), poly_id{p});
        const id_span<poly_id> left = poly_lists_[x.poly_list()];
        const std::uint32_t a = left[0].raw(), b = left[1].raw(), i = local(a, f), j = local(b, f);
        set_owner(f, a, i);
        if (left.size() > 2) continue;
        poly_lists_.clear_row(x.poly_list());
        neighbours_.begin(a)[i].raw = b;
        neighbours_.begin(b)[j].raw = a;
        mark_if_in_poly_list(a, i);
        mark_if_in_poly_list(b, j);
      }
    }
  }

  // Edits that replace a few polys by others: detach() all old ones, attach() the facets of the new ones,
  // refresh_marks() of each new poly and of each poly that shares a facet with a new one or is in a poly list of an old
  // one. A new poly may have the number of an old one.

  encoded_neighbour neighbour(poly_id p, std::uint32_t k) const { return neighbours_.begin(p.raw())[k]; }
  /// The number of polys at facet k of p.
  std::uint32_t num_polys_at(poly_id p, std::uint32_t k) const {
    const encoded_neighbour x = neighbour(p, k);
    return x.is_none() ? 1 : x.is_non_manifold() ? poly_lists_.length(x.poly_list()) : 2;
  }
  /// Allocates memory for `rows` new polys with that many facets in all, which includes the growth of rows that
  /// resize_row() will need, and for `facets` new ones.
  void reserve_polys(std::size_t rows, std::size_t values, std::size_t facets) {
    facets_.reserve_rows(rows, values);
    neighbours_.reserve_rows(rows, values);
    owner_.reserve_back(facets);
  }
  std::uint32_t growth_of_row(poly_id p, std::size_t n) const { return facets_.growth_of_row(p.raw(), n); }
  /// Allocates memory for poly lists of `lists` facets that will have `polys` polys in all.
  void reserve_poly_lists(std::size_t lists, std::size_t polys) {
    poly_lists_.make_editable();
    if (lists > 0) poly_lists_.reserve_rows(lists, 4 * polys + 2 * min_list_capacity * lists);
  }
  /// Calls f for every array, for undoing; save_facet() and save_poly() save the rows of one facet and of one poly.
  template<class F>
  void for_each_array(const F& f) {
    f(facets_), f(neighbours_), f(owner_), f(poly_lists_.rows());
  }
  static constexpr std::uint32_t num_arrays = 4;
  template<class Log>
  void save_facet(Log& log, std::uint32_t first_array, Facet f) const {
    log.save(first_array + 2, owner_, f.raw());
    if (!is_owned(f)) return;
    const incidence s = owner(f);
    const encoded_neighbour x = neighbours_.begin(s.poly)[s.k];
    if (x.is_non_manifold()) log.save(first_array + 3, poly_lists_.rows(), x.poly_list());
    for (const poly_id p : polys_of(f)) log.save(first_array + 1, neighbours_, p.raw());
  }
  template<class Log>
  void save_poly(Log& log, std::uint32_t first_array, poly_id p) const {
    log.save(first_array, facets_, p.raw());
    log.save(first_array + 1, neighbours_, p.raw());
  }
  void detach(poly_id p) { unlink(p.raw()); }
  /// Gives p room for n facets; they are undefined before they are attached.
  void resize_row(poly_id p, std::uint32_t n) {
    facets_.resize_row(p.raw(), n);
    neighbours_.resize_row(p.raw(), n);
  }
  /// Adds a poly with n facets, which are undefined before they are attached.
  void add_poly(std::uint32_t n) {
    facets_.stage_row(nullptr, n);
    neighbours_.stage_row(nullptr, n);
    facets_.commit_row(n);
    neighbours_.commit_row(n);
  }
  /// The same for n polys if all have N facets.
  void add_polys(std::size_t n)
    requires(N > 0)
  {
    facets_.commit_rows(n);
    neighbours_.commit_rows(n);
  }
  /// Makes f facet k of p. Behind it is `other`, or nothing if that is none, for which the same must be said. is_first:
  /// whether f belongs to p first. This takes less time than attach().
  void attach_between(poly_id p, std::uint32_t k, Facet f, poly_id other, bool is_first) {
    facets_.begin(p.raw())[k] = f;
    neighbours_.begin(p.raw())[k].raw = other.raw();  // none is the same number
    if (is_first) set_owner(f, p.raw(), k);
  }
  /// Makes f facet k of p. Other polys at f, but no marks of repeated neighbours, are updated.
  void attach(poly_id p, std::uint32_t k, Facet f) {
    facets_.begin(p.raw())[k] = f;
    encoded_neighbour& own = neighbours_.begin(p.raw())[k];
    own = {};
    if (!is_owned(f)) return set_owner(f, p.raw(), k);
    const incidence s = owner(f);
    encoded_neighbour& first = neighbours_.begin(s.poly)[s.k];
    if (first.is_none()) {
      first.raw = p.raw();
      own.raw = s.poly;
    } else if (first.is_non_manifold()) {
      poly_lists_.insert(first.poly_list(), p);
      own = first;
    } else {
      poly_id three[] = {poly_id{s.poly}, poly_id{first.poly()}, p};
      encoded_neighbour& second = neighbours_.begin(first.poly())[local(first.poly(), f)];
      if (three[1] < three[0]) std::swap(three[0], three[1]);
      if (three[2] < three[1]) std::swap(three[1], three[2]);
      if (three[1] < three[0]) std::swap(three[0], three[1]);
      own.raw = encoded_neighbour::special | encoded_neighbour::non_manifold_bit |
                static_cast<std::uint32_t>(poly_lists_.size());
      poly_lists_.add_row(three, three + 3, min_list_capacity);
      first = second = own;
    }
  }
  // Edits that know that no poly has a neighbour behind two facets or a non-manifold facet, before and afterwards.

  /// Makes f facet k of p. Behind it is `outside`, to which f belongs first, or nothing.
  void put(poly_id p, std::uint32_t k, Facet f, encoded_neighbour outside) {
    facets_.begin(p.raw())[k] = f;
    neighbours_.begin(p.raw())[k] = outside;
    if (outside.is_none()) return set_owner(f, p.raw(), k);
    const std::uint32_t j = local(outside.raw, f);
    neighbours_.begin(outside.raw)[j].raw = p.raw();
    set_owner(f, outside.raw, j);
  }
  /// Makes f facet k of p, to which it belongs first, and facet j of q.
  void put_between(poly_id p, std::uint32_t k, poly_id q, std::uint32_t j, Facet f) {
    facets_.begin(p.raw())[k] = facets_.begin(q.raw())[j] = f;
    neighbours_.begin(p.raw())[k].raw = q.raw();
    neighbours_.begin(q.raw())[j].raw = p.raw();
    set_owner(f, p.raw(), k);
  }
  /// Of the two polys at f, its facet k, p becomes the first.
  void set_first(Facet f, poly_id p, std::uint32_t k) { set_owner(f, p.raw(), k); }
  /// If f has two polys and p is one of them, it becomes the first.
  void keep_first(Facet f, poly_id p) {
    if (!is_owned(f)) return;
    const incidence s = owner(f);
    const encoded_neighbour x = neighbours_.begin(s.poly)[s.k];
    if (!x.is_none() && !x.is_non_manifold() && x.poly() == p.raw()) set_owner(f, p.raw(), local(p.raw(), f));
  }
  /// Marks the incidences of p whose neighbour is already behind an earlier facet or a non-manifold facet of p, and no
  /// others. The scratch memory needs room for its facets, if these are more than `max_scanned_facets`.
  template<class Scratch>
  void refresh_marks(poly_id p, Scratch& scratch);
  static constexpr std::uint32_t few_facets = 8;           // of polys whose poly lists are not stored
  static constexpr std::uint32_t max_scanned_facets = 24;  // up to here comparing all pairs is fastest

  /// Whether an incidence of p is marked or non-manifold.
  bool is_marked(std::uint32_t p) const {
    bool is = false;
    for (const encoded_neighbour *s = neighbours_.begin(p), *last = s + facets_.length(p); s != last; ++s)
      is |= !s->is_none() && !s->is_first_occurrence();
    return is;
  }

  /// A fast test that is false for nearly all polys.
  bool may_repeat(std::uint32_t p) const {
    const std::uint32_t n = facets_.length(p);
    if (n > max_scanned_facets) return true;
    const encoded_neighbour* const s = neighbours_.begin(p);
    bool may = false;
    for (std::uint32_t k = 0; k < n; ++k) {
      may |= s[k].is_non_manifold();
      for (std::uint32_t j = 0; j < k; ++j) may |= s[k].raw == s[j].raw && !s[k].is_none();
    }
    return may;
  }

  /// Marks the incidences of p whose neighbour is already behind an earlier facet or a non-manifold facet of p.
  void mark_repeats(std::uint32_t p, std::vector<std::uint32_t>& met);

 private:
  static constexpr std::size_t min_list_capacity = 4;       // of a new list of polys

  /// Marks incidences of one poly, given as neighbour and position, that repeat a neighbour.
  template<class Scratch>
  static void mark_repeats_in(Scratch& sorted, encoded_neighbour* s);

  void mark_by_scanning(std::uint32_t p);

  /// Marks the incidences of p whose neighbour is also at a non-manifold facet of p.
  void mark_in_poly_lists(std::uint32_t p);

  // A repeated neighbour stays repeated as long as that poly lives, so marks are only added: at incidences with a new
  // poly, with one that is at a non-manifold facet now, or with one that was at a non-manifold facet before.

  /// Marks the incidences of q with neighbour p if p is also behind an earlier facet or a non-manifold facet of q. p is
  /// the last poly of each of its lists.
  void mark_repeats_of(std::uint32_t p, std::uint32_t q);
  /// Marks the incidences of q whose only neighbour is p.
  void mark_facets_to(std::uint32_t p, std::uint32_t q);
  /// Marks facet k of p, which has one neighbour, if that is also at a non-manifold facet of p.
  void mark_if_in_poly_list(std::uint32_t p, std::uint32_t k);

  /// Gives the second poly of every non-manifold facet the list of its polys: before, it had one neighbour there.
  void set_poly_lists();

  /// The k with facet k of p equal to f, which must exist.
  std::uint32_t local(std::uint32_t p, Facet f) const {
    const Facet* const at = facets_.begin(p);
    for (std::uint32_t k = 0; k < row_lookup::longest_scan; ++k)
      if (at[k] == f) return k;
    return facet_lookup_.find(p, facets_[p], f);
  }

  void set_owner(Facet f, std::uint32_t p, std::uint32_t k) { owner_[f.raw()] = N > 0 ? N * p + k : p; }

  void join(incidence s, std::uint32_t p, std::uint32_t k) {
    encoded_neighbour& first = neighbours_.begin(s.poly)[s.k];
    if (first.is_none()) {
      first.raw = p;
      neighbours_.begin(p)[k].raw = s.poly;
    } else {
      add_to_poly_list(s, first, p, k);
    }
  }

  /// The incidence of the second poly is not updated here.
  void add_to_poly_list(incidence s, encoded_neighbour& first, std::uint32_t p, std::uint32_t k);
};

}  // namespace concino::detail

#include <concino/mesh/detail/tables/facet_adjacency_build.ipp>
#include <concino/mesh/detail/tables/facet_adjacency_marks.ipp>
