// planar_graph: outlines, open lines and isolated points that are to be triangulated; and planar_triangulation, what
// becomes of them.
#pragma once

#include <concino/core/error.hpp>
#include <concino/mesh/trimesh.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <span>
#include <tuple>
#include <vector>

namespace concino {

namespace detail {

/// A container of points with two or three coordinates.
template<class R> concept planar_points = requires(const R& r) {
  { (*std::begin(r))[0] } -> std::convertible_to<double>;
  { (*std::begin(r))[1] } -> std::convertible_to<double>;
};

/// p as a point in space; one that is known to have two coordinates has z = 0.
template<class P>
vec3 planar_point(const P& p) {
  if constexpr (requires { std::tuple_size<P>::value; })
    if constexpr (std::tuple_size<P>::value == 2) return {static_cast<double>(p[0]), static_cast<double>(p[1]), 0};
    else return to_vec3(p);
  else if constexpr (requires { P::SizeAtCompileTime; })  // of Eigen
    if constexpr (P::SizeAtCompileTime == 2) return {static_cast<double>(p[0]), static_cast<double>(p[1]), 0};
    else return to_vec3(p);
  else return to_vec3(p);
}

}  // namespace detail

/// A planar straight-line graph: lines through numbered points. The last point of a closed line, an outline, is joined
/// to the first one, unless it repeats it: then both are one vert. Flat arrays: line i has the points
/// line_points[line_ends[i - 1]] to line_points[line_ends[i] - 1]. Lines may share points and segments.
///
///   planar_graph g;
///   for (std::size_t i = 0; i < layer.outer.size(); ++i) g.add_outline(layer.outer[i], layer.z);  // of
///   load_slices(path) for (const auto& line : isolines(m, u, {0.5})) g.add_line(line.points, line.closed);
struct planar_graph {
  std::vector<vec3> points;
  std::vector<std::uint32_t> line_points;  // numbers of points
  std::vector<std::uint32_t> line_ends;
  std::vector<std::uint8_t> line_closed;   // 1: an outline, 0: an open line
  std::vector<std::uint32_t> isolated;     // numbers of points that are to be verts, although they may be on no line

  planar_graph() = default;
  /// One outline.
  planar_graph(std::initializer_list<vec3> outline) { add_outline(outline); }
  template<detail::planar_points Outline>
  planar_graph(const Outline& outline) { add_outline(outline); }

  std::size_t num_lines() const { return line_ends.size(); }
  std::span<const std::uint32_t> line(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : line_ends[i - 1];
    return {line_points.data() + begin, line_ends[i] - begin};
  }

  /// Whether a line is closed and its last point is the first one again, by its number or its coordinates.
  bool repeats_first_point(std::size_t i) const {
    const auto numbers = line(i);
    if (!line_closed[i] || numbers.size() < 2) return false;
    const std::uint32_t first = numbers.front(), last = numbers.back();
    return first == last || (first < points.size() && last < points.size() && points[first] == points[last]);
  }

  std::uint32_t add_point(const vec3& p) {
    points.push_back(p);
    return static_cast<std::uint32_t>(points.size() - 1);
  }
  std::uint32_t add_isolated(const vec3& p) {
    isolated.push_back(add_point(p));
    return isolated.back();
  }

  /// Adds points, and the line through them. Returns the number of the line. With z, only two coordinates of the points
  /// are used.
  template<detail::planar_points Line = std::initializer_list<vec3>>
  std::size_t add_line(const Line& line, bool closed = false) {
    for (const auto& p : line) line_points.push_back(add_point(detail::planar_point(p)));
    return end_line(closed);
  }
  template<detail::planar_points Outline = std::initializer_list<vec3>>
  std::size_t add_outline(const Outline& outline) { return add_line(outline, true); }
  template<detail::planar_points Outline>
  std::size_t add_outline(const Outline& outline, double z) {
    for (const auto& p : outline)
      line_points.push_back(add_point({static_cast<double>(p[0]), static_cast<double>(p[1]), z}));
    return end_line(true);
  }

  /// Adds a line through points that are there. Returns its number.
  std::size_t add_line_through(std::span<const std::uint32_t> numbers, bool closed = false) {
    line_points.insert(line_points.end(), numbers.begin(), numbers.end());
    return end_line(closed);
  }

  /// The segments of all lines, line after line, each as two numbers of points.
  std::vector<std::array<std::uint32_t, 2>> segments() const {
    std::vector<std::array<std::uint32_t, 2>> list;
    list.reserve(line_points.size());
    for (std::size_t i = 0; i < num_lines(); ++i) {
      const auto numbers = line(i);
      for (std::size_t k = 1; k < numbers.size(); ++k) list.push_back({numbers[k - 1], numbers[k]});
      if (line_closed[i] && !numbers.empty() && !repeats_first_point(i))
        list.push_back({numbers.back(), numbers.front()});
    }
    return list;
  }

 private:
  std::size_t end_line(bool closed) {
    line_ends.push_back(static_cast<std::uint32_t>(line_points.size()));
    line_closed.push_back(closed);
    return num_lines() - 1;
  }
};

/// The triangles of a planar_graph, and what its points and segments are in them.
struct planar_triangulation {
  trimesh mesh;
  std::vector<vert_id> vert_of;            // by the number of a point; invalid if it is not in the mesh
  std::vector<edge_id> constraints;        // the edges of all segments, ascending, each once
  std::vector<std::size_t> segment_ends;   // segment i of planar_graph::segments() has the edges before
                                           // segment_edges[segment_ends[i]], in order
  std::vector<edge_id> segment_edges;
  std::vector<poly_id> small_angles = {};  // triangles with an angle below the one asked for, at small angles between
                                           // segments

  /// The edges of a segment, in order from its first point to its second one; none if it is not in the mesh.
  std::span<const edge_id> edges_of(std::size_t segment) const {
    const std::size_t begin = segment == 0 ? 0 : segment_ends[segment - 1];
    return {segment_edges.data() + begin, segment_ends[segment] - begin};
  }
};

}  // namespace concino
