// Virtual elements of order 1: stiffness and mass of one poly of any shape. Functions with values at its verts are
// projected to linear functions.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/operators/corner_gradients.hpp>
#include <concino/operators/discretisation.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// A symmetric 3 x 3 matrix.
struct symmetric3 {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  void add(double factor, const vec3& a) {
    const vec3 b = factor * a;
    xx += a.x * b.x;
    xy += a.x * b.y;
    xz += a.x * b.z;
    yy += a.y * b.y;
    yz += a.y * b.z;
    zz += a.z * b.z;
  }
  void add(double factor, const symmetric3& a) {
    xx += factor * a.xx;
    xy += factor * a.xy;
    xz += factor * a.xz;
    yy += factor * a.yy;
    yz += factor * a.yz;
    zz += factor * a.zz;
  }
  vec3 operator*(const vec3& a) const {
    return {xx * a.x + xy * a.y + xz * a.z, xy * a.x + yy * a.y + yz * a.z, xz * a.x + yz * a.y + zz * a.z};
  }
  double trace() const { return xx + yy + zz; }
  double trace_of_inverse() const {
    const double x = yy * zz - yz * yz, y = xx * zz - xz * xz, z = xx * yy - xy * xy;
    return (x + y + z) / (xx * x - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz));
  }
};

/// The verts of a thin poly in coordinates sorted by extent: y = Q R with orthonormal columns Q that are also
/// orthogonal to constants. Small values along one axis are not lost next to large values along another.
struct thin_poly_coordinates {
  vec3 axis[3];
  std::vector<vec3> q;      // a row for each vert; the last column is 0 for polygons
  double r[3][3] = {};      // upper triangle
  bool is_regular = false;  // the extent along every axis is positive

  /// normal: the unit normal of a polygon; 0 for a polyhedron.
  void find(const std::vector<vec3>& points, const vec3& normal, std::size_t dimension);

  /// R^-1 a: the gradient in these coordinates of the function with values Q a.
  vec3 solve(vec3 a, std::size_t dimension) const;
};

/// The common part of both matrices, the lower triangle row by row. form: of both gradients; factor: of the squares of
/// u - P u at the verts; constant: added to every entry; image: scratch.
void fill_projected(const corner_gradient_arrays& poly, const symmetric3& form, double factor, double constant,
                    std::vector<vec3>& image, std::vector<double>& entries);

/// The projection of a poly's functions to linear ones, P u (x) = mean of u + (sum of u_i g_i) . (x - mean of the
/// verts). Both matrices have the form: the exact one on P u, plus a multiple of the sum of squares of u - P u at the
/// verts, which P maps to 0.
template<EmbeddedMesh M>
class virtual_element {
 protected:
  static constexpr std::size_t dimension = static_cast<std::size_t>(dimension_v<M>);

  const M* m_;
  const char* caller_;
  corner_gradients<M> poly_;

  virtual_element(const M& m, const char* caller) : m_(&m), caller_(caller) {}

  /// Errors: invalid_mesh if p has no area or volume, or points that are not finite.
  void visit(const poly_t<M>& p) {
    poly_.visit(*m_, p);
    if (!poly_.has_gradients()) throw_no_measure(caller_, *m_, p);
  }

  bool is_simplex() const { return poly_.verts.size() == dimension + 1; }

  void name_verts(local_matrix<vert_t<M>>& out) const { out.verts.assign(poly_.verts.begin(), poly_.verts.end()); }
};

/// The stiffness: u . K u is the integral of the squared gradient of P u, plus the squares of u - P u times a factor.
/// The factor gives rectangles and boxes the bilinear and trilinear elements as far as one factor can. It has the order
/// of the stiffness itself however the poly is stretched; a power of its diameter would not. The sum of squares of the
/// g_i also grows with the raggedness of a poly, which would make it too stiff. Of all g_i that are exact on linear
/// functions, Y^-1 y_i with Y the sum of y y^T have the smallest sum of squares, which is the trace of Y^-1. It is the
/// same on boxes, and is used for polyhedra.
/// Source: Beirao da Veiga et al. 2013, "Basic principles of virtual element methods"; 2014, "The hitchhiker's guide to
///         the virtual element method".
template<std::size_t Dimension>
class stiffness_of_poly {
  thin_poly_coordinates thin_;
  std::vector<vec3> image_, gradient_, unseen_;  // the last two for fill_thin

