// The sources of distances on a distributed mesh, and lengths of paths near them.
#pragma once

#include <concino/adapters/detail/distributed/distributed_components.hpp>
#include <concino/adapters/detail/distributed/distributed_polys.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/mpi/mpi_all_to_all.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/core/lexicographic.hpp>
#include <concino/core/vec3.hpp>
#include <concino/fields/support/heat_geodesics_parts.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

namespace concino::detail {

/// A vert by its global number. Lengths are those of the scaled mesh.
struct distributed_source {
  std::uint64_t vert;
  double distance;  // the initial one
  vec3 position;
};

/// The sources of all processes, each vert once with its least initial distance, by number. Collective.
/// Errors: as heat_geodesics.
template<class M, class S>
std::vector<distributed_source> gather_sources(const distributed<M>& m, int exponent, const S& sources) {
  const views::scaled<distributed<M>> scaled(m, exponent);
  std::vector<distributed_source> own;
  on_all(m.communicator(), [&] {
    for_each_distance_source<M>(sources, [&](const vert_t<M>& v, double distance) {
      check_distance_source(m, v, distance, [&] { return static_cast<std::size_t>(m.global_number(v)); });
      own.push_back({m.global_number(v), std::ldexp(distance, -exponent), point(scaled, v)});
    });
  });
  std::vector<distributed_source> all = all_from_all(m.communicator(), own);
  check_has_source(!all.empty());
  std::sort(all.begin(), all.end(),
            [](const auto& a, const auto& b) { return std::tie(a.vert, a.distance) < std::tie(b.vert, b.distance); });
  all.erase(std::unique(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.vert == b.vert; }),
            all.end());
  return all;
}

/// The source at the vert with this number; none: nullptr.
inline const distributed_source* source_at(const std::vector<distributed_source>& sources, std::uint64_t vert) {
  const auto at = std::lower_bound(sources.begin(), sources.end(), vert,
                                   [](const distributed_source& s, std::uint64_t v) { return s.vert < v; });
  return at != sources.end() && at->vert == vert ? &*at : nullptr;
}

/// A source at the lexicographically first vert of each component. Collective.
template<class M>
std::vector<distributed_source> one_source_per_component(const distributed<M>& m, int exponent,
                                                         const distributed_components& components) {
  const views::scaled<distributed<M>> scaled(m, exponent);
  const auto is_before = [](const distributed_source& a, const distributed_source& b) {
    if (core::is_lexicographically_less(a.position, b.position)) return true;
    return !core::is_lexicographically_less(b.position, a.position) && a.vert < b.vert;
  };
  struct candidate {
    std::size_t component;  // none: not on this process
    distributed_source source;
  };
  constexpr std::size_t none = distributed_components::none;
  std::vector<candidate> own(components.size(), candidate{none, {}});
  for (const vert_t<M> v : verts(m)) {
    const std::size_t c = components.of_vert[index_of(m, v)];
    if (c == none || m.is_ghost(v)) continue;
    const candidate x{c, {m.global_number(v), 0, point(scaled, v)}};
    if (own[c].component == none || is_before(x.source, own[c].source)) own[c] = x;
  }
  std::erase_if(own, [](const candidate& x) { return x.component == none; });
  std::vector<candidate> every = all_from_all(m.communicator(), own);
  std::sort(every.begin(), every.end(), [&](const candidate& a, const candidate& b) {
    return a.component != b.component ? a.component < b.component : is_before(a.source, b.source);
  });
  std::vector<distributed_source> first;
  for (std::size_t k = 0; k < every.size(); ++k)
    if (k == 0 || every[k].component != every[k - 1].component) first.push_back(every[k].source);
  std::sort(first.begin(), first.end(), [](const auto& a, const auto& b) { return a.vert < b.vert; });
  return first;
}

inline euclidean_distance straight_distance(const std::vector<distributed_source>& sources) {
  std::vector<distance_source> all;
  for (const distributed_source& s : sources) all.push_back({s.position, s.distance});
  return euclidean_distance(std::move(all));
}

/// Lengths of paths over the mesh from the sources to each local vert, by index; +inf where they are longer than
/// `longest`. The first process finds them, in the polys that are so near. Collective.
template<class M>
std::vector<double> path_lengths_near(const distributed<M>& m, int exponent,
                                      const std::vector<distributed_source>& sources, double longest) {
  const views::scaled<distributed<M>> scaled(m, exponent);
  const euclidean_distance straight = straight_distance(sources);
  const gathered_polys<M> near = gather_polys(m, [&](const poly_t<M>& p) {
    for (const vert_t<M> v : adj_p2v(m, p))
      if (straight(point(scaled, v)) <= longest + 1e-9) return true;
    return false;
  });
  std::vector<double> lengths;
  on_all(m.communicator(), [&] {
    if (near.vert_numbers.empty()) return;
    const distance_graph graph = distance_graph_of(views::scaled<M>(near.mesh, exponent));
    std::vector<distance_graph::start> starts;
    for (std::size_t k = 0; k < sources.size(); ++k) {
      const auto at = std::lower_bound(near.vert_numbers.begin(), near.vert_numbers.end(), sources[k].vert);
      if (at != near.vert_numbers.end() && *at == sources[k].vert)
        starts.push_back(
            {static_cast<int>(at - near.vert_numbers.begin()), static_cast<int>(k), 0, sources[k].distance});
    }
    lengths = graph.path_lengths_from(starts, longest);
  });
  const std::vector<std::uint64_t> numbers = all_from_all(m.communicator(), near.vert_numbers);
  lengths = all_from_all(m.communicator(), lengths);
  std::vector<double> r(vert_index_bound(m), std::numeric_limits<double>::infinity());
  for (const vert_t<M> v : verts(m)) {
    const auto at = std::lower_bound(numbers.begin(), numbers.end(), m.global_number(v));
    if (at != numbers.end() && *at == m.global_number(v))
      r[index_of(m, v)] = lengths[static_cast<std::size_t>(at - numbers.begin())];
  }
  return r;
}

}  // namespace concino::detail
