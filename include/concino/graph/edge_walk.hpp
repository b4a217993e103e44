// A way along the edges of a mesh: what boundary loops and generators of homology are made of.
#pragma once

#include <concino/concepts/mesh_traits.hpp>

#include <vector>

namespace concino {

/// Verts in the order in which they are met, and the edges between them: edges[i] joins verts[i] and verts[i + 1]. Where the walk is closed
/// the last edge joins the last vert and the first, which is not repeated.
template<class M>
struct edge_walk {
  std::vector<vert_t<M>> verts;
  std::vector<edge_t<M>> edges;

  bool is_closed() const { return !edges.empty() && edges.size() == verts.size(); }
  friend bool operator==(const edge_walk&, const edge_walk&) = default;
};

}  // namespace concino
