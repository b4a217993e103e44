// The quality of the polys of a mesh: of one, of all.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/quality/detail/poly_reader.hpp>
#include <concino/quality/mean_ratio.hpp>
#include <concino/quality/metric.hpp>
#include <concino/quality/scaled_jacobian.hpp>

namespace concino {

struct quality_options {
  double mean_size = 0;  // the area or volume that relative sizes compare with, in units of the mesh; 0: the mean of
                         // the polys of the mesh. >= 0
};

/// The shape of poly p: by its number of verts on surfaces, by its faces in volumes.
/// Needs:  AnyMesh.
/// Result: as poly_shape says. A volume cell whose faces are those of a tet, hex, prism or pyramid has that shape,
///         whatever the type of the mesh.
/// Cost:   O(verts of the faces).      Errors: none.
template<EmbeddedMesh M>
poly_shape shape_of_poly(const M& m, const poly_t<M>& p) {
  return detail::poly_reader<M>()(m, p).shape;
}

/// The mean area of the polys of a surface, or the mean volume of those of a volume.
/// Needs:  EmbeddedMesh.      Result: in units of the mesh; inverted cells count negative; 0 for an empty mesh.
/// Cost:   O(size of the mesh); parallel; 8 bytes per poly for the time of the call.      Errors: none.
template<EmbeddedMesh M>
double mean_poly_size(const M& m) {
  const detail::metric_rows rows(dimension_v<M> == 2 ? metric::area : metric::volume);
  poly_map<M, double> size(m, poly_index_bound(m), detail::unwritten{});
  detail::for_each_quality(m, rows, 0, [&](const poly_t<M>& p, double q, poly_shape) { size[p] = q; });
  double sum = 0;
  for (const poly_t<M> p : polys(m)) sum += size[p] / static_cast<double>(num_polys(m));
  return sum;
}

namespace detail {

template<class M>
double chosen_mean_size(const M& m, const metric_rows& rows, const quality_options& options) {
  check_mean_size(options.mean_size);
  return rows.are_relative() && options.mean_size == 0 ? mean_poly_size(m) : options.mean_size;
}

}  // namespace detail

/// A quality metric of poly p, by the metric of its shape.
/// Needs:  EmbeddedMesh; verts of volume cells and their faces oriented as face_is_outward says.
/// Result: as quality(shape, points, metric) of <concino/quality/metric.hpp>, which says what degenerate, inverted and
///         non-finite polys give.
/// Cost:   O(verts of p and its faces); for relative sizes without a mean size, O(size of the mesh).
/// Errors: unsupported if the metric is not defined for the shape of p (is_defined); invalid_argument if the mean size
///         is negative or not finite.
template<EmbeddedMesh M>
double quality(const M& m, const poly_t<M>& p, metric what, const quality_options& options = {}) {
  const detail::metric_rows rows(what);
  detail::poly_reader<M> read;
  detail::poly_geometry g = read(m, p);
  g.mean_size = detail::chosen_mean_size(m, rows, options);
  return rows.evaluate_at(g, index_of(m, p));
}

/// A quality metric of all polys.
/// Needs:  EmbeddedMesh, no temporary.
/// Result: a map of double, with quality(m, p, what) for each p.      Cost: that of quality for every poly; parallel.
/// Errors: as quality of a poly, for the first poly that has one. For other metrics, polys of different shapes have
///         different limits (limits_of).
template<class M>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M>
poly_map<M, double> quality(M&& m, metric what, const quality_options& options = {}) {
  const detail::metric_rows rows(what);
  const double mean_size = detail::chosen_mean_size(m, rows, options);
  poly_map<M, double> value(m, poly_index_bound(m), detail::unwritten{});
  detail::for_each_quality(m, rows, mean_size, [&](const poly_t<M>& p, double q, poly_shape) { value[p] = q; });
  return value;
}

/// The metrics that are defined for polys of all shapes, by their names.
/// Needs:  EmbeddedMesh.      Result: quality(m, p, metric::scaled_jacobian) and so on.      Cost: as quality.     
///         Errors: none.
template<EmbeddedMesh M>
double scaled_jacobian(const M& m, const poly_t<M>& p) {
  return quality(m, p, metric::scaled_jacobian);
}
template<EmbeddedMesh M> double mean_ratio(const M& m, const poly_t<M>& p) { return quality(m, p, metric::mean_ratio); }
template<EmbeddedMesh M> double planarity(const M& m, const poly_t<M>& p) { return quality(m, p, metric::planarity); }
template<EmbeddedMesh M>
double star_shapedness(const M& m, const poly_t<M>& p) {
  return quality(m, p, metric::star_shapedness);
}

// What to write instead of calls that cannot compile.
template<class... T> void quality(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void quality(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void quality(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void quality(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0

}  // namespace concino
