// Edges, and triangles or tets, as flat arrays for searches for shortest paths. Independent of the mesh type.
#pragma once

#include <concino/core/vec3.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// The edges, and triangles or tets inside the polys, with verts as corners. Coordinates are near 1.
///
/// A front reaches the last corner of a triangle (or tet) from the other two (or three). The source is unfolded: placed
/// at its distances from the other corners. The straight line from there counts if it passes between them. On a plane
/// and in space this is exact. On other surfaces the front is also curved according to the Gaussian curvature along its
/// path.
class distance_graph {
  struct neighbour {
    double length;
    int vert;
  };
  /// A triangle, relative to one of its corners.
  struct corner {
    int ends[2];  // the other corners
    double lengths[2];
    double cosine, sine;  // of the angle between the edges to the ends
  };
  /// A tet relative to three corners a, b and c: a is the origin, b is (length, 0), c is (cx, cy); (x, y) is the foot
  /// of the last corner in their plane.
  struct local_tet {
    double length;
    double cx, cy;
    double x, y, height;
  };

  std::size_t corners_;  // number of corners of a simplex
  std::vector<vec3> positions_;
  std::vector<std::size_t> neighbour_begin_;  // by vert
  std::vector<neighbour> neighbour_;
  std::vector<std::size_t> simplex_begin_;  // by vert
  std::vector<corner> corner_;              // triangles at each vert
  std::vector<double> curvature_;           // Gaussian curvature at each vert of a surface; 0 on the boundary
  std::vector<int> tet_at_;                 // positions in tet_, grouped by vert
  std::vector<int> tet_;                    // four corners of each tet

  /// Where the list of each vert begins, if each vert occurs in `verts` once per entry of its list.
  static std::vector<std::size_t> count(std::size_t size, const std::vector<int>& verts) {
    std::vector<std::size_t> begin(size + 1);
    for (const int v : verts) ++begin[static_cast<std::size_t>(v) + 1];
    for (std::size_t i = 0; i < size; ++i) begin[i + 1] += begin[i];
    return begin;
  }

  corner seen_from(int vert, int end, int other) const {
    const auto at = [&](int v) { return positions_[static_cast<std::size_t>(v)]; };
    const vec3 a = at(end) - at(vert), b = at(other) - at(vert), normal = cross(a, b);
    const double x = std::sqrt(dot(a, a)), y = std::sqrt(dot(b, b));
    const bool is_point = !(x > 0 && y > 0);
    return {
        {end, other}, {x, y}, is_point ? 0 : dot(a, b) / x / y, is_point ? 0 : std::sqrt(dot(normal, normal)) / x / y};
  }

  void add_triangles(const std::vector<int>& triangles) {
    corner_.resize(triangles.size());
    std::vector<std::size_t> next = simplex_begin_;
    for (std::size_t i = 0; i < triangles.size(); i += 3)
      for (std::size_t k = 0; k < 3; ++k) {
        const int v = triangles[i + k];
        corner_[next[static_cast<std::size_t>(v)]++] =
            seen_from(v, triangles[i + (k + 1) % 3], triangles[i + (k + 2) % 3]);
      }
    find_curvature();
  }

  void find_curvature() {
    constexpr double turn = 6.28318530717958647692;
    curvature_.assign(positions_.size(), 0.0);
    std::vector<std::uint32_t> times(positions_.size());  // how often a vert was met around the current one
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      double angle = 0, area = 0;
      bool is_inside = true;
      const auto for_each_end = [&](const auto& f) {
        for (std::size_t k = simplex_begin_[v]; k < simplex_begin_[v + 1]; ++k)
          for (const int w : corner_[k].ends) f(times[static_cast<std::size_t>(w)]);
      };
      for (std::size_t k = simplex_begin_[v]; k < simplex_begin_[v + 1]; ++k) {
        const corner& c = corner_[k];
        angle += std::atan2(c.sine, c.cosine);
        area += c.lengths[0] * c.lengths[1] * c.sine / 6;
      }
      for_each_end([](std::uint32_t& n) { ++n; });
      for_each_end([&](std::uint32_t n) { is_inside = is_inside && n == 2; });
      for_each_end([](std::uint32_t& n) { n = 0; });
      if (is_inside && area > 0) curvature_[v] = (turn - angle) / area;
    }
  }

  static local_tet seen_from(const vec3& a, const vec3& b, const vec3& c, const vec3& last) {
    const vec3 ab = b - a, ac = c - a, to = last - a, normal = cross(ab, ac);
    const double length = std::sqrt(dot(ab, ab)), area = std::sqrt(dot(normal, normal));
    if (!(area > 0)) return {};
    const vec3 e = ab / length, f = cross(normal, e) / area;
    return {length, dot(ac, e), dot(ac, f), dot(to, e), dot(to, f), std::abs(dot(to, normal)) / area};
  }

  void add_tets() {
    tet_at_.resize(tet_.size());
    std::vector<std::size_t> next = simplex_begin_;
    for (std::size_t i = 0; i < tet_.size(); ++i)
      tet_at_[next[static_cast<std::size_t>(tet_[i])]++] = static_cast<int>(i);
  }

  static constexpr std::size_t others[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};

 public:
  /// edges: two verts each, including diagonals within polys. simplices: the corners of triangles (corners 3) or tets
  /// (4).
  distance_graph(std::vector<vec3> positions, const std::vector<int>& edges, std::vector<int> simplices,
                 std::size_t corners)
      : corners_(corners), positions_(std::move(positions)), neighbour_begin_(count(positions_.size(), edges)),
        neighbour_(edges.size()), simplex_begin_(count(positions_.size(), simplices)) {
    std::vector<std::size_t> next = neighbour_begin_;
    for (std::size_t i = 0; i < edges.size(); i += 2) {
      const int v = edges[i], w = edges[i + 1];
      const double length = distance(positions_[static_cast<std::size_t>(v)], positions_[static_cast<std::size_t>(w)]);
      neighbour_[next[static_cast<std::size_t>(v)]++] = {length, w};
      neighbour_[next[static_cast<std::size_t>(w)]++] = {length, v};
    }
    if (corners_ == 3) {
      add_triangles(simplices);
    } else {
      tet_ = std::move(simplices);
      add_tets();
    }
  }

  const vec3& position(std::size_t v) const { return positions_[v]; }

  /// A vert at which the search starts. Verts with the same source share its number.
  struct start {
    int vert, source;
    double distance;  // from the source, 0 or more
    double before;    // initial distance at the source
  };
  /// The lengths of paths to each vert from the start verts; +inf where no path exists. Paths longer than `longest` may
  /// be omitted. Defined in distance_bounds.hpp.
  std::vector<double> path_lengths_from(const std::vector<start>& starts, double longest) const;

 private:
  class search;
};

}  // namespace concino::detail
