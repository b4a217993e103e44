// Where the ways of a search come from: a map that bfs and dijkstra fill if asked, and the way to a node read off it.
#pragma once

#include <concino/concepts/maps.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace concino {

/// Refers to a map that a search writes: p[x] becomes the node before x on the way to it, x itself for sources and for what the search did
/// not reach. Any map of nodes by nodes will do, that of make_vert_map<vert_t<M>>(m) or of make_poly_map<poly_t<M>>(m) for one:
///   auto from = make_vert_map<vert_id>(m);
///   bfs(m, a, {.predecessors = &from});
template<class Node>
class predecessors_ref {
  void* map_ = nullptr;
  void (*put_)(void*, const Node&, const Node&) = nullptr;

 public:
  constexpr predecessors_ref() = default;
  constexpr predecessors_ref(std::nullptr_t) {}

  template<class P>
    requires WritableMap<P, Node, Node>
  predecessors_ref(P* map) : map_(map) {
    if (map) put_ = [](void* p, const Node& x, const Node& before) { (*static_cast<P*>(p))[x] = before; };
  }

  explicit operator bool() const { return put_ != nullptr; }
  void put(const Node& x, const Node& before) const { put_(map_, x, before); }
};

/// The nodes on the way to `end` in the tree that a search wrote to `predecessors`, from the source on; `end` alone if the search did not
/// reach it.
/// Needs:  predecessors[x] as bfs and dijkstra write it: following it ends at a node that is its own predecessor.
/// Result: at least one node, `end` last.      Cost: O(nodes on the way).      Errors: none of its own.
template<class P, class Node>
  requires ReadableMap<P, Node>
std::vector<Node> path_to(const P& predecessors, const Node& end) {
  std::vector<Node> path{end};
  for (Node x = predecessors[end]; !(x == path.back()); x = predecessors[x]) path.push_back(x);
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace concino