  static double stabilisation_factor(double n) { return Dimension == 2 ? n / 12 : std::sqrt(n / 162); }
  bool fill_thin(const corner_gradient_arrays& poly, double size, std::vector<double>& entries);

 public:
  /// The lower triangle row by row.
  void fill(const corner_gradient_arrays& poly, std::vector<double>& entries);
};

template<EmbeddedMesh M>
class virtual_stiffness : virtual_element<M> {
  using base = virtual_element<M>;
  stiffness_of_poly<base::dimension> of_poly_;

 public:
  explicit virtual_stiffness(const M& m) : base(m, "virtual elements") {}

  void operator()(const poly_t<M>& p, local_matrix<vert_t<M>>& out) {
    this->visit(p);
    this->name_verts(out);
    of_poly_.fill(this->poly_, out.entries);
  }
};

/// The mass: u . M u is the integral of the square of P u, exact over the poly as it is measured, plus the squares of u
/// - P u times a factor. The factor makes rectangles bilinear elements. Simplices have the mass of linear elements.
/// Source: Ahmad et al. 2013, "Equivalent projectors for virtual element methods".
template<EmbeddedMesh M>
class virtual_mass : virtual_element<M> {
  using base = virtual_element<M>;

 public:
  explicit virtual_mass(const M& m) : base(m, "mass matrix") {}

  void operator()(const poly_t<M>& p, local_matrix<vert_t<M>>& out) {
    this->visit(p);
    const corner_gradients<M>& poly = this->poly_;
    const double size = std::abs(poly.measure), n = static_cast<double>(poly.verts.size());
    moments_ = {};
    first_ = {};
    if constexpr (SurfaceMesh<M>) add_polygon(poly);  // integrates over an area or over a volume
    else add_polyhedron(p);
    const double factor = this->is_simplex() ? 0 : size / (9 * n);
    if (factor > 0)
      for (const vec3& y : poly.points) moments_.add(factor, y);
    this->name_verts(out);
    fill_projected(poly, moments_, factor, size / (n * n), image_, out.entries);
    for (std::size_t i = 0; i < poly.verts.size(); ++i) {  // the mean of the verts is not the centre of mass
      const double ci = dot(poly.gradient[i], first_) / n;
      for (std::size_t j = 0; j <= i; ++j) out.at(i, j) += ci + dot(poly.gradient[j], first_) / n;
    }
  }

 private:
  std::vector<vec3> image_;
  symmetric3 moments_;  // the integral of y y^T, with y relative to the mean of the verts
  vec3 first_;          // the integral of y

  void add_polygon(const corner_gradients<M>& poly) {
    const vec3 direction = poly.normal / norm(poly.normal);
    for (std::size_t i = 0, n = poly.points.size(); i < n; ++i) {
      const vec3 &a = poly.points[i], &b = poly.points[i + 1 < n ? i + 1 : 0];
      const double part = 0.5 * dot(cross(a, b), direction);
      first_ += (part / 3) * (a + b);
      for (const vec3& y : {a, b, a + b}) moments_.add(part / 12, y);
    }
  }

  void add_polyhedron(const poly_t<M>& p) {
    const M& m = *this->m_;
    const vec3 origin = this->poly_.mean;
    const double inverted = this->poly_.measure < 0 ? -1 : 1;
    const auto& around = adj_p2f(m, p);
    for (auto it = around.begin(); it != around.end(); ++it) {
      const auto f = *it;
      const vec3 c = shape_of(m, adj_f2v(m, f)).mean - origin;
      const double sign = (face_is_outward(m, p, f) ? 1 : -1) * inverted;
      for_each_fan_side(m, adj_f2v(m, f), [&](const vec3& x, const vec3& y) {
        const vec3 a = x - origin, b = y - origin, sum = a + b + c;
        const double part = sign * dot(c, cross(a, b)) / 6;
        first_ += (part / 4) * sum;
        for (const vec3& z : {a, b, c, sum}) moments_.add(part / 20, z);
      });
    }
  }
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/operators/detail/virtual_elements.ipp>
#endif
