// triangulate(outlines, cgal): constrained Delaunay triangulations, and meshes without small angles or large triangles,
// by CGAL's 2D mesher.
// Needs: CGAL 5.5, its packages 2D Triangulations and 2D Meshes, under the GPL (Debian: libcgal-dev), GMP and MPFR.
#pragma once

#include <concino/adapters/cgal_tag.hpp>
#include <concino/adapters/cgal_triangulate_options.hpp>
#include <concino/adapters/detail/cgal_planar_division.hpp>
#include <concino/adapters/detail/cgal_planar_mesh.hpp>
#include <concino/generate/planar_graph.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace concino {

namespace detail::cgal_planar {

/// Makes the result from a planar_mesh.
class triangulator {
  const planar_graph& input_;
  const cgal_triangulate_options& options_;
  core::planar_segments g_;
  double scale_;   // a length of the input, by the same one in g_
  vec3 normal_;
  planar_mesh mesh_;
  planar_triangulation result_;
  std::vector<std::array<vert_id, 2>> chain_;                    // the verts of edges along segments, segment after
                                                                 // segment in any order
  std::vector<std::array<std::size_t, 2>> chain_of_;             // by segment: its first and last entry, exclusive, in
                                                                 // chain_
  CGAL::Unique_hash_map<vertex, vert_id> vert_of_;

  static core::planar_segments checked(const planar_graph& g, const cgal_triangulate_options& o) {
    check(o);
    core::planar_segments segments = core::planar_segments_of("triangulate", g, o.holes, o.seen_from, o.merge_points);
    core::sweep(segments);  // for its errors
    return segments;
  }

  vec3 in_space(double x, double y, double height) const {
    return (scale_ * x) * g_.axes[0] + (scale_ * y) * g_.axes[1] + height * normal_;
  }
  double height(std::uint32_t p) const { return dot(input_.points[p], normal_); }

  void refine() {
    const double infinity = std::numeric_limits<double>::infinity();
    if (options_.min_angle_deg == 0 && options_.max_area == infinity && options_.max_length == infinity &&
        !options_.size)
      return;
    const auto size = [&](double x, double y) {
      const vec3 at = in_space(x, y, 0);
      const double s = options_.size(at);
      if (!(s > 0))
        core::throw_joined<invalid_argument>({"triangulate: options.size is ", core::number_text(s), " at (",
                                              core::number_text(at.x), ", ", core::number_text(at.y), ", ",
                                              core::number_text(at.z), "); it must be above 0"});
      return s / scale_;
    };
    const double sine = std::sin(options_.min_angle_deg * (std::numbers::pi / 180));
    bounds b;
    b.squared_sine = sine * sine;
    b.max_area = options_.max_area / scale_ / scale_;
    b.max_length = options_.max_length / scale_;
    if (options_.size) b.size = size;
    mesh_.refine(b, options_.max_verts, options_.progress);
    small_sine_ = b.squared_sine;
  }
  double small_sine_ = 0;

  void add_vert(const vertex& v, surface_arrays& a, const vec3& p) {
    vert_of_[v] = vert_id{a.points.size()};
    a.points.push_back(p);
  }

  /// Heights of added verts are those of the triangulation without them; on segments, those of the segments.
  void add_verts(const triangulation& before, surface_arrays& a) {
    const vert_id used{0};
    for (auto f = mesh_.cgal().finite_faces_begin(); f != mesh_.cgal().finite_faces_end(); ++f)
      for (int k = 0; f->is_in_domain() && k < 3; ++k) vert_of_[f->vertex(k)] = used;
    for (const std::uint32_t p : g_.used)
      if (const vertex v = mesh_.vertex_of(p); !vert_of_[v].is_none()) add_vert(v, a, input_.points[p]);
    chain_of_.resize(g_.segments.size());
    mesh_.for_each_chain([&](std::uint32_t s, const std::vector<vertex>& chain) {
      const double first = height(g_.segments[s][0]), last = height(g_.segments[s][1]);
      const auto &p = chain.front()->point(), &q = chain.back()->point();
      for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
        const auto& x = chain[i]->point();
        if (!vert_of_[chain[i]].is_none())
          add_vert(chain[i], a,
                   in_space(x.x(), x.y(),
                            first + std::sqrt(CGAL::squared_distance(p, x) / CGAL::squared_distance(p, q)) *
                                        (last - first)));
        is_placed_[chain[i]] = 1;
      }
      chain_of_[s][0] = chain_.size();
      for (std::size_t i = 1; i < chain.size(); ++i) chain_.push_back({vert_of_[chain[i - 1]], vert_of_[chain[i]]});
      chain_of_[s][1] = chain_.size();
    });
    if (is_flat()) add_inner_verts(a);
    else add_inner_verts(before, a);
  }

