// The dual mesh of a volume: a polyhedron for each vert and a face for each edge. Clipped cells get additional faces on
// the boundary.
#pragma once

#include <concino/generate/detail/dual/boundary_creases.hpp>
#include <concino/generate/detail/dual/unused_dual_verts.hpp>
#include <concino/generate/detail/dual/vertex_link_checker.hpp>
#include <concino/mesh/arrays.hpp>

namespace concino::detail {

/// Builds the dual mesh of a volume. The centres of dual_parts are edges.
template<VolumeMesh M>
  requires Embedded<M>
class volume_dual {
  static constexpr std::uint32_t none = ~0u;

  /// A boundary face at a vert: its edges there, after and before the vert as seen from outside, and its dual vert.
  struct boundary_corner {
    std::uint32_t after, before, dual;
    bool is_done;
  };

  const M& m_;
  bool has_boundary_cells_, all_are_creases_;
  oriented_edge_table<M> oriented_edges_;
  dual_parts<M> parts_;
  vertex_link_checker<M> link_checker_;
  std::vector<unsigned char> on_border_;            // by vert index
  std::vector<unsigned char> is_crease_;            // by edge index
  std::vector<std::uint32_t> face_of_, middle_of_;  // by edge index: the dual face, and the dual vert at the midpoint
                                                    // of a crease
  std::vector<std::uint32_t> cell_of_, own_of_;     // by vert index: the dual poly, and the dual vert at a vert where
                                                    // creases meet
  std::vector<boundary_corner> around_;
  polyhedra_arrays arrays_;

  void find_border_verts() {
    for (const face_t<M> f : faces(m_))
      if (parts_.is_border(index_of(m_, f)))
        for (const indexed_oriented_edge& s : oriented_edges_.of(index_of(m_, f))) on_border_[s.from] = 1;
  }

  /// Makes creases of the edges between two boundary faces that share several. Without midpoints, their dual edges
  /// would coincide.
  void add_needed_creases() {
    std::vector<std::array<std::uint32_t, 2>> faces_at(edge_index_bound(m_), {none, none});
    const auto for_each_boundary_face = [&](const auto& visit) {
      for (const face_t<M> f : faces(m_))
        if (const std::size_t i = index_of(m_, f); parts_.is_border(i)) visit(static_cast<std::uint32_t>(i));
    };
    for_each_boundary_face([&](std::uint32_t f) {
      for (const indexed_oriented_edge& s : oriented_edges_.of(f))
        faces_at[s.edge][faces_at[s.edge][0] == none ? 0 : 1] = f;
    });
    std::vector<std::uint32_t> seen_from(face_index_bound(m_), none), seen_through(face_index_bound(m_), none);
    for_each_boundary_face([&](std::uint32_t f) {
      for (const indexed_oriented_edge& s : oriented_edges_.of(f)) {
        const std::uint32_t other = faces_at[s.edge][faces_at[s.edge][0] == f ? 1 : 0];
        if (other == none) continue;
        if (seen_from[other] == f) is_crease_[s.edge] = is_crease_[seen_through[other]] = 1;
        seen_from[other] = f;
        seen_through[other] = s.edge;
      }
    });
  }

  void close_face() { arrays_.face_offsets.push_back(static_cast<std::uint32_t>(arrays_.face_verts.size())); }

  /// Adds a face for each edge that has a vert with a cell.
  void add_faces_of_edges() {
    for (const edge_t<M> e : edges(m_)) {
      const std::size_t i = index_of(m_, e);
      if (!parts_.has_polys(i)) continue;
      bool wanted = has_boundary_cells_;
      vec3 middle;
      for (const vert_t<M> v : adj_e2v(m_, e)) {
        wanted = wanted || !on_border_[index_of(m_, v)];
        middle += 0.5 * to_vec3(point(m_, v));
      }
      if (!wanted) continue;
      if (is_crease_[i] && parts_.is_border_centre(i)) middle_of_[i] = parts_.add_vert(middle);
      face_of_[i] = static_cast<std::uint32_t>(arrays_.num_faces());
      parts_.add_loop(i, middle_of_[i], arrays_.face_verts);
      close_face();
    }
  }

  void add_cells() {
    for (const vert_t<M> v : verts(m_)) {
      const std::size_t i = index_of(m_, v);
      bool any = false;
      for (const edge_t<M> e : adj_v2e(m_, v)) any = any || parts_.has_polys(index_of(m_, e));
      if (!any || (on_border_[i] && !has_boundary_cells_)) continue;
      link_checker_.check(v, on_border_[i]);
      add_cell(v);
    }
  }

