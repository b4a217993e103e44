// How `rewire` changes the half-edges of an OpenMesh mesh; see halfedge_edge_plan.hpp.
#pragma once

#include <concino/adapters/detail/halfedge_recorder.hpp>
#include <concino/adapters/detail/openmesh_links.hpp>

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>

#include <bit>
#include <type_traits>

namespace concino::detail {

/// Requests the status attributes of OpenMesh, by which it deletes. OpenMesh counts a failed request as successful and
/// leaves the attribute incomplete. So it is released then, and the next request starts again. Each attribute is
/// requested separately, since there may be memory for one and not for the other.
struct openmesh_status {
  using mesh = OpenMesh::PolyConnectivity;

  template<class Request, class Release>
  static bool request_or_release(bool has, const Request& request, const Release& release) {
    if (has) return false;
    try {
      request();
    } catch (...) {
      release();
      throw;
    }
    return true;
  }
  static void request_of_verts(mesh& m) {
    request_or_release(m.has_vertex_status(), [&] { m.request_vertex_status(); }, [&] { m.release_vertex_status(); });
  }
  static void request_of_edges_and_polys(mesh& m) {
    const bool is_first = request_or_release(
        m.has_edge_status(), [&] { m.request_edge_status(); }, [&] { m.release_edge_status(); });
    if (is_first && m.has_face_status())  // until now, an edge without faces was a deleted one
      for (const auto e : openmesh_elements<OpenMesh::EdgeHandle>(m, m.OpenMesh::ArrayKernel::n_edges()))
        if (m.is_boundary(m.halfedge_handle(e, 0)) && m.is_boundary(m.halfedge_handle(e, 1)))
          m.status(e).set_deleted(true);
    request_or_release(m.has_face_status(), [&] { m.request_face_status(); }, [&] { m.release_face_status(); });
  }
};

/// The operations that do not depend on the points.
struct openmesh_elements_kernel {
  using mesh = OpenMesh::PolyConnectivity;
  using vert = OpenMesh::VertexHandle;
  using edge = OpenMesh::EdgeHandle;
  using poly = OpenMesh::FaceHandle;
  using halfedge = OpenMesh::HalfedgeHandle;
  static constexpr unsigned none = ~0u;
  static constexpr char two_polys[] = "in OpenMesh at most two polys share an edge, in opposite directions";
  static constexpr char one_closed_fan[] = "in OpenMesh a closed fan of polys is the only one at its vert";
  static constexpr char one_edge[] = "two edges of the mesh join the same verts";

 private:
  // the invalid handle is `none`
  static unsigned number(OpenMesh::BaseHandle x) { return static_cast<unsigned>(x.idx()); }
  template<class Handle>
  static Handle handle(unsigned i) { return Handle(static_cast<int>(i)); }
  // In powers of two, so that the arrays grow rarely.
  static std::size_t grown(std::size_t n, unsigned more) { return more == 0 ? 0 : std::bit_ceil(n + more); }

 public:
  static unsigned index(vert v) { return number(v); }
  static unsigned index(poly p) { return number(p); }
  static vert vert_at(unsigned i) { return handle<vert>(i); }
  static poly poly_at(unsigned i) { return handle<poly>(i); }
  static bool contains(const mesh& m, vert v) { return openmesh_links::contains(m, v); }
  static bool contains(const mesh& m, poly p) { return openmesh_links::contains(m, p); }

  static unsigned next(const mesh& m, unsigned h) { return number(m.next_halfedge_handle(handle<halfedge>(h))); }
  static unsigned target(const mesh& m, unsigned h) { return number(m.to_vertex_handle(handle<halfedge>(h))); }
  static unsigned poly_of(const mesh& m, unsigned h) { return number(m.face_handle(handle<halfedge>(h))); }
  static unsigned halfedge_from(const mesh& m, unsigned v) { return number(m.halfedge_handle(handle<vert>(v))); }
  static unsigned halfedge_of(const mesh& m, unsigned p) { return number(m.halfedge_handle(handle<poly>(p))); }
  static unsigned num_verts(const mesh& m) { return static_cast<unsigned>(m.OpenMesh::ArrayKernel::n_vertices()); }
  static unsigned num_edges(const mesh& m) { return static_cast<unsigned>(m.OpenMesh::ArrayKernel::n_edges()); }
  static unsigned num_polys(const mesh& m) { return static_cast<unsigned>(m.OpenMesh::ArrayKernel::n_faces()); }

  static void set_next(mesh& m, unsigned h, unsigned g) {
    m.set_next_halfedge_handle(handle<halfedge>(h), handle<halfedge>(g));
  }
  static void set_target(mesh& m, unsigned h, unsigned v) { m.set_vertex_handle(handle<halfedge>(h), handle<vert>(v)); }
  static void set_poly(mesh& m, unsigned h, unsigned p) { m.set_face_handle(handle<halfedge>(h), handle<poly>(p)); }
  static void set_halfedge_from(mesh& m, unsigned v, unsigned h) {
    m.set_halfedge_handle(handle<vert>(v), handle<halfedge>(h));
  }
  static void set_halfedge_of(mesh& m, unsigned p, unsigned h) {
    m.set_halfedge_handle(handle<poly>(p), handle<halfedge>(h));
  }

