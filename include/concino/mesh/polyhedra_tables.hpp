// All adjacencies of a mesh of general polyhedra in flat arrays, built in linear time from faces (lists of verts) and
// polys (lists of faces). Some are derived on the fly: edges of a face (from its verts), polys around an edge and faces
// at a vert (from the faces at edges).
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/function_ref.hpp>
#include <concino/core/message.hpp>
#include <concino/mesh/detail/edits/cavity_input.hpp>
#include <concino/mesh/detail/edits/edit_log.hpp>
#include <concino/mesh/detail/tables/checks.hpp>
#include <concino/mesh/detail/tables/polyhedra_ranges.hpp>
#include <concino/mesh/detail/tables/vertex_incidence.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace concino {

namespace detail {
class polyhedra_cavity;
}

/// Lists: where the verts of faces are stored, either in rows of these tables, which can be edited, or in an array of
/// the user.
template<class Lists>
class basic_polyhedra_tables {
  template<class> friend class basic_polyhedra_tables;
  template<class T> using jagged = detail::jagged_array<T, 0>;

  detail::alive_elements<vert_id> verts_;
  detail::alive_elements<edge_id> edges_;
  detail::alive_elements<face_id> faces_;
  detail::alive_elements<poly_id> polys_;
  Lists f2v_;
  jagged<vert_id> p2v_;
  detail::incident_edges incident_edges_;
  jagged<edge_id> p2e_;
  jagged<face_id> e2f_;
  jagged<poly_id> v2p_;
  detail::facet_adjacency<face_id, 0> facet_adjacency_;
  detail::row_lookup face_vert_lookup_;  // of verts in faces with many verts
  jagged<std::uint8_t> outward_;  // parallel to the faces of each poly
  detail::jagged_array<vert_id, 2> e2v_;

 public:
  basic_polyhedra_tables() = default;
  basic_polyhedra_tables(const basic_polyhedra_tables&) = default;
  basic_polyhedra_tables(basic_polyhedra_tables&&) noexcept = default;
  // strong exception guarantee
  basic_polyhedra_tables& operator=(const basic_polyhedra_tables& o) { return *this = basic_polyhedra_tables(o); }
  basic_polyhedra_tables& operator=(basic_polyhedra_tables&&) noexcept = default;

  /// From the verts of every face in cyclic order, the faces of every poly, and whether each face is oriented outward
  /// there.
  /// Errors: invalid_mesh that names the face or poly with a bad or repeated vert or face; unsupported if faces of many
  ///         verts belong to so many polys that the adjacencies would be far longer than these lists.
  basic_polyhedra_tables(std::size_t vert_count, std::vector<std::uint32_t> face_offsets,
                         std::vector<vert_id> face_verts, std::vector<std::uint32_t> poly_offsets,
                         std::vector<face_id> poly_faces, std::vector<std::uint8_t> outward);
  /// From lists stored elsewhere, and from tables that were built from a copy of these lists.
  basic_polyhedra_tables(basic_polyhedra_tables<jagged<vert_id>>&& built,
                         Lists elsewhere) requires(!std::same_as<Lists, jagged<vert_id>>)
      : verts_(std::move(built.verts_)), edges_(std::move(built.edges_)), faces_(std::move(built.faces_)),
        polys_(std::move(built.polys_)), f2v_(std::move(elsewhere)), p2v_(std::move(built.p2v_)),
        incident_edges_(std::move(built.incident_edges_)), p2e_(std::move(built.p2e_)), e2f_(std::move(built.e2f_)),
        v2p_(std::move(built.v2p_)), facet_adjacency_(std::move(built.facet_adjacency_)),
        face_vert_lookup_(std::move(built.face_vert_lookup_)), outward_(std::move(built.outward_)),
        e2v_(std::move(built.e2v_)) {}

  const detail::alive_elements<vert_id>& verts() const { return verts_; }
  const detail::alive_elements<edge_id>& edges() const { return edges_; }
  const detail::alive_elements<face_id>& faces() const { return faces_; }
  const detail::alive_elements<poly_id>& polys() const { return polys_; }

