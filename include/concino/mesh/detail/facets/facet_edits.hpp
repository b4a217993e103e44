// Edits of the incidence of polys and facets that replace a few polys by others.
#pragma once

#include <concino/mesh/detail/facets/facet_marks.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace concino::detail {

/// Edits allocate their memory first, which changes nothing, and cannot fail afterwards.
template<class Facet, unsigned N>
class facet_edits : public facet_marks<Facet, N> {
  using base = facet_marks<Facet, N>;

 protected:
  using base::facets_, base::neighbours_, base::owner_, base::poly_lists_, base::facet_lookup_;
  using base::min_list_capacity, base::local, base::set_owner;
  using base::mark_if_in_poly_list;

  using base::base;

 public:
  using typename base::incidence;
  using base::is_owned, base::num_facets, base::num_polys, base::owner, base::polys_of;

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
};

}  // namespace concino::detail
