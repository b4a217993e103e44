// Divides the segments of a planar graph where they cross, overlap or run through points, by CGAL.
#pragma once

#include <concino/adapters/detail/cgal_planar_mesh.hpp>

#include <CGAL/Constrained_triangulation_plus_2.h>

#include <cmath>

namespace concino::detail::cgal_planar {

/// A graph, and which of its segments were those of another one.
struct divided_graph {
  planar_graph graph;
  std::vector<std::size_t> ends;  // segment i of the other graph was divided into those before ends[i]
};

/// Divides the segments of a graph once. Points where segments meet are rounded, and segments with them. In the plane
/// of the projection no segments cross afterwards; points in space are rounded again.
class segment_divider {
  using faces = CGAL::Constrained_triangulation_face_base_2<kernel>;
  using base =
      CGAL::Constrained_Delaunay_triangulation_2<kernel, CGAL::Triangulation_data_structure_2<vertex_base, faces>,
                                                 CGAL::Exact_predicates_tag>;
  using division = CGAL::Constrained_triangulation_plus_2<base>;

  const planar_graph& input_;
  const core::planar_segments& g_;
  division t_;
  std::vector<division::Constraint_id> constraint_of_;  // by segment
  planar_graph result_;
  std::vector<std::size_t> ends_;  // by segment of the input
  std::size_t count_ = 0;          // of segments of the result

  /// The number of a vertex, which is given one if it has none: that of a point on segment s.
  std::uint32_t number(division::Vertex_handle v, std::uint32_t s) {
    std::uint32_t& p = v->info().point;
    if (p != none) return p;
    const auto& [a, b] = g_.segments[s];
    const vec3 x{v->point().x(), v->point().y(), 0}, normal = cross(g_.axes[0], g_.axes[1]);
    const double scale = std::ldexp(1.0, -g_.exponent), first = dot(input_.points[a], normal),
                 last = dot(input_.points[b], normal);
    const double height = first + norm(x - g_.points[a]) / norm(g_.points[b] - g_.points[a]) * (last - first);
    p = result_.add_point((scale * x.x) * g_.axes[0] + (scale * x.y) * g_.axes[1] + height * normal);
    return p;
  }

  /// Adds the points between the ends of a segment of the input, which begins at point `from`, to a line.
  void add_pieces(std::uint32_t s, std::uint32_t from, std::vector<std::uint32_t>& line) {
    std::vector<std::uint32_t> between;
    for (auto v = t_.vertices_in_constraint_begin(constraint_of_[s]);
         v != t_.vertices_in_constraint_end(constraint_of_[s]); ++v)
      between.push_back(number(*v, s));
    if (between.front() != g_.same_as[from]) std::reverse(between.begin(), between.end());
    line.insert(line.end(), between.begin() + 1, between.end() - 1);
    ends_.push_back(count_ += between.size() - 1);
  }

 public:
  segment_divider(const planar_graph& input, const core::planar_segments& g) : input_(input), g_(g) {
    std::vector<division::Vertex_handle> vertex_of(g.points.size());
    for (const std::uint32_t p : g.used) {
      vertex_of[p] = t_.insert(division::Point(g.points[p].x, g.points[p].y));
      vertex_of[p]->info().point = p;
    }
    constraint_of_.reserve(g.segments.size());
    for (const auto& [a, b] : g.segments) constraint_of_.push_back(t_.insert_constraint(vertex_of[a], vertex_of[b]));
  }

  divided_graph operator()() {
    result_.points = input_.points;
    result_.isolated = input_.isolated;
    std::size_t segment = 0;
    std::vector<std::uint32_t> line;
    for (std::size_t i = 0; i < input_.num_lines(); ++i) {
      const auto old = input_.line(i);
      line.assign({old.front()});
      for (std::size_t k = 1; k < old.size(); ++k) {
        add_pieces(g_.segment_of[segment++], old[k - 1], line);
        line.push_back(old[k]);
      }
      if (input_.line_closed[i] && !input_.repeats_first_point(i))
        add_pieces(g_.segment_of[segment++], old.back(), line);
      result_.add_line_through(line, input_.line_closed[i] != 0);
    }
    return {std::move(result_), std::move(ends_)};
  }
};

/// The same graph with divided segments.
/// Errors: those of planar_segments_of.
inline divided_graph divided(std::string_view caller, const planar_graph& g, std::span<const vec3> holes,
                             const vec3& seen_from, bool merge) {
  divided_graph d{g, {}};
  for (int round = 0; round < 8; ++round) {  // usually the second one finds nothing to do
    const core::planar_segments s = core::planar_segments_of(caller, d.graph, holes, seen_from, merge);
    divided_graph next = segment_divider(d.graph, s)();
    const bool is_done = next.graph.line_points.size() == d.graph.line_points.size();
    if (round == 0) d.ends = next.ends;
    else for (std::size_t& end : d.ends) end = end == 0 ? 0 : next.ends[end - 1];
    d.graph = std::move(next.graph);
    if (is_done) break;
    merge = true;  // points may come to the same place by rounding
  }
  return d;
}

}  // namespace concino::detail::cgal_planar
