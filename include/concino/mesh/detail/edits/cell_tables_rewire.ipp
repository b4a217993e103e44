// Replaces a few polys of tables of tets or hexes by others; see cell_tables.hpp and concepts/editable.hpp. Like the
// other edits: first all memory is allocated, which changes no element, then the tables are changed, which cannot fail.
#pragma once

#include <concino/mesh/cell_tables.hpp>
#include <concino/mesh/detail/edits/cell_cavity.hpp>

namespace concino {

template<class Shape, class Lists>
class cell_tables<Shape, Lists>::rewiring {
  using face = typename detail::cell_cavity<Shape>::face;

  cell_tables& t_;
  detail::cell_cavity<Shape> x_;
  const detail::native_cavity& c_ = x_.c;
  const std::size_t first_vert_ = t_.verts_.bound(), first_poly_ = t_.polys_.bound();  // the first added ones
  core::small_array<edge_id, 80> edge_ids_;  // by number of an edge, which takes less memory than the edges
  core::small_array<face_id, 112> face_ids_;                                           // the same of faces
  core::small_array<poly_id, 8> of_lists_;  // polys in lists of faces of old polys

  vert_id vert(unsigned local) const {
    return local < x_.num_old_verts ? x_.verts[local] : vert_id{first_vert_ + (local - x_.num_old_verts)};
  }
  poly_id new_poly(std::size_t k) const { return k < c_.kept ? c_.polys[k] : poly_id{first_poly_ + (k - c_.kept)}; }
  void reserve_poly_lists();
  void change_polys_of_verts();
  void change_faces();
  void replace_polys();
  void attach(std::size_t k, unsigned j);
  void refresh_marks();
  void change_fans();

