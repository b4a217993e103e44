// Defines tube.hpp. Each leaf or joint is a cube, whose faces are divided if more than six bones meet. A bone replaces
// one face at each of its ends by four quads for each of its edges.
#pragma once

#include <concino/skeleton/tube.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace concino::detail {

/// Four verts of a surface, counter-clockwise about a direction.
using tube_ring = std::array<std::uint32_t, 4>;

/// a without its part along the unit vector t, of length 1; some direction orthogonal to t if nothing is left.
inline vec3 unit_orthogonal(vec3 a, const vec3& t) {
  for (const vec3& other : {a, vec3{1, 0, 0}, vec3{0, 1, 0}, vec3{0, 0, 1}}) {
    a = other - dot(other, t) * t;
    if (norm(a) > 0.5 * norm(other) || (other == vec3{0, 0, 1} && norm(a) > 0)) return a / norm(a);
  }
  return {1, 0, 0};
}
inline vec3 unit_or_zero(const vec3& a) {
  const double length = norm(a);
  return length > 0 ? a / length : vec3{};
}

/// The surface of a cube of n x n faces on each side, with points on the unit sphere.
class cube_block {
 public:
  std::vector<vec3> points;
  std::vector<tube_ring> faces;
  std::vector<vec3> directions;  // of the faces

  explicit cube_block(int n) {
    std::map<std::array<int, 3>, std::uint32_t> numbers;
    const auto corner = [&](const std::array<int, 3>& at) {
      const auto [place, is_new] = numbers.insert({at, static_cast<std::uint32_t>(points.size())});
      if (is_new) points.push_back(unit_or_zero({2 * at[0] - n, 2 * at[1] - n, 2 * at[2] - n}));
      return place->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int level : {0, n})
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j) {
            tube_ring face{};
            vec3 sum;
            for (std::size_t k = 0; k < 4; ++k) {
              std::array<int, 3> at{};
              at[axis] = level;
              at[(axis + 1) % 3] = i + (k == 1 || k == 2);
              at[(axis + 2) % 3] = j + (k >= 2);
              face[k] = corner(at);
              sum += points[face[k]];
            }
            if (level == 0) std::reverse(face.begin(), face.end());
            faces.push_back(face);
            directions.push_back(unit_or_zero(sum));
          }
  }
};

class skeleton_tube_builder {
  const flat_curves& g_;
  surface_arrays surface_;
  std::map<int, cube_block> blocks_;
  std::vector<tube_ring> ring_of_edge_;  // at the verts with blocks, for each of their neighbours

  std::uint32_t add_point(const vec3& x) {
    surface_.points.push_back(x);
    return static_cast<std::uint32_t>(surface_.points.size() - 1);
  }
  void add_quad(const tube_ring& q) {
    for (const std::uint32_t v : q) surface_.verts.push_back(vert_id{v});
  }

  /// The face of a block for each direction, with a frame of x and y: the nearest pairs first. Returns the sum of the
  /// cosines of their angles.
  static double assign(const cube_block& block, const std::vector<vec3>& to, const std::array<vec3, 3>& frame,
                       std::vector<std::size_t>& face_of) {
    struct pair {
      double cosine;
      std::size_t direction, face;
    };
    std::vector<pair> pairs;
    for (std::size_t i = 0; i < to.size(); ++i)
      for (std::size_t f = 0; f < block.faces.size(); ++f) {
        const vec3& d = block.directions[f];
        pairs.push_back({dot(to[i], d.x * frame[0] + d.y * frame[1] + d.z * frame[2]), i, f});
      }
    std::stable_sort(pairs.begin(), pairs.end(), [](const pair& a, const pair& b) { return a.cosine > b.cosine; });
    face_of.assign(to.size(), block.faces.size());
    std::vector<char> is_taken(block.faces.size(), 0);
    double sum = 0;
    for (const pair& p : pairs) {
      if (face_of[p.direction] < block.faces.size() || is_taken[p.face]) continue;
      face_of[p.direction] = p.face;
      is_taken[p.face] = 1;
      sum += p.cosine;
    }
    return sum;
  }

  void add_block(std::uint32_t v) {
    std::vector<vec3> to;
    for (std::uint32_t i = g_.first[v]; i < g_.first[v + 1]; ++i)
      to.push_back(unit_or_zero(g_.points[g_.neighbours[i]] - g_.points[v]));
    int n = 1;
    while (6 * static_cast<std::size_t>(n) * static_cast<std::size_t>(n) < to.size()) ++n;
    const cube_block& block = blocks_.try_emplace(n, n).first->second;
    std::array<vec3, 3> best{vec3{1, 0, 0}, vec3{0, 1, 0}, vec3{0, 0, 1}};
    std::vector<std::size_t> best_faces, faces;
    double best_sum = assign(block, to, best, best_faces);
    const std::size_t tried = std::min<std::size_t>(to.size(), 6);
    for (std::size_t i = 0; i < tried; ++i)
      for (std::size_t j = 0; j < tried; ++j) {
        if ((i == j && tried > 1) || to[i] == vec3{}) continue;
        const vec3 y = unit_orthogonal(i == j ? vec3{} : to[j], to[i]);
        const std::array<vec3, 3> frame{to[i], y, cross(to[i], y)};
        if (const double sum = assign(block, to, frame, faces); sum > best_sum + 1e-9)
          best_sum = sum, best = frame, best_faces = faces;
      }
    const auto base = static_cast<std::uint32_t>(surface_.points.size());
    for (const vec3& x : block.points)
      add_point(g_.points[v] + g_.radii[v] * (x.x * best[0] + x.y * best[1] + x.z * best[2]));
    for (std::size_t f = 0; f < block.faces.size(); ++f) {
      tube_ring face = block.faces[f];
      for (std::uint32_t& x : face) x += base;
      const auto found = std::find(best_faces.begin(), best_faces.end(), f);
      if (found == best_faces.end()) add_quad(face);
      else ring_of_edge_[g_.first[v] + static_cast<std::size_t>(found - best_faces.begin())] = face;
    }
  }

