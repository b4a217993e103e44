// cell_patch: the quads or hexes about some elements of a mesh as cube_tables, and cell_edit: what becomes of them.
#pragma once

#include <concino/core/local_numbers.hpp>
#include <concino/core/vec3.hpp>
#include <concino/edit/permission.hpp>
#include <concino/layout/detail/cube_tables.hpp>

#include <vector>

namespace concino::detail {

/// The polys at some verts. Their elements have the numbers in which they come.
template<class M>
struct cell_patch {
  cube_tables t;
  std::vector<vert_t<M>> verts;
  std::vector<poly_t<M>> polys;
  std::vector<vec3> points;
  core::local_numbers vert_numbers, edge_numbers, face_numbers;  // by index

  std::uint32_t number(const M& m, const vert_t<M>& v) const { return vert_numbers.find(index_of(m, v)); }
  std::uint32_t number(const M& m, const edge_t<M>& e) const { return edge_numbers.find(index_of(m, e)); }
  std::uint32_t facet_number(const M& m, const facet_t<M>& f) const {
    return (dimension_v<M> == 2 ? edge_numbers : face_numbers).find(index_of(m, f));
  }

  /// The polys at verts of `elements`; their_verts(x) are those of one.
  template<class X, class Verts>
  cell_patch(const M& m, const std::vector<X>& elements, const Verts& their_verts, const char* caller) {
    core::local_numbers centres, poly_numbers;
    for (const X& x : elements)
      for (const vert_t<M> v : their_verts(x)) {
        const unsigned before = centres.size();
        if (centres.add(index_of(m, v)) < before) continue;
        for (const poly_t<M> p : adj_v2p(m, v))
          if (poly_numbers.add(index_of(m, p)) == polys.size()) polys.push_back(p);
      }
    t.dimension = dimension_v<M>;
    core::local_numbers& facets = dimension_v<M> == 2 ? edge_numbers : face_numbers;
    add_polys(
        m, polys,
        [&](const vert_t<M>& v) {
          const unsigned n = vert_numbers.add(index_of(m, v));
          if (n == verts.size()) verts.push_back(v), points.push_back(to_vec3(point(m, v)));
          return n;
        },
        [&](const edge_t<M>& e) { return edge_numbers.add(index_of(m, e)); },
        [&](const facet_t<M>& f) { return facets.add(index_of(m, f)); }, t, caller);
    t.num_verts = verts.size(), t.num_edges = edge_numbers.size(), t.num_facets = facets.size();
    t.prepare();
  }
};

/// Which elements of a patch are at the boundary. It is known of those at the verts about which the patch was made.
struct boundary_flags {
  std::vector<unsigned char> verts, edges, facets;
  explicit boundary_flags(const cube_tables& t);
};

/// What becomes of the polys of a patch.
struct cell_edit {
  permission allowed;
  std::vector<std::uint32_t> labels;   // of their corners, by poly and place: a vert, or num_verts + a new vert
  std::vector<unsigned char> is_gone;  // by poly
  std::vector<std::uint32_t> removed;  // verts
  std::vector<vec3> points;            // of new verts
  std::vector<std::uint32_t> origins, origin_ends;  // the verts of which each new vert is made, one after another
  std::vector<std::uint32_t> added, added_from;     // corners of additional polys by place; the poly beside each
  std::vector<std::uint32_t> facets;  // what remains of the polys that are gone: facets of others, as positions in
                                      // poly_facets

  explicit cell_edit(const cube_tables& t) : labels(t.poly_verts), is_gone(t.num_polys()) {}
  /// Adds a new vert. Returns its label.
  std::uint32_t add_vert(const cube_tables& t, const vec3& x, const std::vector<std::uint32_t>& from);
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/layout/detail/cell_patch.ipp>
#endif
