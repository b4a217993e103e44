// Models: CGAL's Surface_mesh, and its Polyhedron_3 with ids in its items and through indexed().
#pragma once

#include <concino/adapters/cgal_polyhedron.hpp>
#include <concino/adapters/cgal_surface_mesh.hpp>

#include <agreement/run.hpp>

#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

namespace concino::agreement {

using cgal_kernel = CGAL::Simple_cartesian<double>;
inline cgal_kernel::Point_3 to_cgal(const vec3& x) { return {x.x, x.y, x.z}; }

template<class K>
struct cgal_surface_mesh {
  using kind = K;
  static constexpr const char* column = "CGAL::Surface_mesh";
  static constexpr const char* name = polys_of_kind<K>;
  static constexpr bool any_surface = false, gaps = true;

  template<class F>
  static void with(const input<surface_arrays>& in, F&& f) {
    using M = CGAL::Surface_mesh<cgal_kernel::Point_3>;
    M m;
    const K n(in.arrays);
    for (const auto v : verts(n)) m.add_vertex(to_cgal(point(n, v)));
    for (const auto p : polys(n)) {
      std::vector<M::Vertex_index> ring;
      for (const auto v : adj_p2v(n, p)) ring.emplace_back(v.raw());
      m.add_face(ring);
    }
    for (const unsigned p : in.gone_polys) CGAL::Euler::remove_face(m.halfedge(M::Face_index(p)), m);
    for (const unsigned v : in.gone_verts)
      if (!m.is_removed(M::Vertex_index(v))) m.remove_vertex(M::Vertex_index(v));
    f(std::as_const(m));
  }
};

/// Adds the points and polys through CGAL's incremental builder.
template<class K, class P>
struct cgal_builder : CGAL::Modifier_base<typename P::HalfedgeDS> {
  const K& n;
  explicit cgal_builder(const K& m) : n(m) {}
  void operator()(typename P::HalfedgeDS& hds) override {
    CGAL::Polyhedron_incremental_builder_3<typename P::HalfedgeDS> b(hds, true);
    b.begin_surface(num_verts(n), num_polys(n));
    for (const auto v : verts(n)) b.add_vertex(to_cgal(point(n, v)));
    for (const auto p : polys(n)) {
      b.begin_facet();
      for (const auto v : adj_p2v(n, p)) b.add_vertex_to_facet(v.raw());
      b.end_facet();
    }
    b.end_surface();
  }
};

template<class K, bool Ids>
struct cgal_polyhedron {
  using kind = K;
  static constexpr const char* column = "CGAL::Polyhedron_3";
  static constexpr const char* name = polys_of_kind<K>;
  static constexpr bool any_surface = false, gaps = false;

  template<class F>
  static void with(const input<surface_arrays>& in, F&& f) {
    const K n(in.arrays);
    if constexpr (Ids) {
      using P = CGAL::Polyhedron_3<cgal_kernel, CGAL::Polyhedron_items_with_id_3>;
      P m;
      cgal_builder<K, P> builder(n);
      m.delegate(builder);
      CGAL::set_halfedgeds_items_id(m);
      f(std::as_const(m));
    } else {
      using P = CGAL::Polyhedron_3<cgal_kernel>;
      P m;
      cgal_builder<K, P> builder(n);
      m.delegate(builder);
      const auto view = indexed(m);
      f(view);
    }
  }
};

using cgal_meshes = models<cgal_surface_mesh<trimesh>, cgal_surface_mesh<polygonmesh>, cgal_polyhedron<trimesh, true>, cgal_polyhedron<polygonmesh, false>>;

}  // namespace concino::agreement
