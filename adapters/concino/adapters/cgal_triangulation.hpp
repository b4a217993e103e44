// Adapter for CGAL's 3D triangulations as tet meshes, by indexed(t): Triangulation_3, Delaunay_triangulation_3,
// Regular_triangulation_3 (without the infinite vertex and its cells) and Mesh_complex_3_in_triangulation_3 (the cells
// of the complex, with their verts).
//
//   CGAL::Delaunay_triangulation_3<Kernel> t = ...;
//   const auto m = cn::indexed(t);
//   const auto d = cn::dijkstra(m, m.vert(vertex_handle));
//   d[m.vert(other)];  m.handle(v)->point();
//
// A triangulation has no numbers, and one of its edges or facets has as many descriptions as cells around it. So the
// view numbers the elements: its descriptors are vert_id, edge_id, face_id and poly_id; vert(), edge(), face(), poly()
// and handle() convert from CGAL's types and back. Stored in the view: the connectivity of a tetmesh, handles, and hash
// tables of handles; no points. Cost: as for a tetmesh; conversion of CGAL's vertices and cells is one table look-up,
// that of edges and facets a search around the vert or in the cell. All changes of the triangulation or the complex
// invalidate the view; points may move.
// Needs: CGAL 5.5 (Debian: libcgal-dev).
#pragma once

#include <concino/adapters/detail/cgal_point.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/mesh/cell_tables.hpp>
#include <concino/mesh/indexed_base.hpp>

#include <CGAL/Triangulation_3.h>
#include <CGAL/Unique_hash_map.h>

#include <memory>
#include <vector>

namespace concino {

namespace detail {

/// Handles and their numbers.
template<class Handle, class Id>
class handle_numbers {
  std::vector<Handle> handles_;
  CGAL::Unique_hash_map<Handle, Id> ids_;

 public:
  Id add(const Handle& h) {
    Id& id = ids_[h];
    if (id.is_none()) {
      id = Id(handles_.size());
      handles_.push_back(h);
    }
    return id;
  }
  void reserve(std::size_t n) {
    handles_.reserve(n);
    ids_.reserve(n);
  }
  std::size_t size() const { return handles_.size(); }
  const Handle& operator[](Id id) const { return handles_[id.raw()]; }
  Id operator[](const Handle& h) const { return ids_[h]; }
};

}  // namespace detail

namespace views {

/// Some cells of triangulation T, and their verts.
template<class T>
class indexed_triangulation {
 public:
  using vertex_handle = typename T::Vertex_handle;
  using cell_handle = typename T::Cell_handle;

 private:
  struct numbers {
    detail::handle_numbers<vertex_handle, vert_id> verts;
    detail::handle_numbers<cell_handle, poly_id> polys;
    tet_tables connectivity;
  };
  const T* t_;
  std::shared_ptr<const numbers> numbers_;

 public:
  /// The cells from `first` to before `last`. Verts have the order of `vertices`, followed by others in the order in
  /// which cells use them.
  template<class Vertices, class Iterator>
  indexed_triangulation(const T& t, const Vertices& vertices, Iterator first, const Iterator& last,
                        std::size_t cell_count)
      : t_(&t) {
    const auto n = std::make_shared<numbers>();
    n->verts.reserve(t.number_of_vertices());
    n->polys.reserve(cell_count);
    std::vector<vert_id> corners;
    corners.reserve(4 * cell_count);
    for (const vertex_handle v : vertices) n->verts.add(v);
    for (; first != last; ++first) {
      const cell_handle c = first;
      n->polys.add(c);
      for (int i = 0; i < 4; ++i) corners.push_back(n->verts.add(c->vertex(i)));
    }
    n->connectivity = tet_tables(n->verts.size(), std::move(corners));
    numbers_ = n;
  }

  const T& triangulation() const { return *t_; }
  const tet_tables& tables() const { return numbers_->connectivity; }

