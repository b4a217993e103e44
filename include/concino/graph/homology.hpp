// Homology generators: loops on a closed surface around each handle and through it.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/graph/edge_walk.hpp>
#include <concino/graph/tree_cotree.hpp>

#include <algorithm>

namespace concino {

struct homology_options {
  bool from_root = true;  // false: omit the path from the root of the component and back, so that loops are simple
                          // cycles
};

/// A basis of the first homology group of a closed surface: every closed walk is homologous to a unique sum of these
/// loops.
/// Needs:  SurfaceMesh M that is closed and manifold: two polys at every edge, one fan of polys at every vert (or
///         none).
/// Result: closed walks, component by component, short ones first: 2g for a component of genus g. Each is closed by one
///         edge of the rest of tree_cotree(m), through its tree. All loops of a component begin at its first vert, so
///         they are connected, and cutting the surface along all of them leaves a disk (of genus 0: the whole sphere).
///         No system of loops at that vert that does so has fewer steps. With from_root = false the parts that a loop
///         traverses twice are omitted: simple cycles that need not meet. A component that is not orientable has 2 -
///         chi loops; they generate its homology with coefficients modulo 2.
/// Cost:   O(elements + edges of the loops) time, but for the union of polys, and memory.
/// Errors: invalid_mesh that names the first edge or vert where the surface is not closed or not manifold.
/// Source: Erickson, Whittlesey 2005, "Greedy optimal homotopy and homology generators"; Eppstein 2003.
template<SurfaceMesh M>
std::vector<edge_walk<M>> homology_generators(const M& m, const homology_options& options = {}) {
  detail::tree_cotree_tables<M> t(m, "homology_generators");
  const auto component = [&](const edge_t<M>& e) { return t.component[index_of(m, t.ends(m, e).first)]; };
  std::stable_sort(t.rest.begin(), t.rest.end(),
                   [&](const edge_t<M>& a, const edge_t<M>& b) { return component(a) < component(b); });

  std::vector<edge_walk<M>> loops;
  loops.reserve(t.rest.size());
  for (const edge_t<M>& e : t.rest) {
    auto [a, b] = t.ends(m, e);
    edge_walk<M> there, back;  // from either end up the tree, to the root or to the first common vert
    const auto climb = [&](vert_t<M>& v, edge_walk<M>& path) {
      const std::size_t i = index_of(m, v);
      path.verts.push_back(v);
      path.edges.push_back(t.up_edge[i]);
      v = vert_t<M>(t.up_vert[i]);
    };
    const auto height = [&](const vert_t<M>& v) { return t.hops[index_of(m, v)]; };
    while (options.from_root ? height(a) > 0 || height(b) > 0 : !(a == b)) {
      if (height(a) >= height(b)) climb(a, there);
      else climb(b, back);
    }
    edge_walk<M> loop;
    loop.verts.push_back(a);
    loop.verts.insert(loop.verts.end(), there.verts.rbegin(), there.verts.rend());
    loop.verts.insert(loop.verts.end(), back.verts.begin(), back.verts.end());
    loop.edges.assign(there.edges.rbegin(), there.edges.rend());
    loop.edges.push_back(e);
    loop.edges.insert(loop.edges.end(), back.edges.begin(), back.edges.end());
    loops.push_back(std::move(loop));
  }
  return loops;
}

// What to write instead of calls that cannot compile.
template<class... T> void homology_generators(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino
