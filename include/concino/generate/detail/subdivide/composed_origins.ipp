// Bodies of composed_origins.hpp: the origins of elements of a mesh that was subdivided twice.
#pragma once

#include <concino/core/local_numbers.hpp>
#include <concino/generate/detail/subdivide/composed_origins.hpp>

#include <vector>

namespace concino::detail {

CONCINO_INLINE element_origins origins_through(const element_origins& first, const element_origins& second) {
  element_origins composed;
  std::vector<origin> list;
  for (std::size_t i = 0; i < second.size(); ++i) {
    list.clear();
    core::local_numbers visited;
    for (const origin middle : second[i])
      for (const origin x : first[middle.index]) {
        const unsigned k = visited.add(x.index);
        if (k == list.size()) list.push_back({x.index, 0});
        list[k].weight += middle.weight * x.weight;
      }
    if (list.empty()) composed.add(element_origins::none);
    else if (list.size() == 1 && list[0].weight == 1) composed.add(list[0].index);
    else composed.add(list);
  }
  return composed;
}

CONCINO_INLINE correspondence composed_origins(const correspondence& first, const correspondence& second) {
  return {origins_through(first.verts, second.verts), origins_through(first.edges, second.edges),
          origins_through(first.faces, second.faces), origins_through(first.polys, second.polys),
          origins_through(first.corners, second.corners)};
}

}  // namespace concino::detail
