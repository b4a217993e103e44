// The quality of the polys of a mesh: of one, of all.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/poly_chunks.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/quality/detail/cell_reader.hpp>
#include <concino/quality/mean_ratio.hpp>
#include <concino/quality/metric.hpp>
#include <concino/quality/scaled_jacobian.hpp>

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace concino {

struct quality_options {
  double mean_size = 0;  // the area or volume that relative sizes compare with, in units of the mesh; 0: the mean of the polys of the mesh. >= 0
};

namespace detail {

/// The shape of all polys of a mesh type with a fixed number of verts per poly.
template<class M>
inline constexpr poly_shape known_shape = dimension_v<M> == 2 ? (arity_v<M> == 3 ? poly_shape::triangle : poly_shape::quad) : arity_v<M> == 4 ? poly_shape::tet : poly_shape::hex;

/// Reads the geometry of one poly after another.
template<EmbeddedMesh M>
class poly_reader {
  std::vector<vec3> points_;
  std::vector<vert_t<M>> verts_;
  cell_reader cell_;
  vec3 corners_[8];

 public:
  poly_geometry operator()(const M& m, const poly_t<M>& p) {
    if constexpr (arity_v<M> > 0) {  // the shape is known
      std::size_t n = 0;
      for (const vert_t<M> v : adj_p2v(m, p)) corners_[n++] = to_vec3(point(m, v));
      poly_geometry g{known_shape<M>, {corners_, n}, {}, {}, 0};
      set_standard_faces(g);
      return g;
    } else if constexpr (SurfaceMesh<M>) {  // a cycle of verts; a volume has faces
      points_.clear();
      for (const vert_t<M> v : adj_p2v(m, p)) points_.push_back(to_vec3(point(m, v)));
      return {points_.size() == 3 ? poly_shape::triangle : points_.size() == 4 ? poly_shape::quad : poly_shape::polygon, points_, {}, {}, 0};
    } else {
      read_faces(m, p);
      return cell_.geometry();
    }
  }

 private:
  void read_faces(const M& m, const poly_t<M>& p) {
    cell_.clear();
    verts_.clear();
    for (const vert_t<M> v : adj_p2v(m, p)) {
      verts_.push_back(v);
      cell_.add_point(to_vec3(point(m, v)));
    }
    for (const auto f : adj_p2f(m, p)) {
      cell_.begin_face();
      for (const vert_t<M> v : adj_f2v(m, f)) {
        unsigned local = 0;
        while (local + 1 < verts_.size() && !(verts_[local] == v)) ++local;
        cell_.add_corner(local);
      }
      if (!face_is_outward(m, p, f)) cell_.reverse_face();
    }
  }
};

/// The rows of a metric for all shapes.
class metric_rows {
  metric what_;
  const metric_row* of_shape_[num_poly_shapes];

 public:
  explicit metric_rows(metric what);
  bool are_relative() const;
  /// The values of n polys of one shape, whose points follow one another.
  /// Errors: unsupported that names poly_index if the metric is not defined for their shape.
  void evaluate_at(const poly_geometry& all, std::size_t n, double* values, std::size_t poly_index) const;
  double evaluate_at(const poly_geometry& g, std::size_t poly_index) const {
    double value = 0;
    evaluate_at(g, 1, &value, poly_index);
    return value;
  }
};

/// Errors: invalid_argument if it is negative or not finite.
void check_mean_size(double size);

/// Evaluates a metric for the polys of a part of a mesh, and calls f(poly, value, shape) for each. Polys of a known shape are evaluated together.
template<EmbeddedMesh M, class Part, class F>
void for_each_quality_of(const M& m, const Part& part, const metric_rows& rows, double mean_size, const F& f) {
  if constexpr (arity_v<M> > 0) {  // the shape is known
    constexpr std::size_t arity = arity_v<M>, block = 32;
    poly_t<M> block_polys[block];
    vec3 corners[block * arity];
    double values[block];
    std::size_t n = 0;
    const auto evaluate_block = [&] {
      poly_geometry all{known_shape<M>, {corners, n * arity}, {}, {}, mean_size};
      set_standard_faces(all);
      rows.evaluate_at(all, n, values, index_of(m, block_polys[0]));
      for (std::size_t i = 0; i < n; ++i) f(block_polys[i], values[i], all.shape);
      n = 0;
    };
    for (const poly_t<M> p : part) {
      vec3* corner = corners + n * arity;
      for (const vert_t<M> v : adj_p2v(m, p)) *corner++ = to_vec3(point(m, v));
      block_polys[n++] = p;
      if (n == block) evaluate_block();
    }
    if (n > 0) evaluate_block();
  } else {
    poly_reader<M> read;
    for (const poly_t<M> p : part) {
      poly_geometry g = read(m, p);
      g.mean_size = mean_size;
      f(p, rows.evaluate_at(g, index_of(m, p)), g.shape);
    }
  }
}

/// Calls f(poly, value, shape) for all polys, in parallel.
template<class M, class F>
void for_each_quality(const M& m, const metric_rows& rows, double mean_size, const F& f) {
  if constexpr (const auto& all = polys(m); core::is_divisible<std::remove_cvref_t<decltype(all)>>) {
    core::run_chunks(all.index_bound(), 1024, [&](std::size_t first, std::size_t last) { for_each_quality_of(m, all.part(first, last), rows, mean_size, f); }, {});
  } else {
    core::poly_chunks<M>(m).template for_each<poly_reader<M>>([&](poly_reader<M>& read, const poly_t<M>& p, std::size_t) {
      poly_geometry g = read(m, p);
      g.mean_size = mean_size;
      f(p, rows.evaluate_at(g, index_of(m, p)), g.shape);
      return 0;
    });
  }
}

}  // namespace detail

/// The shape of poly p: by its number of verts on surfaces, by its faces in volumes.
/// Needs:  AnyMesh.
/// Result: as poly_shape says. A volume cell whose faces are those of a tet, hex, prism or pyramid has that shape, whatever the type of the mesh.
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
/// Result: as quality(shape, points, metric) of <concino/quality/metric.hpp>, which says what degenerate, inverted and non-finite polys give.
/// Cost:   O(verts of p and its faces); for relative sizes without a mean size, O(size of the mesh).
/// Errors: unsupported if the metric is not defined for the shape of p (is_defined); invalid_argument if the mean size is negative or not finite.
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
/// Errors: as quality of a poly, for the first poly that has one. For other metrics, polys of different shapes have different limits (limits_of).
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
/// Needs:  EmbeddedMesh.      Result: quality(m, p, metric::scaled_jacobian) and so on.      Cost: as quality.      Errors: none.
template<EmbeddedMesh M> double scaled_jacobian(const M& m, const poly_t<M>& p) { return quality(m, p, metric::scaled_jacobian); }
template<EmbeddedMesh M> double mean_ratio(const M& m, const poly_t<M>& p) { return quality(m, p, metric::mean_ratio); }
template<EmbeddedMesh M> double planarity(const M& m, const poly_t<M>& p) { return quality(m, p, metric::planarity); }
template<EmbeddedMesh M> double star_shapedness(const M& m, const poly_t<M>& p) { return quality(m, p, metric::star_shapedness); }

// What to write instead of calls that cannot compile.
template<class... T> void quality(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
template<class... T> void quality(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void quality(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void quality(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/quality/detail/poly_quality.ipp>
#endif