  /// Converts an element of the triangulation to a descriptor, which is_none() for elements that are not in the mesh.
  vert_id vert(vertex_handle v) const { return numbers_->verts[v]; }
  poly_id poly(cell_handle c) const { return numbers_->polys[c]; }
  edge_id edge(const typename T::Edge& e) const {
    const vert_id a = vert(e.first->vertex(e.second)), b = vert(e.first->vertex(e.third));
    if (a.is_none() || b.is_none()) return {};
    for (const edge_id x : tables().adj_v2e(a))
      for (const vert_id end : tables().adj_e2v(x))
        if (end == b) return x;
    return {};
  }
  face_id face(const typename T::Facet& f) const {
    const auto of_cell = [&](cell_handle c, int i) {
      const poly_id p = poly(c);
      return p.is_none() ? face_id{} : facing(p, vert(c->vertex(i)));
    };
    const face_id here = of_cell(f.first, f.second);
    if (!here.is_none()) return here;
    const auto mirror = t_->mirror_facet(f);
    return of_cell(mirror.first, mirror.second);
  }

  /// Converts a descriptor to an element of the triangulation; for edges and facets it is one of several equivalent
  /// ones.
  vertex_handle handle(vert_id v) const { return numbers_->verts[v]; }
  cell_handle handle(poly_id p) const { return numbers_->polys[p]; }
  typename T::Edge handle(edge_id e) const {
    const cell_handle c = handle(*tables().adj_e2p(e).begin());
    const auto ends = tables().adj_e2v(e);
    return {c, c->index(handle(ends[0])), c->index(handle(ends[1]))};
  }
  typename T::Facet handle(face_id f) const {
    const poly_id p = *tables().adj_f2p(f).begin();
    const cell_handle c = handle(p);
    int i = 0;
    while (facing(p, vert(c->vertex(i))) != f) ++i;
    return {c, i};
  }

 private:
  /// The face of p opposite to v.
  face_id facing(poly_id p, vert_id v) const {
    for (const face_id f : tables().adj_p2f(p)) {
      const auto around = tables().adj_f2v(f);
      if (around[0] != v && around[1] != v && around[2] != v) return f;
    }
    return {};
  }
};

}  // namespace views

template<class T>
struct mesh_traits<views::indexed_triangulation<T>> : indexed_volume<views::indexed_triangulation<T>> {
  static constexpr bool is_view = true;
  static constexpr int arity = 4;
  static const tet_tables& tables(const views::indexed_triangulation<T>& m) { return m.tables(); }
  static vec3 point(const views::indexed_triangulation<T>& m, vert_id v) {
    return detail::read_point(m.handle(v)->point());
  }
};

namespace requirement {

/// A complex of cells, as CGAL's mesh generators return: a triangulation with a selection of its cells.
template<class C> concept is_cgal_complex = requires(const C& c) {
  typename C::Triangulation;
  c.triangulation().mirror_facet(*c.triangulation().facets_begin());
  c.cells_in_complex_begin() != c.cells_in_complex_end();
  c.number_of_cells_in_complex();
};

}  // namespace requirement

/// A triangulation, or the complex in one, as a tet mesh.
/// Needs:  it outlives the view, so a temporary one is refused, and does not change while the view is used, except for
///         its points.
/// Result: a TetMesh of the finite cells, or those in the complex. Verts and polys are numbered in CGAL's order. A
///         triangulation of points in one plane has verts and no polys; a complex has the verts of its cells only.
/// Cost:   O(vertices + cells) time. Memory: that of a tetmesh without its points, a handle per vert and poly, and hash
///         tables of 36 to 72 bytes per vertex of the triangulation and per poly, which copies share.
/// Errors: none of its own.
template<class G, class D, class L>
auto indexed(const CGAL::Triangulation_3<G, D, L>& t) {
  return views::indexed_triangulation<CGAL::Triangulation_3<G, D, L>>(
      t, t.finite_vertex_handles(), t.finite_cells_begin(), t.finite_cells_end(),
      t.dimension() < 3 ? 0 : t.number_of_finite_cells());
}
template<requirement::is_cgal_complex C>
auto indexed(const C& c) {
  using triangulation = typename C::Triangulation;
  return views::indexed_triangulation<triangulation>(
      c.triangulation(), std::vector<typename triangulation::Vertex_handle>(), c.cells_in_complex_begin(),
      c.cells_in_complex_end(), c.number_of_cells_in_complex());
}
template<class G, class D, class L> void indexed(const CGAL::Triangulation_3<G, D, L>&& t) = delete;  // give the mesh a name: auto m = ...;
template<requirement::is_cgal_complex C> void indexed(const C&& c) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
