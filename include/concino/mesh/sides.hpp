// Which polys lie on the two sides of a facet, and which poly lies across each side of a poly. Facets are the edges of a surface and the
// faces of a volume; the table is the same for both, and it is what the dual graph is walked on.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/mesh/rows.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// What lies across one side of a poly, in 32 bits: nothing; a poly; a poly that an earlier side of the same poly already leads to; or a
/// crowd, the list of polys of a facet that has more than two.
struct across {
  std::uint32_t raw = none;

  static constexpr std::uint32_t none = ~0u;
  static constexpr std::uint32_t special = 1u << 31;
  static constexpr std::uint32_t crowd_bit = 1u << 30;
  static constexpr std::uint32_t mask = crowd_bit - 1;

  bool is_none() const { return raw == none; }
  bool is_first() const { return raw < special; }
  bool is_crowd() const { return raw != none && (raw & special) && (raw & crowd_bit); }
  std::uint32_t poly() const { return raw & mask; }
  std::uint32_t crowd() const { return raw & mask; }
};

/// Up to two polys, or a crowd.
class polys_of_facet {
  poly_id few_[2];
  const poly_id* first_ = nullptr;  // null: the few
  std::uint32_t size_ = 0;

 public:
  using value_type = poly_id;
  /// Carries the values themselves, so that it outlives the range.
  class iterator {
    poly_id now_, then_;
    const poly_id* crowd_ = nullptr;
    std::uint32_t left_ = 0;

   public:
    using value_type = poly_id;
    using reference = poly_id;
    using difference_type = std::ptrdiff_t;
    iterator() = default;
    iterator(poly_id a, poly_id b, const poly_id* crowd, std::uint32_t left) : now_(a), then_(b), crowd_(crowd), left_(left) {}
    poly_id operator*() const { return crowd_ ? *crowd_ : now_; }
    iterator& operator++() {
      if (crowd_) ++crowd_;
      else now_ = then_;
      --left_;
      return *this;
    }
    iterator operator++(int) { iterator old = *this; ++*this; return old; }
    friend bool operator==(const iterator& a, const iterator& b) { return a.left_ == b.left_; }
  };

  polys_of_facet() = default;
  explicit polys_of_facet(poly_id a) : few_{a, {}}, size_(1) {}
  polys_of_facet(poly_id a, poly_id b) : few_{a, b}, size_(2) {}
  polys_of_facet(const poly_id* first, const poly_id* last) : first_(first), size_(static_cast<std::uint32_t>(last - first)) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  poly_id operator[](std::size_t i) const { return first_ ? first_[i] : few_[i]; }
  iterator begin() const { return {few_[0], few_[1], first_, size_}; }
  iterator end() const { return {{}, {}, nullptr, 0}; }
};

/// The polys across all sides of one poly, each once.
class polys_across {
  const across* first_ = nullptr;
  const across* last_ = nullptr;
  const rows<poly_id, 0>* crowds_ = nullptr;
  poly_id self_;

 public:
  using value_type = poly_id;
  class iterator {
    const across* at_ = nullptr;
    const across* last_ = nullptr;
    const across* first_ = nullptr;
    const rows<poly_id, 0>* crowds_ = nullptr;
    poly_id self_;
    std::uint32_t nth_ = 0;  // within a crowd

    bool met_before(poly_id q) const {
      for (const across* s = first_; s != at_; ++s) {
        if (s->is_none()) continue;
        if (!s->is_crowd()) {
          if (s->poly() == q.raw()) return true;
        } else {
          for (poly_id r : (*crowds_)[s->crowd()])
            if (r == q) return true;
        }
      }
      return false;
    }
    void settle() {
      while (at_ != last_ && !at_->is_first()) [[unlikely]] {
        if (at_->is_crowd()) {
          const auto crowd = (*crowds_)[at_->crowd()];
          while (nth_ < crowd.size() && (crowd[nth_] == self_ || met_before(crowd[nth_]))) ++nth_;
          if (nth_ < crowd.size()) return;
          nth_ = 0;
        }
        ++at_;
      }
    }

