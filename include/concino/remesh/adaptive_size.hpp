// Lengths for the edges of a surface: short where it is curved, long where it is flat.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/remesh/detail/size_estimate.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace concino {

struct adaptive_size_options {
  double chord_error = 0;         // how far triangles may be from the smooth surface that the mesh represents, about;
                                  // in units of the mesh. Above 0
  double min_length = 0;          // no size is smaller; 0: the chord error. In units of the mesh
  double max_length = 0;          // no size is greater; 0: a tenth of the diagonal of the bounding box, or min_length
                                  // if that is more
  double gradation = 0.5;         // sizes differ by at most this times the length of the path along edges between two
                                  // verts; infinity: no limit. Above 0
  double feature_angle_deg = 40;  // edges at which the surface turns by more than this are no part of the smooth
                                  // surface, but lines with a curvature of their own
};

namespace detail {

inline void check_adaptive_size(const adaptive_size_options& options) {
  const auto fail = [](const char* what) { core::throw_joined<invalid_argument>({"adaptive_size: ", what}); };
  const auto is_length = [](double x) { return x >= 0 && std::isfinite(x); };
  if (!(options.chord_error > 0 && std::isfinite(options.chord_error)))
    fail("options.chord_error must be finite and above 0");
  if (!is_length(options.min_length) || !is_length(options.max_length))
    fail("options.min_length and options.max_length must be finite and at least 0");
  if (options.max_length > 0 && options.max_length < options.min_length)
    fail("options.max_length is less than options.min_length");
  if (!(options.gradation > 0)) fail("options.gradation is not above 0");
  if (!(options.feature_angle_deg >= 0))
    fail("options.feature_angle_deg is negative or not a number; it must be at least 0");
}

/// The edge of an equilateral triangle inscribed in a sphere of this curvature, with the error at its centre. A greater
/// error than the radius means that the whole sphere is negligible; the edge does not become shorter then.
inline double length_on_sphere(double curvature, double error) {
  if (!(curvature > 0)) return std::numeric_limits<double>::infinity();
  const double radius = 1 / curvature;
  return error < radius ? std::sqrt(3 * error * (2 * radius - error)) : std::sqrt(3.0) * error;
}

/// The chord of a circle of this curvature with the error at its middle.
inline double length_on_circle(double curvature, double error) {
  if (!(curvature > 0)) return std::numeric_limits<double>::infinity();
  const double radius = 1 / curvature;
  return error < radius ? 2 * std::sqrt(error * (2 * radius - error)) : 2 * error;
}

}  // namespace detail

/// The lengths that edges should have at the verts, so that triangles of these edges are about as close to the smooth
/// surface as the chord error.
/// Needs:  Embedded SurfaceMesh, no temporary; of any topology, with any polygons.
/// Result: a map of double, in units of the mesh, that scales exactly by powers of two. By the greatest curvature of
///         the polys at a vert and of the feature line through it (sharp edges, boundaries, non-manifold edges). Verts
///         where nothing is curved have max_length. Where polys have no area there is no curvature.
/// Cost:   O(corners) for verts with few polys, parallel; O(n log n) for the gradation.
/// Errors: invalid_argument if an option is out of its range; invalid_mesh if a point is not finite.
/// Source: Dunyach, Vanderhaeghe, Barthe, Botsch 2013, "Adaptive remeshing for real-time mesh deformation"; curvature:
///         Rusinkiewicz 2004, "Estimating curvatures and their derivatives on triangle meshes"; gradation: Persson
///         2006, "Mesh size functions for implicit geometries and PDE-based gradient limiting".
template<class M>
  requires requirement::is_lvalue_or_view<M> && SurfaceMesh<M> && Embedded<M>
vert_map<M, double> adaptive_size(M&& m, const adaptive_size_options& options) {
  using mesh = std::remove_cvref_t<M>;
  detail::check_adaptive_size(options);
  const detail::size_estimate<mesh> estimate(m, options.feature_angle_deg);
  poly_map<mesh, double> curvature(m, poly_index_bound(m), detail::unwritten{});
  parallel_for_each(polys(m), [&](const poly_t<mesh>& p) { curvature[p] = estimate.poly_curvature(p); });
  const double error = estimate.scaled(options.chord_error);
  const double least = options.min_length > 0 ? estimate.scaled(options.min_length) : error;
  const double most =
      std::max(least, options.max_length > 0 ? estimate.scaled(options.max_length) : estimate.diagonal() / 10);
  auto sizes = make_vert_map<double>(m, 0.0);
  parallel_for_each(verts(m), [&](const vert_t<mesh>& v) {
    double greatest = 0;
    for (const poly_t<mesh> p : adj_v2p(m, v)) greatest = std::max(greatest, curvature[p]);
    sizes[v] = std::clamp(std::min(detail::length_on_sphere(greatest, error),
                                   detail::length_on_circle(estimate.line_curvature(v), error)),
                          least, most);
  });
  if (std::isfinite(options.gradation)) estimate.limit_growth(sizes, options.gradation);
  for (const vert_t<mesh> v : verts(m)) sizes[v] = estimate.unscaled(sizes[v]);
  return sizes;
}

// What to write instead of calls that cannot compile.
template<class... T> void adaptive_size(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void adaptive_size(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void adaptive_size(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
