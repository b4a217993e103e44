// edge_walk: a walk along the edges of a mesh. Boundary loops and homology generators are edge walks.
#pragma once

#include <concino/concepts/mesh_traits.hpp>

#include <vector>

namespace concino {

/// The verts of a walk in order, and the edges between them: edges[i] joins verts[i] and verts[i + 1]. If the walk is
/// closed, the last edge joins the last vert and the first, which is not repeated.
template<class M>
struct edge_walk {
  std::vector<vert_t<M>> verts;
  std::vector<edge_t<M>> edges;

  bool is_closed() const { return !edges.empty() && edges.size() == verts.size(); }
  friend bool operator==(const edge_walk&, const edge_walk&) = default;
};

}  // namespace concino
