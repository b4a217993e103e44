// All adjacencies of a surface in flat arrays, built from lists of verts in linear time. The native surfaces consist of
// these tables, and any mesh with only face-vertex lists can store them beside it (see indexed_base.hpp).
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/function_ref.hpp>
#include <concino/core/message.hpp>
#include <concino/mesh/detail/edits/cavity_input.hpp>
#include <concino/mesh/detail/edits/edit_log.hpp>
#include <concino/mesh/detail/rows/alive_elements.hpp>
#include <concino/mesh/detail/tables/checks.hpp>
#include <concino/mesh/detail/facets/facet_adjacency.hpp>
#include <concino/mesh/detail/tables/vertex_incidence.hpp>

namespace concino {

namespace detail {
template<unsigned Arity> class surface_cavity;
}

/// Arity: the number of verts of every polygon, or 0 if polygons differ. Lists: where the verts of polygons are stored,
/// either in rows of these tables, which can be edited, or in an array of the user.
template<unsigned Arity, class Lists = detail::jagged_array<vert_id, Arity>>
class surface_tables {
  template<unsigned, class> friend class surface_tables;
  friend class detail::surface_cavity<Arity>;
  template<class T> using per_poly = detail::jagged_array<T, Arity>;
  template<class T> using jagged = detail::jagged_array<T, 0>;

  detail::alive_elements<vert_id> verts_;
  detail::alive_elements<edge_id> edges_;
  detail::alive_elements<poly_id> polys_;
  Lists p2v_;
  detail::facet_adjacency<edge_id, Arity> facet_adjacency_;
  detail::jagged_array<vert_id, 2> e2v_;
  detail::incident_edges_and_polys incident_;  // to verts

 public:
  static constexpr unsigned arity = Arity;

  surface_tables() = default;
  surface_tables(const surface_tables&) = default;
  surface_tables(surface_tables&&) noexcept = default;
  // strong exception guarantee
  surface_tables& operator=(const surface_tables& o) { return *this = surface_tables(o); }
  surface_tables& operator=(surface_tables&&) noexcept = default;

  /// From the verts of every polygon, in cyclic order. Linear time and memory.
  /// Errors: invalid_mesh that names the polygon with a bad vert, a repeated vert or fewer than 3.
  surface_tables(std::size_t vert_count, std::vector<vert_id> polys)
    requires(Arity > 0)
      : p2v_(detail::checked_lists<Arity>(std::move(polys), "surface_tables: poly")) {
    check(vert_count);
    build(vert_count);
  }
  /// From polygons of any size: poly p's verts are verts[first[p]] .. verts[first[p+1]-1].
  surface_tables(std::size_t vert_count, std::vector<std::uint32_t> first, std::vector<vert_id> verts)
    requires(Arity == 0)
      : p2v_(detail::checked_lists(std::move(first), std::move(verts), "surface_tables: poly")) {
    check(vert_count);
    build(vert_count);
  }
  /// From lists stored elsewhere, and from tables that were built from a copy of these lists.
  surface_tables(surface_tables<Arity>&& built, Lists elsewhere) requires(!std::same_as<Lists, per_poly<vert_id>>)
      : verts_(std::move(built.verts_)), edges_(std::move(built.edges_)), polys_(std::move(built.polys_)),
        p2v_(std::move(elsewhere)), facet_adjacency_(std::move(built.facet_adjacency_)), e2v_(std::move(built.e2v_)),
        incident_(std::move(built.incident_)) {
    if constexpr (Arity == 0) p2v_.share_offsets(built.p2v_);
  }

  const detail::alive_elements<vert_id>& verts() const { return verts_; }
  const detail::alive_elements<edge_id>& edges() const { return edges_; }
  const detail::alive_elements<poly_id>& polys() const { return polys_; }

  id_span<vert_id> adj_v2v(vert_id v) const { return incident_.verts(v); }
  id_span<edge_id> adj_v2e(vert_id v) const { return incident_.edges(v); }
  id_span<poly_id> adj_v2p(vert_id v) const { return incident_.polys(v); }
  id_span<vert_id> adj_e2v(edge_id e) const { return e2v_[e.raw()]; }
  detail::polys_of_facet adj_e2p(edge_id e) const { return facet_adjacency_.polys_of(e); }
  auto adj_p2v(poly_id p) const { return p2v_[p.raw()]; }
  id_span<edge_id> adj_p2e(poly_id p) const { return facet_adjacency_.facets(p); }
  detail::adjacent_polys adj_p2p(poly_id p) const { return facet_adjacency_.polys(p); }

  /// The number of the first corner of p; the other corners of p follow. All corner numbers are below corner_bound().
  /// Edits do not change them.
  std::size_t first_corner(poly_id p) const { return p2v_.first(p.raw()); }
  std::size_t corner_bound() const { return p2v_.num_values(); }

  // Edits have the strong exception guarantee: they allocate all memory first, which changes no element, and cannot
  // fail afterwards. Before the change they call `grow` with the index bounds after the edit; `grow` may throw too.

  /// Adds a vert without edges.
  vert_id add_vert(function_ref<void(const detail::index_bounds&)> grow = {});

  /// Adds a polygon on existing verts. Cost: its size times the edges and polys at its verts.
  /// Errors: invalid_mesh as in the constructor; the tables are unchanged then.
  poly_id add_poly(std::span<const vert_id> corners, function_ref<void(const detail::index_bounds&)> grow = {});

  /// Replaces a few polys by others, as concepts/editable.hpp says. Cost: the corners of old and new polys, and the
  /// edges and polys at their verts.
  /// Errors: invalid_mesh if the cavity lists elements that do not exist, lists some twice or lacks a vert of an old
  ///         poly; if the constructor would refuse a new poly; if it removes a vert that keeps a poly. The tables are
  ///         unchanged then.
  void rewire(const detail::native_cavity& c, const detail::native_cavity_result& made,
              function_ref<void(const detail::index_bounds&)> grow = {}, detail::edit_log* log = nullptr);

