// Maps with a value for every facet of a mesh, an edge of a surface or a face of a volume: make_facet_map<double>(m,
// 0.0).
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/mesh/element_map.hpp>

namespace concino {

template<class M, class T> using facet_map = element_map<std::remove_cvref_t<M>, facet_t<M>, T>;

/// A map with the same value `init` at every facet of m.
/// Needs:  an AnyMesh, no temporary (views may be).
/// Result: a map[x] of T: an edge_map or a face_map.      Cost: O(index bound) time and memory.      Errors: those of
///         the index bound.
template<class T, class M>
  requires requirement::is_lvalue_or_view<M> && requires(const M& m) { facet_index_bound(m); }
facet_map<M, T> make_facet_map(M&& m, const T& init = T()) {
  return {m, facet_index_bound(m), init};
}

// What to write instead of calls that cannot compile.
template<class... T> void make_facet_map(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
template<class... T> void make_facet_map(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
