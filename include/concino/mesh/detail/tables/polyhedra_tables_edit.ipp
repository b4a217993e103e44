// Adds and removes elements of tables of polyhedra; see polyhedra_tables.hpp.
#pragma once

#include <concino/mesh/polyhedra_tables.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino {

template<class Lists>
vert_id basic_polyhedra_tables<Lists>::add_vert(function_ref<void(const detail::index_bounds&)> grow) {
  detail::reserve_lists_of_new_verts(incident_edges_, v2p_, 1, 0, 0);
  verts_.reserve(1);
  if (grow)
    grow(detail::index_bounds{verts_.bound() + 1, edges_.bound(), faces_.bound(), polys_.bound(), p2v_.num_values()});
  detail::add_lists_of_vert(incident_edges_, v2p_, 0, 0);
  return verts_.add();
}

template<class Lists>
void basic_polyhedra_tables<Lists>::save_around_face(detail::edit_log& log, id_span<vert_id> corners) const {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    log.save(of_incident_edges, incident_edges_, corners[i].raw());
    const edge_id e = edge_between(corners[i], corners[i + 1 == corners.size() ? 0 : i + 1]);
    if (!e.is_none()) log.save(of_edges, edges_, e.raw()), log.save(of_e2f, e2f_, e.raw());
  }
}

template<class Lists>
face_id basic_polyhedra_tables<Lists>::add_face(std::span<const vert_id> corners,
                                                function_ref<void(const detail::index_bounds&)> grow,
                                                detail::edit_log* log) {
  const face_id f{faces_.bound()};
  detail::check_new_verts({corners.data(), corners.data() + corners.size()}, verts_, "add_face: face", f.raw());
  if (log) save_around_face(*log, {corners.data(), corners.data() + corners.size()});
  const std::size_t n = corners.size();
  const vert_id* const c = f2v_.stage_row(corners.data(), n);  // corners may have been in a row that moved
  const auto next = [&](std::size_t i) { return c[i + 1 == n ? 0 : i + 1]; };
  bool last_is_new = edge_between(c[n - 1], c[0]).is_none();
  std::size_t more = 0;
  e2f_.make_editable();
  for (std::size_t i = 0; i < n; ++i) {
    const edge_id e = edge_between(c[i], next(i));
    if (!e.is_none()) e2f_.reserve_in_row(e.raw(), 1);
    detail::reserve_edges_at(incident_edges_, c[i], (e.is_none() ? 1u : 0u) + (last_is_new ? 1u : 0u));
    last_is_new = e.is_none();
    more += last_is_new;
  }
  e2f_.reserve_rows(more, more * faces_of_new_edge);
  e2v_.reserve_rows(more);
  edges_.reserve(more);
  faces_.reserve(1);
  facet_adjacency_.reserve_links(nullptr, 0, 1);
  if (grow)
    grow(detail::index_bounds{verts_.bound(), edges_.bound() + more, faces_.bound() + 1, polys_.bound(),
                              p2v_.num_values()});

  f2v_.commit_row(n);
  facet_adjacency_.add_facet();
  for (std::size_t i = 0; i < n; ++i) {
    edge_id e = edge_between(c[i], next(i));
    if (e.is_none()) {
      e = detail::add_edge(edges_, e2v_, incident_edges_, c[i], next(i));
      e2f_.add_row(&f, &f, faces_of_new_edge);
    }
    e2f_.push(e.raw(), f);
  }
  return faces_.add();
}

