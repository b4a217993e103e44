// Adapter for CGAL's linear cell complexes over combinatorial maps of dimension 3: indexed(lcc) is a polyhedral mesh.
//
//   CGAL::Linear_cell_complex_for_combinatorial_map<3> lcc = ...;
//   const auto m = cn::indexed(lcc);
//   const auto d = cn::dijkstra(m, m.vert(dart));
//   d[m.vert(other)];  lcc.info<3>(m.handle(p));
//
// A combinatorial map has only darts: a vertex, edge, facet or volume is an orbit of darts, and each of these can stand
// for it. So the view numbers the elements: its descriptors are vert_id, edge_id, face_id and poly_id. vert(d),
// edge(d), face(d), poly(d) are those at a dart, handle(x) is a dart of x. Stored in the view: the connectivity of a
// polyhedralmesh, one dart per element, and two hash tables of darts; no points. Cost: as for a polyhedralmesh;
// conversion of darts is one table look-up, to an edge also a search through the edges at its vert. All sewing, adding
// and removing invalidates the view; points may move, as long as volumes are not turned inside out.
// Needs: CGAL 5.5 (Debian: libcgal-dev).
#pragma once

#include <concino/adapters/detail/cgal_point.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/indexed_base.hpp>
#include <concino/mesh/polyhedra_tables.hpp>
#include <concino/mesh/support/standard_cells.hpp>

#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Unique_hash_map.h>

#include <memory>
#include <string>
#include <vector>

namespace concino {

namespace views {

template<class L>
class indexed_cell_complex {
 public:
  using dart = typename L::Dart_const_handle;
  using vertex = typename L::Vertex_attribute_const_handle;

 private:
  struct numbers {
    CGAL::Unique_hash_map<vertex, vert_id> verts;
    CGAL::Unique_hash_map<dart, face_id> faces;
    CGAL::Unique_hash_map<dart, poly_id> polys;
    std::vector<dart> vert_darts, edge_darts, face_darts, poly_darts;
    polyhedra_tables connectivity;
  };
  const L* lcc_;
  std::shared_ptr<const numbers> numbers_;

 public:
  explicit indexed_cell_complex(const L& lcc) : lcc_(&lcc) {
    const auto n = std::make_shared<numbers>();
    polyhedra_arrays a{{}, {0}, {}, {0}, {}, {}};
    std::vector<dart> waiting;
    for (dart first = lcc.darts().begin(), last = lcc.darts().end(); first != last; ++first) {
      if (!n->polys[first].is_none()) continue;
      const poly_id p(n->poly_darts.size());
      n->poly_darts.push_back(first);
      waiting.assign(1, first);
      while (!waiting.empty()) {
        const dart first_dart = waiting.back();
        waiting.pop_back();
        if (!n->polys[first_dart].is_none()) continue;
        const face_id opposite = lcc.is_free(first_dart, 3) ? face_id() : n->faces[lcc.beta(first_dart, 3)];
        const face_id f = opposite.is_none() ? face_id(n->face_darts.size()) : opposite;
        dart d = first_dart;
        do {
          if (lcc.is_free(d, 1))
            core::throw_joined<invalid_mesh>(
                {"CGAL::Linear_cell_complex: poly ", p.raw(),
                 " has a facet that is not closed: one of its darts has no next dart (beta 1)"});
          n->polys[d] = p;
          n->faces[d] = f;
          vert_id& v = n->verts[lcc.vertex_attribute(d)];
          if (v.is_none()) {
            v = vert_id(n->vert_darts.size());
            n->vert_darts.push_back(d);
          }
          if (opposite.is_none()) a.face_verts.push_back(v);
          if (!lcc.is_free(d, 2)) waiting.push_back(lcc.beta(d, 2));
          d = lcc.beta(d, 1);
        } while (d != first_dart);
        if (opposite.is_none()) {
          n->face_darts.push_back(first_dart);
          a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
        }
        a.poly_faces.push_back(f);
        a.outward.push_back(opposite.is_none());  // true if a dart of p has the direction of the face
      }
      a.poly_offsets.push_back(static_cast<std::uint32_t>(a.poly_faces.size()));
    }
    turn_outward(*n, a);
    n->connectivity = polyhedra_tables(n->vert_darts.size(), std::move(a.face_offsets), std::move(a.face_verts),
                                       std::move(a.poly_offsets), std::move(a.poly_faces), std::move(a.outward));
    n->edge_darts.resize(n->connectivity.edges().bound());
    for (dart d = lcc.darts().begin(), last = lcc.darts().end(); d != last; ++d)
      n->edge_darts[n->connectivity
                        .edge_between(n->verts[lcc.vertex_attribute(d)], n->verts[lcc.vertex_attribute(lcc.beta(d, 1))])
                        .raw()] = d;
    numbers_ = n;
  }

