// segment_by_shape: parts of a mesh by their shape, with boundaries that are short and prefer concave edges.
// Not part of <concino/graph.hpp>, for the same reason as segment.hpp.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/dihedral_angles.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/geometry/normals.hpp>
#include <concino/graph/detail/cuts/shape_clusters.hpp>
#include <concino/graph/segment.hpp>
#include <concino/mesh/facet_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <type_traits>
#include <vector>

namespace concino {

enum class part_likeness {
  normals,  // polys of a part have similar normals: surfaces only
  distance  // polys of a part are near each other
};

struct segment_by_shape_options {
  int labels = 8;  // the largest number of parts, 1 or more
  part_likeness likeness = part_likeness::normals;  // what polys of one part have in common
  int rounds = 30;            // 0 or more: how often the clusters are improved at most
  double smoothness = 0.1;    // 0 or more: the cost of boundaries between parts; 0 leaves the clusters as they are
  double concave_cost = 0.1;  // in [0, 1]: the cost of a boundary along edges that are concave by 45 degrees or more,
                              // as a fraction of that elsewhere
  concino::progress progress = nullptr;  // called before each round of clusters and each cut
  concino::profiler* profiler = nullptr; // measures the call and its steps
};

namespace detail {

/// The vectors by which the polys of a mesh are clustered.
template<class M>
auto part_vectors(const M& m, part_likeness likeness) {
  if (likeness == part_likeness::distance) return centroids(m);
  if constexpr (dimension_v<M> == 2) return poly_normals(m);  // polys of a volume have no normals
  else
    throw invalid_argument("segment_by_shape: polys of volumes have no normals; use part_likeness::distance");
}

/// What boundaries of parts cost along each facet.
template<class M>
auto boundary_costs(const M& m, [[maybe_unused]] double concave_cost) {
  auto cost = make_facet_map<double>(m);
  for (const facet_t<M> facet : facets(m)) {
    cost[facet] = measure(m, facet);
    if constexpr (dimension_v<M> == 2) {  // faces of a volume have no angle
      const double bend = (dihedral_angle(m, facet) - std::numbers::pi) / (std::numbers::pi / 4);
      cost[facet] *= 1 - (1 - concave_cost) * std::clamp(bend, 0.0, 1.0);
    }
  }
  return cost;
}

/// The graph of polys, in flat arrays.
template<class M>
struct part_graph {
  std::vector<poly_t<M>> polys;
  std::vector<std::uint32_t> number;  // by index of the poly
  shape_nodes nodes;
  double size;  // the measure of all polys

