// Bodies of surface_steps.hpp that look at shapes: triangles without area, and polys that intersect others.
#pragma once

#include <concino/core/local_points.hpp>
#include <concino/geometry/self_intersections.hpp>
#include <concino/graph/disjoint_sets.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/repair/detail/edge_lists.hpp>
#include <concino/repair/detail/surface_steps.hpp>

#include <algorithm>
#include <array>

namespace concino::detail {

class degenerate_triangles {
  surface_lists& s_;
  repair_log& log_;

  bool is_degenerate(std::size_t p) const {
    const auto list = s_.poly(p);
    if (list.size() != 3) return false;
    const std::array<vec3, 3> x{s_.points[list[0]], s_.points[list[1]], s_.points[list[2]]};
    return is_finite(x[0]) && is_finite(x[1]) && is_finite(x[2]) && core::is_degenerate_simplex(x);
  }
  double length(std::uint32_t a, std::uint32_t b) const { return distance(s_.points[a], s_.points[b]); }

  /// Verts of these triangles that are at the same point become one.
  bool collapse_edges(const std::vector<std::uint32_t>& all, std::uint32_t arity) {
    disjoint_sets sets(s_.points.size());
    bool any = false;
    for (const std::uint32_t p : all) {
      const auto list = s_.poly(p);
      for (std::size_t i = 0; i < 3; ++i)
        if (s_.points[list[i]] == s_.points[list[(i + 1) % 3]]) any |= sets.unite(list[i], list[(i + 1) % 3]);
    }
    if (!any) return false;
    for (auto* const numbers : {&s_.verts, &s_.vert_origin, &s_.cluster})
      for (std::uint32_t& v : *numbers) v = static_cast<std::uint32_t>(sets.root(v));
    cut_at_repeated_verts(s_, arity, log_);
    return true;
  }

  /// The polys at the longest edge of each triangle get its third vert, and the triangle vanishes. Polys that have
  /// changed wait for the next round.
  bool split_longest_edges(const std::vector<std::uint32_t>& all) {
    const edge_lists edges(s_.offsets, s_.verts, s_.points.size());
    std::vector<std::uint8_t> changed(s_.num_polys());
    std::vector<std::uint32_t> list;
    for (const std::uint32_t p : all) {
      if (changed[p]) continue;
      std::uint32_t longest = s_.offsets[p];
      for (std::uint32_t c = longest; c < s_.offsets[p + 1]; ++c)
        if (length(s_.verts[c], s_.verts[edges.next(c)]) > length(s_.verts[longest], s_.verts[edges.next(longest)]))
          longest = c;
      const std::uint32_t middle = s_.verts[edges.next(edges.next(longest))];
      const auto at = edges.corners(edges.edge_of(longest));
      const bool can_split = std::all_of(at.begin(), at.end(), [&](std::uint32_t c) {
        const std::uint32_t q = edges.poly_of(c);
        const auto other = s_.poly(q);
        return q == p || (!changed[q] && std::find(other.begin(), other.end(), middle) == other.end());
      });
      if (!can_split) continue;
      for (const std::uint32_t c : at) {
        const std::uint32_t q = edges.poly_of(c);
        changed[q] = 1;
        if (q == p) continue;
        const std::uint32_t from = s_.verts[c], to = s_.verts[edges.next(c)];
        if (s_.offsets[q + 1] - s_.offsets[q] == 3) {
          const std::uint32_t apex = s_.verts[edges.next(edges.next(c))];
          s_.add_poly(std::array{from, middle, apex}, s_.poly_origin[q], s_.is_turned[q]);
          s_.add_poly(std::array{middle, to, apex}, s_.poly_origin[q], s_.is_turned[q]);
        } else {
          list.assign(1, middle);
          for (std::uint32_t i = edges.next(c);; i = edges.next(i)) {
            list.push_back(s_.verts[i]);
            if (i == c) break;
          }
          s_.add_poly(list, s_.poly_origin[q], s_.is_turned[q]);
        }
      }
      log_.add(repair_kind::collapsed_degenerate, s_.poly_origin[p]);
    }
    const bool any = std::find(changed.begin(), changed.end(), std::uint8_t{1}) != changed.end();
    changed.resize(s_.num_polys());
    if (any) s_.remove(changed);
    return any;
  }

 public:
  degenerate_triangles(surface_lists& s, repair_log& log) : s_(s), log_(log) {}

  std::vector<std::uint32_t> find() const {
    std::vector<std::uint32_t> all;
    for (std::uint32_t p = 0; p < s_.num_polys(); ++p)
      if (is_degenerate(p)) all.push_back(p);
    return all;
  }
  void remove(const std::vector<std::uint32_t>& all) {
    std::vector<std::uint8_t> marked(s_.num_polys());
    for (const std::uint32_t p : all) {
      marked[p] = 1;
      log_.add(repair_kind::removed_degenerate, s_.poly_origin[p]);
    }
    s_.remove(marked);
  }
  /// The longest edge at each place becomes shorter, so that this ends; but rounding may prevent that.
  void collapse(std::vector<std::uint32_t> all, std::uint32_t arity) {
    for (int round = 0; round < 64 && !all.empty(); ++round) {
      if (!collapse_edges(all, arity) && !split_longest_edges(all)) break;
      all = find();
    }
    for (const std::uint32_t p : all) log_.add(repair_kind::degenerate, s_.poly_origin[p]);
  }
};

CONCINO_INLINE void mend_degenerate(surface_lists& s, degenerate_elements how, std::uint32_t arity, repair_log& log) {
  if (how == degenerate_elements::keep) return;
  degenerate_triangles mender(s, log);
  std::vector<std::uint32_t> all = mender.find();
  if (all.empty()) return;
  if (how == degenerate_elements::remove) mender.remove(all);
  else mender.collapse(std::move(all), arity);
}

CONCINO_INLINE std::vector<std::uint8_t> mend_intersections(surface_lists& s, intersecting_triangles how,
                                                            repair_log& log) {
  if (how == intersecting_triangles::ignore) return {};
  surface_arrays a{s.points, s.offsets, {}, 0};
  for (const std::uint32_t v : s.verts) a.verts.push_back(vert_id{v});
  const polygonmesh m(std::move(a));
  const auto pairs = self_intersections(m);
  if (pairs.empty()) return {};
  const bool removes = how == intersecting_triangles::remove;
  std::vector<std::uint8_t> marked(s.num_polys());
  for (const auto& [p, q] : pairs) marked[p.raw()] = marked[q.raw()] = 1;
  std::vector<std::uint8_t> at(s.points.size());
  for (std::size_t p = 0; p < marked.size(); ++p) {
    if (!marked[p]) continue;
    if (s.poly_origin[p] != surface_lists::none)
      log.add(removes ? repair_kind::removed_intersecting : repair_kind::intersecting, s.poly_origin[p]);
    for (const std::uint32_t v : s.poly(p)) at[v] = 1;
  }
  if (!removes) return {};
  s.remove(marked);
  return at;
}

}  // namespace concino::detail
