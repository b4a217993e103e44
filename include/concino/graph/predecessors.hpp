// Predecessors of a search: a map that bfs and dijkstra fill on request, and the path to a node in it.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/concepts/mesh_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace concino {

namespace detail {

/// A pointer to any writable map of Keys by Values, or null.
template<class Key, class Value>
class written_map {
  void* map_ = nullptr;
  void (*put_)(void*, const Key&, const Value&) = nullptr;

 public:
  constexpr written_map() = default;
  constexpr written_map(std::nullptr_t) {}

  template<class P>
    requires WritableMap<P, Key, Value>
  written_map(P* map) : map_(map) {
    if (map) put_ = [](void* p, const Key& key, const Value& value) { (*static_cast<P*>(p))[key] = value; };
  }

  explicit operator bool() const { return put_ != nullptr; }
  void put(const Key& key, const Value& value) const { put_(map_, key, value); }
};

}  // namespace detail

/// A reference to a map that a search writes: p[x] becomes the node before x on the path to it, or x itself for sources
/// and unreached nodes. Any map of nodes by nodes can be used, such as that of make_vert_map<vert_t<M>>(m) or of
/// make_poly_map<poly_t<M>>(m):
///   auto from = make_vert_map<vert_id>(m);
///   bfs(m, a, {.predecessors = &from});
template<class Node>
class predecessors_ref : public detail::written_map<Node, Node> {
  using detail::written_map<Node, Node>::written_map;
};

/// A reference to a map that a search writes: c[x] becomes the edge or face between x and its predecessor. It is not
/// written for sources and unreached nodes.
///   auto along = make_vert_map<edge_id>(m);
///   bfs(m, a, {.crossed = &along});
template<class Node, class Crossed>
class crossed_ref : public detail::written_map<Node, Crossed> {
  using detail::written_map<Node, Crossed>::written_map;
};

/// The type of `crossed` for graphs without crossings: it accepts no map, and its message says why.
template<class Node>
class crossed_ref<Node, void> {
 public:
  constexpr crossed_ref() = default;
  constexpr crossed_ref(std::nullptr_t) {}
  template<class P, class R = mistake::remedy<"crossed needs the edges or faces between neighbours: adj_v2e and adj_e2v between verts; adj_p2e and adj_e2p between polys of a surface, adj_p2f and adj_f2p of a volume. This type is only a graph; use predecessors">>
  crossed_ref(P*) = delete;  // crossed needs the edges or faces between neighbours: adj_v2e and adj_e2v ...; use predecessors
  constexpr explicit operator bool() const { return false; }
};

/// The nodes on the path to `end` in the tree that a search wrote to `predecessors`, from the source on; `end` alone if
/// the search did not reach it.
/// Needs:  predecessors[x] as bfs and dijkstra write it: following it ends at a node that is its own predecessor.
/// Result: at least one node, `end` last.      Cost: O(nodes on the path).      Errors: none of its own.
template<class P, class Node>
  requires ReadableMap<P, Node>
std::vector<Node> path_to(const P& predecessors, const Node& end) {
  std::vector<Node> path{end};
  for (Node x = predecessors[end]; !(x == path.back()); x = predecessors[x]) path.push_back(x);
  for (std::size_t i = 0, k = path.size(); i + 1 < k--; ++i) std::swap(path[i], path[k]);
  return path;
}

}  // namespace concino
