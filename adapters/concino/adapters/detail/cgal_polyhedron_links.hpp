// The links between the half-edges of a CGAL::Polyhedron_3.
#pragma once

#include <concino/adapters/detail/cgal_point.hpp>
#include <concino/adapters/detail/mapped_range.hpp>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <functional>

namespace concino::detail {

/// An iterator of a polyhedron as descriptor.
template<class X>
struct cgal_descriptor {
  template<class Iterator>
  X operator()(const Iterator& i) const { return X(i); }
};

/// Links of polyhedron P. M is P itself or a view of it; the handles need no mesh to find their neighbours.
template<class P, class M = P>
struct cgal_polyhedron_links {
  using vert = typename P::Vertex_handle;
  using edge = typename boost::graph_traits<P>::edge_descriptor;
  using poly = typename P::Facet_handle;
  using halfedge = typename P::Halfedge_handle;

  static halfedge next(const M&, halfedge h) { return h->next(); }
  static halfedge opposite(const M&, halfedge h) { return h->opposite(); }
  static vert target(const M&, halfedge h) { return h->vertex(); }
  static bool is_border(const M&, halfedge h) { return h->is_border(); }
  static poly poly_of(const M&, halfedge h) { return h->facet(); }
  static edge edge_of(const M&, halfedge h) { return edge(h); }
  static bool is_isolated(const M&, vert v) { return v->halfedge() == halfedge(); }
  static halfedge halfedge_of(const M&, vert v) { return v->halfedge()->opposite(); }
  /// The same for equal edges, which may store either half-edge.
  static halfedge halfedge_of(const M&, edge e) {
    const halfedge h = e.halfedge(), o = h->opposite();
    return std::less<>()(&*o, &*h) ? o : h;
  }
  static halfedge halfedge_of(const M&, poly p) { return p->halfedge(); }

  static std::size_t num_verts(const M& m) { return base(m).size_of_vertices(); }
  static std::size_t num_edges(const M& m) { return base(m).size_of_halfedges() / 2; }
  static std::size_t num_polys(const M& m) { return base(m).size_of_facets(); }
  static auto verts(const M& m) { return handles<vert>(base(m).vertices_begin(), base(m).vertices_end()); }
  static auto edges(const M& m) { return handles<edge>(base(m).edges_begin(), base(m).edges_end()); }
  static auto polys(const M& m) { return handles<poly>(base(m).facets_begin(), base(m).facets_end()); }
  static auto point(const M&, vert v) { return read_point(v->point()); }

 protected:
  /// Not const, because only a non-const polyhedron returns non-const handles.
  static P& base(const M& m) {
    if constexpr (std::same_as<P, M>) return const_cast<P&>(m);
    else return const_cast<P&>(m.base());
  }
  template<class X, class Iterator>
  static mapped_range<X, Iterator, cgal_descriptor<X>> handles(const Iterator& first, const Iterator& last) {
    return {first, last};
  }
};

}  // namespace concino::detail
