// A constrained Delaunay triangulation of a planar graph, its filled regions, and its refinement by CGAL.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/function_ref.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/progress.hpp>
#include <concino/generate/planar_segments.hpp>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace concino::detail::cgal_planar {

inline constexpr std::uint32_t none = core::planar_segments::none;

/// The number of the point of a vertex; none if refinement added it.
struct vertex_info {
  std::uint32_t point = none;
};

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using vertex_base = CGAL::Triangulation_vertex_base_with_info_2<vertex_info, kernel>;
using face_base = CGAL::Delaunay_mesh_face_base_2<kernel>;
using triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<kernel, CGAL::Triangulation_data_structure_2<vertex_base, face_base>>;
using vertex = triangulation::Vertex_handle;
using face = triangulation::Face_handle;

/// Which triangles are to be divided. All lengths are those of the triangulation.
struct bounds {
  double squared_sine = 0;  // of the smallest angle
  double max_area = std::numeric_limits<double>::infinity();
  double max_length = std::numeric_limits<double>::infinity();
  function_ref<double(double x, double y)> size;  // the longest edge at a point; may be empty
};

/// The squared sine of the smallest angle of a triangle, and its largest size as a fraction of its bound.
struct measures {
  double size = 0, squared_sine = 1;

  /// Whether this triangle is divided first.
  bool operator<(const measures& o) const {
    if (size > 1 || o.size > 1) return size > 1 && (!(o.size > 1) || size > o.size);
    return squared_sine < o.squared_sine;
  }
};

inline measures measured(const face& f, const bounds& b) {
  const auto &p = f->vertex(0)->point(), &q = f->vertex(1)->point(), &r = f->vertex(2)->point();
  std::array<double, 3> squared = {CGAL::squared_distance(q, r), CGAL::squared_distance(r, p),
                                   CGAL::squared_distance(p, q)};
  std::sort(squared.begin(), squared.end());
  const double doubled_area = 2 * CGAL::area(p, q, r);
  measures m;
  m.squared_sine = doubled_area * doubled_area / (squared[1] * squared[2]);
  m.size = std::max(std::sqrt(squared[2]) / b.max_length, doubled_area / 2 / b.max_area);
  if (b.size)
    m.size = std::max(m.size, std::sqrt(squared[2]) / b.size((p.x() + q.x() + r.x()) / 3, (p.y() + q.y() + r.y()) / 3));
  return m;
}

/// The criteria in the form that CGAL expects.
class criteria {
  const bounds* bounds_;

 public:
  using Quality = measures;
  class Is_bad {
    const bounds* bounds_;

   public:
    explicit Is_bad(const bounds* b) : bounds_(b) {}
    CGAL::Mesh_2::Face_badness operator()(const Quality& q) const {
      if (q.size > 1) return CGAL::Mesh_2::IMPERATIVELY_BAD;
      return q.squared_sine < bounds_->squared_sine ? CGAL::Mesh_2::BAD : CGAL::Mesh_2::NOT_BAD;
    }
    CGAL::Mesh_2::Face_badness operator()(const face& f, Quality& q) const {
      return (*this)(q = measured(f, *bounds_));
    }
  };

  explicit criteria(const bounds* b) : bounds_(b) {}
  Is_bad is_bad_object() const { return Is_bad(bounds_); }
};

/// The triangulation of a graph.
class planar_mesh {
  const core::planar_segments& g_;
  triangulation t_;
  std::vector<vertex> vertex_of_;  // by point

 public:
  /// with_hull: whether the edges of the convex hull are constrained too.
  planar_mesh(const core::planar_segments& g, bool with_hull) : g_(g), vertex_of_(g.points.size()) {
    std::vector<std::pair<triangulation::Point, vertex_info>> points;
    points.reserve(g.used.size());
    for (const std::uint32_t p : g.used)
      points.emplace_back(triangulation::Point(g.points[p].x, g.points[p].y), vertex_info{p});
    t_.insert(points.begin(), points.end());
    for (auto v = t_.finite_vertices_begin(); v != t_.finite_vertices_end(); ++v) vertex_of_[v->info().point] = v;
    for (const auto& [a, b] : g.segments) t_.insert_constraint(vertex_of_[a], vertex_of_[b]);
    if (with_hull) constrain_hull();
  }

  const triangulation& cgal() const { return t_; }
  vertex vertex_of(std::uint32_t point) const { return vertex_of_[point]; }

  /// The number of the segment between two points; none if there is no such segment.
  std::uint32_t segment_between(std::uint32_t a, std::uint32_t b) const {
    std::array<std::uint32_t, 2> ends{a, b};
    if (g_.is_before(b, a)) std::swap(ends[0], ends[1]);
    const auto at = std::lower_bound(g_.segments.begin(), g_.segments.end(), ends);
    return at != g_.segments.end() && *at == ends ? static_cast<std::uint32_t>(at - g_.segments.begin()) : none;
  }

