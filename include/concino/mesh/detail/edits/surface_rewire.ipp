// Replaces a few polys of a surface by others; see surface_tables.hpp and concepts/editable.hpp. Like the other edits:
// first all memory is allocated, which changes no element, then the tables are changed, which cannot fail.
#pragma once

#include <concino/mesh/detail/edits/cavity_changes.hpp>
#include <concino/mesh/detail/edits/cavity_edges.hpp>
#include <concino/mesh/detail/edits/surface_cavity.hpp>
#include <concino/mesh/surface_tables.hpp>

namespace concino {

template<unsigned Arity, class Lists>
class surface_tables<Arity, Lists>::rewiring : detail::surface_cavity<Arity> {
  using base = detail::surface_cavity<Arity>;
  using base::c_, base::verts_, base::num_old_verts_, base::num_verts_, base::edges_, base::changes_,
      base::edges_of_new_, base::of_lists_, base::num_new_edges_, base::num_unused_edges_;
  using base::corners, base::next, base::num_added, base::num_corners, base::num_new, base::old_corners;

  surface_tables& t_;
  core::small_array<std::uint64_t, 1> scratch_;
  const std::size_t first_vert_ = t_.verts_.bound(), first_poly_ = t_.polys_.bound();  // the first added ones

  vert_id vert(unsigned local) const {
    return local < num_old_verts_ ? verts_[local] : vert_id{first_vert_ + (local - num_old_verts_)};
  }
  poly_id new_poly(std::size_t k) const { return k < c_.kept ? c_.polys[k] : poly_id{first_poly_ + (k - c_.kept)}; }

 public:
  rewiring(surface_tables& t, const detail::native_cavity& c) : base(t, c), t_(t) {}

  void save(detail::edit_log& log) const;
  void reserve(function_ref<void(const detail::index_bounds&)> grow);
  void commit(const detail::native_cavity_result& made);

 private:
  void reserve_poly_lists();
  std::size_t values_of_rows() const;

  void change_polys_of_verts();
  void replace_polys();
  void restore_order();
  void refresh_marks();

