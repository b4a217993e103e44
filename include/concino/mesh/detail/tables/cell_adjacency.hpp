// All adjacencies of a mesh of tets or hexes, as they are read: what is stored, and what is derived from it.
#pragma once

#include <concino/mesh/detail/tables/cell_ranges.hpp>
#include <concino/mesh/detail/tables/vertex_incidence.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace concino::detail {

/// Lists: where the verts of polys are stored, either in rows of these tables, which can be edited, or in an array of
/// the user.
template<class Shape, class Lists>
class cell_adjacency {
  template<class, class> friend class cell_adjacency;

 protected:
  static constexpr const auto& shape = shape_v<Shape>;

  alive_elements<vert_id> verts_;
  alive_elements<edge_id> edges_;
  alive_elements<face_id> faces_;
  alive_elements<poly_id> polys_;
  Lists p2v_;
  jagged_array<edge_id, Shape::edges> p2e_;
  facet_adjacency<face_id, Shape::faces> facet_adjacency_;
  jagged_array<vert_id, 2> e2v_;
  core::flat_array<std::uint32_t> e2p_;  // one poly at the edge, or `special` and the number of its list in poly_lists_
  jagged_array<poly_id, 0> poly_lists_;
  incident_edges incident_edges_;
  jagged_array<poly_id, 0> v2p_;

  cell_adjacency() = default;
  explicit cell_adjacency(Lists polys) : p2v_(std::move(polys)) {}
  /// From tables that were built from a copy of lists that are stored elsewhere.
  template<class Built>
  cell_adjacency(cell_adjacency<Shape, Built>&& built, Lists elsewhere)
      : verts_(std::move(built.verts_)), edges_(std::move(built.edges_)), faces_(std::move(built.faces_)),
        polys_(std::move(built.polys_)), p2v_(std::move(elsewhere)), p2e_(std::move(built.p2e_)),
        facet_adjacency_(std::move(built.facet_adjacency_)), e2v_(std::move(built.e2v_)), e2p_(std::move(built.e2p_)),
        poly_lists_(std::move(built.poly_lists_)), incident_edges_(std::move(built.incident_edges_)),
        v2p_(std::move(built.v2p_)) {}

  std::size_t poly_list_number(edge_id e) const { return e2p_[e.raw()] & ~encoded_neighbour::special; }

 public:
  const alive_elements<vert_id>& verts() const { return verts_; }
  const alive_elements<edge_id>& edges() const { return edges_; }
  const alive_elements<face_id>& faces() const { return faces_; }
  const alive_elements<poly_id>& polys() const { return polys_; }

  id_span<vert_id> adj_v2v(vert_id v) const { return incident_edges_.verts(v); }
  id_span<edge_id> adj_v2e(vert_id v) const { return incident_edges_.edges(v); }
  auto adj_v2f(vert_id v) const {
    return owned_faces<cell_adjacency, id_span<poly_id>, faces_at_vert,
                               shape_tables<Shape>::valence>(this, adj_v2p(v), {v});
  }
  id_span<poly_id> adj_v2p(vert_id v) const { return v2p_[v.raw()]; }
  id_span<vert_id> adj_e2v(edge_id e) const { return e2v_[e.raw()]; }
  auto adj_e2f(edge_id e) const {
    return owned_faces<cell_adjacency, polys_around_edge<cell_adjacency>, faces_at_edge, 2>(
        this, adj_e2p(e), {e});
  }
  polys_around_edge<cell_adjacency> adj_e2p(edge_id e) const { return {this, e}; }
  inline_array<vert_id, Shape::face_verts> adj_f2v(face_id f) const {
    const auto [p, k] = facet_adjacency_.owner(f);
    const auto v = p2v_[p];
    inline_array<vert_id, Shape::face_verts> all;
    for (unsigned i = 0; i < Shape::face_verts; ++i) all[i] = v[Shape::face_vert[k][i]];
    return all;
  }
  inline_array<edge_id, Shape::face_verts> adj_f2e(face_id f) const {
    const auto [p, k] = facet_adjacency_.owner(f);
    const edge_id* const e = p2e_.begin(p);
    inline_array<edge_id, Shape::face_verts> all;
    for (unsigned i = 0; i < Shape::face_verts; ++i) all[i] = e[shape.face_edge[k][i]];
    return all;
  }
  polys_of_facet adj_f2p(face_id f) const { return facet_adjacency_.polys_of(f); }
  auto adj_p2v(poly_id p) const { return p2v_[p.raw()]; }
  id_span<edge_id> adj_p2e(poly_id p) const { return p2e_[p.raw()]; }
  id_span<face_id> adj_p2f(poly_id p) const { return facet_adjacency_.facets(p); }
  adjacent_polys adj_p2p(poly_id p) const { return facet_adjacency_.polys(p); }

  /// The number of the first corner of p; the other corners of p follow. All corner numbers are below corner_bound().
  /// Edits do not change them.
  std::size_t first_corner(poly_id p) const { return p2v_.first(p.raw()); }
  std::size_t corner_bound() const { return p2v_.num_values(); }

  /// Whether the verts of f run counter-clockwise seen from outside p. This holds for the owner of f; for another poly
  /// the orders are compared.
  bool face_is_outward(poly_id p, face_id f) const {
    if (facet_adjacency_.owner(f).poly == p.raw()) return true;
    const auto verts = adj_f2v(f);
    const id_span<face_id> faces = adj_p2f(p);
    for (unsigned k = 0; k < Shape::faces; ++k) {
      if (faces[k] != f) continue;
      const auto v = p2v_[p.raw()];
      for (unsigned i = 0; i < Shape::face_verts; ++i)
        if (v[Shape::face_vert[k][i]] == verts[0])
          return v[Shape::face_vert[k][(i + 1) % Shape::face_verts]] == verts[1];
    }
    return false;
  }

  // Used by the ranges of cell_ranges.hpp.
  poly_id neighbour_at_face(poly_id p, std::uint32_t k) const {
    const encoded_neighbour x = facet_adjacency_.neighbours_of(p)[k];
    return x.is_none() || x.is_non_manifold() ? poly_id{} : poly_id{x.poly()};
  }
  poly_id first_poly(edge_id e) const { return poly_id{e2p_[e.raw()]}; }
  bool is_non_manifold(edge_id e) const { return e2p_[e.raw()] & encoded_neighbour::special; }
  id_span<poly_id> poly_list(edge_id e) const { return poly_lists_[poly_list_number(e)]; }
  bool owns(poly_id p, std::uint32_t k) const {
    const auto s = facet_adjacency_.owner(facet_adjacency_.facets(p)[k]);
    return s.poly == p.raw() && s.k == k;
  }
  inline_array<std::uint8_t, 2> faces_at(poly_id p, edge_id e) const {
    const edge_id* const all = p2e_.begin(p.raw());
    unsigned i = 0;
    while (i + 1 < Shape::edges && all[i] != e) ++i;
    inline_array<std::uint8_t, 2> two;
    two[0] = shape.edge_face[i][0];
    two[1] = shape.edge_face[i][1];
    return two;
  }
  inline_array<std::uint8_t, shape_tables<Shape>::valence> faces_at(poly_id p, vert_id v) const {
    const auto all = p2v_[p.raw()];
    unsigned i = 0;
    while (i + 1 < Shape::verts && all[i] != v) ++i;
    inline_array<std::uint8_t, shape_tables<Shape>::valence> faces;
    for (unsigned k = 0; k < faces.size(); ++k) faces[k] = shape.vert_face[i][k];
    return faces;
  }
};

}  // namespace concino::detail
