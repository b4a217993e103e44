// The triangles of a surface, for writers of formats that hold triangles only.
#pragma once

#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/io/flat_mesh.hpp>
#include <concino/io/write_context.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace concino {

/// The triangles of one poly after another, oriented as the poly. Triangles of the mesh are taken as they are; other
/// polygons are cut by polygon_triangulator if save_options::as_triangles is set.
///
///   flat_triangles triangles(context, m, ".soup", ".ply or .obj");      // extensions of this format and of others
///   for (std::size_t p = 0; p < m.num_polys; ++p)
///     for (const std::array<vert_id, 3>& t : triangles(p)) ...
///   triangles.report_cut(context.report);
class flat_triangles {
  const write_context& c_;
  const flat_mesh& m_;
  std::string_view format_, instead_;
  polygon_triangulator triangulate_;
  std::vector<vec3> corners_;
  std::vector<std::array<vert_id, 3>> triangles_;
  std::size_t num_polygons_ = 0;

 public:
  /// `format` and `instead` are the extensions of this format and of others, for messages.
  flat_triangles(const write_context& c, const flat_mesh& m, std::string_view format, std::string_view instead)
      : c_(c), m_(m), format_(format), instead_(instead) {}

  /// The triangles of a poly, valid until the next call.
  /// Errors: unsupported if it is no triangle and is not to be cut into some.
  std::span<const std::array<vert_id, 3>> operator()(std::size_t p) {
    const std::span<const vert_id> v = m_.poly_verts[p];
    triangles_.clear();
    if (v.size() == 3) {
      triangles_.push_back({v[0], v[1], v[2]});
      return triangles_;
    }
    if (!c_.options.as_triangles)
      c_.throw_cannot_hold(
          format_, {"poly ", m_.poly_index(p), " of ", v.size(), " corners, unless options.as_triangles is set"},
          instead_);
    ++num_polygons_;
    corners_.clear();
    for (const vert_id x : v) corners_.push_back(m_.points[x.raw()]);
    for (const polygon_triangle& t : triangulate_(corners_)) triangles_.push_back({v[t[0]], v[t[1]], v[t[2]]});
    return triangles_;
  }

  /// Reports how many polygons were cut. Needs: one call for each poly.
  void report_cut(save_report& report) const {
    if (num_polygons_) report.lost.push_back(core::joined({num_polygons_, " polygons were cut into triangles"}));
  }
};

}  // namespace concino