  using cavity_edge = detail::cavity_edge;
};

/// Saves all rows that reserve() and commit() may change. The arrays are numbered as for_each_array() visits them.
template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::rewiring::save(detail::edit_log& log) const {
  enum : std::uint32_t { of_verts, of_edges, of_polys, of_p2v, of_e2v, of_incident, of_facets };
  for (unsigned i = 0; i < num_old_verts_; ++i) {
    const std::size_t v = verts_[i].raw();
    log.save(of_verts, t_.verts_, v), log.save(of_incident, t_.incident_, v);
  }
  for (const cavity_edge& x : edges_) {
    if (x.id.is_none()) continue;
    log.save(of_edges, t_.edges_, x.id.raw()), log.save(of_e2v, t_.e2v_, x.id.raw());
    t_.facet_adjacency_.save_facet(log, of_facets, x.id);
  }
  for (const poly_id p : c_.polys) {
    log.save(of_polys, t_.polys_, p.raw()), log.save(of_p2v, t_.p2v_, p.raw());
    t_.facet_adjacency_.save_poly(log, of_facets, p);
  }
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::rewiring::reserve_poly_lists() {
  std::size_t lists = 0, in_lists = 0;
  for (const cavity_edge& x : edges_) {
    if (x.num_polys - x.old_polys + x.new_polys <= 2) continue;
    ++lists;
    in_lists += x.num_polys + x.new_polys;
  }
  t_.facet_adjacency_.reserve_poly_lists(lists, in_lists);
}

/// The memory for corners that new polys, and old ones whose size changes, need behind the others.
template<unsigned Arity, class Lists>
std::size_t surface_tables<Arity, Lists>::rewiring::values_of_rows() const {
  if constexpr (Arity > 0) return Arity * num_added();
  std::size_t n = 0;
  for (std::size_t k = 0; k < num_new(); ++k)
    n += k < c_.kept ? t_.p2v_.growth_of_row(c_.polys[k].raw(), corners(k).size()) : corners(k).size();
  return n;
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::rewiring::reserve(function_ref<void(const detail::index_bounds&)> grow) {
  detail::reuse_descriptors(edges_, num_new_edges_, num_unused_edges_);
  const std::size_t more_edges = num_new_edges_ > num_unused_edges_ ? num_new_edges_ - num_unused_edges_ : 0;
  detail::reserve_lists_of_verts(t_.incident_, changes_, num_old_verts_, [this](unsigned v) { return vert(v); });
  reserve_poly_lists();
  const std::size_t values = values_of_rows();
  t_.p2v_.reserve_rows(num_added(), values);
  t_.facet_adjacency_.reserve_polys(num_added(), Arity > 0 ? values : 2 * (values + num_corners()) + 4 * c_.kept,
                                    more_edges);
  t_.e2v_.reserve_rows(more_edges);
  t_.verts_.reserve_change(c_.removed, c_.points.size());
  t_.edges_.reserve_change(num_unused_edges_ - std::min(num_new_edges_, num_unused_edges_), more_edges);
  t_.polys_.reserve_change(c_.polys.size() - c_.kept, num_added());
  if constexpr (Arity == 0) {
    std::size_t most = 0;
    for (const poly_id p : of_lists_) most = std::max<std::size_t>(most, t_.p2v_.length(p.raw()));
    for (std::size_t k = 0; k < num_new(); ++k) most = std::max(most, corners(k).size());
    for (const cavity_edge& x : edges_)
      if (!x.id.is_none())
        for (const poly_id p : t_.adj_e2p(x.id)) most = std::max<std::size_t>(most, t_.p2v_.length(p.raw()));
    scratch_.reserve(most);
  }
  if (grow)
    grow({t_.verts_.bound() + c_.points.size(), t_.edges_.bound() + more_edges, 0, t_.polys_.bound() + num_added(),
          t_.p2v_.num_values() + values});
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::rewiring::commit(const detail::native_cavity_result& made) {
  for (unsigned v = num_old_verts_; v < num_verts_; ++v) {
    t_.incident_.add_vert(std::max(std::max(changes_[v].edges_gained, changes_[v].polys_after), 1u));
    made.verts[v - num_old_verts_] = vert(v);
  }
  for (const poly_id p : c_.polys) t_.facet_adjacency_.detach(p);
  change_polys_of_verts();
  detail::change_edges(edges_, t_.edges_, t_.e2v_, t_.incident_, [this](unsigned v) { return vert(v); });
  while (t_.facet_adjacency_.num_facets() < t_.edges_.bound()) t_.facet_adjacency_.add_facet();
  replace_polys();
  restore_order();
  refresh_marks();
  for (std::size_t k = c_.kept; k < c_.polys.size(); ++k) t_.polys_.remove(c_.polys[k]);
  for (std::size_t k = 0; k < num_new(); ++k) made.polys[k] = new_poly(k);
  for (std::size_t k = c_.kept; k < num_new(); ++k) t_.polys_.add();
  for (std::size_t v = num_old_verts_ - c_.removed; v < num_old_verts_; ++v) t_.verts_.remove(c_.verts[v]);
  for (unsigned v = num_old_verts_; v < num_verts_; ++v) t_.verts_.add();
}

/// Verts that a poly has before and after keep it where it is in their lists. All removals come first: memory is
/// reserved for the lists as they will be.
template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::rewiring::change_polys_of_verts() {
  constexpr std::size_t longest_scan = 16;
  const auto is_compared = [&](std::size_t k) {
    return k < c_.kept && (Arity > 0 || (corners(k).size() <= longest_scan && old_corners(k).size() <= longest_scan));
  };
  const auto has = [](id_span<unsigned> all, unsigned v) {
    bool found = false;
    for (const unsigned x : all) found |= x == v;
    return found;
  };
  for (std::size_t k = 0; k < c_.polys.size(); ++k) {
    const bool compared = is_compared(k);
    for (const unsigned v : old_corners(k))
      if (!compared || !has(corners(k), v)) t_.incident_.remove(verts_[v], c_.polys[k]);
  }
  for (std::size_t k = 0; k < num_new(); ++k) {
    const bool compared = is_compared(k);
    for (const unsigned v : corners(k))
      if (!compared || !has(old_corners(k), v)) t_.incident_.push(vert(v), new_poly(k));
  }
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::rewiring::replace_polys() {
  const unsigned* edge = edges_of_new_.begin();
  for (std::size_t k = 0; k < num_new(); ++k) {
    const id_span<unsigned> v = corners(k);
    const poly_id p = new_poly(k);
    const auto n = static_cast<std::uint32_t>(v.size());
    if (k < c_.kept) {
      t_.p2v_.resize_row(p.raw(), n);
      t_.facet_adjacency_.resize_row(p, n);
    } else {
      t_.p2v_.stage_row(nullptr, n);
      t_.p2v_.commit_row(n);
      t_.facet_adjacency_.add_poly(n);
    }
    for (std::uint32_t i = 0; i < n; ++i) t_.p2v_.begin(p.raw())[i] = vert(v[i]);
    for (std::uint32_t i = 0; i < n; ++i) t_.facet_adjacency_.attach(p, i, edges_[*edge++].id);
  }
}

/// The first poly of an edge that had two, and has two again, stays the first.
template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::rewiring::restore_order() {
  for (const cavity_edge& x : edges_)
    if (!x.first_poly.is_none() && !x.is_unused()) t_.facet_adjacency_.keep_first(x.id, x.first_poly);
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::rewiring::refresh_marks() {
  detail::facet_adjacency<edge_id, Arity>& all = t_.facet_adjacency_;
  for (std::size_t k = 0; k < num_new(); ++k) {
    const poly_id p = new_poly(k);
    all.refresh_marks(p, scratch_);
    for (std::uint32_t i = 0; i < corners(k).size(); ++i) {
      const detail::encoded_neighbour x = all.neighbour(p, i);
      if (x.is_none()) continue;
      if (!x.is_non_manifold()) all.refresh_marks(poly_id{x.poly()}, scratch_);
      else
        for (const poly_id q : t_.adj_e2p(all.facets(p)[i])) all.refresh_marks(q, scratch_);
    }
  }
  for (const poly_id q : of_lists_) all.refresh_marks(q, scratch_);
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::rewire(const detail::native_cavity& c, const detail::native_cavity_result& made,
                                          function_ref<void(const detail::index_bounds&)> grow, detail::edit_log* log) {
  rewiring r(*this, c);
  if (log) r.save(*log);
  r.reserve(grow);
  r.commit(made);
}

}  // namespace concino
