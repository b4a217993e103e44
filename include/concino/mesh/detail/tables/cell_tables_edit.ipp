// Adding and removing verts and polys of tables of tets and hexes; see cell_tables.hpp.
#pragma once

#include <concino/mesh/cell_tables.hpp>

namespace concino {

template<class Shape, class Lists>
vert_id cell_tables<Shape, Lists>::add_vert(function_ref<void(const detail::index_bounds&)> grow) {
  detail::reserve_lists_of_new_verts(incident_edges_, v2p_, 1, 0, 0);
  verts_.reserve(1);
  if (grow)
    grow(detail::index_bounds{verts_.bound() + 1, edges_.bound(), faces_.bound(), polys_.bound(), p2v_.num_values()});
  detail::add_lists_of_vert(incident_edges_, v2p_, 0, 0);
  return verts_.add();
}

template<class Shape, class Lists>
poly_id cell_tables<Shape, Lists>::add_poly(std::span<const vert_id> corners,
                                            function_ref<void(const detail::index_bounds&)> grow) {
  const poly_id p{polys_.bound()};
  if (corners.size() != Shape::verts)
    core::throw_joined<invalid_mesh>(
        {"add_poly: poly ", p.raw(), " has ", corners.size(), " verts; every poly of this mesh has ", Shape::verts});
  detail::check_new_verts({corners.data(), corners.data() + corners.size()}, verts_, "add_poly: poly", p.raw());
  vert_id c[Shape::verts];
  std::copy_n(corners.begin(), Shape::verts, c);
  edges_of_new_poly at = find_edges(c);
  edge_id* const e = at.edges;
  face_id* const f = facet_adjacency_.stage_poly(Shape::faces);
  std::uint32_t more_faces = 0;
  for (unsigned k = 0; k < Shape::faces; ++k) {
    f[k] = face_on(c, k);
    more_faces += f[k].is_none();
  }
  for (unsigned i = 0; i < Shape::verts; ++i) {
    detail::reserve_edges_at(incident_edges_, c[i], at.more_at[i]);
    v2p_.reserve_in_row(c[i].raw(), 1);
  }
  p2v_.reserve_rows(1);
  p2e_.reserve_rows(1);
  e2v_.reserve_rows(at.more);
  e2p_.reserve_back(at.more);
  reserve_poly_lists_at(at);
  edges_.reserve(at.more);
  faces_.reserve(more_faces);
  polys_.reserve(1);
  auto scratch = facet_adjacency_.reserve_links(f, Shape::faces, more_faces);
  if (grow)
    grow(detail::index_bounds{verts_.bound(), edges_.bound() + at.more, faces_.bound() + more_faces, polys_.bound() + 1,
                              p2v_.num_values() + Shape::verts});

  for (unsigned j = 0; j < Shape::edges; ++j)
    if (e[j].is_none()) {
      e[j] = detail::add_edge(edges_, e2v_, incident_edges_, c[Shape::edge_vert[j][0]], c[Shape::edge_vert[j][1]]);
      e2p_.push_back(p.raw());
    }
  p2v_.add_row(c, c + Shape::verts);
  p2e_.add_row(e, e + Shape::edges);
  facet_adjacency_.commit_poly(Shape::faces);
  for (unsigned k = 0; k < Shape::faces; ++k) {
    face_id face = f[k];
    if (face.is_none()) {
      face = faces_.add();
      facet_adjacency_.add_facet();
    }
    facet_adjacency_.link(p.raw(), k, face);
  }
  facet_adjacency_.update_marks(p.raw(), std::move(scratch));
  for (const vert_id v : c) v2p_.push(v.raw(), p);
  const poly_id added = polys_.add();
  for (unsigned j = 0; j < Shape::edges; ++j) update_fan(e[j], at.num_polys[j]);
  return added;
}

template<class Shape, class Lists>
auto cell_tables<Shape, Lists>::find_edges(const vert_id* corners) const -> edges_of_new_poly {
  edges_of_new_poly at;
  for (unsigned j = 0; j < Shape::edges; ++j) {
    const unsigned a = Shape::edge_vert[j][0], b = Shape::edge_vert[j][1];
    at.edges[j] = incident_edges_.edge_between(corners[a], corners[b]);
    at.num_polys[j] = 1;
    if (at.edges[j].is_none()) ++at.more, ++at.more_at[a], ++at.more_at[b];
    else at.num_polys[j] += count_polys(at.edges[j]);
  }
  return at;
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::reserve_poly_lists_at(const edges_of_new_poly& at) {
  std::uint32_t more = 0;
  std::size_t num_listed = 0;
  poly_lists_.make_editable();
  for (unsigned j = 0; j < Shape::edges; ++j) {
    if (at.edges[j].is_none()) continue;
    if (is_non_manifold(at.edges[j])) poly_lists_.reserve_in_row(poly_list_number(at.edges[j]), 1);
    else ++more, num_listed += at.num_polys[j];
  }
  if (more > 0) poly_lists_.reserve_rows(more, num_listed);
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::reserve_removal(std::span<const poly_id> removed) {
  detail::make_vertex_incidence_growable(incident_edges_, v2p_);
  poly_lists_.make_editable();
  facet_adjacency_.reserve_removal();
  verts_.reserve_removal();
  edges_.reserve_removal();
  faces_.reserve_removal();
  polys_.reserve_removal();
  std::size_t num_poly_lists = 0, num_listed = 0;
  for (const poly_id p : removed)
    for (const edge_id e : adj_p2e(p)) ++num_poly_lists, num_listed += count_polys(e) - 1;
  if (num_poly_lists > 0) poly_lists_.reserve_rows(num_poly_lists, num_listed);
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::remove_poly(poly_id p) {
  std::uint32_t left[Shape::edges];
  std::size_t num_listed = 0;
  for (unsigned j = 0; j < Shape::edges; ++j) num_listed += left[j] = count_polys(adj_p2e(p)[j]) - 1;
  reserve_removal({});
  poly_lists_.reserve_rows(Shape::edges, num_listed);
  facet_adjacency_.unlink(p.raw());
  for (const face_id f : facet_adjacency_.facets(p))
    if (!facet_adjacency_.is_owned(f)) faces_.remove(f);
  for (const vert_id v : adj_p2v(p)) v2p_.remove(v.raw(), p);
  polys_.remove(p);
  for (unsigned j = 0; j < Shape::edges; ++j) update_fan(adj_p2e(p)[j], left[j]);
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::remove_vert(vert_id v) {
  assert(v2p_[v.raw()].empty());
  verts_.reserve_removal();
  verts_.remove(v);
}

template<class Shape, class Lists>
face_id cell_tables<Shape, Lists>::face_on(std::span<const vert_id> corners, unsigned k) const {
  constexpr unsigned n = Shape::face_verts;
  const auto corner = [&](unsigned i) { return corners[Shape::face_vert[k][i % n]]; };
  for (const poly_id q : adj_v2p(corner(0)))
    for (unsigned j = 0; j < Shape::faces; ++j) {
      const auto other = [&](unsigned i) { return p2v_.begin(q.raw())[Shape::face_vert[j][i % n]]; };
      unsigned at = 0;
      while (at < n && other(at) != corner(0)) ++at;
      if (at == n) continue;
      bool along = true, against = true;
      for (unsigned i = 1; i < n; ++i) {
        along = along && corner(i) == other(at + i);
        against = against && corner(i) == other(at + n - i);
      }
      if (along || against) return adj_p2f(q)[j];
    }
  return {};
}

}  // namespace concino
