// Bodies of skeleton_graph.hpp: curve skeletons: graphs in space with a radius at each vert.
#pragma once

#include <concino/core/error.hpp>
#include <concino/io/skeleton_graph.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace concino {

CONCINO_INLINE skeleton::skeleton(std::vector<vec3> points, std::vector<std::array<vert_id, 2>> all_edges,
                                  std::vector<double> radii)
    : points_(std::move(points)), radii_(std::move(radii)), edges_(std::move(all_edges)) {
  const std::size_t n = points_.size();
  if (n >= 0xFFFFFFFF || edges_.size() >= 0x7FFFFFFF)
    core::throw_joined<unsupported>({"skeleton: more verts or edges than ids can number"});
  if (!radii_.empty() && radii_.size() != n)
    core::throw_joined<invalid_argument>({"skeleton: ", radii_.size(), " radii for ", n, " points"});
  first_.assign(n + 1, 0);
  for (std::size_t e = 0; e < edges_.size(); ++e)
    for (const vert_id v : edges_[e]) {
      if (v.raw() >= n)
        core::throw_joined<invalid_mesh>(
            {"skeleton: edge ", e, " has vert ", v.raw(), ", but there are ", n, " verts"});
      ++first_[v.raw() + 1];
    }
  for (std::size_t v = 0; v < n; ++v) first_[v + 1] += first_[v];
  struct neighbour {
    vert_id vert;
    edge_id edge;
    bool operator<(const neighbour& o) const { return vert < o.vert; }
  };
  std::vector<neighbour> all(2 * edges_.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t e = 0; e < edges_.size(); ++e)
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}})
      all[next[edges_[e][k].raw()]++] = {edges_[e][1 - k], edge_id{e}};
  neighbours_.reserve(all.size());
  incident_.reserve(all.size());
  for (std::size_t v = 0; v < n; ++v) {
    std::sort(all.begin() + first_[v], all.begin() + first_[v + 1]);
    for (std::size_t i = first_[v]; i < first_[v + 1]; ++i) {
      if (all[i].vert.raw() == v)
        core::throw_joined<invalid_mesh>({"skeleton: edge ", all[i].edge.raw(), " joins vert ", v, " with itself"});
      if (i != first_[v] && all[i].vert == all[i - 1].vert)
        core::throw_joined<invalid_mesh>({"skeleton: edges ", std::min(all[i].edge, all[i - 1].edge).raw(), " and ",
                                          std::max(all[i].edge, all[i - 1].edge).raw(), " join the same verts"});
      neighbours_.push_back(all[i].vert);
      incident_.push_back(all[i].edge);
    }
  }
}

}  // namespace concino