  // The first poly of an edge with two polys stays the first, in each edit after which it has the edge still and the
  // edge has two polys again.

  // Edits of an edge of triangles, faster than by rewire and with the same result. They do nothing if the edit is
  // impossible, or if a triangle at the edge has a non-manifold edge or a neighbour behind two of its edges.

  /// Splits e, and each poly at it into two. Returns the new vert, or none if nothing is done.
  vert_id split_edge(edge_id e)
    requires(Arity == 3);
  /// Replaces e by the edge between the verts opposite to it. Returns whether it was done.
  bool flip_edge(edge_id e)
    requires(Arity == 3);
  /// Collapses e: its first end remains. Returns whether it was done. Nothing is done if the removed end is not inside
  /// a manifold or has many polys.
  bool collapse_edge(edge_id e)
    requires(Arity == 3);

  /// Calls f for every array of the tables, for undoing edits.
  template<class F>
  void for_each_array(const F& f) {
    f(verts_), f(edges_), f(polys_), f(p2v_), f(e2v_), f(incident_);
    facet_adjacency_.for_each_array(f);
  }
  static constexpr std::uint32_t num_arrays = 6 + detail::facet_adjacency<edge_id, Arity>::num_arrays;

  /// Allocates the memory for the removal of these polys and of verts without polys. These removals cannot fail
  /// afterwards.
  void reserve_removal(std::span<const poly_id>);

  /// Removes p and the edges that no other poly has; verts stay. The ids of other elements do not change.
  void remove_poly(poly_id p);

  /// Removes a vert that has no polys.
  void remove_vert(vert_id v);

  /// These tables without gaps, as packed as new ones. Elements and the entries of all lists keep their order.
  surface_tables compacted(const detail::compaction& kept) const;

 private:
  class rewiring;

  // Of edits of triangles.
  struct side_of_edge;
  struct outer_edge;
  static constexpr std::uint32_t longest_fan = 32;
  std::uint32_t find_triangles(edge_id e, vert_id a, side_of_edge* two) const;
  void reserve_split(const side_of_edge* s, std::uint32_t n)
    requires(Arity == 3);
  void split_edges(edge_id e, vert_id x, const side_of_edge* s, std::uint32_t n, edge_id* to)
    requires(Arity == 3);
  bool have_common_edge(vert_id a, vert_id b) const;
  bool is_closed_fan(vert_id b, const side_of_edge* s) const;
  void set_ends(edge_id e, vert_id a, vert_id b);
  void move_end(edge_id e, vert_id from, vert_id to, poly_id p, std::uint32_t k);

  void check(std::size_t vert_count) const;

  struct found_edges;
  void build(std::size_t vert_count);
  void find_edges(found_edges& found, jagged<poly_id>& v2p, const detail::offsets& poly_of);

  /// Lists, for each vert, what build() needs to find its polys: polys or corners. It lists corners if all polygons
  /// have the same size, and also if some polygon is long, since searching it for the vert would take too long. Returns
  /// the poly of each corner, if polygons differ and corners are listed.
  detail::offsets list_at_verts(jagged<poly_id>& v2p, core::flat_array<std::uint32_t>& scratch) const;

  /// Vert k of `poly`, which has `size` verts.
  struct poly_corner {
    std::uint32_t poly, k, size;
  };
  poly_corner find_corner(poly_id listed, std::uint32_t vert, const detail::offsets& poly_of) const;
};

// The members that are compiled into the library for the arities of its meshes.
#define CONCINO_SURFACE_TABLES(EXTERN, ARITY)                                                               \
  EXTERN template vert_id surface_tables<ARITY>::add_vert(function_ref<void(const detail::index_bounds&)>); \
  EXTERN template poly_id surface_tables<ARITY>::add_poly(std::span<const vert_id>,                         \
                                                          function_ref<void(const detail::index_bounds&)>); \
  EXTERN template void surface_tables<ARITY>::rewire(                                                       \
      const detail::native_cavity&, const detail::native_cavity_result&,                                    \
      function_ref<void(const detail::index_bounds&)>, detail::edit_log*);                                  \
  EXTERN template void surface_tables<ARITY>::reserve_removal(std::span<const poly_id>);                    \
  EXTERN template void surface_tables<ARITY>::remove_poly(poly_id);                                         \
  EXTERN template void surface_tables<ARITY>::remove_vert(vert_id);                                         \
  EXTERN template surface_tables<ARITY> surface_tables<ARITY>::compacted(const detail::compaction&) const;  \
  EXTERN template void surface_tables<ARITY>::check(std::size_t) const;                                     \
  EXTERN template void surface_tables<ARITY>::build(std::size_t)
#define CONCINO_TRIANGLE_EDITS(EXTERN)                                   \
  EXTERN template vert_id surface_tables<3>::split_edge(edge_id);        \
  EXTERN template bool surface_tables<3>::flip_edge(edge_id);            \
  EXTERN template bool surface_tables<3>::collapse_edge(edge_id)
#ifdef CONCINO_COMPILED
CONCINO_SURFACE_TABLES(extern, 0);
CONCINO_SURFACE_TABLES(extern, 3);
CONCINO_SURFACE_TABLES(extern, 4);
CONCINO_TRIANGLE_EDITS(extern);
#endif

}  // namespace concino

#include <concino/mesh/detail/tables/surface_tables.ipp>
#include <concino/mesh/detail/edits/surface_rewire.ipp>
#include <concino/mesh/detail/tables/surface_compact.ipp>
#include <concino/mesh/detail/edits/triangle_edits.ipp>
