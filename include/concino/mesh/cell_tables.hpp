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
#include <concino/mesh/detail/tables/cell_adjacency.hpp>
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
class cell_tables : public detail::cell_adjacency<Shape, Lists> {
  template<class, class> friend class cell_tables;
  friend class detail::cell_cavity<Shape>;
  using base = detail::cell_adjacency<Shape, Lists>;
  template<class T> using jagged = detail::jagged_array<T, 0>;
  using base::shape, base::verts_, base::edges_, base::faces_, base::polys_, base::p2v_, base::p2e_,
      base::facet_adjacency_, base::e2v_, base::e2p_, base::poly_lists_, base::incident_edges_, base::v2p_;
  using base::poly_list_number;

 public:
  static constexpr unsigned arity = Shape::verts;
  using base::verts, base::edges, base::faces, base::polys;
  using base::adj_e2f, base::adj_e2p, base::adj_e2v, base::adj_f2e, base::adj_f2p, base::adj_f2v, base::adj_p2e,
      base::adj_p2f, base::adj_p2v, base::adj_v2e, base::adj_v2f, base::adj_v2p, base::adj_v2v;
  using base::faces_at, base::first_poly, base::is_non_manifold, base::neighbour_at_face, base::poly_list;

  cell_tables() = default;
  cell_tables(const cell_tables&) = default;
  cell_tables(cell_tables&&) noexcept = default;
  cell_tables& operator=(const cell_tables& o) { return *this = cell_tables(o); }  // strong exception guarantee
  cell_tables& operator=(cell_tables&&) noexcept = default;

  /// From the verts of every poly in the standard order. Linear time and memory.
  /// Errors: invalid_mesh that names the poly with a bad or a repeated vert.
  cell_tables(std::size_t vert_count, std::vector<vert_id> poly_verts)
      : base(detail::checked_lists<Shape::verts>(std::move(poly_verts), "cell_tables: poly")) {
    detail::check_counts("cell_tables", vert_count, p2v_.size(), p2v_.num_values());
    build(vert_count);
  }
  /// From lists in another corner order: a tet_order or hex_order.
  template<class Order>
    requires(detail::corners_in(Order{}) == Shape::verts)
  cell_tables(std::size_t vert_count, std::vector<vert_id> poly_verts, Order order)
      : cell_tables(vert_count, detail::to_standard_order(std::move(poly_verts), order)) {}
  /// From lists stored elsewhere, and from tables that were built from a copy of these lists.
  cell_tables(cell_tables<Shape>&& built,
              Lists elsewhere) requires(!std::same_as<Lists, detail::jagged_array<vert_id, Shape::verts>>)
      : base(static_cast<detail::cell_adjacency<Shape, detail::jagged_array<vert_id, Shape::verts>>&&>(built),
             std::move(elsewhere)) {}

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