  part_graph(const M& m, const segment_by_shape_options& options)
      : number(poly_index_bound(m)),
        nodes{{}, {}, {0}, {}, options.likeness == part_likeness::normals}, size(0) {
    const auto at = part_vectors(m, options.likeness);
    for (const poly_t<M> p : concino::polys(m)) {
      number[index_of(m, p)] = static_cast<std::uint32_t>(polys.size());
      polys.push_back(p);
      nodes.at.push_back(at[p]);
      nodes.weight.push_back(measure(m, p));
      size += nodes.weight.back();
      if (!std::isfinite(dot(at[p], at[p])) || !std::isfinite(size))
        core::throw_joined<invalid_mesh>(
            {"segment_by_shape: a point of poly ", index_of(m, p), " is not finite, or too far from the others"});
    }
    for (const poly_t<M> p : polys) {
      detail::for_each(adj_p2p(m, p), [&](const poly_t<M>& q) { nodes.neighbours.push_back(number[index_of(m, q)]); });
      nodes.first.push_back(nodes.neighbours.size());
    }
  }
};

/// Whether a node of a cluster may change to another: where the two are adjacent.
inline std::vector<unsigned char> adjacent_clusters(const shape_nodes& nodes, const std::vector<int>& label,
                                                    std::size_t labels) {
  std::vector<unsigned char> is_adjacent(labels * labels);
  for (std::size_t i = 0; i < label.size(); ++i) {
    const auto a = static_cast<std::size_t>(label[i]);
    is_adjacent[a * labels + a] = 1;
    for (std::size_t k = nodes.first[i]; k < nodes.first[i + 1]; ++k)
      is_adjacent[a * labels + static_cast<std::size_t>(label[nodes.neighbours[k]])] = 1;
  }
  return is_adjacent;
}

inline void expect_shape_options(const segment_by_shape_options& options) {
  if (options.labels < 1) throw invalid_argument("segment_by_shape: labels must be 1 or more");
  if (options.rounds < 0) throw invalid_argument("segment_by_shape: rounds must be 0 or more");
  if (!(options.smoothness >= 0 && options.smoothness < std::numeric_limits<double>::infinity()))
    throw invalid_argument("segment_by_shape: smoothness must be finite and 0 or more");
  if (!(options.concave_cost >= 0 && options.concave_cost <= 1))
    throw invalid_argument("segment_by_shape: concave_cost must be in [0, 1]");
}

}  // namespace detail

/// Parts of a mesh by shape: clusters of polys with similar normals, or near each other, and then the cut between these
/// clusters whose boundaries are short and follow concave edges.
/// Needs:  EmbeddedMesh M; finite points.
/// Result: a segmentation into at most options.labels parts. Clusters are connected where the mesh is, and the cut lets
///         polys change to adjacent clusters only. The energy has two terms. The first is the sum of
///         measure(p) |x - y|^2 over all polys, where x is the normal of p and y that of its part; by distance, x and y
///         are the centroids, in units of s. The second is smoothness s times the sum of w length(e) over all edges
///         between different parts. There s is the size of a part, (measure of the mesh / labels)^(1 / dimension).
///         The weight w is 1, or down to concave_cost at concave edges. In volumes, areas of faces replace lengths.
///         Labels follow the order in which clusters were added; some may be left without polys. Independent of scale.
/// Cost:   (labels + rounds) O(E log E) for the clusters, and the cuts of segment_polys; O(V labels + E) memory.
/// Errors: invalid_argument if an option is out of its range, or if normals are asked of a volume; invalid_mesh that
///         names a poly whose points are not finite; cancelled.
/// Source: Cohen-Steiner, Alliez, Desbrun 2004, "Variational shape approximation"; cuts at concave edges: Katz, Tal
///         2003, "Hierarchical mesh decomposition using fuzzy clustering and cuts".
template<class M>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M>
auto segment_by_shape(M&& m, const segment_by_shape_options& input_options = {}) {
  const core::profiled_options profiled(input_options, "segment_by_shape");
  const segment_by_shape_options& options = *profiled;
  using mesh = std::remove_cvref_t<M>;
  using poly = poly_t<mesh>;
  detail::expect_shape_options(options);
  const detail::part_graph<mesh> g(m, options);
  const auto clusters =
      detail::find_shape_clusters(g.nodes, options.labels, options.rounds, options.progress, "segment_by_shape");
  const std::size_t labels = std::max<std::size_t>(clusters.centre.size(), 1);
  const auto may_change = detail::adjacent_clusters(g.nodes, clusters.label, labels);
  constexpr double d = dimension_v<mesh>;
  const double part = std::pow(g.size / options.labels, 1 / d);
  const double unit = options.likeness == part_likeness::normals || part == 0 ? 1 : 1 / (part * part);
  const auto facet_cost = detail::boundary_costs(m, options.concave_cost);
  const auto cost = [&](const poly& p, int l) {
    const std::size_t i = g.number[index_of(m, p)], to = static_cast<std::size_t>(l);
    if (!may_change[static_cast<std::size_t>(clusters.label[i]) * labels + to])
      return std::numeric_limits<double>::infinity();
    // With no cost of boundaries, each poly stays in its cluster.
    if (options.smoothness == 0) return clusters.label[i] == l ? 0.0 : std::numeric_limits<double>::infinity();
    const vec3 step = g.nodes.at[i] - clusters.centre[to];
    return g.nodes.weight[i] * dot(step, step) * unit;
  };
  const auto boundary = [&](const poly& p, const poly& q, int a, int b) {
    if (a == b) return 0.0;
    double sum = 0;
    for (const auto& facet : adj_p2facet(m, p))
      for (const poly& other : adj_facet2p(m, facet))
        if (other == q) sum += facet_cost[facet];
    return options.smoothness * part * sum;
  };
  return segment_polys(m, cost, boundary, {.labels = static_cast<int>(labels), .progress = options.progress});
}

// What to write instead of calls that cannot compile.
template<class... T> void segment_by_shape(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void segment_by_shape(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void segment_by_shape(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
