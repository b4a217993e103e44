// Components of verts joined by edges, and the rigid motions by which handles move them.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The power of 2 next above x, or 1 if x is not positive.
double power_of_two_above(double x);
/// That of the size of the points that are used.
double unit_of(const std::vector<vec3>& points, const std::vector<std::size_t>& used);

/// The component of each vert; those without edges have one of their own.
struct edge_components {
  std::vector<std::uint32_t> of;
  std::size_t number = 0;

  /// first, to: the edges from each vert, in both directions.
  template<class Index>
  static edge_components find(std::size_t num_verts, const Index* first, const Index* to) {
    constexpr auto none = static_cast<std::uint32_t>(-1);
    edge_components all{std::vector<std::uint32_t>(num_verts, none), 0};
    std::vector<std::size_t> open;
    for (std::size_t v = 0; v < num_verts; ++v) {
      if (all.of[v] != none) continue;
      all.of[v] = static_cast<std::uint32_t>(all.number++);
      open.push_back(v);
      while (!open.empty()) {
        const std::size_t w = open.back();
        open.pop_back();
        for (Index k = first[w]; k < first[w + 1]; ++k)
          if (const auto u = static_cast<std::size_t>(to[k]); all.of[u] == none)
            all.of[u] = all.of[v], open.push_back(u);
      }
    }
    return all;
  }

  /// Each vert moved by the best rigid motion of the handles of its component; by that of all handles, if it has none.
  /// position: of the handles, by index of the vert.
  std::vector<vec3> moved(const std::vector<vec3>& rest, const std::vector<std::uint32_t>& handles,
                          const std::vector<vec3>& position) const;
};

/// Errors: always solver_error, about the component of a vert that is not determined, for this reason.
[[noreturn, gnu::cold]] void throw_not_determined(const char* caller, const edge_components& components,
                                                  std::size_t vert, const char* why);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/deform/detail/arap/components.ipp>
#endif