template<class Lists>
poly_id basic_polyhedra_tables<Lists>::add_poly(std::span<const face_id> list, std::span<const std::uint8_t> outward,
                                                function_ref<void(const detail::index_bounds&)> grow,
                                                detail::edit_log* log) {
  const poly_id p{polys_.bound()};
  const auto name = [&] { return core::joined({"add_poly: poly ", p.raw()}); };
  if (list.empty() || list.size() != outward.size())
    core::throw_joined<invalid_mesh>({name(), " needs at least one face and an outward flag for each"});
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (!faces_.contains(list[k]))
      core::throw_joined<invalid_mesh>({name(), " names face ", list[k].raw(), ", which is not a face of the mesh"});
    if (std::find(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(k), list[k]) !=
        list.begin() + static_cast<std::ptrdiff_t>(k))
      core::throw_joined<invalid_mesh>({name(), " has face ", list[k].raw(), " twice; its faces must differ"});
  }
  if (log)
    for (const face_id f : list) {
      facet_adjacency_.save_facet(*log, of_facets, f);
      for (const vert_id v : adj_f2v(f)) log->save(of_v2p, v2p_, v.raw());
    }
  const auto n = static_cast<std::uint32_t>(list.size());
  const face_id* const faces = facet_adjacency_.stage_poly(n, list.data());  // list may have been in a row that moved
  outward_.stage_row(outward.data(), n);
  std::vector<vert_id> corners;
  std::vector<edge_id> around;
  for (std::uint32_t k = 0; k < n; ++k) {
    for (const vert_id v : adj_f2v(faces[k]))
      if (std::find(corners.begin(), corners.end(), v) == corners.end()) corners.push_back(v);
    for (const edge_id e : adj_f2e(faces[k]))
      if (std::find(around.begin(), around.end(), e) == around.end()) around.push_back(e);
  }
  p2v_.stage_row(corners.data(), corners.size());
  p2e_.stage_row(around.data(), around.size());
  for (const vert_id v : corners) v2p_.reserve_in_row(v.raw(), 1);
  polys_.reserve(1);
  auto scratch = facet_adjacency_.reserve_links(faces, n, 0);
  if (grow)
    grow(detail::index_bounds{verts_.bound(), edges_.bound(), faces_.bound(), polys_.bound() + 1,
                              p2v_.num_values() + corners.size()});

  facet_adjacency_.commit_poly(n);
  outward_.commit_row(n);
  p2v_.commit_row(corners.size());
  p2e_.commit_row(around.size());
  for (std::uint32_t k = 0; k < n; ++k) facet_adjacency_.link(p.raw(), k, faces[k]);
  for (const vert_id v : corners) v2p_.push(v.raw(), p);
  facet_adjacency_.update_marks(p.raw(), std::move(scratch));
  return polys_.add();
}

template<class Lists>
void basic_polyhedra_tables<Lists>::reserve_removal(std::span<const poly_id>) {
  detail::make_vertex_incidence_growable(incident_edges_, v2p_);
  e2f_.make_editable();
  facet_adjacency_.reserve_removal();
  verts_.reserve_removal();
  edges_.reserve_removal();
  faces_.reserve_removal();
  polys_.reserve_removal();
}

template<class Lists>
void basic_polyhedra_tables<Lists>::remove_poly(poly_id p) {
  reserve_removal({&p, 1});
  facet_adjacency_.unlink(p.raw());
  for (const vert_id v : adj_p2v(p)) v2p_.remove(v.raw(), p);
  polys_.remove(p);
  for (const face_id f : facet_adjacency_.facets(p))
    if (!facet_adjacency_.is_owned(f)) remove_face(f);
}

template<class Lists>
void basic_polyhedra_tables<Lists>::remove_face(face_id f, detail::edit_log* log) {
  assert(!facet_adjacency_.is_owned(f));
  if (log) log->save(of_faces, faces_, f.raw()), save_around_face(*log, adj_f2v(f));
  reserve_removal({});
  const id_span<vert_id> corners = adj_f2v(f);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const edge_id e = edge_between(corners[i], corners[i + 1 == corners.size() ? 0 : i + 1]);
    e2f_.remove(e.raw(), f);
    if (adj_e2f(e).empty()) detail::remove_edge(edges_, e2v_, incident_edges_, e);
  }
  faces_.remove(f);
}

template<class Lists>
void basic_polyhedra_tables<Lists>::remove_vert(vert_id v) {
  assert(v2p_[v.raw()].empty());
  reserve_removal({});
  while (!adj_v2e(v).empty()) remove_face(adj_e2f(adj_v2e(v)[0])[0]);
  verts_.remove(v);
}

}  // namespace concino