 public:
  rewiring(cell_tables& t, const detail::native_cavity& c) : t_(t), x_(t, c) {}
  void save(detail::edit_log& log) const;
  void reserve(function_ref<void(const detail::index_bounds&)> grow);
  void commit(const detail::native_cavity_result& made);
};

/// Saves all rows that reserve() and commit() may change. The arrays are numbered as for_each_array() visits them.
template<class Shape, class Lists>
void cell_tables<Shape, Lists>::rewiring::save(detail::edit_log& log) const {
  enum : std::uint32_t {
    of_verts,
    of_edges,
    of_faces,
    of_polys,
    of_p2v,
    of_p2e,
    of_e2v,
    of_e2p,
    of_poly_lists,
    of_incident_edges,
    of_v2p,
    of_facets
  };
  for (const vert_id x : c_.verts) {
    const std::size_t v = x.raw();
    log.save(of_verts, t_.verts_, v), log.save(of_incident_edges, t_.incident_edges_, v), log.save(of_v2p, t_.v2p_, v);
  }
  for (const detail::cavity_edge& x : x_.edges) {
    if (x.id.is_none()) continue;
    log.save(of_edges, t_.edges_, x.id.raw()), log.save(of_e2v, t_.e2v_, x.id.raw()),
        log.save(of_e2p, t_.e2p_, x.id.raw());
    if (t_.is_non_manifold(x.id)) log.save(of_poly_lists, t_.poly_lists_, t_.poly_list_number(x.id));
  }
  for (const face& x : x_.faces) {
    if (x.id.is_none()) continue;
    log.save(of_faces, t_.faces_, x.id.raw());
    t_.facet_adjacency_.save_facet(log, of_facets, x.id);
  }
  for (const poly_id p : c_.polys) {
    log.save(of_polys, t_.polys_, p.raw()), log.save(of_p2v, t_.p2v_, p.raw()), log.save(of_p2e, t_.p2e_, p.raw());
    t_.facet_adjacency_.save_poly(log, of_facets, p);
  }
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::rewiring::reserve(function_ref<void(const detail::index_bounds&)> grow) {
  detail::reuse_descriptors(x_.edges, x_.num_new_edges, x_.num_unused_edges);
  detail::reuse_descriptors(x_.faces, x_.num_new_faces, x_.num_unused_faces,
                            [this](const face& x, const face& y) { return x_.share_all_but_one(x, y); });
  edge_ids_.reserve(x_.edges.size()), face_ids_.reserve(x_.faces.size());
  const std::size_t more_edges = x_.num_new_edges - std::min(x_.num_new_edges, x_.num_unused_edges);
  const std::size_t more_faces = x_.num_new_faces - std::min(x_.num_new_faces, x_.num_unused_faces);
  detail::reserve_lists_of_verts(t_.incident_edges_, t_.v2p_, x_.changes, x_.num_old_verts,
                                 [this](unsigned v) { return vert(v); });
  reserve_poly_lists();
  t_.p2v_.reserve_rows(x_.num_added());
  t_.p2e_.reserve_rows(x_.num_added());
  t_.facet_adjacency_.reserve_polys(x_.num_added(), x_.num_added() * Shape::faces, more_faces);
  t_.e2v_.reserve_rows(more_edges);
  t_.e2p_.reserve_back(more_edges);
  t_.verts_.reserve_change(c_.removed, c_.points.size());
  t_.edges_.reserve_change(x_.num_unused_edges - std::min(x_.num_new_edges, x_.num_unused_edges), more_edges);
  t_.faces_.reserve_change(x_.num_unused_faces - std::min(x_.num_new_faces, x_.num_unused_faces), more_faces);
  t_.polys_.reserve_change(c_.polys.size() - c_.kept, x_.num_added());
  if (grow)
    grow({t_.verts_.bound() + c_.points.size(), t_.edges_.bound() + more_edges, t_.faces_.bound() + more_faces,
          t_.polys_.bound() + x_.num_added(), t_.p2v_.num_values() + x_.num_added() * Shape::verts});
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::rewiring::reserve_poly_lists() {
  std::size_t lists = 0, listed = 0;
  for (const face& x : x_.faces) {
    if (x.num_polys > 2 && x.old_polys > 0)
      for (const poly_id p : t_.adj_f2p(x.id)) of_lists_.push_back(p);
    if (x.num_polys - x.old_polys + x.new_polys > 2) ++lists, listed += x.num_polys + x.new_polys;
  }
  t_.facet_adjacency_.reserve_poly_lists(lists, listed);
  lists = listed = 0;
  t_.poly_lists_.make_editable();
  for (const detail::cavity_edge& x : x_.edges) {
    if (!x_.fans[x_.edges.number(x)].is_irregular || x.new_polys + x.num_polys == 0) continue;
    if (!x.id.is_none() && t_.is_non_manifold(x.id))
      t_.poly_lists_.reserve_in_row(t_.poly_list_number(x.id), x.new_polys);
    else ++lists, listed += x.new_polys + (x.id.is_none() ? 0 : t_.count_polys(x.id));
  }
  if (lists > 0) t_.poly_lists_.reserve_rows(lists, listed);
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::rewiring::commit(const detail::native_cavity_result& made) {
  for (unsigned v = x_.num_old_verts; v < x_.num_verts; ++v) {
    detail::add_lists_of_vert(t_.incident_edges_, t_.v2p_, x_.changes[v].edges_gained, x_.changes[v].polys_after);
    made.verts[v - x_.num_old_verts] = t_.verts_.add();
  }
  for (const poly_id p : c_.polys) t_.facet_adjacency_.detach(p);
  change_polys_of_verts();
  for (const detail::cavity_edge& x : x_.edges)
    if (x.is_unused() && t_.is_non_manifold(x.id)) t_.poly_lists_.clear_row(t_.poly_list_number(x.id));
  detail::change_edges(x_.edges, t_.edges_, t_.e2v_, t_.incident_edges_, [this](unsigned v) { return vert(v); });
  for (const detail::cavity_edge& x : x_.edges) edge_ids_.push_back(x.id);
  t_.e2p_.resize(t_.edges_.bound());
  change_faces();
  replace_polys();
  change_fans();
  refresh_marks();
  for (std::size_t k = c_.kept; k < c_.polys.size(); ++k) t_.polys_.remove(c_.polys[k]);
  for (std::size_t k = c_.kept; k < x_.num_new(); ++k) t_.polys_.add();
  for (std::size_t k = 0; k < x_.num_new(); ++k) made.polys[k] = new_poly(k);
  for (std::size_t v = c_.verts.size() - c_.removed; v < c_.verts.size(); ++v) t_.verts_.remove(c_.verts[v]);
}

/// A vert that a kept poly has before and after keeps it in its list. All removals come first: memory is reserved for
/// the lists as they will be.
template<class Shape, class Lists>
void cell_tables<Shape, Lists>::rewiring::change_polys_of_verts() {
  // `others`: the corners of all polys at the other time
  const auto keeps = [this](std::size_t k, unsigned local, const unsigned* others) {
    if (k >= c_.kept) return false;
    bool has = false;
    for (unsigned i = 0; i < Shape::verts; ++i) has |= others[k * Shape::verts + i] == local;
    return has;
  };
  for (std::size_t k = 0; k < c_.polys.size(); ++k)
    for (unsigned i = 0; i < Shape::verts; ++i)
      if (const unsigned v = x_.corners_of_old[k * Shape::verts + i]; !keeps(k, v, c_.corners.begin())) {
        const std::size_t row = x_.verts[v].raw();
        t_.v2p_.remove_at(row, t_.v2p_.find_in_row(row, c_.polys[k]));
      }
  for (std::size_t k = 0; k < x_.num_new(); ++k)
    for (unsigned i = 0; i < Shape::verts; ++i)
      if (const unsigned v = x_.corners(k)[i]; !keeps(k, v, x_.corners_of_old.begin()))
        t_.v2p_.push_reserved(vert(v).raw(), new_poly(k));
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::rewiring::change_faces() {
  for (face& x : x_.faces) {
    if (x.is_unused() && !x.has_partner()) t_.faces_.remove(x.id);
    if (x.id.is_none()) {
      if (x.has_partner()) {
        x.id = x_.faces[x.partner].id;
      } else {
        x.id = t_.faces_.add();
        t_.facet_adjacency_.add_facet();
      }
    }
    face_ids_.push_back(x.id);
  }
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::rewiring::replace_polys() {
  t_.p2v_.commit_rows(x_.num_added());
  t_.p2e_.commit_rows(x_.num_added());
  t_.facet_adjacency_.add_polys(x_.num_added());
  for (std::size_t k = 0; k < x_.num_new(); ++k) {
    const poly_id p = new_poly(k);
    for (unsigned i = 0; i < Shape::verts; ++i) t_.p2v_.begin(p.raw())[i] = vert(x_.corners(k)[i]);
    for (unsigned j = 0; j < Shape::edges; ++j) t_.p2e_.begin(p.raw())[j] = edge_ids_[x_.edges_of_new(k)[j]];
    for (unsigned j = 0; j < Shape::faces; ++j) attach(k, j);
  }
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::rewiring::attach(std::size_t k, unsigned j) {
  const auto use = static_cast<std::uint32_t>(k * Shape::faces + j), mate = x_.mate(use);
  const face_id f = face_ids_[x_.faces_of_new(k)[j]];
  if (mate == x_.has_others) return t_.facet_adjacency_.attach(new_poly(k), j, f);
  t_.facet_adjacency_.attach_between(new_poly(k), j, f, mate == x_.no_mate ? poly_id{} : new_poly(mate / Shape::faces),
                                     use < mate);
}

/// Sets where walks around edges start, and checks the edges whose polys may not be one fan.
template<class Shape, class Lists>
void cell_tables<Shape, Lists>::rewiring::change_fans() {
  for (const detail::cavity_edge& x : x_.edges) {
    const detail::fan_change& fan = x_.fans[x_.edges.number(x)];
    if (x.num_polys - x.old_polys + x.new_polys == 0) continue;
    const bool is_new = x.num_polys == 0;
    if (is_new || (!fan.is_irregular && fan.starts_at_old))
      t_.e2p_[x.id.raw()] = new_poly(x.first_new / Shape::edges).raw();
    if (fan.is_irregular) t_.update_fan(x.id, t_.count_polys(x.id));
  }
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::rewiring::refresh_marks() {
  detail::facet_adjacency<face_id, Shape::faces>& all = t_.facet_adjacency_;
  core::small_array<std::uint64_t, 1> scratch;
  for (std::size_t k = 0; k < x_.num_new(); ++k) all.refresh_marks(new_poly(k), scratch);
  for (const face& x : x_.faces)
    if (x.new_polys > 0 && x.num_polys > x.old_polys)
      for (const poly_id p : t_.adj_f2p(x.id))
        if (p != new_poly(x.new_uses[0] / Shape::faces)) all.refresh_marks(p, scratch);
  for (const poly_id p : of_lists_) all.refresh_marks(p, scratch);
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::rewire(const detail::native_cavity& c, const detail::native_cavity_result& made,
                                       function_ref<void(const detail::index_bounds&)> grow, detail::edit_log* log) {
  rewiring r(*this, c);
  if (log) r.save(*log);
  r.reserve(grow);
  r.commit(made);
}

}  // namespace concino
