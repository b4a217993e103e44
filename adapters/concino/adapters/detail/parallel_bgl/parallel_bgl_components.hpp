// Connected components of distributed meshes by Parallel BGL.
#pragma once

#include <concino/adapters/detail/parallel_bgl/parallel_bgl_nodes.hpp>
#include <concino/graph/components.hpp>

#include <boost/graph/distributed/connected_components.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace concino::detail {

/// One vertex of the component of each vertex of this process, the same for the whole component. Collective.
inline std::vector<distributed_arcs::vertex_descriptor> component_roots(const distributed_arcs& g) {
  std::vector<distributed_arcs::vertex_descriptor> roots(num_vertices(g));
  auto map = distributed_values(g, roots);
  map.set_consistency_model(0);  // what Boost caches of other processes is not sent back, where it may be out of date
  boost::graph::distributed::connected_components(g, boost::dummy_property_map(), map);
  return roots;
}

/// The lowest of the numbers in the component of each vertex of this process, whose numbers increase. Collective.
inline std::vector<std::uint64_t> lowest_numbers(const distributed_arcs& g,
                                                 const std::vector<distributed_arcs::vertex_descriptor>& roots,
                                                 const std::vector<std::uint64_t>& numbers) {
  std::vector<std::uint64_t> lowest(roots.size(), std::numeric_limits<std::uint64_t>::max());
  auto of_root = distributed_values(g, lowest);
  of_root.set_max_ghost_cells(0);  // no bound
  set_property_map_role(boost::vertex_distance, of_root);  // keeps the lowest
  for (std::size_t k = 0; k < roots.size(); ++k)
    if (numbers[k] < get(of_root, roots[k])) put(of_root, roots[k], numbers[k]);
  synchronize(process_group(g));  // all are put
  synchronize(of_root);           // and are known elsewhere
  std::vector<std::uint64_t> r;
  for (const auto& root : roots) r.push_back(get(of_root, root));
  return r;
}

template<class G, class Options>
auto find_distributed_components(const G& g, const Options& options) {
  const distributed_nodes<G> nodes(g);
  arc_lists lists = arcs_of(g, nodes, {}, unit_lengths(), options, "connected_components");
  auto labels = make_node_map<int>(g, -1);
  std::vector<std::uint64_t> numbers;
  on_all(g.m.communicator(), [&] {
    for (const auto& x : nodes.own) {
      numbers.push_back(g.m.global_number(x));
      if (!options.may_enter || options.may_enter(x)) labels[x] = 0;
    }
  });
  const distributed_arcs arcs(g.m.communicator(), std::move(lists.ends), std::move(lists.arcs));
  const auto lowest = lowest_numbers(arcs, component_roots(arcs), numbers);
  std::vector<std::uint64_t> firsts, all_firsts;  // the lowest number of each component
  for (std::size_t k = 0; k < lowest.size(); ++k)
    if (labels[nodes.own[k]] == 0 && lowest[k] == numbers[k]) firsts.push_back(lowest[k]);
  all_gather(process_group(arcs), firsts.begin(), firsts.end(), all_firsts);
  std::sort(all_firsts.begin(), all_firsts.end());
  for (std::size_t k = 0; k < lowest.size(); ++k)
    if (int& label = labels[nodes.own[k]]; label == 0)
      label =
          static_cast<int>(std::lower_bound(all_firsts.begin(), all_firsts.end(), lowest[k]) - all_firsts.begin());
  exchange_ghosts(labels);
  return component_labels<decltype(labels)>{static_cast<int>(all_firsts.size()), std::move(labels)};
}

}  // namespace concino::detail