  /// Whether the heights of all points are equal, up to rounding.
  bool is_flat() const {
    double low = std::numeric_limits<double>::infinity(), high = -low, size = 0;
    for (const std::uint32_t p : g_.used) {
      low = std::min(low, height(p));
      high = std::max(high, height(p));
      size = std::max(size, norm(input_.points[p]));
    }
    return !(high - low > 0x1p-50 * size);
  }

  bool is_added(const vertex& v) const { return v->info().point == none && !is_placed_[v] && !vert_of_[v].is_none(); }

  void add_inner_verts(surface_arrays& a) {
    for (auto v = mesh_.cgal().finite_vertices_begin(); v != mesh_.cgal().finite_vertices_end(); ++v)
      if (is_added(v)) add_vert(v, a, in_space(v->point().x(), v->point().y(), height(g_.used.front())));
  }

  /// From neighbour to neighbour, so that each is located near one that is.
  void add_inner_verts(const triangulation& before, surface_arrays& a) {
    const triangulation& t = mesh_.cgal();
    CGAL::Unique_hash_map<vertex, std::uint8_t> is_met(std::uint8_t{0});
    std::vector<std::pair<vertex, face>> moved;
    const auto meet = [&](const vertex& v, const face& hint) {
      if (t.is_infinite(v) || is_met[v]) return;
      is_met[v] = 1;
      moved.emplace_back(v, before.locate(v->point(), hint));
    };
    if (t.dimension() == 2) meet(t.finite_vertices_begin(), before.infinite_face());
    for (std::size_t i = 0; i < moved.size(); ++i) {
      const auto [v, at] = moved[i];
      if (is_added(v)) add_vert(v, a, in_space(v->point().x(), v->point().y(), height_in(before, at, v->point())));
      auto next = t.incident_vertices(v);
      const auto first = next;
      do meet(next, at);
      while (++next != first);
    }
  }
  CGAL::Unique_hash_map<vertex, std::uint8_t> is_placed_{std::uint8_t{0}};

  double height_in(const triangulation& t, face f, const triangulation::Point& x) const {
    if (t.is_infinite(f)) f = f->neighbor(f->index(t.infinite_vertex()));
    const auto &p = f->vertex(0)->point(), &q = f->vertex(1)->point(), &r = f->vertex(2)->point();
    const double at_p = height(f->vertex(0)->info().point), whole = CGAL::area(p, q, r);
    return at_p + CGAL::area(p, x, r) / whole * (height(f->vertex(1)->info().point) - at_p) +
           CGAL::area(p, q, x) / whole * (height(f->vertex(2)->info().point) - at_p);
  }

  void add_triangles(surface_arrays& a) {
    for (auto f = mesh_.cgal().finite_faces_begin(); f != mesh_.cgal().finite_faces_end(); ++f) {
      if (!f->is_in_domain()) continue;
      if (small_sine_ > 0 && measured(f, {}).squared_sine < small_sine_)
        result_.small_angles.push_back(poly_id{a.verts.size() / 3});
      for (int k = 0; k < 3; ++k) a.verts.push_back(vert_of_[f->vertex(k)]);
    }
  }

