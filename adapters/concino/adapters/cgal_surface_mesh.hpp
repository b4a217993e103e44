// Adapter for CGAL::Surface_mesh, over any type of point, and classes derived from it, as a SurfaceMesh. The
// descriptors are CGAL's own Vertex_index, Edge_index and Face_index.
//
//   CGAL::Surface_mesh<Kernel::Point_3> m = ...;
//   const auto d = cn::dijkstra(m, CGAL::SM_Vertex_index(0));
//
// Stored: nothing. Cost: every ring takes time proportional to its length, as in CGAL; neighbours, ends and indices
// take constant time. Removed elements that wait for collect_garbage() are not part of the mesh: they are skipped, but
// index bounds include them. Property maps of the mesh are maps: map[v] reads and writes. Meshes with points in space
// that can be written are editable: all operators of <concino/edit.hpp> work on them. What CGAL cannot represent is
// refused with the reason. Properties stay at elements that keep their descriptors; new ones have default values, but a
// new edge that takes the descriptor of a removed one also takes its values. No value is interpolated, as property_rule
// says for properties of native meshes: write those of new elements after an edit, which returns them. Transactions
// undo what functions of this library change; removed elements come back with their descriptors and values. Values that
// are written in a transaction are not undone, and redo() gives new elements default values. The first transaction adds
// a property map of edges, "e:concino". garbage_collect(m) changes nothing if memory runs out. If copies of a
// property's values can fail, as of strings, it makes a copy of the mesh before; the mesh becomes that copy if they do
// fail, and property maps obtained before are invalid then. point(m, v) returns the coordinates of CGAL's points as
// doubles. Those of inexact kernels are copied, those of exact kernels are converted by CGAL::to_double. That is exact
// for numbers that are doubles; for others a lazy kernel's relative precision holds, 1e-5 by default. CGAL::to_double
// may evaluate lazy numbers, which is as thread-safe as the kernel. Points in the plane have z = 0. Other types of
// points are returned by reference if they have p[0], p[1], p[2]; a mesh over any other type has no points.
// Needs: CGAL 5.5 (Debian: libcgal-dev).
//        Connectivity that CGAL calls valid, in which no two edges join the same two verts. Euler operations can create
//        such edges; check_laws finds them.
//
// If all polys are known to be triangles, declare this, and algorithms for a TriMesh accept the mesh:
//
//   struct my_mesh : CGAL::Surface_mesh<Point> { ... };
//   template<> struct concino::mesh_traits<my_mesh> : concino::mesh_traits<CGAL::Surface_mesh<Point>> { static
//   constexpr int arity = 3; };
#pragma once

#include <concino/adapters/detail/cgal_compaction.hpp>
#include <concino/adapters/detail/cgal_point.hpp>
#include <concino/adapters/detail/cgal_surface_kernel.hpp>
#include <concino/concepts/editable.hpp>
#include <concino/concepts/halfedge_kernel.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/mesh/element_origins.hpp>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace concino {

