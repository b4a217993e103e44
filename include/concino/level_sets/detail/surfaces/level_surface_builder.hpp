// Makes a surface of polygons or of triangles of the level sets of a volume.
#pragma once

#include <concino/core/number_in_messages.hpp>
#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/level_sets/detail/cut/crossed_volume_reader.hpp>
#include <concino/level_sets/detail/surfaces/level_polygons.hpp>
#include <concino/level_sets/detail/surfaces/polygon_sheets.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/element_origins.hpp>
#include <concino/mesh/mesh_point.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

/// Adds one level set after another.
template<class M>
class level_surface_builder {
  const M& m_;
  bool with_origins_;
  surface_arrays a_;
  polygon_triangulator triangulate_;
  std::vector<vec3> corners_;

 public:
  std::vector<mesh_point<M>> places;  // by vert
  std::vector<poly_t<M>> polys;       // by poly of the surface
  std::vector<double> values;         // by poly of the surface
  element_origins origins;            // of the verts, if asked for

  level_surface_builder(const M& m, bool triangles, bool with_origins) : m_(m), with_origins_(with_origins) {
    if (triangles) a_.arity = 3;
    else a_.offsets.push_back(0);
  }

  /// Of the polygons only those in polys for which is_chosen(p).
  template<class U, class IsChosen>
  void add(const U& u, double level, const char* caller, const IsChosen& is_chosen) {
    const std::vector<poly_t<M>> cells = crossed_polys(m_, level_states(m_, u, level, caller));
    const crossed_volume_reader<M> crossed(m_, u, level, cells);
    std::vector<std::uint32_t> names;
    for (const poly_t<M>& p : cells) names.push_back(static_cast<std::uint32_t>(core::number_in_messages(m_, p)));
    cell_cuts cuts(crossed.arrays, arity_v<M> > 0 ? cell_cuts::cells_are::spheres : cell_cuts::cells_are::unknown,
                   caller, names);
    polygon_sheets sheets;
    level_polygons(cuts, sheets).add_all();
    add_polygons(sheets.make(), crossed, cells, level, is_chosen);
  }

  surface_arrays arrays() && { return std::move(a_); }

 private:
  template<class IsChosen>
  void add_polygons(const level_surface_arrays& made, const crossed_volume_reader<M>& crossed,
                    const std::vector<poly_t<M>>& cells, double level, const IsChosen& is_chosen) {
    std::vector<unsigned char> is_used(made.places.size());
    for_each_polygon(made, cells, is_chosen, [&](const poly_t<M>&, std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t k = first; k < end; ++k) is_used[made.verts[k]] = 1;
    });
    std::vector<vert_id> vert(made.places.size());
    for (std::size_t i = 0; i < vert.size(); ++i) {
      if (!is_used[i]) continue;
      vert[i] = vert_id{a_.points.size()};
      places.push_back(crossed.mesh_point_of(m_, made.places[i]));
      a_.points.push_back(places.back().position);
      if (with_origins_) origins.add(std::span<const origin>(crossed.origins_of(made.places[i])));
    }
    std::vector<vert_id> polygon;
    for_each_polygon(made, cells, is_chosen, [&](const poly_t<M>& p, std::uint32_t first, std::uint32_t end) {
      polygon.clear();
      for (std::uint32_t k = first; k < end; ++k) polygon.push_back(vert[made.verts[k]]);
      const std::size_t n = add_polygon(polygon);
      polys.insert(polys.end(), n, p);
      values.insert(values.end(), n, level);
    });
  }

  /// Calls f(poly, first, end) for the polygons in chosen polys; first and end are positions in made.verts.
  template<class IsChosen, class F>
  static void for_each_polygon(const level_surface_arrays& made, const std::vector<poly_t<M>>& cells,
                               const IsChosen& is_chosen, F f) {
    for (std::size_t i = 0; i < made.ends.size(); ++i)
      if (const poly_t<M>& p = cells[made.cells[i]]; is_chosen(p)) f(p, i == 0 ? 0u : made.ends[i - 1], made.ends[i]);
  }

  /// Adds a polygon, or its triangles. Returns how many polys it adds.
  std::size_t add_polygon(const std::vector<vert_id>& polygon) {
    if (a_.arity != 3 || polygon.size() == 3) {
      a_.verts.insert(a_.verts.end(), polygon.begin(), polygon.end());
      if (a_.arity != 3) a_.offsets.push_back(static_cast<std::uint32_t>(a_.verts.size()));
      return 1;
    }
    corners_.clear();
    for (const vert_id v : polygon) corners_.push_back(a_.points[v.raw()]);
    const auto triangles = triangulate_(corners_);
    for (const polygon_triangle& t : triangles)
      for (const std::uint32_t corner : t) a_.verts.push_back(polygon[corner]);
    return triangles.size();
  }
};

}  // namespace concino::detail
