// How `rewire` changes the half-edges of a CGAL::Surface_mesh; see halfedge_edge_plan.hpp.
#pragma once

#include <concino/adapters/detail/cgal_point.hpp>
#include <concino/adapters/detail/halfedge_recorder.hpp>

#include <CGAL/Surface_mesh.h>

#include <bit>

namespace concino::detail {

template<class P>
struct cgal_surface_kernel {
  using mesh = CGAL::Surface_mesh<P>;
  using vert = typename mesh::Vertex_index;
  using edge = typename mesh::Edge_index;
  using poly = typename mesh::Face_index;
  using halfedge = typename mesh::Halfedge_index;
  static constexpr unsigned none = ~0u;  // also the index of CGAL's null elements
  static constexpr char two_polys[] = "in CGAL::Surface_mesh at most two polys share an edge, in opposite directions";
  static constexpr char one_closed_fan[] = "in CGAL::Surface_mesh a closed fan of polys is the only one at its vert";
  static constexpr char one_edge[] = "two edges of the mesh join the same verts";

  static unsigned index(vert v) { return v.idx(); }
  static unsigned index(poly p) { return p.idx(); }
  static vert vert_at(unsigned i) { return vert(i); }
  static poly poly_at(unsigned i) { return poly(i); }
  static bool contains(const mesh& m, vert v) { return v.idx() < m.num_vertices() && !m.is_removed(v); }
  static bool contains(const mesh& m, poly p) { return p.idx() < m.num_faces() && !m.is_removed(p); }

  static unsigned next(const mesh& m, unsigned h) { return m.next(halfedge(h)).idx(); }
  static unsigned target(const mesh& m, unsigned h) { return m.target(halfedge(h)).idx(); }
  static unsigned poly_of(const mesh& m, unsigned h) { return m.face(halfedge(h)).idx(); }
  static unsigned halfedge_from(const mesh& m, unsigned v) { return opposite(m.halfedge(vert(v)).idx()); }
  static unsigned halfedge_of(const mesh& m, unsigned p) { return m.halfedge(poly(p)).idx(); }
  static unsigned num_verts(const mesh& m) { return m.num_vertices(); }
  static unsigned num_edges(const mesh& m) { return m.num_edges(); }
  static unsigned num_polys(const mesh& m) { return m.num_faces(); }

  static void set_next(mesh& m, unsigned h, unsigned g) { m.set_next(halfedge(h), halfedge(g)); }
  static void set_target(mesh& m, unsigned h, unsigned v) { m.set_target(halfedge(h), vert(v)); }
  static void set_poly(mesh& m, unsigned h, unsigned p) { m.set_face(halfedge(h), poly(p)); }
  static void set_halfedge_from(mesh& m, unsigned v, unsigned h) { m.set_halfedge(vert(v), halfedge(opposite(h))); }
  static void set_halfedge_of(mesh& m, unsigned p, unsigned h) { m.set_halfedge(poly(p), halfedge(h)); }

  static void reserve(mesh& m, unsigned verts, unsigned edges, unsigned polys, bool) {
    if (verts + edges + polys > 0)
      m.reserve(grown(m.num_vertices(), verts), grown(m.num_edges(), edges), grown(m.num_faces(), polys));
  }
  static unsigned add_vert(mesh& m) { return m.add_vertex().idx(); }
  static unsigned add_edge(mesh& m) { return m.add_edge().idx() >> 1; }
  static unsigned add_poly(mesh& m) { return m.add_face().idx(); }
  static void remove_vert(mesh& m, unsigned v) { m.remove_vertex(vert(v)); }
  static void remove_edge(mesh& m, unsigned e) { m.remove_edge(edge(e)); }
  static void remove_poly(mesh& m, unsigned p) { m.remove_face(poly(p)); }

  using point = P;
  struct points {};
  using edits = halfedge_edits<cgal_surface_kernel>;
  static constexpr char name_of_edits[] = "e:concino";  // so short that a std::string needs no memory

  static points find_points(mesh&) { return {}; }
  static P& point_of(mesh& m, points, unsigned v) { return m.point(vert(v)); }
  template<class X> static void assign_point(P& p, const X& x) { detail::assign_point(p, x); }

  // CGAL::Surface_mesh has no properties of the whole mesh, so this is the property of the edge with index 0.
  static edits* find_edits(mesh& m) {
    if (m.num_edges() == 0) return nullptr;
    const auto found = m.template property_map<edge, uncopied<edits>>(name_of_edits);
    return found.second ? found.first[edge(0)].get() : nullptr;
  }
  static edits& edits_of(mesh& m) {
    if (m.num_edges() == 0) remove_edge(m, add_edge(m));
    return m.template add_property_map<edge, uncopied<edits>>(name_of_edits).first[edge(0)].get_or_make();
  }

