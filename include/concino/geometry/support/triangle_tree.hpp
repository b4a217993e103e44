// Triangles with a tree of their boxes, for the distance between surfaces.
#pragma once

#include <concino/geometry/bounding_box.hpp>
#include <concino/geometry/closest_point.hpp>
#include <concino/geometry/detail/box_tree_build.hpp>
#include <concino/geometry/detail/polygon_pieces.hpp>
#include <concino/geometry/detail/tree_queries.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino::core {

/// Triangles with a tree of their boxes.
class triangle_tree {
  std::vector<detail::triangle_points> triangles_;
  detail::box_tree boxes_;

 public:
  explicit triangle_tree(std::vector<detail::triangle_points> triangles) {
    std::vector<std::uint32_t> order;
    boxes_ = detail::build_box_tree(triangles.size(), 4, [&](std::size_t i) {
      box b;
      for (const vec3& x : triangles[i]) b.add(x);
      return b;
    }, order);
    detail::arrange(triangles, order);
    triangles_ = std::move(triangles);
  }

  const detail::triangle_points& triangle(std::size_t i) const { return triangles_[i]; }
  double squared_distance(const vec3& x, std::size_t i) const {
    const detail::triangle_points& t = triangles_[i];
    const vec3 d = x - closest_point(x, t[0], t[1], t[2]);
    return dot(d, d);
  }

  struct nearest_result {
    std::size_t triangle;
    double squared;
  };
  /// The triangle nearest to x. The search is quick if `guess` is near.
  nearest_result nearest(const vec3& x, std::size_t guess) const {
    nearest_result best{guess, squared_distance(x, guess)};
    boxes_.search([&](const detail::box_node& n) { return n.squared_distance(x); }, best.squared, [&](std::size_t i) {
      const detail::triangle_points& t = triangles_[i];
      if (detail::squared_distance_to_box(x, t[0], t[1], t[2]) >= best.squared) return;
      const double squared = squared_distance(x, i);
      if (squared < best.squared) best = {i, squared};
    });
    return best;
  }
};

}  // namespace concino::core