  tube_ring ring_at(std::uint32_t from, std::uint32_t to) const {
    std::uint32_t i = g_.first[from];
    while (g_.neighbours[i] != to) ++i;
    return ring_of_edge_[i];
  }

  /// The angle of vert x about an axis through `centre`, from the direction e.
  double angle_of(std::uint32_t x, const vec3& centre, const vec3& axis, const vec3& e) const {
    const vec3 d = surface_.points[x] - centre;
    return std::atan2(dot(d, cross(axis, e)), dot(d, e));
  }

  void join(const tube_ring& a, const tube_ring& b) {
    for (std::size_t i = 0; i < 4; ++i) add_quad({a[i], a[(i + 1) % 4], b[(i + 1) % 4], b[i]});
  }

  /// The rotation, less than a turn by 45 degrees, from an angle to the nearest of four, and which it is.
  static std::pair<double, std::size_t> nearest_turn(double from, const std::array<double, 4>& to) {
    std::pair<double, std::size_t> best{10, 0};
    for (std::size_t k = 0; k < 4; ++k) {
      const double turn = std::remainder(to[k] - from, 2 * std::numbers::pi);
      if (std::abs(turn) < std::abs(best.first)) best = {turn, k};
    }
    return best;
  }

  void add_bone(const std::vector<std::uint32_t>& walk) {
    const bool is_cycle = walk.front() == walk.back() && g_.num_neighbours(walk.front()) == 2;
    const std::size_t n = walk.size() - 1;
    std::vector<vec3> along;  // of the edges
    for (std::size_t i = 0; i < n; ++i) along.push_back(unit_or_zero(g_.points[walk[i + 1]] - g_.points[walk[i]]));
    // The axes at the verts, and directions that turn about them as little as possible.
    std::vector<vec3> axis(n + 1), e(n + 1);
    for (std::size_t i = 0; i <= n; ++i) {
      const vec3 before = i > 0 ? along[i - 1] : is_cycle ? along[n - 1] : vec3{};
      const vec3 after = i < n ? along[i] : is_cycle ? along[0] : vec3{};
      axis[i] = unit_or_zero(before + after);
      if (axis[i] == vec3{}) axis[i] = before;
      if (axis[i] == vec3{}) axis[i] = i > 0 ? axis[i - 1] : vec3{1, 0, 0};
      e[i] = unit_orthogonal(i > 0 ? e[i - 1] : vec3{}, axis[i]);
    }
    tube_ring first{}, last{};
    double start = 0;
    std::array<double, 4> end{};
    if (!is_cycle) {
      first = ring_at(walk[0], walk[1]);
      last = ring_at(walk[n], walk[n - 1]);
      std::reverse(last.begin(), last.end());  // it is seen from the other end
      start = angle_of(first[0], g_.points[walk[0]], axis[0], e[0]);
      for (std::size_t k = 0; k < 4; ++k) end[k] = angle_of(last[k], g_.points[walk[n]], axis[n], e[n]);
    } else {
      const double back = std::atan2(dot(e[0], cross(axis[n], e[n])), dot(e[0], e[n]));
      for (std::size_t k = 0; k < 4; ++k) end[k] = back + 0.5 * std::numbers::pi * static_cast<double>(k);
    }
    const auto [turn, corner] = nearest_turn(start, end);
    tube_ring previous = first;
    for (std::size_t i = is_cycle ? 0 : 1; i < n; ++i) {
      tube_ring ring{};
      for (std::size_t k = 0; k < 4; ++k) {
        const double angle = start + turn * static_cast<double>(i) / static_cast<double>(n) +
                             0.5 * std::numbers::pi * static_cast<double>(k);
        const vec3 out = std::cos(angle) * e[i] + std::sin(angle) * cross(axis[i], e[i]);
        ring[k] = add_point(g_.points[walk[i]] + g_.radii[walk[i]] * out);
      }
      if (is_cycle && i == 0) last = ring;
      else join(previous, ring);
      previous = ring;
    }
    std::rotate(last.begin(), last.begin() + static_cast<std::ptrdiff_t>(corner), last.end());
    join(previous, last);
  }

 public:
  explicit skeleton_tube_builder(const flat_curves& g) : g_(g), ring_of_edge_(g.neighbours.size()) {
    surface_.arity = 4;
  }

  surface_arrays operator()() {
    for (std::uint32_t v = 0; v < g_.points.size(); ++v)
      if (g_.num_neighbours(v) != 2) add_block(v);
    for (const auto& walk : bone_walks(g_)) add_bone(walk);
    return std::move(surface_);
  }
};

CONCINO_INLINE surface_arrays tube_around(const flat_curves& g) { return skeleton_tube_builder(g)(); }

}  // namespace concino::detail