  static void resize(mesh& m, unsigned verts, unsigned edges, unsigned polys) { m.resize(verts, edges, polys); }
  static bool is_removed_vert(const mesh& m, unsigned v) { return m.is_removed(vert(v)); }
  static bool is_removed_edge(const mesh& m, unsigned e) { return m.is_removed(edge(e)); }
  static bool is_removed_poly(const mesh& m, unsigned p) { return m.is_removed(poly(p)); }
  static bool set_recycling(mesh& m, bool now) {
    const bool before = m.does_recycle_garbage();
    m.set_recycle_garbage(now);
    return before;
  }
  static void revive(mesh& m, removed_elements verts, removed_elements edges, removed_elements polys) {
    const bool was_recycling = m.does_recycle_garbage();
    revive_kind<vert_list>(m, verts);
    revive_kind<edge_list>(m, edges);
    revive_kind<poly_list>(m, polys);
    m.set_recycle_garbage(was_recycling);
  }
  /// No element is a removed one any more. Before: the last elements of each kind are the removed ones.
  static void forget_removed(mesh& m) noexcept {
    const bool was_recycling = m.does_recycle_garbage();
    m.set_recycle_garbage(true);
    forget_removed_of_kind<vert_list>(m, m.number_of_removed_vertices(), m.num_vertices());
    forget_removed_of_kind<edge_list>(m, m.number_of_removed_edges(), m.num_edges());
    forget_removed_of_kind<poly_list>(m, m.number_of_removed_faces(), m.num_faces());
    m.set_recycle_garbage(was_recycling);
  }

 private:
  // CGAL links removed elements of a kind to a list, whose first one is private. The link of an element is stored in
  // its connectivity.
  struct vert_list {
    using key = vert;
    static constexpr char name[] = "v:removed";
    static unsigned link(const mesh& m, unsigned v) { return m.halfedge(vert(v)).idx(); }
    static void set_link(mesh& m, unsigned v, unsigned next) { m.set_halfedge(vert(v), halfedge(next)); }
    static unsigned value(unsigned v) { return v; }
    static unsigned add(mesh& m) { return add_vert(m); }
    static void remove(mesh& m, unsigned v) { remove_vert(m, v); }
  };
  struct edge_list {
    using key = edge;
    static constexpr char name[] = "e:removed";
    static unsigned link(const mesh& m, unsigned e) { return m.next(halfedge(2 * e)).idx(); }
    static void set_link(mesh& m, unsigned e, unsigned next) { m.set_next_only(halfedge(2 * e), halfedge(next)); }
    static unsigned value(unsigned e) { return 2 * e; }
    static unsigned add(mesh& m) { return add_edge(m); }
    static void remove(mesh& m, unsigned e) { remove_edge(m, e); }
  };
  struct poly_list {
    using key = poly;
    static constexpr char name[] = "f:removed";
    static unsigned link(const mesh& m, unsigned p) { return m.halfedge(poly(p)).idx(); }
    static void set_link(mesh& m, unsigned p, unsigned next) { m.set_halfedge(poly(p), halfedge(next)); }
    static unsigned value(unsigned p) { return p; }
    static unsigned add(mesh& m) { return add_poly(m); }
    static void remove(mesh& m, unsigned p) { remove_poly(m, p); }
  };
  // To add an element, CGAL takes the first one of the list, and sets its properties to default values. The values of
  // revived elements must stay, so a new element, which refers to itself, is taken from the list once for each of them.
  template<class List>
  static void revive_kind(mesh& m, removed_elements removed) {
    if (removed.empty()) return;
    const unsigned rest = List::link(m, removed[0]);
    m.set_recycle_garbage(false);
    const unsigned x = List::add(m);
    List::remove(m, x);
    m.set_recycle_garbage(true);
    for (std::size_t i = 0; i < removed.size(); ++i) List::set_link(m, x, List::value(x)), List::add(m);
    List::set_link(m, x, rest);
    List::add(m);
    const auto flags = m.template property_map<typename List::key, bool>(List::name).first;
    for (const unsigned i : removed) flags[typename List::key(i)] = false;
  }
  // Adds the last element as often as elements were removed. It is removed once more before, which makes it the first
  // one of the list.
  template<class List>
  static void forget_removed_of_kind(mesh& m, unsigned removed, unsigned bound) noexcept {
    if (removed == 0) return;
    const unsigned x = bound - 1;
    List::remove(m, x);
    for (unsigned i = 0; i <= removed; ++i) {
      List::set_link(m, x, i < removed ? List::value(x) : none);
      try {
        List::add(m);
      } catch (...) {  // a default value of x cannot be copied; it is not needed
      }
    }
  }
  static unsigned opposite(unsigned h) { return h == none ? none : h ^ 1; }
  // In powers of two, so that the arrays grow rarely.
  static unsigned grown(unsigned n, unsigned more) { return more == 0 ? 0 : std::bit_ceil(n + more); }
};

}  // namespace concino::detail
