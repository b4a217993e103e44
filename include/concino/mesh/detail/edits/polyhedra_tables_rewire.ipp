// Replaces a few general polyhedra by others; see polyhedra_tables.hpp and concepts/editable.hpp. Like the other edits:
// first all memory is allocated, which changes no element, then the tables are changed, which cannot fail.
#pragma once

#include <concino/mesh/detail/edits/polyhedra_cavity.hpp>
#include <concino/mesh/polyhedra_tables.hpp>

namespace concino {

template<class Lists>
class basic_polyhedra_tables<Lists>::rewiring {
  using face = detail::polyhedra_cavity_face;

  basic_polyhedra_tables& t_;
  detail::polyhedra_cavity x_;
  const detail::native_cavity& c_ = x_.c;
  const std::size_t first_vert_ = t_.verts_.bound(), first_poly_ = t_.polys_.bound();  // the first added ones
  core::small_array<poly_id, 8> of_lists_;  // polys in lists of faces of old polys
  core::small_array<std::uint64_t, 1> scratch_;

  vert_id vert(unsigned local) const {
    return local < x_.num_old_verts ? x_.verts[local] : vert_id{first_vert_ + (local - x_.num_old_verts)};
  }
  poly_id new_poly(std::size_t k) const { return k < c_.kept ? c_.polys[k] : poly_id{first_poly_ + (k - c_.kept)}; }

  void reserve_faces_of_edges();
  void reserve_faces();
  std::size_t reserve_polys();
  void reserve_scratch();
  void remove_faces();
  void add_faces();
  void replace_polys();
  void refresh_marks();

