// A triangle mesh as flat arrays, with each triangle laid into the plane along each of its sides. Paths are unfolded
// with it.
#pragma once

#include <concino/core/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace concino::core {

/// Side s = 3 t + k of triangle t runs from corner k to the next corner; corner k is numbered s as well. Lengths are in
/// units of 2^exponent.
struct unfolded_triangles {
  struct plane_point {
    double x, y;
  };
  /// fan: one closed ring of triangles; open_fan: from boundary to boundary; other: any other arrangement, paths may
  /// pass in any direction.
  enum class vert_fan : unsigned char { fan, open_fan, other };
  /// Widens the turns of paths at a vert beyond the geometric ones, so that rounding leaves no gap between paths on its
  /// two sides.
  static constexpr double turn_tolerance = 1e-8;

  std::vector<int> vert;       // by corner
  std::vector<int> edge;       // by side
  std::vector<int> twin;       // the next side of the same edge, in a cycle; a boundary side is its own twin
  std::vector<double> length;  // by side
  std::vector<plane_point> apex;     // by side: the third corner, along the side from its start and perpendicular to it
  std::vector<double> angle;   // by corner
  std::vector<double> turn;    // by corner: the angle from the start of the fan about its vert
  std::vector<unsigned char> is_backward;   // by corner: the fan goes from the side that ends there to the side that
                                            // starts there
  std::vector<double> whole_turn;           // by vert: the angle of the whole fan
  std::vector<vert_fan> around;          // by vert
  std::vector<int> first_corner, corner;    // the corners at each vert
  int exponent = 0;
  bool is_manifold = true;  // no edge has more than two sides

  static int next(int s) { return s % 3 == 2 ? s - 2 : s + 1; }
  static int previous(int s) { return s % 3 == 0 ? s + 2 : s - 1; }
  int start(int s) const { return vert[static_cast<std::size_t>(s)]; }
  int end(int s) const { return vert[static_cast<std::size_t>(next(s))]; }

  /// Whether a shortest path can pass through vert v. It then has at least half a turn on both sides.
  bool may_be_passed(int v) const {
    const auto i = static_cast<std::size_t>(v);
    return around[i] != vert_fan::fan || whole_turn[i] > 2 * (std::numbers::pi - turn_tolerance);
  }

  /// The angle in the fan of a direction at corner c, which is input as the angle from the side that starts there.
  double fan_angle(int c, double from_side) const {
    const auto i = static_cast<std::size_t>(c);
    return turn[i] + (is_backward[i] ? angle[i] - from_side : from_side);
  }

  void reserve(std::size_t num_triangles) {
    vert.reserve(3 * num_triangles);
    length.reserve(3 * num_triangles);
    apex.reserve(3 * num_triangles);
    angle.reserve(3 * num_triangles);
  }

  /// Adds a triangle of three finite points, in units of 2^exponent; false if it has no area.
  bool add(const std::array<int, 3>& verts, const std::array<vec3, 3>& x) {
    for (std::size_t k = 0; k < 3; ++k) {
      const vec3 side = x[(k + 1) % 3] - x[k], other = x[(k + 2) % 3] - x[k];
      const double size = norm(side), twice_area = norm(cross(side, other)), along = dot(side, other);
      const plane_point p{along / size, twice_area / size};
      if (!(size > 0 && p.y > 0 && std::isfinite(p.x) && std::isfinite(p.y))) return false;
      vert.push_back(verts[k]);
      length.push_back(size);
      apex.push_back(p);
      angle.push_back(std::atan2(twice_area, along));
    }
    return true;
  }

  /// Call this after all triangles are added: edge_of[s] is the edge of side s.
  void join(std::vector<int> edge_of, std::size_t num_edges, std::size_t num_verts) {
    edge = std::move(edge_of);
    const auto n = static_cast<int>(vert.size());
    std::vector<int> last(num_edges, -1);
    twin.resize(vert.size());
    for (int s = 0; s < n; ++s) {
      int& of_edge = last[static_cast<std::size_t>(edge[static_cast<std::size_t>(s)])];
      int& own_twin = twin[static_cast<std::size_t>(s)];
      if (of_edge < 0) {
        own_twin = s;
      } else {
        int& other = twin[static_cast<std::size_t>(of_edge)];
        is_manifold = is_manifold && other == of_edge;
        own_twin = other;
        other = s;
      }
      of_edge = s;
    }
    first_corner.assign(num_verts + 1, 0);
    for (const int v : vert) ++first_corner[static_cast<std::size_t>(v) + 1];
    for (std::size_t v = 0; v < num_verts; ++v) first_corner[v + 1] += first_corner[v];
    std::vector<int> at(first_corner.begin(), first_corner.end() - 1);
    corner.resize(vert.size());
    for (int s = 0; s < n; ++s) corner[static_cast<std::size_t>(at[static_cast<std::size_t>(start(s))]++)] = s;
    turn.assign(vert.size(), 0);
    is_backward.assign(vert.size(), 0);
    whole_turn.assign(num_verts, 0);
    around.assign(num_verts, vert_fan::other);
    for (std::size_t v = 0; v < num_verts; ++v) walk_around(v);
  }

 private:
  bool is_boundary(int s) const { return twin[static_cast<std::size_t>(s)] == s; }

  void walk_around(std::size_t v) {
    const int first = first_corner[v], n = first_corner[v + 1] - first;
    if (n == 0) return;
    // start at the boundary, if there is one
    int c = corner[static_cast<std::size_t>(first)];
    bool backward = false;
    for (int k = first; k < first + n; ++k) {
      const int here = corner[static_cast<std::size_t>(k)];
      if (!is_boundary(here) && !is_boundary(previous(here))) continue;
      c = here;
      backward = !is_boundary(here);
      break;
    }
    const bool is_open = is_boundary(backward ? previous(c) : c);
    const int begin = c;
    double sum = 0;
    for (int visited = 1; visited <= n; ++visited) {
      const auto i = static_cast<std::size_t>(c);
      turn[i] = sum;
      is_backward[i] = backward;
      sum += angle[i];
      const int crossed = backward ? c : previous(c), other = twin[static_cast<std::size_t>(crossed)];
      if (twin[static_cast<std::size_t>(other)] != crossed) return;  // three triangles at one edge
      const bool ends_here = other == crossed;
      if (!ends_here) {
        const bool starts = start(other) == static_cast<int>(v);
        c = starts ? other : next(other);
        backward = !starts;
      }
      if (!ends_here && c != begin) continue;
      if (visited < n || ends_here != is_open) return;  // several fans at one vert
      around[v] = is_open ? vert_fan::open_fan : vert_fan::fan;
      whole_turn[v] = sum;
      return;
    }
  }
};

}  // namespace concino::core