  /// Sets in_domain of all faces: those inside an odd number of outlines, or of all bounded regions; but not those with
  /// a hole point.
  void fill(bool by_nesting) {
    for (auto f = t_.all_faces_begin(); f != t_.all_faces_end(); ++f) f->set_in_domain(false);
    if (t_.dimension() < 2) return check_holes(nullptr);
    CGAL::Unique_hash_map<face, std::uint32_t> region(none);
    std::vector<std::uint8_t> filled;
    std::vector<std::pair<face, std::uint8_t>> starts{{t_.infinite_face(), std::uint8_t{0}}};
    std::vector<face> faces;
    for (std::size_t i = 0; i < starts.size(); ++i) {  // regions are found from the outside inwards
      if (region[starts[i].first] != none) continue;
      const auto number = static_cast<std::uint32_t>(filled.size());
      filled.push_back(by_nesting ? starts[i].second : number > 0);
      faces.assign({starts[i].first});
      region[starts[i].first] = number;
      while (!faces.empty()) {
        const face f = faces.back();
        faces.pop_back();
        for (int k = 0; k < 3; ++k) {
          const face next = f->neighbor(k);
          if (region[next] != none) continue;
          if (f->is_constrained(k)) {
            const std::uint32_t s =
                segment_between(f->vertex(t_.cw(k))->info().point, f->vertex(t_.ccw(k))->info().point);
            starts.emplace_back(next,
                                static_cast<std::uint8_t>((starts[i].second != 0) != (s != none && g_.is_outline[s])));
          } else {
            region[next] = number;
            faces.push_back(next);
          }
        }
      }
    }
    check_holes([&](const face& f) { return region[f]; });
    for (const vec3& h : g_.holes) filled[region[t_.locate({h.x, h.y})]] = 0;
    for (auto f = t_.finite_faces_begin(); f != t_.finite_faces_end(); ++f) f->set_in_domain(filled[region[f]] != 0);
  }

  /// Adds vertices until all bounds are met.
  void refine(const bounds& b, std::size_t max_verts, const progress& report) {
    if (t_.dimension() < 2) return;
    CGAL::Delaunay_mesher_2<triangulation, criteria> mesher(t_, criteria(&b));
    mesher.init(true);
    for (std::size_t step = 0; !mesher.is_refinement_done(); ++step) {
      if (step % 4096 == 0) report_progress(report, 0, g_.caller.data());
      mesher.try_one_step_refine_mesh();
      if (t_.number_of_vertices() > max_verts)
        core::throw_joined<invalid_argument>(
            {g_.caller, ": refinement needs more than options.max_verts = ", max_verts,
             " verts; allow more, larger triangles, or smaller angles (it is known to end up to 20.7 degrees)"});
    }
  }

  /// Calls visit(segment, vertices) for each segment: its vertices, from its first point to its second one.
  template<class Visit>
  void for_each_chain(Visit&& visit) const {
    std::vector<vertex> chain;
    for (const std::uint32_t p : g_.used) {
      const vertex v = vertex_of_[p];
      for_each_constrained(v, [&](const vertex& next) {
        chain.assign({v, next});
        while (chain.back()->info().point == none)
          chain.push_back(other_constrained(chain.back(), chain[chain.size() - 2]));
        const std::uint32_t end = chain.back()->info().point, s = segment_between(p, end);
        if (s != none && g_.segments[s][0] == p) visit(s, chain);
      });
    }
  }

 private:
  void constrain_hull() {
    if (t_.dimension() < 2) return;
    std::vector<std::array<vertex, 2>> hull;
    auto f = t_.incident_faces(t_.infinite_vertex());
    const auto first = f;
    do {
      const int k = f->index(t_.infinite_vertex());
      hull.push_back({f->vertex(t_.cw(k)), f->vertex(t_.ccw(k))});
    } while (++f != first);
    for (const auto& [a, b] : hull) t_.insert_constraint(a, b);
  }

  template<class RegionOf>
  void check_holes(const RegionOf& region_of) const {
    for (std::size_t h = 0; h < g_.holes.size(); ++h)
      if (region_of(t_.locate({g_.holes[h].x, g_.holes[h].y})) == 0) fail_hole(h);
  }
  void check_holes(std::nullptr_t) const {
    if (!g_.holes.empty()) fail_hole(0);
  }
  void fail_hole(std::size_t h) const {
    core::throw_joined<invalid_argument>({g_.caller, ": hole point ", h, " lies in no bounded region"});
  }

  /// Calls visit(w) for each constrained edge from v to w.
  template<class Visit>
  void for_each_constrained(const vertex& v, Visit&& visit) const {
    if (t_.dimension() < 2) return;
    auto e = t_.incident_edges(v);
    const auto first = e;
    do {
      if (t_.is_infinite(*e) || !t_.is_constrained(*e)) continue;
      const vertex a = e->first->vertex(t_.cw(e->second)), b = e->first->vertex(t_.ccw(e->second));
      visit(a == v ? b : a);
    } while (++e != first);
  }

  /// The other end of the constrained edge that continues one from `from` at v, a vertex that refinement put on a
  /// segment.
  vertex other_constrained(const vertex& v, const vertex& from) const {
    vertex next = from;
    for_each_constrained(v, [&](const vertex& w) {
      if (w != from) next = w;
    });
    return next;
  }
};

}  // namespace concino::detail::cgal_planar
