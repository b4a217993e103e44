// What TetGen is given: points, triangles, segments and regions in its own structure, and its switches.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>
#include <concino/generate/tetrahedralize_options.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>

#ifndef TETLIBRARY
#define TETLIBRARY
#endif
#include <tetgen.h>
#undef REAL
#undef FILENAMESIZE
#undef INPUTLINESIZE

namespace concino::detail {

struct tetgen_input {
  const tetrahedralize_input& input;
  const tetrahedralize_options& options;

  /// p: a surface is filled; Q: silent; J: points keep their numbers; Y: boundary kept; q, a, A as the options say.
  std::string switches() const {
    std::string s = "pQJ";
    if (options.keep_boundary) s += 'Y';
    if (options.radius_edge > 0 || options.min_dihedral_deg > 0 || options.edge_length)
      s += core::joined({"q", core::number_text(options.radius_edge > 0 ? options.radius_edge : 2.0), "/",
                         core::number_text(options.min_dihedral_deg)});
    if (options.max_volume > 0) s += core::joined({"a", core::number_text(options.max_volume)});
    if (std::any_of(options.regions.begin(), options.regions.end(),
                    [](const tet_region& r) { return r.max_volume > 0; }))
      s += "aA";
    return s;
  }

  void fill(tetgenio& in) const {
    const auto& points = input.points;
    in.numberofpoints = count(points.size());
    in.pointlist = new double[3 * points.size()];
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) in.pointlist[3 * i + k] = points[i][k];
    const auto& triangles = input.triangles;
    in.facetlist = new tetgenio::facet[triangles.size()];
    for (std::size_t i = 0; i < triangles.size(); ++i) tetgenio::init(in.facetlist + i);
    in.numberoffacets = count(triangles.size());  // after init(): the destructor of tetgenio reads the lists if memory
                                                  // runs out below
    in.facetmarkerlist = new int[triangles.size()];
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      tetgenio::facet& f = in.facetlist[i];
      f.polygonlist = new tetgenio::polygon[1];
      tetgenio::polygon& p = f.polygonlist[0];
      tetgenio::init(&p);
      f.numberofpolygons = 1;
      p.vertexlist = new int[3];
      p.numberofvertices = 3;
      for (std::size_t k = 0; k < 3; ++k) p.vertexlist[k] = static_cast<int>(triangles[i][k]);
      in.facetmarkerlist[i] = static_cast<int>(i) + 1;
    }
    if (!input.segments.empty()) {
      in.numberofedges = count(input.segments.size());
      in.edgelist = new int[2 * input.segments.size()];
      for (std::size_t i = 0; i < input.segments.size(); ++i)
        for (std::size_t k = 0; k < 2; ++k) in.edgelist[2 * i + k] = static_cast<int>(input.segments[i][k]);
    }
    if (!options.regions.empty()) {
      in.numberofregions = count(options.regions.size());
      in.regionlist = new double[5 * options.regions.size()];
      for (std::size_t i = 0; i < options.regions.size(); ++i) {
        const tet_region& r = options.regions[i];
        const double values[5] = {r.inside.x, r.inside.y, r.inside.z, static_cast<double>(i),
                                  r.max_volume > 0         ? r.max_volume
                                  : options.max_volume > 0 ? options.max_volume
                                                           : -1};
        std::copy(values, values + 5, in.regionlist + 5 * i);
      }
    }
    if (options.edge_length) {
      edge_length() = &options.edge_length;
      in.tetunsuitable = is_too_large;
    }
  }

 private:
  // TetGen calls a function without an argument of the caller's, so the function that gives edge lengths is kept for
  // the time of the call, by thread.
  static const function_ref<double(const vec3&)>*& edge_length() {
    thread_local const function_ref<double(const vec3&)>* current = nullptr;
    return current;
  }
  static bool is_too_large(double* a, double* b, double* c, double* d, double*, double) {
    const vec3 p[4] = {{a[0], a[1], a[2]}, {b[0], b[1], b[2]}, {c[0], c[1], c[2]}, {d[0], d[1], d[2]}};
    double longest = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) longest = std::max(longest, norm(p[i] - p[j]));
    return longest > (*edge_length())((p[0] + p[1] + p[2] + p[3]) / 4);
  }

  static int count(std::size_t n) {
    if (n > static_cast<std::size_t>(std::numeric_limits<int>::max()) / 4)
      throw unsupported("tetrahedralize: the surface has more elements than TetGen can number");
    return static_cast<int>(n);
  }
};

}  // namespace concino::detail