  id_span<vert_id> adj_v2v(vert_id v) const { return incident_edges_.verts(v); }
  id_span<edge_id> adj_v2e(vert_id v) const { return incident_edges_.edges(v); }
  detail::faces_at_edges<basic_polyhedra_tables> adj_v2f(vert_id v) const { return {this, v}; }
  id_span<poly_id> adj_v2p(vert_id v) const { return v2p_[v.raw()]; }
  id_span<vert_id> adj_e2v(edge_id e) const { return e2v_[e.raw()]; }
  id_span<face_id> adj_e2f(edge_id e) const { return e2f_[e.raw()]; }
  detail::polys_of_faces<basic_polyhedra_tables> adj_e2p(edge_id e) const { return {this, adj_e2f(e)}; }
  auto adj_f2v(face_id f) const { return f2v_[f.raw()]; }
  auto adj_f2e(face_id f) const { return detail::edges_between(this, adj_f2v(f)); }
  detail::polys_of_facet adj_f2p(face_id f) const { return facet_adjacency_.polys_of(f); }
  id_span<vert_id> adj_p2v(poly_id p) const { return p2v_[p.raw()]; }
  id_span<edge_id> adj_p2e(poly_id p) const { return p2e_[p.raw()]; }
  id_span<face_id> adj_p2f(poly_id p) const { return facet_adjacency_.facets(p); }
  detail::adjacent_polys adj_p2p(poly_id p) const { return facet_adjacency_.polys(p); }

  /// The number of the first corner of p; the other corners of p follow. All corner numbers are below corner_bound().
  /// Edits do not change them.
  std::size_t first_corner(poly_id p) const { return p2v_.first(p.raw()); }
  std::size_t corner_bound() const { return p2v_.num_values(); }

  bool face_is_outward(poly_id p, face_id f) const {
    const std::uint32_t k = facet_adjacency_.position_of(p, f);
    return k < outward_.length(p.raw()) && outward_.begin(p.raw())[k] != 0;
  }

  // Edits have the strong exception guarantee: they allocate all memory first, which changes no element, and cannot
  // fail afterwards. Before the change they call `grow` with the index bounds after the edit; `grow` may throw too.

  /// Adds a vert without edges.
  vert_id add_vert(function_ref<void(const detail::index_bounds&)> grow = {});

  /// Adds a face on existing verts, without polys. A second face on the same verts is a different face.
  /// Errors: invalid_mesh as in the constructor; the tables are unchanged then.
  face_id add_face(std::span<const vert_id> corners, function_ref<void(const detail::index_bounds&)> grow = {},
                   detail::edit_log* log = nullptr);

  /// Adds a poly of existing faces; outward[k] as in the constructor. Cost: at most the square of the corners of its
  /// faces.
  /// Errors: invalid_mesh as in the constructor; the tables are unchanged then.
  poly_id add_poly(std::span<const face_id> list, std::span<const std::uint8_t> outward,
                   function_ref<void(const detail::index_bounds&)> grow = {}, detail::edit_log* log = nullptr);

  /// Replaces a few polys by others, as concepts/editable.hpp says. A new face is the existing one, or the other new
  /// one, that has the same verts in the same or the reversed cyclic order. Cost: the old and new polys, and the edges,
  /// faces and polys at their verts.
  /// Errors: invalid_mesh if the cavity lists elements that do not exist, lists some twice or lacks a vert of an old
  ///         poly, or if the constructor would refuse a new poly. invalid_mesh if a vert that is to be removed keeps a
  ///         poly or a face without polys. The tables are unchanged then.
  void rewire(const detail::native_cavity& c, const detail::native_cavity_result& made,
              function_ref<void(const detail::index_bounds&)> grow = {}, detail::edit_log* log = nullptr);

  /// Calls f for every array of the tables, for undoing edits.
  template<class F>
  void for_each_array(const F& f) {
    f(verts_), f(edges_), f(faces_), f(polys_), f(f2v_), f(p2v_), f(p2e_), f(outward_), f(e2v_), f(e2f_),
        f(incident_edges_), f(v2p_);
    facet_adjacency_.for_each_array(f);
  }
  static constexpr std::uint32_t num_arrays = 12 + detail::facet_adjacency<face_id, 0>::num_arrays;

  /// Allocates the memory for the removal of these polys, and of faces and verts without polys. These removals cannot
  /// fail afterwards.
  void reserve_removal(std::span<const poly_id>);

