// Reads the geometry of polys, and evaluates a metric for all polys of a mesh.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/poly_chunks.hpp>
#include <concino/quality/detail/cell_reader.hpp>

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace concino::detail {

/// The shape of all polys of a mesh type with a fixed number of verts per poly.
template<class M>
inline constexpr poly_shape known_shape = dimension_v<M> == 2
                                              ? (arity_v<M> == 3 ? poly_shape::triangle : poly_shape::quad)
                                          : arity_v<M> == 4 ? poly_shape::tet
                                                            : poly_shape::hex;

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
      return {points_.size() == 3   ? poly_shape::triangle
              : points_.size() == 4 ? poly_shape::quad
                                    : poly_shape::polygon,
              points_,
              {},
              {},
              0};
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

/// Evaluates a metric for the polys of a part of a mesh, and calls f(poly, value, shape) for each. Polys of a known
/// shape are evaluated together.
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
    core::run_chunks(
        all.index_bound(), 1024,
        [&](std::size_t first, std::size_t last) { for_each_quality_of(m, all.part(first, last), rows, mean_size, f); },
        {});
  } else {
    core::poly_chunks<M>(m).template for_each<poly_reader<M>>(
        [&](poly_reader<M>& read, const poly_t<M>& p, std::size_t) {
          poly_geometry g = read(m, p);
          g.mean_size = mean_size;
          f(p, rows.evaluate_at(g, index_of(m, p)), g.shape);
          return 0;
        });
  }
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/quality/detail/poly_reader.ipp>
#endif