  void add_edges() {
    const std::vector<edge_id> edges = core::edges_between(result_.mesh, chain_);
    const auto ends = input_.segments();
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const std::uint32_t s = g_.segment_of[i];
      const auto [first, last] = chain_of_[s];
      const bool forward = g_.same_as[ends[i][0]] == g_.segments[s][0];
      for (std::size_t k = first; k < last; ++k)
        if (const edge_id e = edges[forward ? k : first + last - 1 - k]; !e.is_none())
          result_.segment_edges.push_back(e);
      result_.segment_ends.push_back(result_.segment_edges.size());
    }
    result_.constraints = result_.segment_edges;
    std::sort(result_.constraints.begin(), result_.constraints.end());
    result_.constraints.erase(std::unique(result_.constraints.begin(), result_.constraints.end()),
                              result_.constraints.end());
  }

 public:
  triangulator(const planar_graph& g, const cgal_triangulate_options& o)
      : input_(g), options_(o), g_(checked(g, o)), scale_(std::ldexp(1.0, -g_.exponent)),
        normal_(cross(g_.axes[0], g_.axes[1])), mesh_(g_, o.convex_hull) {}

  planar_triangulation operator()() {
    mesh_.fill(options_.holes.empty() && !options_.convex_hull);
    const triangulation before = mesh_.cgal();
    refine();
    surface_arrays a{{}, {}, {}, 3};
    add_verts(before, a);
    add_triangles(a);
    result_.mesh = trimesh(std::move(a));
    result_.vert_of.resize(input_.points.size());
    for (std::size_t p = 0; p < input_.points.size(); ++p)
      if (g_.same_as[p] != none) result_.vert_of[p] = vert_of_[mesh_.vertex_of(g_.same_as[p])];
    add_edges();
    return std::move(result_);
  }
};

/// Divides segments first.
inline planar_triangulation triangulate_divided(const planar_graph& g, cgal_triangulate_options o) {
  check(o);
  const divided_graph d = divided("triangulate", g, o.holes, o.seen_from, o.merge_points);
  o.merge_points = true;  // points that were merged stay so
  planar_triangulation t = triangulator(d.graph, o)();
  t.vert_of.resize(g.points.size());
  std::vector<std::size_t> ends;
  ends.reserve(d.ends.size());
  for (const std::size_t end : d.ends) ends.push_back(end == 0 ? 0 : t.segment_ends[end - 1]);
  t.segment_ends = std::move(ends);
  return t;
}

}  // namespace detail::cgal_planar

/// Triangulates what is inside of outlines, or the convex hull: the constrained Delaunay triangulation of the points,
/// or with bounds on angles or sizes a refinement of it, with new points, also on segments.
/// Needs:  a graph as for triangulate(g). Segments must not meet except at common points, unless
///         options.divide_segments is set.
/// Result: as of triangulate(g), with the same verts first, then the new ones; without bounds there are none. Only
///         edges along segments are not Delaunay edges. With bounds, each angle is min_angle_deg or more and each
///         triangle has the sizes asked for. The exceptions are triangles near angles between segments that are
///         smaller; small_angles lists them. A new vert on a segment has the height of the segment, along seen_from;
///         another one has that of the triangulation without new points. With divide_segments, a vert at each place
///         where segments meet follows those of the points. Its coordinates are rounded, and it has the height of the
///         first of these segments.
/// Cost:   O(n log n) for most graphs, for n verts of the result.
/// Errors: invalid_argument as triangulate(g); also for an option out of its range, for a size that is not above 0,
///         with the place, and if there would be more than max_verts verts. Refinement is proven to end for angles up
///         to 20.7 degrees, and nearly always ends up to 30. cancelled.
/// Source: Chew 1989; Ruppert 1995; Shewchuk 2002, "Delaunay refinement algorithms for triangular mesh generation",
///         through CGAL's 2D mesher.
inline planar_triangulation triangulate(const planar_graph& g, cgal_t, const cgal_triangulate_options& options = {}) {
  const core::profiled_options profiled(options, "triangulate");
  return options.divide_segments ? detail::cgal_planar::triangulate_divided(g, *profiled)
                                 : detail::cgal_planar::triangulator(g, *profiled)();
}

}  // namespace concino
