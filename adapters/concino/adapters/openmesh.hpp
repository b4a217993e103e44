// Adapter for OpenMesh: every polygon and triangle mesh of OpenMesh, whatever its traits, and every class derived from one,
// is a SurfaceMesh. The descriptors are OpenMesh's own handles, and nothing is copied. as_map(mesh, handle) makes a map of a property.
//
// Elements that are deleted but not yet collected as garbage are skipped; hidden ones are not, since hiding concerns only display. num_verts and
// its siblings count what is left, in time proportional to all. Polys that touch only at a vert are all in the rings of that vert, since
// OpenMesh links their borders. OpenMesh cannot represent edges of more than two polys.
// Needs: OpenMesh (Debian: libopenmesh-dev).
#pragma once

#include <concino/adapters/detail/openmesh_links.hpp>
#include <concino/adapters/detail/openmesh_numbers.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/vec3.hpp>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <cassert>
#include <concepts>
#include <span>
#include <type_traits>

namespace concino {

template<std::derived_from<OpenMesh::PolyConnectivity> M>
struct mesh_traits<M> : halfedge_kernel<OpenMesh::PolyConnectivity, detail::openmesh_links> {
  using vert = OpenMesh::VertexHandle;
  using poly = OpenMesh::FaceHandle;
  static constexpr int arity = std::derived_from<M, OpenMesh::TriConnectivity> ? 3 : 0;

  // Points may be of any type with x[0], x[1], x[2]; those of the plane have z = 0.
  static decltype(auto) point(const M& m, vert v) requires(detail::openmesh_coordinates<M> >= 3) { return m.point(v); }
  static vec3 point(const M& m, vert v) requires(detail::openmesh_coordinates<M> == 2) { return {m.point(v)[0], m.point(v)[1], 0}; }
  template<class X>
    requires(detail::openmesh_coordinates<M> >= 3)
  static void set_point(M& m, vert v, const X& x) {
    using scalar = typename OpenMesh::vector_traits<typename M::Point>::value_type;
    typename M::Point p = m.point(v);
    p[0] = static_cast<scalar>(x[0]);
    p[1] = static_cast<scalar>(x[1]);
    p[2] = static_cast<scalar>(x[2]);
    m.set_point(v, p);
  }

  static vert add_vert(M& m, const vec3& x) requires(detail::openmesh_coordinates<M> >= 3) {
    const vert v = m.OpenMesh::PolyConnectivity::add_vertex();
    set_point(m, v, x);
    return v;
  }
  static poly add_poly(M& m, std::span<const vert> corners) {
    detail::check_openmesh_poly(m, corners, arity);
    const poly p = m.OpenMesh::PolyConnectivity::add_face(corners.data(), corners.size());
    assert(p.is_valid() && "check_openmesh_poly has refused the polys that OpenMesh refuses");
    return p;
  }
  // OpenMesh deletes by status attributes. If the mesh has none, they are requested, as users of OpenMesh do themselves.
  static void reserve_removal(M& m, std::span<const poly>) {
    request_vert_status(m);
    request_status(m);
  }
  static void remove_poly(M& m, poly p) {
    request_status(m);
    m.OpenMesh::PolyConnectivity::delete_face(p, false);
  }
  static void remove_vert(M& m, vert v) {
    request_vert_status(m);
    m.status(v).set_deleted(true);  // as delete_vertex does for a vert without polys, which allocates memory for none
  }
  // If memory runs out in OpenMesh's own function, it may leave an incomplete mesh.
  static correspondence garbage_collect(M& m) {
    using base = mesh_traits<M>;
    detail::openmesh_numbers<OpenMesh::VPropHandleT<int>> of_verts(m, m.n_vertices());
    detail::openmesh_numbers<OpenMesh::EPropHandleT<int>> of_edges(m, m.n_edges());
    detail::openmesh_numbers<OpenMesh::FPropHandleT<int>> of_polys(m, m.n_faces());
    m.OpenMesh::ArrayKernel::garbage_collection();
    return {of_verts.origins(base::verts(m), m.n_vertices()), of_edges.origins(base::edges(m), m.n_edges()), {}, of_polys.origins(base::polys(m), m.n_faces())};
  }

 private:
  // OpenMesh counts a failed request as successful and leaves the attribute incomplete. So it is released then, and the next request
  // starts again. Each attribute is requested separately, since there may be memory for one and not for the other.
  template<class Request, class Release>
  static void request_or_release(bool has, const Request& request, const Release& release) {
    if (has) return;
    try {
      request();
    } catch (...) {
      release();
      throw;
    }
  }
  static void request_vert_status(M& m) {
    request_or_release(m.has_vertex_status(), [&] { m.request_vertex_status(); }, [&] { m.release_vertex_status(); });
  }
  static void request_status(M& m) {
    request_or_release(m.has_edge_status(), [&] { m.request_edge_status(); }, [&] { m.release_edge_status(); });
    request_or_release(m.has_face_status(), [&] { m.request_face_status(); }, [&] { m.release_face_status(); });
  }
};

/// A property of an OpenMesh mesh as a map. Copies of it are the same map.
template<class Handle, class Property>
class openmesh_map {
  Property* property_;

 public:
  using key_type = Handle;
  using value_type = typename Property::value_type;

  explicit openmesh_map(Property& p) : property_(&p) {}
  decltype(auto) operator[](Handle x) const { return (*property_)[x.idx()]; }
};

namespace requirement {

template<class P> concept is_openmesh_property = std::same_as<P, OpenMesh::VPropHandleT<typename P::Value>> ||
    std::same_as<P, OpenMesh::EPropHandleT<typename P::Value>> || std::same_as<P, OpenMesh::FPropHandleT<typename P::Value>>;

}  // namespace requirement

/// A property of verts, edges or faces as a map, u = as_map(m, handle): u[v] is the mesh's own value, writable unless m is
/// const. An OpenMesh::PropertyManager is already such a map.
/// Needs:  the property stays in the mesh while the map is used.
/// Result: a map by the handles of verts, edges or faces. Copies of it are the same map.
/// Cost:   none; nothing is copied.
/// Errors: invalid_argument if the handle belongs to no property.
template<std::derived_from<OpenMesh::BaseKernel> M, requirement::is_openmesh_property P>
auto as_map(M& m, const P& handle) {
  if (!handle.is_valid()) throw invalid_argument("as_map: the property handle is not valid; add the property to the mesh first");
  auto& property = m.property(handle);
  return openmesh_map<typename P::Handle, std::remove_reference_t<decltype(property)>>(property);
}

static_assert(SurfaceMesh<OpenMesh::PolyConnectivity> && TriMesh<OpenMesh::TriConnectivity>);
static_assert(SurfaceMesh<OpenMesh::PolyMesh_ArrayKernelT<>> && MutablePoints<OpenMesh::PolyMesh_ArrayKernelT<>>);
static_assert(TriMesh<OpenMesh::TriMesh_ArrayKernelT<>> && MutablePoints<OpenMesh::TriMesh_ArrayKernelT<>>);

}  // namespace concino