   public:
    using value_type = poly_id;
    using reference = poly_id;
    using difference_type = std::ptrdiff_t;
    iterator() = default;
    iterator(const across* at, const across* last, const rows<poly_id, 0>* crowds, poly_id self)
        : at_(at), last_(last), first_(at), crowds_(crowds), self_(self) {
      settle();
    }
    poly_id operator*() const {
      if (at_->is_first()) [[likely]] return poly_id{at_->raw};
      return (*crowds_)[at_->crowd()][nth_];
    }
    iterator& operator++() {
      if (at_->is_first()) [[likely]] ++at_;
      else ++nth_;
      settle();
      return *this;
    }
    iterator operator++(int) { iterator old = *this; ++*this; return old; }
    friend bool operator==(const iterator& a, const iterator& b) { return a.at_ == b.at_ && a.nth_ == b.nth_; }
  };

  polys_across() = default;
  polys_across(const across* first, const across* last, const rows<poly_id, 0>* crowds, poly_id self)
      : first_(first), last_(last), crowds_(crowds), self_(self) {}
  iterator begin() const { return {first_, last_, crowds_, self_}; }
  iterator end() const { return {last_, last_, crowds_, self_}; }
};

/// N sides a poly, or as many as each has (N = 0).
template<class Facet, unsigned N>
class sides {
  rows<Facet, N> facets_;        // per poly
  rows<across, N> across_;       // parallel to facets_
  offsets owner_;                // per facet: N > 0: the side N * poly + k that met it first; N = 0: that poly; ~0: none
  rows<poly_id, 0> crowds_;

 public:
  struct side {
    std::uint32_t poly, k;
  };

  sides() = default;
  /// Begins with every side open and every facet unowned; link() each side once.
  sides(rows<Facet, N> facets, rows<across, N> open_sides) : facets_(std::move(facets)), across_(std::move(open_sides)) {}

  std::size_t num_polys() const { return facets_.size(); }
  std::size_t num_facets() const { return owner_.size(); }
  id_span<Facet> facets(poly_id p) const { return facets_[p.raw()]; }
  const across* across_sides(poly_id p) const { return across_.begin(p.raw()); }
  polys_across polys(poly_id p) const { return {across_.begin(p.raw()), across_.end(p.raw()), &crowds_, p}; }
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
  void reserve_facets(std::size_t n) { owner_.reserve(n); }
  void resize_facets(std::size_t n) { owner_.resize(n, ~0u); }

  /// Builds: side k of p is facet f.
  void link(std::uint32_t p, std::uint32_t k, Facet f) {
    facets_.begin(p)[k] = f;
    std::uint32_t& o = owner_[f.raw()];
    if (o == ~0u) {
      o = N > 0 ? N * p + k : p;
      return;
    }
    const side s = owner(f);
    across& first = across_.begin(s.poly)[s.k];
    if (first.is_none()) {
      first.raw = p;
      across_.begin(p)[k].raw = s.poly;
    } else {
      crowd_in(s, first, p, k);
    }
  }

  /// Builds: after the last link, so that a poly met across two sides is listed once.
  void finish() {
    owner_.shrink_to_fit();
    std::vector<std::uint32_t> met;
    for (std::uint32_t p = 0; p < num_polys(); ++p) mark_repeats(p, met);
  }

  /// Edits: a poly with n sides that are still to be linked.
  void add_poly(std::uint32_t n) {
    const std::vector<Facet> facets(n);
    const std::vector<across> open(n);
    facets_.add_row(facets.begin(), facets.end());
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
    for (const Facet f : facets_[p]) {
      std::vector<poly_id> rest;
      for (const poly_id q : polys_of(f))
        if (q.raw() != p) rest.push_back(q), around.push_back(q.raw());
      relink(f, rest);
    }
    across* const s = across_.begin(p);
    for (std::uint32_t k = 0; k < facets_.length(p); ++k) s[k] = {};
    for (const std::uint32_t q : around) remark_one(q);
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
  void remark_one(std::uint32_t p) {
    std::vector<std::uint32_t> met;
    across* const s = across_.begin(p);
    for (std::uint32_t k = 0; k < facets_.length(p); ++k)
      if (!s[k].is_none() && !s[k].is_crowd()) s[k].raw &= across::mask;
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
