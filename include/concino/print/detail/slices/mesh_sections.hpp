// Sections of any mesh at a height, for slice_mesh.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/concepts/oriented_edges.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/geometry/self_intersections.hpp>
#include <concino/level_sets/isolines.hpp>
#include <concino/level_sets/isosurface.hpp>
#include <concino/print/detail/slices/section_lines.hpp>

#include <cstdint>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

namespace concino::detail {

/// The heights of verts above z, of which none is 0: material above the plane counts, so verts in it are below.
template<class M>
struct heights_above_layer {
  const M& m;
  double z;

  double operator[](const vert_t<M>& v) const {
    const double height = to_vec3(point(m, v)).z - z;
    return height == 0 ? -std::numeric_limits<double>::denorm_min() : height;
  }
};

/// Errors: invalid_mesh that names an edge without exactly two polys, or with two that run in the same direction; one
///         if the surface is inside out.
template<class M>
void check_closed_outward(const M& m) {
  std::vector<std::int8_t> count(edge_index_bound(m)), sum(edge_index_bound(m));
  double volume = 0;
  vec3 origin;
  bool any = false;
  for (const poly_t<M> p : polys(m)) {
    for (const auto& [e, from, to] : oriented_edges(m, p)) {
      const std::size_t i = index_of(m, e);
      if (!std::exchange(any, true)) origin = to_vec3(point(m, from));
      count[i] = static_cast<std::int8_t>(count[i] < 3 ? count[i] + 1 : 3);
      sum[i] = static_cast<std::int8_t>(sum[i] + (end_verts(m, e).first == from ? 1 : -1));
    }
    const polygon_shape shape = shape_of(m, adj_p2v(m, p));
    volume += dot(shape.mean - origin, shape.area);
  }
  for (const edge_t<M> e : edges(m)) {
    const std::size_t i = index_of(m, e);
    if (count[i] == 0) continue;
    if (count[i] == 1)
      core::throw_joined<invalid_mesh>(
          {"slice_mesh: the surface is open at edge ", i, "; close it, or slice it with {.accept_open = true}"});
    if (count[i] > 2)
      core::throw_joined<invalid_mesh>(
          {"slice_mesh: edge ", i, " has more than two polys; slice it with {.accept_open = true}"});
    if (sum[i] != 0)
      core::throw_joined<invalid_mesh>(
          {"slice_mesh: the polys of edge ", i, " are not oriented alike; flip_winding turns one"});
  }
  if (volume < 0)
    core::throw_joined<invalid_mesh>({"slice_mesh: the surface is inside out; flip_winding turns all polys"});
}

/// Errors: invalid_mesh that names two polys that intersect.
template<class M>
void check_no_intersections(const M& m) {
  const auto pairs = self_intersections(m);
  if (pairs.empty()) return;
  core::throw_joined<invalid_mesh>({"slice_mesh: polys ", index_of(m, pairs[0].first), " and ",
                                    index_of(m, pairs[0].second), " intersect, and ", pairs.size() - 1,
                                    " more pairs; slice it with {.accept_intersections = true}"});
}

/// The sections of a mesh at several heights. Polys that they pass are numbered by `found`.
template<class M>
class mesh_sections {
  const M& m_;
  std::vector<std::uint32_t> number_;  // by index of a poly

  std::uint32_t number(const poly_t<M>& p) {
    std::uint32_t& n = number_[index_of(m_, p)];
    if (n == 0) {
      found.push_back(p);
      n = static_cast<std::uint32_t>(found.size());
    }
    return n - 1;
  }

  using places = std::vector<poly_t<M>>;
  void polys_at(const mesh_point<M>& x, places& to) const {
    to.clear();
    if (const auto* on_edge = std::get_if<edge_point<M>>(&x.element)) {
      for (const poly_t<M> p : adj_e2p(m_, on_edge->edge)) to.push_back(p);
    } else if (const auto* inside = std::get_if<poly_t<M>>(&x.element)) {
      to.push_back(*inside);
    } else if (const auto* at = std::get_if<vert_t<M>>(&x.element)) {
      for (const poly_t<M> p : adj_v2p(m_, *at)) to.push_back(p);
    }
  }

 public:
  std::vector<poly_t<M>> found;

  explicit mesh_sections(const M& m) : m_(m), number_(poly_index_bound(m)) {}

  /// The lines of a surface. Larger heights are to their left seen from outside, so material is to the left seen from
  /// above.
  section_layer of_surface(double z) {
    section_layer result;
    result.layer.z = z;
    places here, next;
    for (const level_line<M>& line : isolines(m_, heights_above_layer<M>{m_, z}, {0.0})) {
      section_line s;
      const std::size_t n = line.places.size();
      if (n > 0) polys_at(line.places[0], here);
      for (std::size_t i = 0; i < n; ++i, std::swap(here, next)) {
        polys_at(line.places[i + 1 < n ? i + 1 : 0], next);
        const poly_t<M>* common = here.data();
        for (const poly_t<M>& p : here)
          for (const poly_t<M>& q : next)
            if (p == q) common = &p;
        s.add(section_point(line.points[i].x, line.points[i].y), number(*common));
      }
      if (line.closed) result.add_contour(std::move(s), 0);
      else {
        if (s.polys.size() > 1) s.polys.pop_back();  // there is no segment behind the last point
        result.add_open(s, 0);
      }
    }
    return result;
  }

  /// The contours of the polys of each label of a volume; label(p) is one.
  template<class Label>
  section_layer of_volume(double z, const Label& label) {
    section_layer result;
    result.layer.z = z;
    const level_surface<M> section = isosurface(m_, heights_above_layer<M>{m_, z}, {0.0});
    const auto& s = section.mesh;
    std::vector<std::int32_t> labels(num_polys(s));
    for (const poly_id p : polys(s)) labels[p.raw()] = label(section.poly_of(p));
    std::vector<std::pair<std::int32_t, section_edge>> all;
    for (const poly_id p : polys(s))
      for (const auto& [e, from, to] : oriented_edges(s, p)) {
        bool is_inside = false;
        for (const poly_id q : other_polys(s, p, e)) is_inside = is_inside || labels[q.raw()] == labels[p.raw()];
        if (!is_inside) all.push_back({labels[p.raw()], {from.raw(), to.raw(), number(section.poly_of(p))}});
      }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<section_edge> edges;
    for (std::size_t i = 0; i < all.size(); ++i) {
      edges.push_back(all[i].second);
      if (i + 1 < all.size() && all[i + 1].first == all[i].first) continue;
      for (const auto& cycle : simple_cycles(edges)) {
        section_line line;
        for (const std::uint32_t e : cycle) {
          const vec3 x = point(s, vert_id{edges[e].from});
          line.add(section_point(x.x, x.y), edges[e].poly);
        }
        result.add_contour(std::move(line), all[i].first);
      }
      edges.clear();
    }
    return result;
  }
};

}  // namespace concino::detail