namespace detail {

/// Whether an element of one kind was removed.
template<class Mesh, class X>
struct cgal_is_removed {
  const Mesh* m = nullptr;  // null if nothing was removed
  bool operator()(unsigned i) const { return m && m->is_removed(X(i)); }
};

template<class P>
struct cgal_surface_links
    : std::conditional_t<writable_point<P>, halfedge_editing<cgal_surface_kernel<P>, 0>, no_halfedge_editing> {
  using mesh = CGAL::Surface_mesh<P>;
  using vert = typename mesh::Vertex_index;
  using edge = typename mesh::Edge_index;
  using poly = typename mesh::Face_index;
  using halfedge = typename mesh::Halfedge_index;

  static halfedge next(const mesh& m, halfedge h) { return m.next(h); }
  static halfedge opposite(const mesh& m, halfedge h) { return m.opposite(h); }
  static vert target(const mesh& m, halfedge h) { return m.target(h); }
  static bool is_border(const mesh& m, halfedge h) { return m.is_border(h); }
  static poly poly_of(const mesh& m, halfedge h) { return m.face(h); }
  static edge edge_of(const mesh& m, halfedge h) { return m.edge(h); }
  static bool is_isolated(const mesh& m, vert v) { return m.is_isolated(v); }
  static halfedge halfedge_of(const mesh& m, vert v) { return m.opposite(m.halfedge(v)); }
  // Not m.halfedge(e), which differs between equal edges: an edge stores the half-edge from which it was constructed.
  static halfedge halfedge_of(const mesh&, edge e) { return halfedge(2 * e.idx()); }
  static halfedge halfedge_of(const mesh& m, poly p) { return m.halfedge(p); }

  // number_of_vertices() counts existing elements, num_vertices() also removed ones.
  static std::size_t num_verts(const mesh& m) { return m.number_of_vertices(); }
  static std::size_t num_edges(const mesh& m) { return m.number_of_edges(); }
  static std::size_t num_polys(const mesh& m) { return m.number_of_faces(); }
  static std::size_t vert_index_bound(const mesh& m) { return m.num_vertices(); }
  static std::size_t edge_index_bound(const mesh& m) { return m.num_edges(); }
  static std::size_t poly_index_bound(const mesh& m) { return m.num_faces(); }
  static auto verts(const mesh& m) { return existing<vert>(m, m.num_vertices()); }
  static auto edges(const mesh& m) { return existing<edge>(m, m.num_edges()); }
  static auto polys(const mesh& m) { return existing<poly>(m, m.num_faces()); }
  static std::size_t index_of(const mesh&, vert v) { return v.idx(); }
  static std::size_t index_of(const mesh&, edge e) { return e.idx(); }
  static std::size_t index_of(const mesh&, poly p) { return p.idx(); }
  static bool contains(const mesh& m, vert v) { return v.idx() < m.num_vertices() && !m.is_removed(v); }
  static bool contains(const mesh& m, edge e) { return e.idx() < m.num_edges() && !m.is_removed(e); }
  static bool contains(const mesh& m, poly p) { return p.idx() < m.num_faces() && !m.is_removed(p); }

  static decltype(auto) point(const mesh& m, vert v) requires readable_point<P> { return read_point(m.point(v)); }
  template<class X>
    requires writable_point<P>
  static void set_point(mesh& m, vert v, const X& x) {
    if (auto* const recorder = halfedge_recorder_of<kernel>(m)) recorder->save_point(v.idx());
    assign_point(m.point(v), x);
  }

  static poly add_poly(mesh& m, std::span<const vert> corners) {
    constexpr auto cannot_be_linked =
        "cannot be linked: in CGAL::Surface_mesh at most two polys share an edge, in opposite directions, each vert of a new poly is on the boundary, and a closed fan is the only one at its vert";
    const auto refuse = [&](const std::string& why) {
      core::throw_joined<invalid_mesh>({"add_poly: poly ", m.num_faces(), " ", why});
    };
    if (corners.size() < 3) refuse(core::joined({"has ", corners.size(), " verts; it needs at least 3"}));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (!contains(m, corners[i]))
        refuse(core::joined({"names vert ", corners[i].idx(), ", which is not in the mesh"}));
      if (std::find(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(i), corners[i]) !=
          corners.begin() + static_cast<std::ptrdiff_t>(i))
        refuse(core::joined({"has vert ", corners[i].idx(), " twice; its verts must differ"}));
    }
    if constexpr (writable_point<P>)
      if (halfedge_recorder_of<kernel>(m)) try {
          return add_poly_by_rewire(m, corners);
        } catch (const unsupported&) {
          refuse(cannot_be_linked);
        }
    if (closes_one_of_several_fans(m, corners)) refuse(cannot_be_linked);
    auto* const before = kernel::find_edits(m);
    kernel::reserve(m, 0, static_cast<unsigned>(corners.size()), 1, false);
    const poly p = m.add_face(corners);
    if (p == mesh::null_face()) refuse(cannot_be_linked);
    concino::detail::count_edit(before);
    return p;
  }
  static void remove_poly(mesh& m, poly p)
    requires writable_point<P>
  {
    remove_poly_by_rewire(m, p);
  }
  static void remove_vert(mesh& m, vert v) {
    if constexpr (writable_point<P>) return remove_vert_by_rewire(m, v);
    m.remove_vertex(v);
  }

  static correspondence garbage_collect(mesh& m) {
    if (halfedge_recorder_of<kernel>(m)) refuse_garbage_collection();
    cgal_compaction<P> compaction(m);
    compaction.make();
    concino::detail::count_edit(kernel::find_edits(m));  // CGAL may have lost the edits
    return compaction.origins();
  }

 private:
  using kernel = cgal_surface_kernel<P>;

  template<class X>
  static skipping_range<X, cgal_is_removed<mesh, X>> existing(const mesh& m, unsigned bound) {
    return {bound, {m.has_garbage() ? &m : nullptr}};
  }

  /// Whether a new poly would close a fan at a vert that has another one too. CGAL's add_face does not see that, and
  /// loses the other fan.
  static bool closes_one_of_several_fans(const mesh& m, std::span<const vert> corners) {
    for (std::size_t i = 0, n = corners.size(); i < n; ++i) {
      if (m.is_isolated(corners[i])) continue;
      const halfedge in = m.halfedge(corners[(i + n - 1) % n], corners[i]),
                     out = m.halfedge(corners[i], corners[(i + 1) % n]);
      if (in == mesh::null_halfedge() || out == mesh::null_halfedge() || !m.is_border(in) || !m.is_border(out) ||
          m.next(in) == out)
        continue;
      halfedge last = m.opposite(out);
      do last = m.opposite(m.next(last));
      while (!m.is_border(last));
      if (last == in) return true;
    }
    return false;
  }
};

template<class P> std::type_identity<P> point_of_cgal_surface_mesh(const CGAL::Surface_mesh<P>*);
template<class M> concept is_cgal_surface_mesh = requires(const M* m) { detail::point_of_cgal_surface_mesh(m); };

}  // namespace detail

/// For all classes that are, or derive from, a CGAL::Surface_mesh<P>.
template<class M>
  requires detail::is_cgal_surface_mesh<M>
struct mesh_traits<M>
    : mesh_traits<
          CGAL::Surface_mesh<typename decltype(detail::point_of_cgal_surface_mesh(std::declval<const M*>()))::type>> {
};

template<class P>
struct mesh_traits<CGAL::Surface_mesh<P>> : halfedge_kernel<CGAL::Surface_mesh<P>, detail::cgal_surface_links<P>> {};

static_assert(EditableSurfaceMesh<CGAL::Surface_mesh<vec3>> && SurfaceMesh<CGAL::Surface_mesh<int>>);

}  // namespace concino