  const L& complex() const { return *lcc_; }
  const polyhedra_tables& tables() const { return numbers_->connectivity; }

  /// The element at a dart: the vert that it leaves, its edge, its facet and its volume.
  vert_id vert(dart d) const { return vert(lcc_->vertex_attribute(d)); }
  vert_id vert(vertex v) const { return numbers_->verts[v]; }
  edge_id edge(dart d) const { return tables().edge_between(vert(d), vert(lcc_->beta(d, 1))); }
  face_id face(dart d) const { return numbers_->faces[d]; }
  poly_id poly(dart d) const { return numbers_->polys[d]; }

  /// One of the darts of an element.
  dart handle(vert_id v) const { return numbers_->vert_darts[v.raw()]; }
  dart handle(edge_id e) const { return numbers_->edge_darts[e.raw()]; }
  dart handle(face_id f) const { return numbers_->face_darts[f.raw()]; }
  dart handle(poly_id p) const { return numbers_->poly_darts[p.raw()]; }

 private:
  /// The facets of a volume have the same orientation. If points say that it is inward, `outward` is inverted for all
  /// of them.
  void turn_outward(const numbers& n, polyhedra_arrays& a) const {
    const auto point = [&](vert_id v) { return detail::read_point(lcc_->point(n.vert_darts[v.raw()])); };
    for (std::size_t p = 0; p + 1 < a.poly_offsets.size(); ++p) {
      const vec3 apex = point(a.face_verts[a.face_offsets[a.poly_faces[a.poly_offsets[p]].raw()]]);
      double volume = 0;
      for (std::uint32_t i = a.poly_offsets[p]; i < a.poly_offsets[p + 1]; ++i) {
        const std::uint32_t f = a.poly_faces[i].raw(), first = a.face_offsets[f];
        const double one = six_times_volume_under(
            a.face_offsets[f + 1] - first, [&](std::size_t k) { return point(a.face_verts[first + k]); }, apex);
        volume += a.outward[i] ? one : -one;
      }
      if (volume < 0)
        for (std::uint32_t i = a.poly_offsets[p]; i < a.poly_offsets[p + 1]; ++i) a.outward[i] = !a.outward[i];
    }
  }
};

}  // namespace views

template<class L>
struct mesh_traits<views::indexed_cell_complex<L>> : indexed_volume<views::indexed_cell_complex<L>> {
  static constexpr bool is_view = true;
  static const polyhedra_tables& tables(const views::indexed_cell_complex<L>& m) { return m.tables(); }
  static vec3 point(const views::indexed_cell_complex<L>& m, vert_id v) {
    return detail::read_point(m.complex().point(m.handle(v)));
  }
};

namespace requirement {

template<class L>
concept is_cgal_cell_complex = L::dimension == 3 && L::ambient_dimension == 3 &&
                               requires(const L& lcc, typename L::Dart_const_handle d) {
  typename L::Vertex_attribute_const_handle;
  lcc.beta(d, 1);
  lcc.point(d);
};

}  // namespace requirement

/// A linear cell complex as a polyhedral mesh.
/// Needs:  it outlives the view, so a temporary one is refused, and does not change while the view is used, except for
///         its points.
/// Result: a VolumeMesh. Verts, faces and polys are numbered by their first dart in the order of iteration. Facets that
///         are not sewn to another volume are the boundary.
/// Cost:   O(darts) time, times the edges at a vert. Memory: that of a polyhedralmesh without its points, a handle per
///         element, two hash tables of darts.
/// Errors: invalid_mesh if a facet is not closed, or meets a vert twice.
template<requirement::is_cgal_cell_complex L>
auto indexed(const L& lcc) {
  return views::indexed_cell_complex<L>(lcc);
}
template<requirement::is_cgal_cell_complex L> void indexed(const L&& lcc) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
