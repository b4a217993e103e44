// Collects points and polygons for a surface of polygons or of triangles.
#pragma once

#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/mesh/arrays.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

/// Appends values. If there are none before them, they are moved.
template<class T>
void append(std::vector<T>&& values, std::vector<T>& to) {
  if (to.empty()) to = std::move(values);
  else to.insert(to.end(), values.begin(), values.end());
}

/// Polygons come in parts: their corners are numbers of points of the same part.
class surface_builder {
  surface_arrays a_;
  polygon_triangulator triangulate_;
  std::vector<vec3> corners_;

 public:
  explicit surface_builder(bool triangles) {
    if (triangles) a_.arity = 3;
    else a_.offsets.push_back(0);
  }

  /// Adds polygons, or the triangles of their triangulations. `begins`: where the corners of each polygon begin, and where the last ones end. `polys`: something
  /// for each polygon; after the call, the same for each poly that was added.
  template<class Poly>
  void add_part(std::vector<vec3>&& points, std::vector<vert_id>&& verts, std::vector<std::uint32_t>&& begins, std::vector<Poly>& polys) {
    const auto shift = static_cast<std::uint32_t>(a_.points.size()), num_verts = static_cast<std::uint32_t>(a_.verts.size());
    append(std::move(points), a_.points);
    if (shift > 0)
      for (vert_id& v : verts) v = vert_id{shift + v.raw()};
    if (a_.arity == 3) return add_triangles(verts, begins, polys);
    append(std::move(verts), a_.verts);
    if (num_verts == 0) a_.offsets = std::move(begins);
    else for (std::size_t i = 1; i < begins.size(); ++i) a_.offsets.push_back(num_verts + begins[i]);
  }

  surface_arrays arrays() && { return std::move(a_); }

 private:
  template<class Poly>
  void add_triangles(const std::vector<vert_id>& verts, const std::vector<std::uint32_t>& begins, std::vector<Poly>& polys) {
    std::vector<Poly> of_triangles;
    for (std::size_t i = 0; i < polys.size(); ++i) {
      const std::size_t n = add_triangles({verts.data() + begins[i], begins[i + 1] - begins[i]});
      of_triangles.insert(of_triangles.end(), n, polys[i]);
    }
    polys.swap(of_triangles);
  }
  /// Adds the triangles of a polygon. Returns their number.
  std::size_t add_triangles(std::span<const vert_id> polygon) {
    if (polygon.size() == 3) {
      a_.verts.insert(a_.verts.end(), polygon.begin(), polygon.end());
      return 1;
    }
    corners_.clear();
    for (const vert_id v : polygon) corners_.push_back(a_.points[v.raw()]);
    const auto triangles = triangulate_(corners_);
    for (const polygon_triangle& t : triangles)
      for (const std::uint32_t k : t) a_.verts.push_back(polygon[k]);
    return triangles.size();
  }
};

}  // namespace concino::detail
