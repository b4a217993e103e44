// What is asked of trivial_connection, by the numbers of its surface.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>
#include <concino/directions/detail/connection/trivial_turns.hpp>
#include <concino/directions/detail/surface/oriented_surface.hpp>
#include <concino/directions/detail/surface/poly_planes.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace concino::detail {

/// The loop of the boundary that an edge is of, by its place.
template<class M>
std::uint32_t loop_of(const M& m, const std::vector<std::uint32_t>& place, const edge_t<M>& e, const char* caller) {
  if (!contains(m, e))
    core::throw_joined<invalid_mesh>({caller, ": the index of a loop is given at what is no edge of the mesh"});
  if (num_elements(adj_e2p(m, e)) == 1)
    for (const vert_t<M> v : adj_e2v(m, e)) return place[index_of(m, v)];
  core::throw_joined<invalid_argument>(
      {caller, ": the index of a loop is given at edge ", index_of(m, e), ", which is not at the boundary"});
}

/// The indices of verts and loops.      Errors: those of trivial_connection about indices.
template<class M, class I, class B>
std::vector<std::optional<double>> wanted_holonomy(const M& m, const oriented_surface& s,
                                                   const std::vector<std::uint32_t>& place, const I& indices,
                                                   const B& boundary, int n, const char* caller) {
  std::vector<std::optional<double>> holonomy(s.num_verts());
  for (std::size_t v = 0; v < s.num_verts(); ++v)
    if (!s.on_boundary[v]) holonomy[v] = 0;
  std::vector<unsigned char> is_given(s.num_verts());
  const auto give = [&](std::size_t i, int index) {
    is_given[i] = 1;
    holonomy[i] = 2 * std::numbers::pi * index / n;
  };
  for (const auto& [v, index] : indices) {
    if (!contains(m, v) || s.component[index_of(m, v)] == oriented_surface::none)
      core::throw_joined<invalid_mesh>({caller, ": an index is given at what is no vert of a poly of the mesh"});
    const std::size_t i = index_of(m, v);
    if (s.on_boundary[i])
      core::throw_joined<invalid_argument>(
          {caller, ": vert ", i, " is at the boundary; give the index of its loop, as an option"});
    if (is_given[i]) core::throw_joined<invalid_argument>({caller, ": vert ", i, " is given two indices"});
    give(i, index);
  }
  for (const auto& [e, index] : boundary) {
    const std::uint32_t loop = loop_of(m, place, e, caller);
    if (is_given[loop])
      core::throw_joined<invalid_argument>({caller, ": the loop of vert ", loop, " is given two indices"});
    give(loop, index);
  }
  return holonomy;
}

/// On each component where all are given, the indices have the sum that there must be.
/// Errors: invalid_argument if not.
inline void check_sums_of_indices(const oriented_surface& s, const wanted_turns& wanted,
                                  const std::vector<double>& defects, int n, const char* caller) {
  std::vector<double> given(s.num_components, 0.0), all(s.num_components, 0.0);
  std::vector<unsigned char> is_open(s.num_components);
  for (std::size_t v = 0; v < s.num_verts(); ++v) {
    if (s.component[v] == oriented_surface::none || wanted.place[v] != v) continue;
    if (!wanted.holonomy[v]) is_open[s.component[v]] = 1;
    given[s.component[v]] += wanted.holonomy[v].value_or(0) * n / (2 * std::numbers::pi);
    all[s.component[v]] += defects[v] * n / (2 * std::numbers::pi);
  }
  for (std::size_t k = 0; k < given.size(); ++k)
    if (const auto sum = std::lround(given[k]), wants = std::lround(all[k]); !is_open[k] && sum != wants)
      core::throw_joined<invalid_argument>({caller, ": the indices of component ", k, " sum to ", sum,
                                            "; they must sum to the symmetry times its Euler characteristic, ",
                                            wants});
}

/// The number of the poly whose direction is given, and its angle there.      Errors: those about `start`.
template<class M>
std::pair<std::uint32_t, double> start_of(const M& m, const oriented_surface& s, const poly_planes& planes,
                                          const std::optional<std::pair<poly_t<M>, vec3>>& given,
                                          const char* caller) {
  if (!given) return {0, 0.0};
  const auto& [poly, d] = *given;
  std::uint32_t p = 0;
  if (contains(m, poly))
    while (p < s.num_polys() && s.poly_index[p] != index_of(m, poly)) ++p;
  if (!contains(m, poly) || p == s.num_polys())
    core::throw_joined<invalid_mesh>({caller, ": start is at what is no poly of the mesh"});
  const double x = dot(d, planes.axes[p][0]), y = dot(d, planes.axes[p][1]);
  if (!is_finite(d) || !(std::hypot(x, y) > 1e-9 * norm(d)))
    core::throw_joined<invalid_argument>({caller, ": the direction of start is not finite, or 0 in the plane of poly ",
                                          s.poly_index[p]});
  return {p, std::atan2(y, x)};
}

}  // namespace concino::detail
