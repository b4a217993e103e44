// The dual mesh of a volume: a polyhedron for each vert and a face for each edge. Clipped cells get additional faces on the boundary.
#pragma once

#include <concino/generate/detail/vertex_link_checker.hpp>
#include <concino/mesh/arrays.hpp>

namespace concino::detail {

/// Builds the dual mesh of a volume. The centres of dual_parts are edges.
template<VolumeMesh M>
  requires Embedded<M>
class volume_dual {
  static constexpr std::uint32_t none = ~0u;

  const M& m_;
  bool clipped_;
  oriented_edge_table<M> oriented_edges_;
  dual_parts<M> parts_;
  vertex_link_checker<M> link_checker_;
  std::vector<unsigned char> on_border_;            // by vert index
  std::vector<std::uint32_t> face_of_, middle_of_;  // by edge index: the dual face, and the dual vert at the midpoint of a boundary edge
  polyhedra_arrays arrays_;

  void find_border_verts() {
    for (const face_t<M> f : faces(m_))
      if (parts_.is_border(index_of(m_, f)))
        for (const indexed_oriented_edge& s : oriented_edges_.of(index_of(m_, f))) on_border_[s.from] = 1;
  }

  void close_face() { arrays_.face_offsets.push_back(static_cast<std::uint32_t>(arrays_.face_verts.size())); }

  /// Adds a face for each edge that has a vert with a cell.
  void add_faces_of_edges() {
    for (const edge_t<M> e : edges(m_)) {
      const std::size_t i = index_of(m_, e);
      if (!parts_.has_polys(i)) continue;
      bool wanted = clipped_;
      vec3 middle;
      for (const vert_t<M> v : adj_e2v(m_, e)) {
        wanted = wanted || !on_border_[index_of(m_, v)];
        middle += 0.5 * to_vec3(point(m_, v));
      }
      if (!wanted) continue;
      if (parts_.is_border_centre(i)) middle_of_[i] = parts_.add_vert(middle);
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
      if (!any || (on_border_[i] && !clipped_)) continue;
      link_checker_.check(v, on_border_[i]);
      add_cell(v);
    }
  }

  void add_cell(const vert_t<M>& v) {
    const std::size_t i = index_of(m_, v);
    for (const edge_t<M> e : adj_v2e(m_, v)) {
      const std::size_t k = index_of(m_, e);
      if (face_of_[k] == none) continue;
      arrays_.poly_faces.push_back(face_id{face_of_[k]});
      arrays_.outward.push_back(oriented_edges_.second_end(k) != i);  // loops are counter-clockwise as seen from the second end
    }
    if (on_border_[i]) close_cell_at_border(v);
    arrays_.poly_offsets.push_back(static_cast<std::uint32_t>(arrays_.poly_faces.size()));
  }

  /// Adds a quad in each boundary face at v: v, the midpoint of the next edge, the dual vert of the face, the midpoint of the previous edge.
  void close_cell_at_border(const vert_t<M>& v) {
    const std::size_t i = index_of(m_, v);
    const std::uint32_t own = parts_.add_vert(to_vec3(point(m_, v)));
    for (const face_t<M> f : adj_v2f(m_, v)) {
      if (!parts_.is_border(index_of(m_, f))) continue;
      const auto ring = oriented_edges_.of(index_of(m_, f));
      std::size_t k = 0;
      while (ring[k].from != i) ++k;
      const std::uint32_t before = middle_of_[ring[k == 0 ? ring.size() - 1 : k - 1].edge], after = middle_of_[ring[k].edge];
      arrays_.poly_faces.push_back(face_id{arrays_.num_faces()});
      for (const poly_t<M> p : adj_f2p(m_, f)) arrays_.outward.push_back(face_is_outward(m_, p, f));  // a boundary face has one poly
      for (const std::uint32_t x : {own, after, parts_.facet_vert(index_of(m_, f)), before}) arrays_.face_verts.push_back(vert_id{x});
      close_face();
    }
  }

 public:
  volume_dual(const M& m, bool clipped)
      : m_(m), clipped_(clipped), oriented_edges_(m), parts_(m, clipped, oriented_edges_), link_checker_(m, parts_), on_border_(vert_index_bound(m)),
        face_of_(edge_index_bound(m), none), middle_of_(edge_index_bound(m), none) {}

  /// Result: the dual mesh. If cells are not clipped, some points may belong to no face.
  polyhedra_arrays build() && {
    find_border_verts();
    core::reserve_large(arrays_.face_verts, parts_.num_corners());
    arrays_.face_offsets.push_back(0);
    arrays_.poly_offsets.push_back(0);
    add_faces_of_edges();
    add_cells();
    arrays_.points = std::move(parts_.points);
    return std::move(arrays_);
  }
};

}  // namespace concino::detail
