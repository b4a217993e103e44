// All adjacencies of a mesh of tetrahedra or of hexahedra in flat arrays, built in linear time from the verts of each
// cell. The tables store what graph algorithms traverse and what cannot be derived. They derive on the fly: verts,
// edges and polys of a face (from the poly that owns it), polys and faces around an edge (by steps from poly to poly),
// faces at a vert.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/function_ref.hpp>
#include <concino/core/message.hpp>
#include <concino/mesh/corner_orders.hpp>
#include <concino/mesh/detail/edits/cavity_input.hpp>
#include <concino/mesh/detail/edits/edit_log.hpp>
#include <concino/mesh/detail/tables/cell_ranges.hpp>
#include <concino/mesh/detail/tables/checks.hpp>
#include <concino/mesh/detail/tables/vertex_incidence.hpp>

namespace concino {

namespace detail {
template<class Shape> class cell_cavity;
}

/// Lists: where the verts of polys are stored, either in rows of these tables, which can be edited, or in an array of
/// the user.
template<class Shape, class Lists = detail::jagged_array<vert_id, Shape::verts>>
class cell_tables {
  template<class, class> friend class cell_tables;
  friend class detail::cell_cavity<Shape>;
  template<class T> using jagged = detail::jagged_array<T, 0>;
  static constexpr const auto& shape = detail::shape_v<Shape>;

  detail::alive_elements<vert_id> verts_;
  detail::alive_elements<edge_id> edges_;
  detail::alive_elements<face_id> faces_;
  detail::alive_elements<poly_id> polys_;
  Lists p2v_;
  detail::jagged_array<edge_id, Shape::edges> p2e_;
  detail::facet_adjacency<face_id, Shape::faces> facet_adjacency_;
  detail::jagged_array<vert_id, 2> e2v_;
  core::flat_array<std::uint32_t> e2p_;  // one poly at the edge, or `special` and the number of its list in poly_lists_
  jagged<poly_id> poly_lists_;
  detail::incident_edges incident_edges_;
  jagged<poly_id> v2p_;

 public:
  static constexpr unsigned arity = Shape::verts;

  cell_tables() = default;
  cell_tables(const cell_tables&) = default;
  cell_tables(cell_tables&&) noexcept = default;
  cell_tables& operator=(const cell_tables& o) { return *this = cell_tables(o); }  // strong exception guarantee
  cell_tables& operator=(cell_tables&&) noexcept = default;

  /// From the verts of every poly in the standard order. Linear time and memory.
  /// Errors: invalid_mesh that names the poly with a bad or a repeated vert.
  cell_tables(std::size_t vert_count, std::vector<vert_id> polys)
      : p2v_(detail::checked_lists<Shape::verts>(std::move(polys), "cell_tables: poly")) {
    detail::check_counts("cell_tables", vert_count, p2v_.size(), p2v_.num_values());
    build(vert_count);
  }
  /// From lists in another corner order: a tet_order or hex_order.
  template<class Order>
    requires(detail::corners_in(Order{}) == Shape::verts)
  cell_tables(std::size_t vert_count, std::vector<vert_id> polys, Order order)
      : cell_tables(vert_count, detail::to_standard_order(std::move(polys), order)) {}
  /// From lists stored elsewhere, and from tables that were built from a copy of these lists.
  cell_tables(cell_tables<Shape>&& built,
              Lists elsewhere) requires(!std::same_as<Lists, detail::jagged_array<vert_id, Shape::verts>>)
      : verts_(std::move(built.verts_)), edges_(std::move(built.edges_)), faces_(std::move(built.faces_)),
        polys_(std::move(built.polys_)), p2v_(std::move(elsewhere)), p2e_(std::move(built.p2e_)),
        facet_adjacency_(std::move(built.facet_adjacency_)), e2v_(std::move(built.e2v_)), e2p_(std::move(built.e2p_)),
        poly_lists_(std::move(built.poly_lists_)), incident_edges_(std::move(built.incident_edges_)),
        v2p_(std::move(built.v2p_)) {}

  const detail::alive_elements<vert_id>& verts() const { return verts_; }
  const detail::alive_elements<edge_id>& edges() const { return edges_; }
  const detail::alive_elements<face_id>& faces() const { return faces_; }
  const detail::alive_elements<poly_id>& polys() const { return polys_; }

