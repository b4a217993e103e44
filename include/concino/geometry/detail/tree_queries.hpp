// Point and box queries of a tree, for items of any kind, in the units of the tree and by rank.
#pragma once

#include <concino/geometry/closest_point.hpp>
#include <concino/geometry/detail/box_tree.hpp>
#include <concino/geometry/detail/surface_facts.hpp>
#include <concino/geometry/detail/triangle_tests.hpp>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace concino::detail {

/// The squared distance from x to the bounding box of three points.
inline double squared_distance_to_box(const vec3& x, const vec3& a, const vec3& b, const vec3& c) {
  const auto beyond = [](double p, double u, double v, double w) {
    const double low = std::min(std::min(u, v), w), high = std::max(std::max(u, v), w);
    return std::max(std::max(low - p, p - high), 0.0);
  };
  const double dx = beyond(x.x, a.x, b.x, c.x), dy = beyond(x.y, a.y, b.y, c.y), dz = beyond(x.z, a.z, b.z, c.z);
  return dx * dx + dy * dy + dz * dz;
}

/// The rank of the poly with the point nearest to x, and that point.
template<class Pieces>
std::optional<std::pair<std::size_t, vec3>> nearest_piece(const Pieces& pieces, const box_tree& boxes, const vec3& x) {
  double least = std::numeric_limits<double>::infinity();
  std::size_t best = 0;
  vec3 nearest;
  // slightly less than the distance of the box: then rounding skips none of several equally near polys, and the first
  // can be found
  boxes.search([&](const box_node& n) { return n.squared_distance(x) * (1 - 0x1p-50); }, least, [&](std::size_t i) {
    const std::size_t rank = pieces.owner(i);
    pieces.for_each_triangle(i, [&](const vec3& a, const vec3& b, const vec3& c) {
      if (squared_distance_to_box(x, a, b, c) * (1 - 0x1p-50) > least) return;
      const vec3 y = closest_point(x, a, b, c);
      const double squared = dot(x - y, x - y);
      if (squared > least || (squared == least && rank >= best)) return;
      least = squared;
      best = rank;
      nearest = y;
    });
  });
  if (!(least < std::numeric_limits<double>::infinity())) return {};
  return std::pair{best, nearest};
}

/// How a point is located: perturbed, so that it lies on no boundary; or unperturbed, where boundaries count.
enum class point_location { perturbed, unperturbed };

/// The rank of the solid poly that contains x, or of the polygon that contains x in the projection along `axis`.
template<class Pieces>
std::optional<std::size_t> containing_piece(const Pieces& pieces, const box_tree& boxes,
                                            [[maybe_unused]] std::size_t axis, const vec3& x, point_location how) {
  std::optional<std::size_t> found;
  if constexpr (Pieces::are_solid) {
    boxes.walk([&](const box_node& n) { return n.holds(x); }, [&](std::size_t i) {
      bool holds = false;
      if (how == point_location::perturbed) holds = pieces.holds(i, x);
      else
        pieces.for_each_triangle(
            i, [&](const vec3& a, const vec3& b, const vec3& c) { holds = holds || is_on_triangle(a, b, c, x); });
      if (holds && (!found || pieces.owner(i) < *found)) found = pieces.owner(i);
      return holds && how == point_location::perturbed;  // if polys tile, no other one contains the perturbed point
    });
  } else {
    double least = std::numeric_limits<double>::infinity();
    const vec3 y = project_along(x, axis);
    boxes.walk([&](const box_node& n) { return n.projection_contains(x, axis); }, [&](std::size_t i) {
      const std::size_t rank = pieces.owner(i);
      pieces.for_each_triangle(i, [&](const vec3& a, const vec3& b, const vec3& c) {
        const vec3 p = project_along(a, axis), q = project_along(b, axis), r = project_along(c, axis);
        if (how == point_location::perturbed) {
          if (perturbed_inside2d(p, q, r, y) == 0) return;
        } else {
          const int s = orient2d(p, q, r);
          if (s == 0 || !inside2d(p, q, r, s, y)) return;
        }
        const double off = height_difference(a, b, c, x, axis);
        if (found && (off > least || (off == least && rank >= *found))) return;
        least = off;
        found = rank;
      });
      return false;
    });
  }
  return found;
}

/// The position of a point relative to a closed surface.
struct surroundings {
  int winding = 0;         // the winding number around the point
  unsigned crossings = 0;  // the number of crossings of the upward ray
  bool touches = false;    // whether the point lies on the surface; the others are then unknown
};

template<class Pieces>
surroundings surface_around(const Pieces& pieces, const box_tree& boxes, const vec3& x) {
  surroundings s;
  s.touches = boxes.walk([&](const box_node& n) { return n.max.z >= x.z && n.projection_contains(x, 2); },
                         [&](std::size_t i) {
                           bool touches = false;
                           pieces.for_each_triangle(i, [&](const vec3& a, const vec3& b, const vec3& c) {
                             const int crossing = crossing_above(a, b, c, x);
                             s.winding += crossing;
                             s.crossings += crossing != 0;
                             touches = touches || is_on_triangle(a, b, c, x);
                           });
                           return touches;
                         });
  return s;
}

/// The ranks of the polys that have a point in common with the box, which is in the units of the tree; sorted.
template<class Pieces>
std::vector<std::size_t> pieces_in_box(const Pieces& pieces, const box_tree& boxes, box b) {
  std::vector<std::size_t> ranks;
  if (boxes.nodes().empty() || !boxes.nodes()[0].meets(b)) return ranks;
  for (std::size_t k = 0; k < 3; ++k) {  // clips to the bounds of the tree; bounds of the box may be infinite
    b.min[k] = std::max(b.min[k], boxes.nodes()[0].min[k]);
    b.max[k] = std::min(b.max[k], boxes.nodes()[0].max[k]);
  }
  boxes.walk([&](const box_node& n) { return n.meets(b); }, [&](std::size_t i) {
    bool meets = false;
    pieces.for_each_triangle(i, [&](const vec3& p, const vec3& q, const vec3& r) {
      meets = meets || triangle_meets_box({p, q, r}, b);
    });
    if constexpr (Pieces::are_solid) meets = meets || pieces.holds(i, b.min);
    if (meets) ranks.push_back(pieces.owner(i));
    return false;
  });
  std::sort(ranks.begin(), ranks.end());
  ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
  return ranks;
}

}  // namespace concino::detail