  void add_cell(const vert_t<M>& v) {
    const std::size_t i = index_of(m_, v);
    cell_of_[i] = static_cast<std::uint32_t>(arrays_.num_polys());
    for (const edge_t<M> e : adj_v2e(m_, v)) {
      const std::size_t k = index_of(m_, e);
      if (face_of_[k] == none) continue;
      arrays_.poly_faces.push_back(face_id{face_of_[k]});
      arrays_.outward.push_back(oriented_edges_.second_end(k) != i);  // loops are counter-clockwise as seen from the
                                                                      // second end
    }
    if (on_border_[i]) close_cell_at_border(v);
    arrays_.poly_offsets.push_back(static_cast<std::uint32_t>(arrays_.poly_faces.size()));
  }

  void find_boundary_corners(const vert_t<M>& v) {
    around_.clear();
    for (const face_t<M> f : adj_v2f(m_, v)) {
      const std::size_t facet = index_of(m_, f);
      if (!parts_.is_border(facet)) continue;
      const auto ring = oriented_edges_.of(facet);
      std::size_t k = 0;
      while (ring[k].from != index_of(m_, v)) ++k;
      boundary_corner c{ring[k].edge, ring[k == 0 ? ring.size() - 1 : k - 1].edge, parts_.facet_vert(facet), false};
      for (const poly_t<M> p : adj_f2p(m_, f))  // a boundary face has one poly
        if (!face_is_outward(m_, p, f)) std::swap(c.after, c.before);
      around_.push_back(c);
    }
  }

  /// Adds a face for each part of the boundary at v between two creases: v, the midpoint of a crease, the dual verts of
  /// boundary faces, the midpoint of the next crease. Without creases it is one face, and where one crease ends it is
  /// one too, both without v.
  void close_cell_at_border(const vert_t<M>& v) {
    find_boundary_corners(v);
    const auto is_crease = [&](std::uint32_t e) { return is_crease_[e] != 0; };
    const auto with = [&](std::uint32_t boundary_corner::*side, std::uint32_t edge) {
      return std::find_if(around_.begin(), around_.end(), [&](const boundary_corner& c) { return c.*side == edge; });
    };
    const auto num_creases =
        std::count_if(around_.begin(), around_.end(), [&](const boundary_corner& c) { return is_crease(c.after); });
    std::uint32_t& own = own_of_[index_of(m_, v)];
    if (num_creases > 1) own = parts_.add_vert(to_vec3(point(m_, v)));
    for (auto start = around_.begin(); start != around_.end(); ++start) {
      if (start->is_done) continue;
      auto at = start;
      while (!is_crease(at->after)) {
        at = with(&boundary_corner::before, at->after);
        if (at == start) break;
      }
      if (own != none) arrays_.face_verts.push_back(vert_id{own});
      if (is_crease(at->after)) arrays_.face_verts.push_back(vert_id{middle_of_[at->after]});
      for (; !at->is_done; at = with(&boundary_corner::after, at->before)) {
        at->is_done = true;
        arrays_.face_verts.push_back(vert_id{at->dual});
        if (!is_crease(at->before)) continue;
        if (own != none) arrays_.face_verts.push_back(vert_id{middle_of_[at->before]});
        break;
      }
      arrays_.poly_faces.push_back(face_id{arrays_.num_faces()});
      arrays_.outward.push_back(true);
      close_face();
    }
  }

 public:
  template<class Creases>
  volume_dual(const M& m, const boundary_creases<M, Creases>& creases, dual_points where)
      : m_(m), has_boundary_cells_(creases.has_boundary_cells()), all_are_creases_(creases.all_are_creases()),
        oriented_edges_(m), parts_(m, has_boundary_cells_, where, oriented_edges_), link_checker_(m, parts_),
        on_border_(vert_index_bound(m)), is_crease_(creases.at_edges()), face_of_(edge_index_bound(m), none),
        middle_of_(edge_index_bound(m), none), cell_of_(vert_index_bound(m), none), own_of_(vert_index_bound(m), none) {
  }

  /// Builds the arrays of the dual mesh. If cells are not clipped, some points may belong to no face.
  polyhedra_arrays build() {
    find_border_verts();
    if (has_boundary_cells_ && !all_are_creases_) add_needed_creases();
    arrays_.face_verts.reserve(parts_.num_corners());
    arrays_.face_offsets.push_back(0);
    arrays_.poly_offsets.push_back(0);
    add_faces_of_edges();
    add_cells();
    arrays_.points = std::move(parts_.points);
    return std::move(arrays_);
  }

  dual_maps maps() const {
    return {ids<poly_id>(cell_of_),
            ids<face_id>(face_of_),
            ids<vert_id>(parts_.vert_of_poly()),
            ids<vert_id>(parts_.vert_of_facet()),
            ids<vert_id>(middle_of_),
            ids<vert_id>(own_of_)};
  }
};

}  // namespace concino::detail
