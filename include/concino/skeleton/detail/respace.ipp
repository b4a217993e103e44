// Defines respace.hpp.
#pragma once

#include <concino/core/number_text.hpp>
#include <concino/skeleton/respace.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace concino::detail {

CONCINO_INLINE skeleton respaced(const flat_curves& g, double spacing) {
  if (!(spacing > 0 && std::isfinite(spacing)))
    core::throw_joined<invalid_argument>(
        {"respace: the spacing is ", core::number_text(spacing), "; it has to be finite and larger than 0"});
  const auto walks = bone_walks(g);
  constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> number(g.points.size(), none);
  for (std::uint32_t v = 0; v < g.points.size(); ++v)
    if (g.num_neighbours(v) != 2) number[v] = 0;
  for (const auto& walk : walks) number[walk.front()] = 0;
  std::vector<vec3> points;
  std::vector<double> radii;
  for (std::uint32_t v = 0; v < g.points.size(); ++v) {
    if (number[v] == none) continue;
    number[v] = static_cast<std::uint32_t>(points.size());
    points.push_back(g.points[v]);
    if (!g.radii.empty()) radii.push_back(g.radii[v]);
  }
  std::vector<std::array<vert_id, 2>> all_edges;
  std::set<std::array<std::uint32_t, 2>> are_joined;
  for (const auto& walk : walks) {
    const bone_curve curve = curve_along(g, walk);
    const double wanted = length(curve) / spacing;
    if (wanted + static_cast<double>(points.size()) > 4e9)
      core::throw_joined<invalid_argument>({"respace: the spacing is ", core::number_text(spacing),
                                            ", which gives more than 4,000,000,000 verts; choose a larger one"});
    const std::uint32_t from = number[walk.front()], to = number[walk.back()];
    std::size_t n = std::max<std::size_t>(static_cast<std::size_t>(std::lround(wanted)), from == to ? 3 : 1);
    if (n == 1 && !are_joined.insert({std::min(from, to), std::max(from, to)}).second) n = 2;
    vert_id last{from};
    for (std::size_t i = 1; i < n; ++i) {
      const bone_sample x = sample(curve, static_cast<double>(i) / static_cast<double>(n));
      const vert_id new_vert{static_cast<std::uint32_t>(points.size())};
      points.push_back(x.point);
      if (!g.radii.empty()) radii.push_back(x.radius);
      all_edges.push_back({last, new_vert});
      last = new_vert;
    }
    all_edges.push_back({last, vert_id{to}});
  }
  return skeleton(std::move(points), std::move(all_edges), std::move(radii));
}

}  // namespace concino::detail

namespace concino {

CONCINO_INLINE split_bone_result split_bone(const skeleton& k, const bone<skeleton>& b, double fraction) {
  const bone_sample x = sample(b, fraction);
  for (std::size_t i = 0; i < b.verts.size(); ++i)
    if (b.verts[i].raw() >= k.num_verts())
      core::throw_joined<invalid_argument>(
          {"split_bone: the bone has vert ", b.verts[i].raw(), ", which the skeleton does not have"});
  if (b.verts.size() != b.points.size() || b.verts.size() < 2)
    core::throw_joined<invalid_argument>({"split_bone: the bone has ", b.verts.size(), " verts and ", b.points.size(),
                                          " points; pass one of bones(k)"});
  for (const std::size_t end : {std::size_t{0}, std::size_t{1}})
    if (x.parameter == static_cast<double>(end)) return {k, b.verts[x.segment + end], false};
  const vert_id from = b.verts[x.segment], to = b.verts[x.segment + 1];
  auto points = k.points();
  auto radii = k.radii();
  auto all_edges = k.edges();
  const vert_id new_vert{static_cast<std::uint32_t>(points.size())};
  points.push_back(x.point);
  if (k.has_radii()) radii.push_back(x.radius);
  for (auto& e : all_edges) {
    if (!((e[0] == from && e[1] == to) || (e[0] == to && e[1] == from))) continue;
    const vert_id end = std::exchange(e[1], new_vert);
    all_edges.push_back({new_vert, end});
    return {skeleton(std::move(points), std::move(all_edges), std::move(radii)), new_vert, true};
  }
  core::throw_joined<invalid_argument>({"split_bone: verts ", from.raw(), " and ", to.raw(),
                                        " are not joined in the skeleton; pass one of bones(k)"});
}

}  // namespace concino
