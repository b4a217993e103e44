// Builds the convex hull of points that are not all coplanar, one point after another.
#pragma once

#include <concino/core/error.hpp>
#include <concino/geometry/orientation.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

/// Polygons through points, by their numbers.
using hull_polygons = std::vector<std::vector<std::uint32_t>>;

/// The axes i, j of the first projection in which a, b, c are not collinear; equal axes if there is none: then they are
/// collinear.
inline std::array<std::size_t, 2> spanning_axes(const vec3& a, const vec3& b, const vec3& c) {
  for (const auto& [i, j] : {std::array<std::size_t, 2>{0, 1}, {1, 2}, {2, 0}})
    if (orient2d({a[i], a[j], 0}, {b[i], b[j], 0}, {c[i], c[j], 0}) != 0) return {i, j};
  return {0, 0};
}

/// The hull of points that are not all coplanar. The first four points are those of a tet.
class hull_builder {
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  struct facet {
    std::array<std::uint32_t, 3> verts;
    std::array<std::uint32_t, 3> neighbours;  // across the edge from verts[k] to the next
    std::uint32_t outside = none;             // the first point of the list of those that were found to see it
    std::uint32_t group = none;               // of coplanar facets
    bool is_alive = true;
  };
  struct horizon_edge {
    std::uint32_t from, to, beyond;  // beyond: the facet that is not visible
  };

  std::span<const vec3> points_;
  std::vector<facet> facets_;
  std::vector<std::uint32_t> free_, next_outside_, facet_of_, starts_at_;
  std::vector<std::uint64_t> tested_;  // per facet: twice the round in which it was tested, plus 1 if it is visible
  std::vector<std::uint32_t> visible_, new_;
  std::vector<horizon_edge> horizon_;
  std::uint64_t round_ = 1;

  bool sees(std::uint32_t p, std::uint32_t f) const {
    const auto& v = facets_[f].verts;
    return orient3d(points_[v[0]], points_[v[1]], points_[v[2]], points_[p]) > 0;
  }

  std::uint32_t add_facet(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const facet made{{a, b, c}, {none, none, none}};
    if (free_.empty()) {
      facets_.push_back(made);
      tested_.push_back(0);
      return static_cast<std::uint32_t>(facets_.size() - 1);
    }
    const std::uint32_t f = free_.back();
    free_.pop_back();
    facets_[f] = made;
    tested_[f] = 0;
    return f;
  }

  template<class Facets>
  void put_outside_of_one(std::uint32_t p, const Facets& candidates) {
    facet_of_[p] = none;
    for (const std::uint32_t f : candidates)
      if (sees(p, f)) {
        facet_of_[p] = f;
        next_outside_[p] = facets_[f].outside;
        facets_[f].outside = p;
        return;
      }
  }