  id_span<vert_id> adj_v2v(vert_id v) const { return incident_edges_.verts(v); }
  id_span<edge_id> adj_v2e(vert_id v) const { return incident_edges_.edges(v); }
  auto adj_v2f(vert_id v) const {
    return detail::owned_faces<cell_tables, id_span<poly_id>, detail::faces_at_vert,
                               detail::shape_tables<Shape>::valence>(this, adj_v2p(v), {v});
  }
  id_span<poly_id> adj_v2p(vert_id v) const { return v2p_[v.raw()]; }
  id_span<vert_id> adj_e2v(edge_id e) const { return e2v_[e.raw()]; }
  auto adj_e2f(edge_id e) const {
    return detail::owned_faces<cell_tables, detail::polys_around_edge<cell_tables>, detail::faces_at_edge, 2>(
        this, adj_e2p(e), {e});
  }
  detail::polys_around_edge<cell_tables> adj_e2p(edge_id e) const { return {this, e}; }
  detail::inline_array<vert_id, Shape::face_verts> adj_f2v(face_id f) const {
    const auto [p, k] = facet_adjacency_.owner(f);
    const auto v = p2v_[p];
    detail::inline_array<vert_id, Shape::face_verts> all;
    for (unsigned i = 0; i < Shape::face_verts; ++i) all[i] = v[Shape::face_vert[k][i]];
    return all;
  }
  detail::inline_array<edge_id, Shape::face_verts> adj_f2e(face_id f) const {
    const auto [p, k] = facet_adjacency_.owner(f);
    const edge_id* const e = p2e_.begin(p);
    detail::inline_array<edge_id, Shape::face_verts> all;
    for (unsigned i = 0; i < Shape::face_verts; ++i) all[i] = e[shape.face_edge[k][i]];
    return all;
  }
  detail::polys_of_facet adj_f2p(face_id f) const { return facet_adjacency_.polys_of(f); }
  auto adj_p2v(poly_id p) const { return p2v_[p.raw()]; }
  id_span<edge_id> adj_p2e(poly_id p) const { return p2e_[p.raw()]; }
  id_span<face_id> adj_p2f(poly_id p) const { return facet_adjacency_.facets(p); }
  detail::adjacent_polys adj_p2p(poly_id p) const { return facet_adjacency_.polys(p); }

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

  // Edits have the strong exception guarantee: they allocate all memory first, which changes no element, and cannot
  // fail afterwards. Before the change they call `grow` with the index bounds after the edit; `grow` may throw too.

  /// Adds a vert without edges.
  vert_id add_vert(function_ref<void(const detail::index_bounds&)> grow = {});

  /// Adds a poly on existing verts, in the standard order. Cost: the edges and polys at its verts.
  /// Errors: invalid_mesh as in the constructor; the tables are unchanged then.
  poly_id add_poly(std::span<const vert_id> corners, function_ref<void(const detail::index_bounds&)> grow = {});

  /// Replaces a few polys by others, as concepts/editable.hpp says. Cost: the old and new polys, and the edges and
  /// polys at their verts.
  /// Errors: invalid_mesh if the cavity lists elements that do not exist, lists some twice or lacks a vert of an old
  ///         poly; if the constructor would refuse a new poly; if it removes a vert that keeps a poly. The tables are
  ///         unchanged then.
  void rewire(const detail::native_cavity& c, const detail::native_cavity_result& made,
              function_ref<void(const detail::index_bounds&)> grow = {}, detail::edit_log* log = nullptr);

  /// Calls f for every array of the tables, for undoing edits.
  template<class F>
  void for_each_array(const F& f) {
    f(verts_), f(edges_), f(faces_), f(polys_), f(p2v_), f(p2e_), f(e2v_), f(e2p_), f(poly_lists_), f(incident_edges_),
        f(v2p_);
    facet_adjacency_.for_each_array(f);
  }
  static constexpr std::uint32_t num_arrays = 11 + detail::facet_adjacency<face_id, Shape::faces>::num_arrays;

  /// Allocates the memory for the removal of these polys and of verts without polys. These removals cannot fail
  /// afterwards.
  void reserve_removal(std::span<const poly_id> polys);

  /// Removes p and the faces and edges that no other poly has; verts stay. The ids of other elements do not change.
  void remove_poly(poly_id p);

  /// Removes a vert that has no polys.
  void remove_vert(vert_id v);

  /// These tables without gaps, as packed as new ones. Elements and the entries of all lists keep their order.
  cell_tables compacted(const detail::compaction& kept) const;

