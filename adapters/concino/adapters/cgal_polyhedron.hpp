// Adapter for CGAL::Polyhedron_3 and classes derived from it, as a SurfaceMesh: directly if the items have ids, else
// through indexed(m).
//
//   CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3> p = ...;
//   CGAL::set_halfedgeds_items_id(p);                                    // after the last change of its connectivity
//   const auto d = cn::dijkstra(p, p.vertices_begin());
//
//   CGAL::Polyhedron_3<Kernel> q = ...;
//   const auto i = cn::indexed(q);                                       // q has no ids; verts(q), adj_v2v(q, v),
//   point(q, v) work without const auto d = cn::dijkstra(i, q.vertices_begin());
//
// Descriptors are CGAL's own, those of boost::graph_traits: Vertex_handle, Facet_handle, and for edges a half-edge that
// equals its opposite. They are handles, not const handles, even for a const mesh, as everywhere in CGAL's graphs;
// nothing is changed through them. Stored: nothing in the mesh, and no data of the mesh anywhere; see indexed(). Cost:
// rings take time proportional to their length. point(m, v) returns doubles, as
// <concino/adapters/cgal_surface_mesh.hpp> says. Property maps, as get(CGAL::vertex_point, m), become maps by
// as_map(pm) of <concino/graph/property_map.hpp>.
// Needs: CGAL 5.5 (Debian: libcgal-dev).
//        Ids as CGAL::set_halfedgeds_items_id sets them: 0, 1, 2 ... in the order of the elements. Without them, or
//        after elements were added or erased, index bounds throw invalid_mesh, and so do all functions that make a map.
//        No two edges join the same two verts.
#pragma once

#include <concino/adapters/detail/cgal_polyhedron_links.hpp>
#include <concino/concepts/halfedge_kernel.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>

#include <CGAL/Unique_hash_map.h>

#include <cstdint>
#include <memory>

namespace concino {

namespace detail {

template<class P>
concept has_ids = requires(const typename P::Vertex& v, const typename P::Halfedge& h, const typename P::Facet& f) {
  { v.id() } -> std::convertible_to<std::size_t>;
  { h.id() } -> std::convertible_to<std::size_t>;
  { f.id() } -> std::convertible_to<std::size_t>;
};

/// Indices are the ids of the items.
template<class P>
struct cgal_polyhedron_ids : cgal_polyhedron_links<P> {
  using base = cgal_polyhedron_links<P>;
  using typename base::edge;
  using typename base::poly;
  using typename base::vert;

  static std::size_t vert_index_bound(const P& m) { return bound(m.size_of_vertices(), m.vertices_end(), "vert"); }
  static std::size_t poly_index_bound(const P& m) { return bound(m.size_of_facets(), m.facets_end(), "facet"); }
  static std::size_t edge_index_bound(const P& m) {
    vert_index_bound(m);
    poly_index_bound(m);  // edges are added and erased with verts and facets, but normalize_border() may reorder them
    return m.size_of_halfedges() / 2;
  }
  static std::size_t index_of(const P&, vert v) { return v->id(); }
  static std::size_t index_of(const P&, edge e) { return e.halfedge()->id() / 2; }
  static std::size_t index_of(const P&, poly p) { return p->id(); }
  static bool contains(const P& m, vert v) { return v != vert() && v->id() < m.size_of_vertices(); }
  static bool contains(const P& m, edge e) { return e != edge() && e.halfedge()->id() < m.size_of_halfedges(); }
  static bool contains(const P& m, poly p) { return p != poly() && p->id() < m.size_of_facets(); }

