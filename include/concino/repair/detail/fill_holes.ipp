// Bodies of surface_steps.hpp that fill holes.
#pragma once

#include <concino/core/local_points.hpp>
#include <concino/graph/boundary_loops.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/repair/detail/surface_steps.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

namespace concino::detail {

/// Fills one hole after another. Triangles of a filling have area, and edges that are new.
class hole_filler {
  surface_lists& s_;
  const polygonmesh mesh_;                                   // before the first filling
  std::vector<std::uint32_t> place_;                         // by vert: in the hole
  std::set<std::pair<std::uint32_t, std::uint32_t>> added_;  // edges of fillings, the smaller vert first
  std::vector<std::uint32_t> hole_;                          // in the direction of the filling
  std::vector<std::uint8_t> is_edge_;                        // by two places in the hole: they cannot be joined
  core::local_points local_;

  static polygonmesh mesh_of(const surface_lists& s) {
    surface_arrays a{s.points, s.offsets, {}, 0};
    a.verts.reserve(s.verts.size());
    for (const std::uint32_t v : s.verts) a.verts.push_back(vert_id{v});
    return polygonmesh(std::move(a));
  }

  std::size_t size() const { return hole_.size(); }
  static std::pair<std::uint32_t, std::uint32_t> ordered(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

  /// Finds which verts of the hole are joined by edges that are no edges of the hole.
  void find_edges() {
    is_edge_.assign(size() * size(), 0);
    for (std::size_t i = 0; i < size(); ++i) place_[hole_[i]] = static_cast<std::uint32_t>(i);
    for (std::size_t i = 0; i < size(); ++i)
      for (const vert_id w : adj_v2v(mesh_, vert_id{hole_[i]}))
        if (place_[w.raw()] != surface_lists::none) is_edge_[i * size() + place_[w.raw()]] = 1;
    for (std::size_t i = 0; !added_.empty() && i < size(); ++i)
      for (std::size_t j = 0; j < size(); ++j)
        if (added_.contains(ordered(hole_[i], hole_[j]))) is_edge_[i * size() + j] = 1;
    for (const std::uint32_t v : hole_) place_[v] = surface_lists::none;
  }

  bool has_area(const vec3& a, const vec3& b, const vec3& c) const {
    const std::array<vec3, 3> corners{a, b, c};
    return !core::is_degenerate_simplex(corners);
  }
  bool is_poly(std::span<const std::uint32_t> list) const {
    for (const poly_id p : adj_v2p(mesh_, vert_id{list[0]})) {
      std::size_t common = 0, n = 0;
      for (const vert_id v : adj_p2v(mesh_, p)) {
        ++n;
        common += std::find(list.begin(), list.end(), v.raw()) != list.end();
      }
      if (n == list.size() && common == n) return true;
    }
    return false;
  }
  void add(std::initializer_list<std::uint32_t> list) {
    s_.add_poly({list.begin(), list.size()}, surface_lists::none);
    for (const std::uint32_t *v = list.begin(), *w = list.end() - 1; v != list.end(); w = v++)
      added_.insert(ordered(*v, *w));
  }

  /// The triangles i < k < j of least area, over all ways to divide the polygon.
  bool add_minimal_area() {
    const std::size_t n = size();
    constexpr double never = std::numeric_limits<double>::infinity();
    local_.points.clear();
    for (const std::uint32_t v : hole_) local_.points.push_back(s_.points[v]);
    if (!local_.fit()) return false;
    const std::vector<vec3>& x = local_.points;
    std::vector<double> least(n * n, never);  // from i to j
    std::vector<std::uint32_t> middle(n * n, 0);
    for (std::size_t i = 0; i + 1 < n; ++i) least[i * n + i + 1] = 0;
    for (std::size_t length = 2; length < n; ++length)
      for (std::size_t i = 0; i + length < n; ++i) {
        const std::size_t j = i + length;
        if (length + 1 < n && is_edge_[i * n + j]) continue;
        for (std::size_t k = i + 1; k < j; ++k) {
          const double rest = least[i * n + k] + least[k * n + j];
          if (!(rest < least[i * n + j])) continue;
          const double all = rest + norm(cross(x[k] - x[i], x[j] - x[i]));
          if (!(all < least[i * n + j])) continue;
          if (!has_area(s_.points[hole_[i]], s_.points[hole_[k]], s_.points[hole_[j]])) continue;
          least[i * n + j] = all;
          middle[i * n + j] = static_cast<std::uint32_t>(k);
        }
      }
    if (!(least[n - 1] < never)) return false;
    std::vector<std::pair<std::size_t, std::size_t>> stack{{0, n - 1}};
    while (!stack.empty()) {
      const auto [i, j] = stack.back();
      stack.pop_back();
      if (j == i + 1) continue;
      const std::size_t k = middle[i * n + j];
      add({hole_[i], hole_[k], hole_[j]});
      stack.push_back({k, j});
      stack.push_back({i, k});
    }
    return true;
  }

  bool add_fan() {
    vec3 mean = s_.points[hole_[0]];
    for (const std::uint32_t v : hole_) mean += (s_.points[v] - s_.points[hole_[0]]) / static_cast<double>(size());
    for (std::size_t i = 0; i < size(); ++i)
      if (!has_area(s_.points[hole_[i]], s_.points[hole_[(i + 1) % size()]], mean)) return false;
    const std::uint32_t centre = s_.add_vert(mean, surface_lists::none);
    s_.of_new_verts.emplace_back();
    for (const std::uint32_t v : hole_) s_.of_new_verts.back().push_back(s_.vert_origin[v]);
    for (std::size_t i = 0; i < size(); ++i) add({hole_[i], hole_[(i + 1) % size()], centre});
    return true;
  }

  bool fill(hole_filling how, std::uint32_t arity) {
    if (arity == 4) {
      if (size() != 4 || is_poly(hole_)) return false;
      add({hole_[0], hole_[1], hole_[2], hole_[3]});
      return true;
    }
    if (size() == 3) {
      if (is_poly(hole_) || !has_area(s_.points[hole_[0]], s_.points[hole_[1]], s_.points[hole_[2]])) return false;
      add({hole_[0], hole_[1], hole_[2]});
      return true;
    }
    if (how == hole_filling::minimal_area) {
      find_edges();
      if (add_minimal_area()) return true;
    }
    return add_fan();
  }

 public:
  explicit hole_filler(surface_lists& s) : s_(s), mesh_(mesh_of(s)), place_(s.points.size(), surface_lists::none) {}

  bool fill(std::size_t max_edges, const std::vector<std::uint8_t>& marked, hole_filling how, std::uint32_t arity,
            repair_log& log) {
    bool any = false;
    for (const auto& loop : boundary_loops(mesh_).loops) {
      if (!loop.is_closed()) continue;
      hole_.clear();
      bool is_marked = !marked.empty(), is_known = true;
      for (const vert_id v : loop.verts) {
        hole_.push_back(v.raw());
        is_marked = is_marked && marked[v.raw()];
        is_known = is_known && is_finite(s_.points[v.raw()]);
      }
      if (!is_known || (size() > max_edges && !is_marked)) continue;
      std::reverse(hole_.begin(), hole_.end());
      const std::uint32_t at = *std::min_element(hole_.begin(), hole_.end());
      const bool is_filled = fill(how, arity);
      any = any || is_filled;
      log.add(is_filled ? repair_kind::filled_holes : repair_kind::left_hole, s_.vert_origin[at]);
    }
    return any;
  }
};

CONCINO_INLINE bool fill_holes(surface_lists& s, std::size_t max_edges, const std::vector<std::uint8_t>& marked,
                               hole_filling how, std::uint32_t arity, repair_log& log) {
  if (max_edges < 3 && marked.empty()) return false;
  return hole_filler(s).fill(max_edges, marked, how, arity, log);
}

}  // namespace concino::detail