  static void reserve(mesh& m, unsigned verts, unsigned edges, unsigned polys, bool removes) {
    if (removes) openmesh_status::request_of_verts(m), openmesh_status::request_of_edges_and_polys(m);
    if (verts + edges + polys > 0)
      m.reserve(grown(num_verts(m), verts), grown(num_edges(m), edges), grown(num_polys(m), polys));
  }
  static unsigned add_vert(mesh& m) { return number(m.new_vertex()); }
  static unsigned add_edge(mesh& m) { return number(m.edge_handle(m.new_edge(vert(), vert()))); }
  static unsigned add_poly(mesh& m) { return number(m.new_face()); }

  static void set_removed_vert(mesh& m, unsigned v, bool is_removed) {
    openmesh_property(m.vprops_begin(), m.vertex_status_pph())[static_cast<int>(v)].set_deleted(is_removed);
  }
  static void set_removed_edge(mesh& m, unsigned e, bool is_removed) {
    openmesh_property(m.eprops_begin(), m.edge_status_pph())[static_cast<int>(e)].set_deleted(is_removed);
    if (m.has_halfedge_status())
      for (const unsigned h : {2 * e, 2 * e + 1})
        openmesh_property(m.hprops_begin(), m.halfedge_status_pph())[static_cast<int>(h)].set_deleted(is_removed);
  }
  static void set_removed_poly(mesh& m, unsigned p, bool is_removed) {
    openmesh_property(m.fprops_begin(), m.face_status_pph())[static_cast<int>(p)].set_deleted(is_removed);
  }
  static void remove_vert(mesh& m, unsigned v) { set_removed_vert(m, v, true); }
  static void remove_edge(mesh& m, unsigned e) { set_removed_edge(m, e, true); }
  static void remove_poly(mesh& m, unsigned p) { set_removed_poly(m, p, true); }

  static void resize(mesh& m, unsigned verts, unsigned edges, unsigned polys) { m.resize(verts, edges, polys); }
  static bool is_removed_vert(const mesh& m, unsigned v) {
    return m.has_vertex_status() && m.status(handle<vert>(v)).deleted();
  }
  static bool is_removed_edge(const mesh& m, unsigned e) {
    return m.has_edge_status() && m.status(handle<edge>(e)).deleted();
  }
  static bool is_removed_poly(const mesh& m, unsigned p) {
    return m.has_face_status() && m.status(handle<poly>(p)).deleted();
  }
  static void revive(mesh& m, removed_elements verts, removed_elements edges, removed_elements polys) {
    for (const unsigned v : verts) set_removed_vert(m, v, false);
    for (const unsigned e : edges) set_removed_edge(m, e, false);
    for (const unsigned p : polys) set_removed_poly(m, p, false);
  }
  static bool set_recycling(mesh&, bool) { return false; }  // OpenMesh does not use indices again
};

/// Points are those of type P that OpenMesh stores as a property.
template<class P>
struct openmesh_kernel : openmesh_elements_kernel {
  using point = P;
  using points = OpenMesh::PropertyT<P>*;
  using edits = halfedge_edits<openmesh_kernel>;
  using edits_property = OpenMesh::MPropHandleT<uncopied<edits>>;
  static constexpr char name_of_edits[] = "concino:edits";

  static points find_points(mesh& m) { return find_property<P>(m.vprops_begin(), m.vprops_end(), "v:points"); }
  static P& point_of(mesh&, points p, unsigned v) { return (*p)[static_cast<int>(v)]; }
  template<class X>
  static void assign_point(P& p, const X& x) {
    using scalar = typename OpenMesh::vector_traits<P>::value_type;
    p[0] = static_cast<scalar>(x[0]);
    p[1] = static_cast<scalar>(x[1]);
    p[2] = static_cast<scalar>(x[2]);
  }

  static edits* find_edits(mesh& m) {
    auto* const found = find_property<uncopied<edits>>(m.mprops_begin(), m.mprops_end(), name_of_edits);
    return found ? (*found)[0].get() : nullptr;
  }
  static edits& edits_of(mesh& m) {
    edits_property p;
    if (!m.get_property_handle(p, name_of_edits)) {
      try {
        m.add_property(p, name_of_edits);
      } catch (...) {  // OpenMesh keeps an incomplete property
        if (p.is_valid()) m.remove_property(p);
        throw;
      }
    }
    return m.property(p).get_or_make();
  }

 private:
  /// The property of this name, or null. m.get_property_handle(...) allocates memory for the name of the type.
  template<class T, class Iterator>
  static OpenMesh::PropertyT<T>* find_property(Iterator first, Iterator last, const char* name) {
    for (; first != last; ++first)
      if (*first && (*first)->name() == name)
        if (auto* const found = dynamic_cast<OpenMesh::PropertyT<T>*>(*first)) return found;
    return nullptr;
  }
};

}  // namespace concino::detail