 private:
  /// Checks one id, which is enough: new elements are the last ones and copy the id of another one or have none, and
  /// after an erasure the id of the last one is too large.
  template<class Iterator>
  static std::size_t bound(std::size_t size, Iterator end, const char* kind) {
    if (size > 0 && (--end)->id() != size - 1)
      core::throw_joined<invalid_mesh>({"CGAL::Polyhedron_3: the ids of the ", kind,
                                          "s are not 0, 1, 2, ... in their order; call "
                                          "CGAL::set_halfedgeds_items_id(m) after changes of connectivity"});
    return size;
  }
};

/// Verts and facets have a half-edge, and half-edges have a vert and a facet, as for all items of CGAL except
/// Polyhedron_min_items_3.
template<class P>
concept has_all_links = P::Supports_vertex_halfedge::value && P::Supports_face_halfedge::value &&
    P::Supports_halfedge_vertex::value && P::Supports_halfedge_face::value;

template<class T, class I, template<class, class, class> class H, class A>
std::type_identity<CGAL::Polyhedron_3<T, I, H, A>> base_of_cgal_polyhedron(const CGAL::Polyhedron_3<T, I, H, A>*);
template<class M> concept is_cgal_polyhedron =
    requires(const M* m) { requires has_all_links<typename decltype(detail::base_of_cgal_polyhedron(m))::type>; };

template<class P>
struct cgal_polyhedron_traits
    : halfedge_kernel<P, std::conditional_t<has_ids<P>, cgal_polyhedron_ids<P>, cgal_polyhedron_links<P>>> {
  template<class X>
  static void set_point(P&, typename P::Vertex_handle v, const X& x) { assign_point(v->point(), x); }
};

}  // namespace detail

/// For all classes that are, or derive from, a CGAL::Polyhedron_3.
template<detail::is_cgal_polyhedron M>
struct mesh_traits<M> : detail::cgal_polyhedron_traits<typename decltype(detail::base_of_cgal_polyhedron(
                            static_cast<const M*>(nullptr)))::type> {};

namespace views {

/// A polyhedron P with a number for each of its handles.
template<class P>
class indexed_polyhedron {
  template<class X>
  class table {
    CGAL::Unique_hash_map<X, std::uint32_t> number_;

   public:
    template<class R>
    table(std::size_t size, const R& elements) : number_(~std::uint32_t{0}, size) {
      std::uint32_t i = 0;
      for (const X x : elements) number_[x] = i++;
    }
    std::size_t operator[](const X& x) const { return number_[x]; }
  };
  using links = mesh_traits<P>;
  struct tables {
    table<vert_t<P>> verts;
    table<edge_t<P>> edges;
    table<poly_t<P>> polys;
  };

  const P* m_;
  std::shared_ptr<const tables> tables_;

 public:
  explicit indexed_polyhedron(const P& m)
      : m_(&m), tables_(new tables{{links::num_verts(m), links::verts(m)},
                                   {links::num_edges(m), links::edges(m)},
                                   {links::num_polys(m), links::polys(m)}}) {}
  const P& base() const { return *m_; }
  std::size_t number_of(const vert_t<P>& v) const { return tables_->verts[v]; }
  std::size_t number_of(const edge_t<P>& e) const { return tables_->edges[e]; }
  std::size_t number_of(const poly_t<P>& p) const { return tables_->polys[p]; }
};

}  // namespace views

namespace detail {

template<class P>
struct indexed_polyhedron_links : cgal_polyhedron_links<P, views::indexed_polyhedron<P>> {
  using view = views::indexed_polyhedron<P>;
  using base = cgal_polyhedron_links<P, view>;
  static std::size_t vert_index_bound(const view& m) { return base::num_verts(m); }
  static std::size_t edge_index_bound(const view& m) { return base::num_edges(m); }
  static std::size_t poly_index_bound(const view& m) { return base::num_polys(m); }
  template<class X>
  static std::size_t index_of(const view& m, const X& x) requires requires {
    m.number_of(x);
  }
  { return m.number_of(x); }
  template<class X> static bool contains(const view& m, const X& x) requires requires { m.number_of(x); } {
    return x != X() && m.number_of(x) != ~std::uint32_t{0};
  }
};

}  // namespace detail

template<class P>
struct mesh_traits<views::indexed_polyhedron<P>>
    : halfedge_kernel<views::indexed_polyhedron<P>, detail::indexed_polyhedron_links<P>> {
  static constexpr bool is_view = true;
};

/// A polyhedron whose items need no ids, as a SurfaceMesh.
/// Needs:  m: any Polyhedron_3 or a class derived from it; it must outlive the view, so a temporary one is refused. Its
///         connectivity must not change while the view is used; points may.
/// Result: a SurfaceMesh with the descriptors of m. Indices follow the order of verts, edges and facets in m.
/// Cost:   O(V + E + F) time, and hash tables of 36 to 72 bytes per vert, edge and facet, which copies share; none of
///         m's data. Every index_of is a table look-up.
/// Errors: none of its own.
template<detail::is_cgal_polyhedron M>
auto indexed(const M& m) {
  return views::indexed_polyhedron<typename decltype(detail::base_of_cgal_polyhedron(&m))::type>(m);
}
template<detail::is_cgal_polyhedron M>
void indexed(const M&& m) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
