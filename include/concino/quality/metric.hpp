// The quality metrics of polys: their names, the shapes they are defined for, their ranges, and which value is worse.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <cstddef>
#include <span>
#include <string_view>

namespace concino {

/// The shapes of polys that quality metrics distinguish. `polygon` has 5 verts or more; `polyhedron` is any other
/// volume cell.
enum class poly_shape : unsigned char { triangle, quad, polygon, tet, hex, prism, pyramid, polyhedron };
inline constexpr std::size_t num_poly_shapes = 8;

/// The quality metrics, with the names of the Verdict library. They are an enumeration, not types: a metric does not
/// change what is computed from the mesh, programs read its name from users, and all kernels are compiled once. Which
/// shapes have which metric: is_defined. "Edges" are those of the poly, "corners" the edges at one of its verts. On
/// surfaces, signs refer to the vector area of the poly.
enum class metric : unsigned char {
  area,                    // of the vector area, in units of length^2
  area_perimeter_ratio,    // 4 pi area over the squared perimeter: 1 for a circle
  volume,                  // in units of length^3; negative if inverted
  aspect_beta,             // radius_ratio; infinite if inverted
  aspect_frobenius,        // sum of squared edges over area; for tets, of the matrix that maps a regular one to it
  aspect_gamma,            // (root of the mean squared edge)^3 over volume
  aspect_ratio,            // longest edge over inradius
  circle_ratio,            // radius of the largest circle inside over that of the smallest one around; 0 if the polygon
                           // touches itself
  collapse_ratio,          // smallest height over the longest edge of the face below
  condition,               // condition number of the corners; infinite if inverted
  diagonal,                // shortest over longest diagonal
  dimension,               // characteristic length for stable time steps
  distortion,              // smallest Jacobian at the Gauss points, times reference measure over measure
  edge_ratio,              // longest over shortest edge
  equiangle_skew,          // largest deviation of an angle from that of the regular shape
  equivolume_skew,         // deviation of the volume from that of the regular tet in the same sphere
  inradius,                // of the inscribed sphere; negative if inverted
  jacobian,                // smallest Jacobian determinant of the corners, and of the centre of hexes
  max_aspect_frobenius,    // the largest condition number of the corners
  max_edge_ratio,          // longest over shortest principal axis
  maximum_angle,           // largest angle between edges, in degrees
  mean_ratio,              // that of the worst corner: 1 where it is as in the regular shape, negative if inverted
  med_aspect_frobenius,    // the mean condition number of the corners
  minimum_angle,           // smallest angle between edges, or dihedral angle of a tet, in degrees
  nodal_jacobian_ratio,    // smallest over largest Jacobian determinant of the corners
  normalized_inradius,     // smallest inradius of the parts between midpoints of edges, over the circumradius; of
                           // triangles 1 / radius_ratio
  oddy,                    // largest deviation of the metric tensor of a corner
  planarity,               // of the least planar face: 1 - thickness / (twice the largest distance of a vert from the
                           // mean)
  radius_ratio,            // circumradius over inradius
  relative_size_squared,   // min(s, 1/s)^2; s is the area or volume, divided by the mean one of the mesh
  scaled_jacobian,         // smallest Jacobian determinant of unit vectors along the edges of a corner
  shape,                   // mean_ratio of the worst corner, 0 if inverted
  shape_and_size,          // shape times relative_size_squared
  shear,                   // scaled_jacobian, 0 if inverted
  shear_and_size,          // shear times relative_size_squared
  skew,                    // largest cosine between principal axes
  star_shapedness,         // the part of the poly from which all of it is visible: 1 if convex, 0 if it is not
                           // star-shaped
  stretch,                 // shortest edge over longest diagonal
  taper,                   // largest cross derivative over principal axis
  warpage,                 // 1 - cosine^3 between normals at opposite corners
  aspect = aspect_ratio,   // the short name
  kernel_ratio = star_shapedness,  // the name of Attene et al.
};
inline constexpr std::size_t num_metrics = 40;

/// A closed interval.
struct value_range {
  double low = 0, high = 0;
  constexpr bool contains(double x) const { return low <= x && x <= high; }  // no for NaN
};

/// The values of a metric for polys of one shape.
struct metric_limits {
  value_range acceptable;  // Verdict's. What it does not limit, and the metrics that it lacks, have the limits of this
                           // library
  value_range full;        // all values; infinite where a limit does not exist
  double ideal = 1;        // of the regular shape with unit edges; NaN if it depends on the other polys, or if there is
                           // no regular one
  unsigned length_power = 0;  // the value of a poly scaled by s is multiplied by s^length_power; relative sizes are
                              // measured in the scaled mesh
};

/// Whether `what` is defined for polys of this shape.
/// Needs:  nothing.
/// Result: true for scaled_jacobian, mean_ratio, planarity, star_shapedness, edge_ratio, area or volume and
///         relative_size_squared of all shapes, circle_ratio and area_perimeter_ratio of all polygons, and for what the
///         Verdict manual defines.
/// Cost:   O(1).      Errors: none.
bool is_defined(metric what, poly_shape shape);

/// The ranges of a metric.
/// Needs:  a metric that is defined for the shape.      Result: see metric_limits.      Cost: O(1).      Errors:
///         unsupported if it is not defined.
/// Source: Stimpson, Ernst, Knupp, Pebay and Thompson 2007, "The Verdict geometric quality library", SAND2007-1751.
metric_limits limits_of(metric what, poly_shape shape);

/// Whether a value is acceptable: not worse than all of limits_of(what, shape).acceptable. The better end of that range
/// is the ideal value, which rounding errors may exceed.
/// Needs:  a metric that is defined for the shape.      Result: no for NaN.      Cost: O(1).      Errors: unsupported
///         if it is not defined.
bool is_acceptable(metric what, poly_shape shape, double value);

/// Whether larger values of a metric are worse, as for aspect_ratio; else smaller ones are, as for scaled_jacobian,
/// area and volume.
/// Needs:  nothing.      Result: the same for all shapes.      Cost: O(1).      Errors: none.
bool larger_is_worse(metric what);

/// Whether the value a is worse than b. NaN, the value of polys with points that are not finite, is worse than any
/// number.
/// Needs:  values of `what`.      Result: a strict weak order.      Cost: O(1).      Errors: none.
inline bool is_worse(metric what, double a, double b) {
  if (a != a || b != b) return a != a && b == b;
  return larger_is_worse(what) ? a > b : a < b;
}

/// The names of a metric and of a shape, as the enumerators are written; the metric of a name.
/// Needs:  nothing.      Result: a text with static lifetime.      Cost: O(1), of metric_named O(number of metrics).
/// Errors: invalid_argument that lists the metrics, if none has this name.
std::string_view name_of(metric what);
std::string_view name_of(poly_shape shape);
metric metric_named(std::string_view name);

/// The value of a metric for a poly of this shape with these points.
/// Needs:  a triangle, quad, tet, hex, prism or pyramid in the standard order (that of MEDIT and Verdict), or a polygon
///         in cyclic order. Relative sizes are those to mean_size, a mean area or volume; they are 0 if it is 0.
/// Result: within limits_of(what, shape).full, up to rounding. NaN if a point is not finite. A degenerate poly, for
///         which the definition divides by 0, has the value 0 where smaller ones are worse, else the high end of the
///         full range, mostly infinity (Verdict: 1e30). Inverted cells have negative scaled_jacobian, mean_ratio,
///         jacobian, volume, inradius and collapse_ratio. Polys of any magnitude are evaluated as if scaled by a power
///         of two.
/// Cost:   O(points); star_shapedness of polys that are not convex O(points^2), circle_ratio as inscribed_circle.
/// Errors: unsupported if the metric is not defined for the shape, or for a polyhedron, which needs its faces;
///         invalid_argument for a wrong number of points.
/// Source: as limits_of. Where the manual and the values of Verdict's tests differ, the tests are followed, except for
///         warpage, which is that of the manual. mean_ratio of other shapes than triangles and tets: Knupp 2001,
///         "Algebraic mesh quality metrics". star_shapedness: Sorgente, Biasotti, Manzini and Spagnuolo 2022, "The role
///         of mesh quality and mesh quality indicators in the virtual element method". circle_ratio, kernel_ratio and
///         area_perimeter_ratio: Attene, Biasotti, Bertoluzza, Cabiddu, Livesu, Patane, Pennacchio, Prada and Spagnuolo
///         2019, "Benchmark of polygon quality metrics for polytopal element methods".
double quality(poly_shape shape, std::span<const vec3> points, metric what, double mean_size = 0);

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/quality/detail/metric_row.hpp>  // includes the definitions
#endif
