// make_graph_tubes: the edges of graphs and meshes as tubes, such as skeletons, seams and wireframes.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/render/detail/shapes/graph_lines.hpp>
#include <concino/render/tubes.hpp>

#include <concepts>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino {

namespace requirement {

/// A predicate of edges, or a range of them.
template<class S, class M>
concept selects_edges = has_adj_e2v<M> &&(std::predicate<const S&, edge_t<M>> || is_range_of<S, edge_t<M>>);

}  // namespace requirement

namespace detail {

/// The verts of m, numbered in the order of verts(m).
template<class M>
class numbered_verts {
  const M& m_;
  std::vector<std::uint32_t> number_;

 public:
  flat_graph graph;

  explicit numbered_verts(const M& m) : m_(m), number_(vert_index_bound(m)) {
    for (const vert_t<M> v : verts(m)) {
      if (graph.points.size() >= std::numeric_limits<std::uint32_t>::max())
        throw unsupported("make_graph_tubes: the graph has more than 4,294,967,294 verts");
      number_[index_of(m, v)] = static_cast<std::uint32_t>(graph.points.size());
      graph.points.push_back(to_vec3(point(m, v)));
    }
  }
  std::uint32_t operator[](const vert_t<M>& v) const { return number_[index_of(m_, v)]; }

  /// Errors: invalid_mesh if an end has coordinates that are not finite.
  void add_edge(const vert_t<M>& a, const vert_t<M>& b) {
    for (const vert_t<M>& v : {a, b})
      if (!is_finite(graph.points[(*this)[v]]))
        core::throw_joined<invalid_mesh>(
            {"make_graph_tubes: vert ", index_of(m_, v), " has a coordinate that is not a finite number"});
    graph.edges.push_back({(*this)[a], (*this)[b]});
  }
};

}  // namespace detail

/// All edges of a graph or a mesh as tubes, each once: cn::make_graph_tubes(skeleton, {.radii = skeleton.radii()}).
/// Needs:  EmbeddedGraph M. options.values and options.radii have one number for each vert, in the order of verts(g);
///         options.closed is ignored.
/// Result: a drawable as that of make_tubes: tubes are round where edges meet. Edges are drawn as lines that go
///         straight on where they can; `polys` has the numbers of these lines. A vert without edges is a ball.
/// Cost:   O(verts + edges); memory as make_tubes: about 130 bytes for each corner of a cross-section at each edge.
/// Errors: invalid_mesh if a vert has a coordinate that is not finite; else as make_tubes.
template<EmbeddedGraph M>
drawable make_graph_tubes(const M& g, const tube_options& options = {}) {
  detail::numbered_verts<M> numbered(g);
  for (const vert_t<M> v : verts(g)) {
    bool alone = true;
    for (const vert_t<M> w : adj_v2v(g, v)) {
      alone = false;
      if (numbered[v] < numbered[w]) numbered.add_edge(v, w);
    }
    if (alone && !is_finite(to_vec3(point(g, v))))
      core::throw_joined<invalid_mesh>(
          {"make_graph_tubes: vert ", index_of(g, v), " has a coordinate that is not a finite number"});
  }
  numbered.graph.lone_verts = true;
  return detail::tubes_of(numbered.graph, options, "make_graph_tubes");
}

/// Some edges as tubes: cn::make_graph_tubes(m, [&](auto e) { return is_boundary(m, e); }).
/// Needs:  Embedded M with verts and edges; some: a range of edges of m, or a predicate of them.
/// Result: as above, without verts that have no edge.
/// Cost:   as above, and a call of the predicate for each edge.      Errors: as above, for the verts of these edges.
template<Embedded M, class S>
  requires requirement::has_verts<M> && requirement::selects_edges<S, M>
drawable make_graph_tubes(const M& m, const S& some, const tube_options& options = {}) {
  detail::numbered_verts<M> numbered(m);
  const auto add = [&](const edge_t<M>& e) {
    const auto [a, b] = end_verts(m, e);
    numbered.add_edge(a, b);
  };
  if constexpr (std::predicate<const S&, edge_t<M>>) {
    for (const edge_t<M> e : edges(m))
      if (some(e)) add(e);
  } else {
    for (const edge_t<M> e : some) add(e);
  }
  return detail::tubes_of(numbered.graph, options, "make_graph_tubes");
}

// What to write instead of calls that cannot compile.
template<class... T> void make_graph_tubes(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void make_graph_tubes(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