 public:
  rewiring(basic_polyhedra_tables& t, const detail::native_cavity& c) : t_(t), x_(t, c) {}
  void save(detail::edit_log& log) const;
  void reserve(function_ref<void(const detail::index_bounds&)> grow);
  void commit(const detail::native_cavity_result& made);
};

/// Saves all rows that reserve() and commit() may change.
template<class Lists>
void basic_polyhedra_tables<Lists>::rewiring::save(detail::edit_log& log) const {
  for (const vert_id x : c_.verts) {
    const std::size_t v = x.raw();
    log.save(of_verts, t_.verts_, v), log.save(of_incident_edges, t_.incident_edges_, v), log.save(of_v2p, t_.v2p_, v);
  }
  for (const detail::cavity_edge& x : x_.edges) {
    const std::size_t e = x.id.raw();
    if (!x.id.is_none()) log.save(of_edges, t_.edges_, e), log.save(of_e2v, t_.e2v_, e), log.save(of_e2f, t_.e2f_, e);
  }
  for (const face& x : x_.faces) {
    if (x.id.is_none()) continue;
    log.save(of_faces, t_.faces_, x.id.raw()), log.save(of_f2v, t_.f2v_, x.id.raw());
    t_.facet_adjacency_.save_facet(log, of_facets, x.id);
  }
  for (const poly_id x : c_.polys) {
    const std::size_t p = x.raw();
    log.save(of_polys, t_.polys_, p), log.save(of_p2v, t_.p2v_, p), log.save(of_p2e, t_.p2e_, p),
        log.save(of_outward, t_.outward_, p);
    t_.facet_adjacency_.save_poly(log, of_facets, x);
  }
}

template<class Lists>
void basic_polyhedra_tables<Lists>::rewiring::reserve(function_ref<void(const detail::index_bounds&)> grow) {
  detail::reserve_lists_of_verts(t_.incident_edges_, t_.v2p_, x_.changes, x_.num_old_verts,
                                 [this](unsigned v) { return vert(v); });
  reserve_faces_of_edges();
  reserve_faces();
  const std::size_t corners = reserve_polys();
  reserve_scratch();
  t_.e2v_.reserve_rows(x_.more_edges());
  t_.verts_.reserve_change(c_.removed, c_.points.size());
  t_.edges_.reserve_change(x_.num_unused_edges - std::min(x_.num_new_edges, x_.num_unused_edges), x_.more_edges());
  t_.faces_.reserve_change(x_.num_unused_faces - std::min(x_.num_new_faces, x_.num_unused_faces), x_.more_faces());
  t_.polys_.reserve_change(c_.polys.size() - c_.kept, x_.num_added());
  if (grow)
    grow({t_.verts_.bound() + c_.points.size(), t_.edges_.bound() + x_.more_edges(),
          t_.faces_.bound() + x_.more_faces(), t_.polys_.bound() + x_.num_added(), t_.p2v_.num_values() + corners});
}

/// An edge that takes the descriptor of one that is left over also takes its list, which is empty then.
template<class Lists>
void basic_polyhedra_tables<Lists>::rewiring::reserve_faces_of_edges() {
  std::size_t values = 0;
  t_.e2f_.make_editable();
  for (const detail::cavity_edge& x : x_.edges) {
    const bool is_new = x.id.is_none();
    if (is_new && !x.has_partner()) {
      values += std::max<std::size_t>(x.new_polys, faces_of_new_edge);
      continue;
    }
    const edge_id e = is_new ? x_.edges[x.partner].id : x.id;
    const std::uint32_t lost = is_new ? t_.e2f_.length(e.raw()) : x.old_polys;
    if (x.new_polys > lost) t_.e2f_.reserve_in_row(e.raw(), x.new_polys - lost);
  }
  t_.e2f_.reserve_rows(x_.more_edges(), values);
}

template<class Lists>
void basic_polyhedra_tables<Lists>::rewiring::reserve_faces() {
  std::size_t values = 0, lists = 0, listed = 0;
  for (const face& x : x_.faces) {
    if (x.id.is_none())
      values += x.has_partner() ? t_.f2v_.growth_of_row(x_.faces[x.partner].id.raw(), x.size) : x.size;
    if (x.num_polys > 2 && x.old_polys > 0)
      for (const poly_id p : t_.adj_f2p(x.id)) of_lists_.push_back(p);
    if (x.num_polys - x.old_polys + x.new_polys > 2) ++lists, listed += x.num_polys + x.new_polys;
  }
  t_.f2v_.reserve_rows(x_.more_faces(), values);
  t_.facet_adjacency_.reserve_poly_lists(lists, listed);
}

/// Result: how much the bound of corners grows.
template<class Lists>
std::size_t basic_polyhedra_tables<Lists>::rewiring::reserve_polys() {
  std::size_t in_p2v = 0, in_p2e = 0, in_p2f = 0, in_outward = 0;
  for (std::size_t k = 0; k < x_.num_new(); ++k) {
    const poly_id p = new_poly(k);
    const bool is_kept = k < c_.kept;
    in_p2v += is_kept ? t_.p2v_.growth_of_row(p.raw(), x_.num_verts_of(k)) : x_.num_verts_of(k);
    in_p2e += is_kept ? t_.p2e_.growth_of_row(p.raw(), x_.num_edges_of(k)) : x_.num_edges_of(k);
    in_p2f += is_kept ? t_.facet_adjacency_.growth_of_row(p, x_.num_faces_of(k)) : x_.num_faces_of(k);
    in_outward += is_kept ? t_.outward_.growth_of_row(p.raw(), x_.num_faces_of(k)) : x_.num_faces_of(k);
  }
  t_.p2v_.reserve_rows(x_.num_added(), in_p2v);
  t_.p2e_.reserve_rows(x_.num_added(), in_p2e);
  t_.outward_.reserve_rows(x_.num_added(), in_outward);
  t_.facet_adjacency_.reserve_polys(x_.num_added(), in_p2f, x_.more_faces());
  return in_p2v;
}

/// Allocates what refresh_marks() needs for the poly with the most faces.
template<class Lists>
void basic_polyhedra_tables<Lists>::rewiring::reserve_scratch() {
  std::size_t most = 0;
  for (std::size_t k = 0; k < x_.num_new(); ++k) most = std::max(most, x_.num_faces_of(k));
  for (const poly_id p : of_lists_) most = std::max(most, t_.adj_p2f(p).size());
  for (const face& x : x_.faces)
    if (!x.id.is_none())
      for (const poly_id p : t_.adj_f2p(x.id)) most = std::max(most, t_.adj_p2f(p).size());
  scratch_.reserve(most);
}

template<class Lists>
void basic_polyhedra_tables<Lists>::rewiring::commit(const detail::native_cavity_result& made) {
  for (unsigned v = x_.num_old_verts; v < x_.num_verts; ++v) {
    detail::add_lists_of_vert(t_.incident_edges_, t_.v2p_, x_.changes[v].edges_gained, x_.changes[v].polys_after);
    made.verts[v - x_.num_old_verts] = t_.verts_.add();
  }
  for (const poly_id p : c_.polys) {
    t_.facet_adjacency_.detach(p);
    for (const vert_id v : t_.adj_p2v(p)) t_.v2p_.remove_at(v.raw(), t_.v2p_.find_in_row(v.raw(), p));
  }
  remove_faces();
  detail::change_edges(x_.edges, t_.edges_, t_.e2v_, t_.incident_edges_, [this](unsigned v) { return vert(v); });
  for (const detail::cavity_edge& x : x_.edges)
    if (x.id.raw() == t_.e2f_.size())
      t_.e2f_.add_row(static_cast<const face_id*>(nullptr), static_cast<const face_id*>(nullptr),
                      std::max<std::size_t>(x.new_polys, faces_of_new_edge));
  add_faces();
  replace_polys();
  refresh_marks();
  for (std::size_t k = c_.kept; k < c_.polys.size(); ++k) t_.polys_.remove(c_.polys[k]);
  for (std::size_t k = c_.kept; k < x_.num_new(); ++k) t_.polys_.add();
  for (std::size_t k = 0; k < x_.num_new(); ++k) made.polys[k] = new_poly(k);
  for (std::size_t v = c_.verts.size() - c_.removed; v < c_.verts.size(); ++v) t_.verts_.remove(c_.verts[v]);
}

template<class Lists>
void basic_polyhedra_tables<Lists>::rewiring::remove_faces() {
  for (const face& x : x_.faces) {
    if (!x.is_unused()) continue;
    x_.for_each_edge(x, [&](const detail::cavity_edge& e) { t_.e2f_.remove(e.id.raw(), x.id); });
    if (!x.has_partner()) t_.faces_.remove(x.id);
  }
}

template<class Lists>
void basic_polyhedra_tables<Lists>::rewiring::add_faces() {
  for (face& x : x_.faces) {
    if (!x.id.is_none()) continue;
    if (x.has_partner()) {
      x.id = x_.faces[x.partner].id;
      t_.f2v_.resize_row(x.id.raw(), x.size);
    } else {
      x.id = t_.faces_.add();
      t_.facet_adjacency_.add_facet();
      t_.f2v_.stage_row(nullptr, x.size);
      t_.f2v_.commit_row(x.size);
    }
    for (std::uint32_t i = 0; i < x.size; ++i) t_.f2v_.begin(x.id.raw())[i] = vert(x.corners[i]);
    x_.for_each_edge(x, [&](const detail::cavity_edge& e) { t_.e2f_.insert_sorted(e.id.raw(), x.id); });
  }
}

template<class Lists>
void basic_polyhedra_tables<Lists>::rewiring::replace_polys() {
  const auto set_length = [](auto& rows, poly_id p, std::size_t n) {
    if (p.raw() < rows.size()) return rows.resize_row(p.raw(), n);
    rows.stage_row(nullptr, n);
    rows.commit_row(n);
  };
  for (std::size_t k = 0; k < x_.num_new(); ++k) {
    const poly_id p = new_poly(k);
    const auto n = static_cast<std::uint32_t>(x_.num_faces_of(k));
    set_length(t_.p2v_, p, x_.num_verts_of(k));
    set_length(t_.p2e_, p, x_.num_edges_of(k));
    set_length(t_.outward_, p, n);
    if (k < c_.kept) t_.facet_adjacency_.resize_row(p, n);
    else t_.facet_adjacency_.add_poly(n);
    const unsigned* const v = x_.verts_of_new.begin() + x_.begin_of(x_.verts_end, k);
    const unsigned* const e = x_.edges_of_new.begin() + x_.begin_of(x_.edges_end, k);
    for (std::size_t i = 0; i < x_.num_verts_of(k); ++i) {
      t_.p2v_.begin(p.raw())[i] = vert(v[i]);
      t_.v2p_.push_reserved(vert(v[i]).raw(), p);
    }
    for (std::size_t i = 0; i < x_.num_edges_of(k); ++i) t_.p2e_.begin(p.raw())[i] = x_.edges[e[i]].id;
    for (std::uint32_t j = 0; j < n; ++j) {
      t_.outward_.begin(p.raw())[j] = x_.outward_of_new[x_.first_face(k) + j];
      t_.facet_adjacency_.attach(p, j, x_.faces[x_.faces_of_new[x_.first_face(k) + j]].id);
    }
  }
}

template<class Lists>
void basic_polyhedra_tables<Lists>::rewiring::refresh_marks() {
  for (std::size_t k = 0; k < x_.num_new(); ++k) t_.facet_adjacency_.refresh_marks(new_poly(k), scratch_);
  for (const face& x : x_.faces)
    if (x.new_polys > 0 && x.num_polys > x.old_polys)
      for (const poly_id p : t_.adj_f2p(x.id)) t_.facet_adjacency_.refresh_marks(p, scratch_);
  for (const poly_id p : of_lists_) t_.facet_adjacency_.refresh_marks(p, scratch_);
}

template<class Lists>
void basic_polyhedra_tables<Lists>::rewire(const detail::native_cavity& c, const detail::native_cavity_result& made,
                                           function_ref<void(const detail::index_bounds&)> grow,
                                           detail::edit_log* log) {
  rewiring r(*this, c);
  if (log) r.save(*log);
  r.reserve(grow);
  r.commit(made);
}

}  // namespace concino
