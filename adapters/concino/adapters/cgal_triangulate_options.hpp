// The options of triangulate(outlines, cgal).
// Needs: as <concino/adapters/cgal_triangulate.hpp>, which includes it.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/function_ref.hpp>
#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/core/vec3.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace concino {

struct cgal_triangulate_options {
  std::vector<vec3> holes = {};  // a point inside each hole; if there are any, nothing else is a hole: all else that
                                 // outlines and lines enclose is filled
  bool convex_hull = false;      // whether all within the convex hull is filled, but the holes
  double min_angle_deg = 0;      // the least angle of triangles, in degrees, 0 to 33; 0: no bound
  double max_area = std::numeric_limits<double>::infinity();    // of a triangle, projected along seen_from; above 0
  double max_length = std::numeric_limits<double>::infinity();  // of edges, projected along seen_from; above 0
  function_ref<double(const vec3&)> size = {};                  // the longest edge of triangles at a point, projected
                                                                // along seen_from; above 0. Empty: no bound
  vec3 seen_from = {0, 0, 1};          // the direction from which triangles are counter-clockwise; not 0. Points are
                                       // projected along it
  bool merge_points = false;           // whether points at the same place are one vert; otherwise they are an error
  bool divide_segments = false;        // whether segments that cross, overlap or run through points are divided there;
                                       // otherwise they are an error
  std::size_t max_verts = 10'000'000;  // of the result; more are an error, so that refinement ends
  concino::progress progress = {};     // may stop the refinement; the fraction is always 0
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

namespace detail::cgal_planar {

inline void check(const cgal_triangulate_options& o) {
  const auto require = [](bool good, const char* what, double value) {
    if (!good)
      core::throw_joined<invalid_argument>({"triangulate: options.", what, ", but is ", core::number_text(value)});
  };
  require(o.min_angle_deg >= 0 && o.min_angle_deg <= 33,
          "min_angle_deg must be from 0 to 33, because larger angles are rarely reached", o.min_angle_deg);
  require(o.max_area > 0, "max_area must be above 0", o.max_area);
  require(o.max_length > 0, "max_length must be above 0", o.max_length);
}

}  // namespace detail::cgal_planar

}  // namespace concino