  /// Removes p, the faces that no other poly has and the edges that no other face has; verts stay. The ids of other
  /// elements do not change.
  void remove_poly(poly_id p);

  /// Removes a face that has no polys.
  void remove_face(face_id f, detail::edit_log* log = nullptr);

  /// Removes a vert that has no polys, and the faces at it, which have none either.
  void remove_vert(vert_id v);

  /// These tables without gaps, as packed as new ones. Elements and the entries of all lists keep their order, apart
  /// from the neighbours of verts with many.
  basic_polyhedra_tables compacted(const detail::compaction& kept) const;

  // Used by the ranges above.
  edge_id edge_between(vert_id a, vert_id b) const {
    const auto [smaller, larger] = std::minmax({a, b});
    if (incident_edges_.num_edges(larger) > detail::row_lookup::longest_scan)
      if (const edge_id e = edge_to_smaller(larger, smaller); !e.is_none()) return e;
    return incident_edges_.edge_between(larger, smaller);
  }
  vert_id next_in_face(face_id f, vert_id v) const {
    const auto corners = adj_f2v(f);
    const std::size_t n = corners.size();
    std::size_t i = 0;
    if (n > detail::row_lookup::longest_scan) i = face_vert_lookup_.find(f.raw(), corners, v);
    else
      while (i < n && corners[i] != v) ++i;
    return i == n ? vert_id{} : corners[i + 1 == n ? 0 : i + 1];
  }

 private:
  friend class detail::polyhedra_cavity;
  class rewiring;

  static constexpr std::size_t faces_of_new_edge = 4;  // for which memory is reserved

  /// The arrays as for_each_array() numbers them.
  enum array_number : std::uint32_t {
    of_verts,
    of_edges,
    of_faces,
    of_polys,
    of_f2v,
    of_p2v,
    of_p2e,
    of_outward,
    of_e2v,
    of_e2f,
    of_incident_edges,
    of_v2p,
    of_facets
  };

  /// Saves what changes when a face with these verts is added or removed.
  void save_around_face(detail::edit_log& log, id_span<vert_id> corners) const;

  /// Result: the number of verts of the faces of all polys, a face counted for every poly that has it.
  std::size_t check(std::size_t vert_count, const jagged<face_id>& polys) const;
  std::size_t check_polys(const jagged<face_id>& polys) const;

  /// The smaller neighbours of a vert come before the larger ones, in ascending order, until edges are added or removed
  /// there.
  edge_id edge_to_smaller(vert_id v, vert_id smaller) const;

  void build(std::size_t vert_count, const jagged<face_id>& polys, std::size_t poly_corners);

  void sort_smaller_neighbours();

  /// Builds edges as in a surface whose polys are the faces; f2e[i] is the edge that begins at the i-th corner.
  void build_edges(std::size_t vert_count, core::flat_array<edge_id>& f2e);
  void list_faces_of_edges(const core::flat_array<edge_id>& f2e);
  void link_polys(const jagged<face_id>& polys);

  // The edges and verts of every poly are listed in the order in which they occur in its faces.
  void list_edges_of_polys(const core::flat_array<edge_id>& f2e, const jagged<face_id>& polys,
                           std::size_t poly_corners);
  /// Lists the verts of every poly, and the polys of every vert.
  void list_verts_of_polys(std::size_t vert_count, const jagged<face_id>& polys, std::size_t poly_corners);
};

template<class Lists>
edge_id basic_polyhedra_tables<Lists>::edge_to_smaller(vert_id v, vert_id smaller) const {
  const id_span<vert_id> near = incident_edges_.verts(v);
  const vert_id* const at = std::lower_bound(near.begin(), near.end(), smaller);
  return at != near.end() && *at == smaller ? incident_edges_.edges(v)[static_cast<std::size_t>(at - near.begin())]
                                            : edge_id{};
}

using polyhedra_tables = basic_polyhedra_tables<detail::jagged_array<vert_id, 0>>;

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/edits/polyhedra_tables_rewire.ipp>
#include <concino/mesh/detail/tables/polyhedra_compact.ipp>
#include <concino/mesh/detail/tables/polyhedra_tables_build.ipp>
#include <concino/mesh/detail/tables/polyhedra_tables_edit.ipp>
#endif
