// critical_points: the minima, saddles and maxima of a function on the verts of a mesh, with multiplicities.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/fields/detail/topology/lower_links.hpp>
#include <concino/mesh/element_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino {

/// The critical points of a function. c[v][k] is how often v is critical with index k. Index 0 is a minimum. Index 1
/// joins components of {u <= u(v)}, or closes a loop of it. Index 2 is a maximum on surfaces; in volumes it fills a
/// loop or closes a cavity, and index 3 is a maximum. All are 0 at a regular vert.
template<class M>
struct critical_points_of {
  vert_map<M, std::array<std::uint32_t, 4>> multiplicity;
  std::vector<vert_t<M>> verts;        // those that are not regular, in the order of verts(m)
  std::array<std::size_t, 4> count{};  // the sums of multiplicities, by index: count[0] - count[1] + count[2] -
                                       // count[3] is the Euler characteristic

  const std::array<std::uint32_t, 4>& operator[](const vert_t<M>& v) const { return multiplicity[v]; }
};

/// The critical points of the function u of the verts. The lower link of a vert v consists of the edges, polygons and
/// polyhedra whose highest vert is v. The multiplicity of index k is its reduced Betti number k - 1: 1 - 0 for an empty
/// one, components - 1, loops, cavities. A vert can have several indices at once.
/// Needs:  AnyMesh, not a temporary, open or non-manifold too; polyhedra have closed boundaries. u[v] is a finite
///         number for each vert, readable from several threads.
/// Result: the multiplicities, with coefficients modulo 2. Of verts with equal values, the one with the smaller index
///         counts as the lower one. Verts without edges are minima. On surfaces a saddle of multiplicity k has k + 1
///         valleys. A vert of the boundary is regular where its lower link is one piece without loops, so a least value
///         on the boundary is a minimum, but a greatest value there is regular. The alternating sum over all verts is
///         the number of verts - edges + polygons - polyhedra.
/// Cost:   O(elements) time, up to an inverse Ackermann factor, and memory; more at verts where more than two polyhedra
///         share a face.
/// Errors: invalid_argument that names a vert whose value is not finite. invalid_mesh that names a vert if the faces of
///         a polyhedron at it are not closed and the counts show it.
/// Source: Banchoff 1970, "Critical points and curvature for embedded polyhedral surfaces"; Edelsbrunner, Harer,
///         Zomorodian 2003, "Hierarchical Morse-Smale complexes for piecewise linear 2-manifolds"; Edelsbrunner, Muecke
///         1990, "Simulation of simplicity".
template<class M, class U>
  requires requirement::is_lvalue_or_view<M> && AnyMesh<M> && requirement::gives_numbers<U, vert_t<M>>
critical_points_of<std::remove_cvref_t<M>> critical_points(M&& m, const U& u) {
  using mesh = std::remove_cvref_t<M>;
  const detail::vert_order order(m, u, "critical_points");
  const detail::lower_links<mesh> links(m, order);
  critical_points_of<mesh> result{make_vert_map<std::array<std::uint32_t, 4>>(m), {}, {}};
  for (const vert_t<mesh> v : verts(m)) {
    const auto of_vert = links.multiplicity(index_of(m, v));
    result.multiplicity[v] = of_vert;
    if (of_vert == std::array<std::uint32_t, 4>{}) continue;
    result.verts.push_back(v);
    for (std::size_t k = 0; k < 4; ++k) result.count[k] += of_vert[k];
  }
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void critical_points(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void critical_points(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_at_verts>>
  requires(AnyMesh<M> && !requirement::gives_numbers<U, vert_t<M>>)
void critical_points(M&&, const U&, ...) = delete;  // a number at each vert: make_vert_map<double>(m)

}  // namespace concino
