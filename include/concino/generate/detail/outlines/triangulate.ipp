// Bodies of triangulate.hpp: triangulate: triangles inside outlines, with holes, open lines and isolated points,
// without new points.
#pragma once

#include <concino/generate/detail/outlines/monotone_polygon.hpp>
#include <concino/generate/detail/outlines/planar_faces.hpp>
#include <concino/generate/triangulate.hpp>
#include <concino/geometry/triangulate_polygon.hpp>

#include <algorithm>
#include <utility>

namespace concino::detail {

/// Fills the regions of a graph with triangles.
class region_filler {
  static constexpr std::uint32_t none = core::planar_segments::none;
  /// Ears of polygons give better triangles, but may take quadratic time; a region with more corners is divided into
  /// monotone ones.
  static constexpr std::size_t max_ear_corners = 1000;

  const planar_graph& input_;
  core::planar_segments g_;
  core::swept_segments swept_;
  std::vector<std::uint32_t> hole_above_;  // by segment: a hole point right above it
  std::vector<std::uint32_t> next_hole_;   // by hole point: the next one above the same segment
  std::vector<std::uint8_t> is_hole_found_;
  std::vector<std::uint8_t> filled_above_, filled_below_;  // by segment
  std::vector<std::array<std::uint32_t, 3>> triangles_;  // of points

  bool is_segment(std::uint32_t d) const { return d / 2 < g_.segments.size(); }

  bool is_filled(const std::vector<std::uint32_t>& edges) {
    if (g_.holes.empty()) {
      for (const std::uint32_t d : edges)
        if (is_segment(d)) return swept_.inside_above[d / 2] != (d % 2 == 1 && g_.is_outline[d / 2]);
      return false;
    }
    bool filled = true;
    for (const std::uint32_t d : edges)
      if (is_segment(d) && d % 2 == 1 && swept_.unbounded_below[d / 2]) return false;
    for (const std::uint32_t d : edges)
      if (is_segment(d) && hole_above_[d / 2] != none && d % 2 == 0) {
        filled = false;
        for (std::uint32_t h = hole_above_[d / 2]; h != none; h = next_hole_[h]) is_hole_found_[h] = 1;
      }
    return filled;
  }

  void place_holes() {
    hole_above_.assign(g_.segments.size(), none);
    next_hole_.assign(g_.holes.size(), none);
    is_hole_found_.assign(g_.holes.size(), 0);
    for (std::uint32_t h = 0; h < g_.holes.size(); ++h) {
      const std::uint32_t s = swept_.below_hole[h];
      if (s == none) continue;
      next_hole_[h] = hole_above_[s];
      hole_above_[s] = h;
    }
  }

  /// Finds the filled regions. Returns the largest number of corners of one.
  std::size_t find_filled() {
    filled_above_.assign(g_.segments.size(), 0);
    filled_below_.assign(g_.segments.size(), 0);
    std::size_t largest = 0;
    planar_faces(g_, swept_.bridges)
        .for_each([&](const std::vector<std::uint32_t>& cycle, const std::vector<std::uint32_t>& edges) {
          if (!is_filled(edges)) return;
          largest = std::max(largest, cycle.size());
          for (const std::uint32_t d : edges)
            if (is_segment(d)) (d % 2 == 0 ? filled_above_ : filled_below_)[d / 2] = 1;
        });
    for (std::size_t h = 0; h < is_hole_found_.size(); ++h)
      if (!is_hole_found_[h])
        core::throw_joined<invalid_argument>({"triangulate: hole point ", h, " lies in no bounded region"});
    return largest;
  }

  /// Whether find_filled found that the region is filled.
  bool is_marked(const std::vector<std::uint32_t>& edges) const {
    for (const std::uint32_t d : edges)
      if (is_segment(d)) return (d % 2 == 0 ? filled_above_ : filled_below_)[d / 2];
    return true;  // diagonals are in filled regions only
  }

 public:
  region_filler(const planar_graph& input, const triangulate_options& options)
      : input_(input),
        g_(core::planar_segments_of("triangulate", input, options.holes, options.seen_from, options.merge_points)),
        swept_(core::sweep(g_)) {}

  void fill() {
    place_holes();
    const bool is_divided = find_filled() > max_ear_corners;
    if (is_divided) swept_.bridges = core::monotone_diagonals(g_, filled_above_);
    polygon_triangulator cut;
    monotone_polygon cut_monotone;
    std::vector<vec3> corners;
    planar_faces(g_, swept_.bridges)
        .for_each([&](const std::vector<std::uint32_t>& cycle, const std::vector<std::uint32_t>& edges) {
          if (!is_marked(edges)) return;
          if (is_divided && cycle.size() > max_ear_corners)
            return cut_monotone(g_, cycle, [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
              triangles_.push_back({p, q, r});
            });
          corners.clear();
          for (const std::uint32_t p : cycle) corners.push_back(g_.points[p]);
          for (const polygon_triangle& t : cut.from_above(corners))
            triangles_.push_back({cycle[t[0]], cycle[t[1]], cycle[t[2]]});
        });
  }

  planar_triangulation result() const {
    std::vector<vert_id> vert_of(input_.points.size());
    for (const auto& t : triangles_)
      for (const std::uint32_t p : t) vert_of[p] = vert_id{0};
    surface_arrays a{{}, {}, {}, 3};
    for (const std::uint32_t p : g_.used)
      if (!vert_of[p].is_none()) {
        vert_of[p] = vert_id{a.points.size()};
        a.points.push_back(input_.points[p]);
      }
    a.verts.reserve(3 * triangles_.size());
    for (const auto& t : triangles_)
      for (const std::uint32_t p : t) a.verts.push_back(vert_of[p]);
    for (std::size_t p = 0; p < vert_of.size(); ++p)
      if (g_.same_as[p] != none) vert_of[p] = vert_of[g_.same_as[p]];
    planar_triangulation result{trimesh(std::move(a)), std::move(vert_of), {}, {}, {}};
    add_edges(result);
    return result;
  }

 private:
  void add_edges(planar_triangulation& r) const {
    std::vector<std::array<vert_id, 2>> ends;
    ends.reserve(g_.segments.size());
    for (const auto& [a, b] : g_.segments) ends.push_back({r.vert_of[a], r.vert_of[b]});
    const std::vector<edge_id> edge_of = core::edges_between(r.mesh, ends);
    for (const edge_id e : edge_of)
      if (!e.is_none()) r.constraints.push_back(e);
    std::sort(r.constraints.begin(), r.constraints.end());
    for (const std::uint32_t s : g_.segment_of) {
      if (!edge_of[s].is_none()) r.segment_edges.push_back(edge_of[s]);
      r.segment_ends.push_back(r.segment_edges.size());
    }
  }
};

}  // namespace concino::detail

namespace concino {

CONCINO_INLINE planar_triangulation triangulate(const planar_graph& g, const triangulate_options& options) {
  detail::region_filler filler(g, options);
  filler.fill();
  return filler.result();
}

}  // namespace concino