  void start() {
    std::array<std::uint32_t, 4> t{0, 1, 2, 3};
    if (orient3d(points_[0], points_[1], points_[2], points_[3]) > 0) std::swap(t[1], t[2]);
    for (const auto& [a, b, c] : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})
      add_facet(t[a], t[b], t[c]);
    for (std::uint32_t f = 0; f < 4; ++f)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::uint32_t g = 0; g < 4; ++g)
          for (std::size_t l = 0; l < 3; ++l)
            if (facets_[f].verts[k] == facets_[g].verts[(l + 1) % 3] &&
                facets_[f].verts[(k + 1) % 3] == facets_[g].verts[l])
              facets_[f].neighbours[k] = g;
    for (std::uint32_t p = 4; p < points_.size(); ++p) put_outside_of_one(p, std::array<std::uint32_t, 4>{0, 1, 2, 3});
  }

  /// Collects the facets that p sees, and the edges around them.
  void look_from(std::uint32_t p) {
    ++round_;
    visible_.assign(1, facet_of_[p]);
    horizon_.clear();
    tested_[facet_of_[p]] = 2 * round_ + 1;
    for (std::size_t i = 0; i < visible_.size(); ++i) {
      const facet& f = facets_[visible_[i]];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t g = f.neighbours[k];
        if (tested_[g] / 2 != round_) {
          tested_[g] = 2 * round_ + sees(p, g);
          if (tested_[g] % 2 == 1) visible_.push_back(g);
        }
        if (tested_[g] % 2 == 0) horizon_.push_back({f.verts[k], f.verts[(k + 1) % 3], g});
      }
    }
  }

  void add_point(std::uint32_t p) {
    look_from(p);
    new_.clear();
    for (const auto& [from, to, beyond] : horizon_) {
      const std::uint32_t f = add_facet(from, to, p);
      new_.push_back(f);
      starts_at_[from] = f;
      facets_[f].neighbours[0] = beyond;
      facet& g = facets_[beyond];
      for (std::size_t k = 0; k < 3; ++k)
        if (g.verts[k] == to && g.verts[(k + 1) % 3] == from) g.neighbours[k] = f;
    }
    for (const std::uint32_t f : new_) {
      const std::uint32_t next = starts_at_[facets_[f].verts[1]];
      facets_[f].neighbours[1] = next;
      facets_[next].neighbours[2] = f;
    }
    // A point that saw a removed facet and is still outside sees a new one, see Barber, Dobkin and Huhdanpaa.
    for (const std::uint32_t f : visible_) {
      for (std::uint32_t q = facets_[f].outside; q != none;) {
        const std::uint32_t next = next_outside_[q];
        if (q != p) put_outside_of_one(q, new_);
        q = next;
      }
      facets_[f].is_alive = false;
    }
    free_.insert(free_.end(), visible_.begin(), visible_.end());
  }

  std::uint32_t group_coplanar() {
    std::uint32_t count = 0;
    std::vector<std::uint32_t> later;
    for (std::uint32_t first = 0; first < facets_.size(); ++first) {
      if (!facets_[first].is_alive || facets_[first].group != none) continue;
      facets_[first].group = count;
      later.assign(1, first);
      while (!later.empty()) {
        const facet& f = facets_[later.back()];
        later.pop_back();
        for (const std::uint32_t g : f.neighbours) {
          if (facets_[g].group != none) continue;
          const auto& w = facets_[g].verts;
          const bool flat = std::all_of(w.begin(), w.end(), [&](std::uint32_t x) {
            return x == f.verts[0] || x == f.verts[1] || x == f.verts[2] ||
                   orient3d(points_[f.verts[0]], points_[f.verts[1]], points_[f.verts[2]], points_[x]) == 0;
          });
          if (!flat) continue;
          facets_[g].group = count;
          later.push_back(g);
        }
      }
      ++count;
    }
    return count;
  }

  /// Whether points are corners of the hull: three or more groups meet there.
  std::vector<bool> find_corners() const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> meetings;
    for (const facet& f : facets_)
      if (f.is_alive)
        for (const std::uint32_t v : f.verts) meetings.emplace_back(v, f.group);
    std::sort(meetings.begin(), meetings.end());
    meetings.erase(std::unique(meetings.begin(), meetings.end()), meetings.end());
    std::vector<std::uint32_t> groups(points_.size(), 0);
    for (const auto& [v, group] : meetings) ++groups[v];
    std::vector<bool> result(points_.size());
    for (std::size_t v = 0; v < result.size(); ++v) result[v] = groups[v] >= 3;
    return result;
  }

 public:
  explicit hull_builder(std::span<const vec3> points)
      : points_(points), next_outside_(points.size(), none), facet_of_(points.size(), none),
        starts_at_(points.size(), none) {}

  hull_polygons operator()() {
    start();
    for (std::uint32_t p = 4; p < points_.size(); ++p)
      if (facet_of_[p] != none) add_point(p);
    hull_polygons polygons(group_coplanar());
    const std::vector<bool> is_corner = find_corners();
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> edges(polygons.size());
    for (const facet& f : facets_)
      if (f.is_alive)
        for (std::size_t k = 0; k < 3; ++k)
          if (facets_[f.neighbours[k]].group != f.group) edges[f.group].emplace_back(f.verts[k], f.verts[(k + 1) % 3]);
    for (std::size_t g = 0; g < polygons.size(); ++g) {
      for (const auto& [from, to] : edges[g]) starts_at_[from] = to;
      std::uint32_t v = edges[g].front().first;
      for (std::size_t i = 0; i < edges[g].size(); ++i, v = starts_at_[v])
        if (is_corner[v]) polygons[g].push_back(v);
    }
    return polygons;
  }
};

}  // namespace concino::detail