  // Used by the ranges of cell_ranges.hpp.
  poly_id neighbour_at_face(poly_id p, std::uint32_t k) const {
    const detail::encoded_neighbour x = facet_adjacency_.neighbours_of(p)[k];
    return x.is_none() || x.is_non_manifold() ? poly_id{} : poly_id{x.poly()};
  }
  poly_id first_poly(edge_id e) const { return poly_id{e2p_[e.raw()]}; }
  bool is_non_manifold(edge_id e) const { return e2p_[e.raw()] & detail::encoded_neighbour::special; }
  id_span<poly_id> poly_list(edge_id e) const { return poly_lists_[poly_list_number(e)]; }
  bool owns(poly_id p, std::uint32_t k) const {
    const auto s = facet_adjacency_.owner(facet_adjacency_.facets(p)[k]);
    return s.poly == p.raw() && s.k == k;
  }
  detail::inline_array<std::uint8_t, 2> faces_at(poly_id p, edge_id e) const {
    const edge_id* const all = p2e_.begin(p.raw());
    unsigned i = 0;
    while (i + 1 < Shape::edges && all[i] != e) ++i;
    detail::inline_array<std::uint8_t, 2> two;
    two[0] = shape.edge_face[i][0];
    two[1] = shape.edge_face[i][1];
    return two;
  }
  detail::inline_array<std::uint8_t, detail::shape_tables<Shape>::valence> faces_at(poly_id p, vert_id v) const {
    const auto all = p2v_[p.raw()];
    unsigned i = 0;
    while (i + 1 < Shape::verts && all[i] != v) ++i;
    detail::inline_array<std::uint8_t, detail::shape_tables<Shape>::valence> faces;
    for (unsigned k = 0; k < faces.size(); ++k) faces[k] = shape.vert_face[i][k];
    return faces;
  }

 private:
  class rewiring;

  /// The edges of a poly that will be added.
  struct edges_of_new_poly {
    edge_id edges[Shape::edges];             // none where the edge does not exist yet
    std::uint32_t num_polys[Shape::edges];   // at the edge, including the new one
    std::uint32_t more = 0;                  // number of new edges
    std::uint32_t more_at[Shape::verts] = {};  // number of new edges at each vert
  };
  edges_of_new_poly find_edges(const vert_id* corners) const;

  /// Allocates memory for the new poly in the poly lists of edges, and for the poly lists of edges that may need one.
  void reserve_poly_lists_at(const edges_of_new_poly& at);

  /// The face that would be facet k of a poly with these corners; none if it does not exist yet.
  face_id face_on(std::span<const vert_id> corners, unsigned k) const;

  std::size_t poly_list_number(edge_id e) const { return e2p_[e.raw()] & ~detail::encoded_neighbour::special; }

  /// Calls f(p) for every poly at e, in the order of adj_v2p of the first vert of e.
  template<class F>
  void for_each_poly_at(edge_id e, const F& f) const {
    for (const poly_id p : adj_v2p(adj_e2v(e)[0]))
      for (const edge_id other : adj_p2e(p))
        if (other == e) f(p);
  }
  std::uint32_t count_polys(edge_id e) const;

  /// Updates e after polys at it were added or removed, so that n polys remain: sets the start of the walk around e, or
  /// its poly list, or removes e. Needs memory in the poly list of e, or for a new list if n > 1.
  void update_fan(edge_id e, std::uint32_t n);

  static constexpr unsigned valence = detail::shape_tables<Shape>::valence;

  /// Builds all tables from the verts of polys.
  class builder;
  void build(std::size_t vert_count);

  /// Whether the walk around e returns to the first poly before it has met all n polys. Two polys are assumed to share
  /// at most one face at e: then no closed walk has fewer than 3 steps, and the last steps are not needed. The answer
  /// is no if the walk ends at the boundary.
  bool closes_early(edge_id e, std::uint32_t n) const;

  /// Marks e for a poly list unless the walk around it meets `uses` polys.
  void check_fan(edge_id e, std::uint32_t uses);

  /// Makes the poly lists of the marked edges.
  void list_polys_of_edges();
};

using tet_tables = cell_tables<detail::tet_shape>;
using hex_tables = cell_tables<detail::hex_shape>;

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/edits/cell_tables_rewire.ipp>
#include <concino/mesh/detail/tables/cell_tables_build.ipp>
#include <concino/mesh/detail/tables/cell_tables_compact.ipp>
#include <concino/mesh/detail/tables/cell_tables_edit.ipp>
#include <concino/mesh/detail/tables/cell_tables_fans.ipp>
#endif
