// tetrahedralize(surface, cgal): tets that approximate the volume in a surface, by CGAL's 3D mesher.
//
//   const auto tets = tetrahedralize(surface, cgal, {.facet_distance = 0.01, .feature_angle_deg = 60});
//
// Needs: CGAL 5.5, its package 3D Mesh Generation, under the GPL (Debian: libcgal-dev), GMP and MPFR.
#pragma once

#include <concino/adapters/cgal_tag.hpp>
#include <concino/adapters/detail/cgal_mesh_in_surface.hpp>
#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>
#include <concino/generate/tetrahedralize.hpp>

#include <cmath>

namespace concino {

namespace detail {

/// CGAL's mesher as a back end of tetrahedralize().
struct cgal_mesher {
  const cgal_tetrahedralize_options& options;

  static constexpr const char* name() { return "CGAL"; }
  double surface_distance(double diagonal) const {
    return options.facet_distance > 0 ? options.facet_distance : diagonal / 200;
  }
  tetrahedralize_output tetrahedralize(const tetrahedralize_input& in, const tetrahedralize_options&) const {
    return cgal_mesh_in_surface(in, options).fill(surface_distance(in.diagonal));
  }
};

}  // namespace detail

/// Fills a closed surface with tets whose boundary is near to the surface, but does not keep its triangles; sharp edges
/// are kept where asked for.
/// Needs:  as tetrahedralize() with other back ends. The surface winds around each point at most once.
/// Result: tets of positive volume. The corners of boundary faces are within facet_distance of the surface, and the
///         volume differs from the enclosed one by at most that distance times the area. With features, their verts
///         where they end or turn sharply are verts of the result, and vert_of finds them. poly_of gives the nearest
///         poly of the surface for each boundary face. The same each time.
/// Cost:   that of CGAL, ten or more times that of TetGen for as many tets.
/// Errors: as tetrahedralize(). unsupported if CGAL fails, makes more verts than allowed, or misses the distance.
///         cancelled.
/// Source: Jamin, Alliez, Yvinec, Boissonnat 2015, "CGALmesh: a generic framework for Delaunay mesh generation".
template<SurfaceMesh M>
  requires Embedded<M>
tetrahedralization<M> tetrahedralize(const M& m, cgal_t, const cgal_tetrahedralize_options& input_options = {}) {
    const core::profiled_options profiled(input_options, "tetrahedralize");
    const cgal_tetrahedralize_options& options = *profiled;
    const auto check = [](const char* name, double x, bool is_allowed, const char* range) {
      if (!is_allowed)
        core::throw_joined<invalid_argument>(
            {"tetrahedralize: ", name, " is ", core::number_text(x), "; it must be ", range});
    };
    check("facet_distance", options.facet_distance,
          options.facet_distance >= 0 && std::isfinite(options.facet_distance), "0 or more");
    check("facet_angle_deg", options.facet_angle_deg, options.facet_angle_deg >= 0 && options.facet_angle_deg <= 30,
          "from 0 to 30");
    check("facet_size", options.facet_size, options.facet_size >= 0 && std::isfinite(options.facet_size), "0 or more");
    check("feature_angle_deg", options.feature_angle_deg,
          options.feature_angle_deg > 0 && options.feature_angle_deg <= 180, "above 0 and at most 180");
    check("feature_edge_length", options.feature_edge_length,
          options.feature_edge_length >= 0 && std::isfinite(options.feature_edge_length), "0 or more");
    check("radius_edge", options.radius_edge, options.radius_edge >= 2 && std::isfinite(options.radius_edge),
          "at least 2, where the mesher is known to end");
    return tetrahedralize(m, detail::cgal_mesher{options},
                          tetrahedralize_options{.radius_edge = options.radius_edge,
                                                 .max_volume = options.max_volume,
                                                 .edge_length = options.edge_length,
                                                 .progress = options.progress});
}

}  // namespace concino
