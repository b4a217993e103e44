// check_laws: checks the semantic requirements of concepts, which the compiler cannot check. For tests of meshes and
// adapters.
#pragma once

#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/validate/detail/facet_laws.hpp>
#include <concino/validate/detail/halfedge_laws.hpp>
#include <concino/validate/detail/hex_orders.hpp>
#include <concino/validate/detail/surface_laws.hpp>
#include <concino/validate/detail/volume_laws.hpp>

#include <cmath>
#include <new>

namespace concino {

namespace detail {

template<class M>
void check_point_laws(const M& m, const element_table<vert_t<M>>& vs, law_log& log) {
  for (order_index v = 0; v < vs.size() && !log.full("EM1"); ++v) {
    try {
      const auto& x = point(m, vs.items[v]);
      if (!std::isfinite(static_cast<double>(x[0])) || !std::isfinite(static_cast<double>(x[1])) ||
          !std::isfinite(static_cast<double>(x[2])))
        log.add("EM1", core::joined({"point(", vs.name(v), ") is not three finite numbers"}), vs.name(v));
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& e) {
      log.add("EM1", core::joined({"point(", vs.name(v), ") throws: ", e.what()}), vs.name(v));
    }
  }
}

/// Checks the corner order of hexes. A few hexes may have any shape, but if all of them look like lexicographic order,
/// their lists are in that order.
template<HexMesh M>
void check_corner_order(const M& m, law_log& log) {
  hex_order_checks order_of;
  hex_order order = hex_order::standard;
  for (const poly_t<M> p : polys(m)) {
    order = order_of(m, p);
    if (!is_lexicographic(order)) return;
  }
  if (is_lexicographic(order))
    log.add("EM2", core::joined({"the corners of all hexes look like ", hex_order_remedy(order)}), "");
}

}  // namespace detail

/// Checks the laws of every concept that M models, and returns those that m breaks; empty if it satisfies all.
/// Needs:  PrimalGraph or DualGraph M; AnyMesh and Embedded are checked if M models them.
/// Result: at most four witnesses per law, in the order of the concepts. Inconsistent meshes (indices out of bounds,
///         asymmetric adjacency, endless ranges, exceptions) are reported, never dereferenced: only elements produced
///         by the element ranges are queried. If the indices of a kind of elements (PG1, DG1, SM1, VM1) or the links of
///         half-edges (HE1 .. HE4) are wrong, repair these first: their consequences are not reported. The laws of
///         facets FC1 .. FC4 follow from the laws of the mesh, and are not reported if one of those is broken.
/// Cost:   O(elements + adjacencies) time and memory, counting adjacencies as the mesh lists them: n equal triangles
///         have n^2 neighbours.
/// Errors: std::bad_alloc is passed on. Any other exception of the mesh is reported as a broken law.
template<class M>
  requires PrimalGraph<M> || DualGraph<M>
std::vector<broken_law> check_laws(const M& m) {
  detail::law_log log;
  if constexpr (detail::halfedge_mesh<M>) {
    detail::law_log elements;  // checked again below, together with its dependants
    detail::halfedge_laws<M> laws(m, log);
    if (laws.read_elements_of_mesh(elements) && !laws.check()) return log.take();
  }
  if constexpr (AnyMesh<M>) {
    const auto primal = detail::check_primal_graph(m, log);
    const auto dual = detail::check_dual_graph(m, log);
    if constexpr (SurfaceMesh<M>) detail::check_surface_mesh(m, primal, dual, log);  // each concept has its own laws
    else detail::check_volume_mesh(m, primal, dual, log);
    if (log.empty()) detail::facet_laws<M>(m, primal, dual, log).check();
    if constexpr (Embedded<M>) detail::check_point_laws(m, primal.nodes, log);
    if constexpr (Embedded<M> && HexMesh<M>)  // only hexes have commonly confused orders
      if (log.empty()) detail::check_corner_order(m, log);
  } else {
    if constexpr (PrimalGraph<M>) {
      [[maybe_unused]] const auto primal = detail::check_primal_graph(m, log);
      if constexpr (Embedded<M>) detail::check_point_laws(m, primal.nodes, log);
    }
    if constexpr (DualGraph<M>) detail::check_dual_graph(m, log);
  }
  return log.take();
}

// What to write instead of calls that cannot compile.
template<class... T> void check_laws(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino
