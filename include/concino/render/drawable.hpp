// Drawables: the boundary polygons of any mesh, with the triangles, normals and values that render() needs.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/geometry/outer_polygons.hpp>
#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/render/appearance.hpp>
#include <concino/render/smooth_normals.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace concino {

/// The elements of a drawable that carry its values and colours.
enum class value_place : std::uint8_t { points, polygons, corners };

/// The polygons of the surface of a mesh, prepared for rendering. Lengths are in units of the mesh.
struct drawable {
  std::vector<vec3> points;
  std::vector<double> values;                           // by the elements `values_at`; empty: no values
  value_place values_at = value_place::points;
  std::vector<rgb> colors;                              // by the elements `colors_at`, instead of values; empty: none
  value_place colors_at = value_place::polygons;
  std::vector<double> edge_values;                      // by corner: of the edge to the next corner; empty: edges have one colour
  std::vector<std::array<float, 2>> texture_coordinates;  // by corner; empty: no texture
  std::vector<std::uint8_t> exposed;                    // by polygon: 1 if a cut laid it bare; empty: none is
  std::vector<std::uint32_t> offsets = {0};             // polygon p has the corners offsets[p] .. offsets[p+1]-1
  std::vector<std::uint32_t> corners;                   // the point of each corner
  std::vector<std::array<float, 3>> normals;            // by corner, unit vectors
  std::vector<std::uint32_t> polys;                     // by polygon: index_of its poly in the mesh
  std::vector<std::array<std::uint32_t, 3>> triangles;  // the three corners of each
  std::vector<std::uint32_t> polygon_of;                // by triangle
  appearance look;

  polygon_list polygons() const { return {points, offsets, corners}; }
};

struct drawable_options {
  double crease_angle = 60;  // degrees, in [0, 180]: edges with a larger angle look sharp; 0: flat shading, 180: smooth everywhere
};

namespace detail {

inline void add_triangles(drawable& d) {
  polygon_triangulator cut;
  std::vector<vec3> polygon;
  for (std::size_t p = 0; p + 1 < d.offsets.size(); ++p) {
    const std::uint32_t first = d.offsets[p], last = d.offsets[p + 1], index = static_cast<std::uint32_t>(p);
    if (last - first == 3) {
      d.triangles.push_back({first, first + 1, first + 2});
      d.polygon_of.push_back(index);
      continue;
    }
    polygon.clear();
    for (std::uint32_t c = first; c < last; ++c) polygon.push_back(d.points[d.corners[c]]);
    for (const polygon_triangle& t : cut(polygon)) {
      d.triangles.push_back({first + t[0], first + t[1], first + t[2]});
      d.polygon_of.push_back(index);
    }
  }
}

template<class M, class Value>
drawable make_drawable(const M& m, const drawable_options& options, bool with_values, Value&& value) {
  if (!(options.crease_angle >= 0 && options.crease_angle <= 180))
    throw invalid_argument("make_drawable: crease_angle must be in [0, 180] degrees");
  constexpr std::uint32_t unseen = ~std::uint32_t{0};
  drawable d;
  std::vector<std::uint32_t> point_of(vert_index_bound(m), unseen);
  for_each_outer_polygon(m, [&](const poly_t<M>& p, const auto& ring, bool is_outward) {
    for (const auto r : ring) {
      const vert_t<M> v = r;
      std::uint32_t& at = point_of[index_of(m, v)];
      if (at == unseen) {
        at = static_cast<std::uint32_t>(d.points.size());
        d.points.push_back(to_vec3(point(m, v)));
        if (!is_finite(d.points.back()))
          core::throw_joined<invalid_mesh>({"make_drawable: vert ", index_of(m, v),
                                              " has a coordinate that is not a finite number"});
        if (with_values) d.values.push_back(value(v));
      }
      d.corners.push_back(at);
    }
    if (!is_outward) std::reverse(d.corners.begin() + d.offsets.back(), d.corners.end());
    d.offsets.push_back(static_cast<std::uint32_t>(d.corners.size()));
    d.polys.push_back(static_cast<std::uint32_t>(index_of(m, p)));
  });
  add_triangles(d);
  d.normals = smooth_normals(d.polygons(), options.crease_angle);
  return d;
}

}  // namespace detail

/// The drawable of a mesh: the polygons of a surface, or the faces of a volume that have exactly one poly.
/// Needs:  EmbeddedMesh M.      Result: a drawable of one colour; change `look` as you like.
/// Cost:   O(polygons), more if many of them meet at a vert.
/// Errors: invalid_mesh if a visible vert has a coordinate that is not finite; invalid_argument if crease_angle is out of range.
template<EmbeddedMesh M>
drawable make_drawable(const M& m, const drawable_options& options = {}) {
  return detail::make_drawable(m, options, false, [](const auto&) { return 0.0; });
}

/// The drawable of a mesh, coloured by a value per vert, which is interpolated over each polygon.
/// Needs:  EmbeddedMesh M; u: any readable map of numbers on verts; they need not be finite.
/// Result: as above; `look.scale` is linear over the finite values of the visible verts.
/// Cost:   as above.
/// Errors: as above.
template<class M, class U>
  requires EmbeddedMesh<M> && requirement::gives_numbers<U, vert_t<M>>
drawable make_drawable(const M& m, const U& u, const drawable_options& options = {}) {
  drawable d = detail::make_drawable(m, options, true, [&](const auto& v) { return static_cast<double>(u[v]); });
  d.look.scale = value_scale::linear(d.values);
  return d;
}

// What to write instead of calls that cannot compile.
template<class... T> void make_drawable(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
template<class... T> void make_drawable(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_at_verts>>
  requires(EmbeddedMesh<M> && !requirement::gives_numbers<U, vert_t<M>>)
void make_drawable(M&&, const U&, ...) = delete;  // a number at each vert: make_vert_map<double>(m)

}  // namespace concino
