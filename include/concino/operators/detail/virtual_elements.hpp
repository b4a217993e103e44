// Virtual elements of order 1: stiffness and mass of one poly of any shape, by projecting functions known at its verts to linear ones.
#pragma once

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

/// The places of the verts of a thin poly in coordinates along which it is longest first, y = Q R with orthonormal columns Q that are orthogonal to
/// constants too. What is tiny along one axis is not lost beside what is large along another.
struct thin_places {
  vec3 axis[3];
  std::vector<vec3> q;      // a row for each vert; where polygons are measured, the last column is 0
  double r[3][3] = {};      // upper triangle
  bool is_regular = false;  // there is an extent along every axis

  /// normal: of unit length, of a polygon; 0 of a polyhedron.
  void find(const std::vector<vec3>& place, const vec3& normal, std::size_t dimension) {
    const auto longest = [&](auto&& part) {
      vec3 best;
      for (const vec3& y : place)
        if (const vec3 x = part(y); dot(x, x) > dot(best, best)) best = x;
      return best / norm(best);
    };
    const auto without = [](const vec3& x, const vec3& a) { return x - dot(a, x) * a; };
    axis[0] = longest([&](const vec3& y) { return without(y, normal); });
    if (dimension == 2) {
      axis[1] = cross(normal, axis[0]);
    } else {
      axis[1] = longest([&](const vec3& y) { return without(without(y, axis[0]), axis[0]); });
      axis[2] = cross(axis[0], axis[1]);
    }
    q.assign(place.size(), vec3{});
    is_regular = true;
    const double n = static_cast<double>(place.size());
    for (std::size_t k = 0; k < dimension; ++k) {
      for (std::size_t i = 0; i < q.size(); ++i) q[i][k] = dot(axis[k], place[i]);
      for (auto& row : r) row[k] = 0;
      for (int round = 0; round < 2; ++round) {  // Gram and Schmidt's method, twice for the digits
        double mean = 0;
        for (const vec3& x : q) mean += x[k] / n;
        for (vec3& x : q) x[k] -= mean;
        for (std::size_t l = 0; l < k; ++l) {
          double along = 0;
          for (const vec3& x : q) along += x[l] * x[k];
          for (vec3& x : q) x[k] -= along * x[l];
          r[l][k] += along;
        }
      }
      double squares = 0;
      for (const vec3& x : q) squares += x[k] * x[k];
      r[k][k] = std::sqrt(squares);
      is_regular &= r[k][k] > 0 && std::isfinite(r[k][k]);
      for (vec3& x : q) x[k] /= r[k][k];
    }
  }

  /// R^-1 a, the gradient in these coordinates of what has the values Q a.
  vec3 solve(vec3 a, std::size_t dimension) const {
    for (std::size_t k = dimension; k-- > 0;) {
      for (std::size_t l = k + 1; l < dimension; ++l) a[k] -= r[k][l] * a[l];
      a[k] /= r[k][k];
    }
    return a;
  }
};

/// The projection of a poly's functions to linear ones, P u (x) = mean of u + (sum of u_i g_i) . (x - mean of the verts), and the form
/// that both matrices have: the exact one on P u, and a multiple of the sum of squares of u - P u at the verts, which P does not see.
template<AnyMesh M>
  requires Embedded<M>
class virtual_element {
 protected:
  static constexpr std::size_t dimension = static_cast<std::size_t>(dimension_v<M>);

  const M* m_;
  const char* who_;
  corner_gradients<M> poly_;
  std::vector<vec3> image_;  // of each corner's gradient, by the quadratic form

  virtual_element(const M& m, const char* who) : m_(&m), who_(who) {}

  /// Errors: invalid_mesh if p has no area or volume, or points that are not finite.
  void visit(const poly_t<M>& p) {
    poly_.visit(*m_, p);
    if (!poly_.has_gradients()) throw_no_measure(who_, *m_, p);
  }

  bool is_simplex() const { return poly_.verts.size() == dimension + 1; }

  /// entry(i, j) = g_i . form g_j + factor (delta_ij - 1/n - y_i . g_j - y_j . g_i), where `form` already has factor times the sum of y y^T:
  /// what the squares of u - P u come to.
  void fill(local_matrix<vert_t<M>>& out, const symmetric3& form, double factor, double constant) {
    const std::size_t n = poly_.verts.size();
    out.verts.assign(poly_.verts.begin(), poly_.verts.end());
    out.entries.resize(n * (n + 1) / 2);
    image_.resize(n);
    for (std::size_t i = 0; i < n; ++i) image_[i] = form * poly_.gradient[i];
    constant -= factor / static_cast<double>(n);
    for (std::size_t i = 0; i < n; ++i) {
      double* const row = &out.at(i, 0);
      for (std::size_t j = 0; j <= i; ++j)
        row[j] = dot(image_[i], poly_.gradient[j]) - factor * (dot(poly_.place[i], poly_.gradient[j]) + dot(poly_.place[j], poly_.gradient[i])) + constant;
      row[i] += factor;
    }
  }
};

/// The stiffness: u . K u is the integral of the squared gradient of P u, plus the squares of u - P u times a factor that makes rectangles and
/// boxes the bilinear and trilinear elements as far as one factor can. It is of the order of the stiffness itself however the poly is
/// stretched, which a power of its diameter would not be. The sum of squares of the g_i grows with the raggedness of a poly too, which would
/// make it too stiff. Of all g_i that are exact on linear functions those with least squares are Y^-1 y_i, with Y the sum of y y^T, and come to
/// the trace of Y^-1: the same on boxes, and what counts for polyhedra.
/// Source: Beirao da Veiga et al. 2013, "Basic principles of virtual element methods"; 2014, "The hitchhiker's guide to the virtual element method".
template<AnyMesh M>
  requires Embedded<M>
class virtual_stiffness : virtual_element<M> {
  using base = virtual_element<M>;

 public:
  explicit virtual_stiffness(const M& m) : base(m, "virtual elements") {}

  void operator()(const poly_t<M>& p, local_matrix<vert_t<M>>& out) {
    this->visit(p);
    const corner_gradients<M>& poly = this->poly_;
    const double size = std::abs(poly.measure);
    double factor = 0;
    symmetric3 form{size, 0, 0, size, 0, size};
    if (!this->is_simplex()) {
      const auto n = static_cast<double>(poly.verts.size());
      double squares = 0;
      for (const vec3& g : poly.gradient) squares += dot(g, g);
      symmetric3 spread;
      for (const vec3& y : poly.place) spread.add(1, y);
      if (squares * spread.trace() > thin && fill_thin(out, size)) [[unlikely]] return;
      if constexpr (base::dimension == 3) {  // of polygons the spread across them is 0
        const double least = spread.trace_of_inverse();
        if (least > 0 && least < squares) squares = least;  // rounding has the last word on polys next to flat
      }
      factor = size * squares * stiffening(n);
      form.add(factor, spread);
    }
    this->fill(out, form, factor, 0);
  }

 private:
  thin_places thin_;
  std::vector<vec3> gradient_, unseen_;  // of fill_thin

  /// The square of some hundred times as long as thick.
  static constexpr double thin = 0x1p16;

  static double stiffening(double n) { return base::dimension == 2 ? n / 12 : std::sqrt(n / 162); }

  /// The same of thin polys, where y . g is a difference of numbers far larger than itself. With y = Q R and h_i = R (g_i - R^-1 q_i) without what
  /// constants and linear functions have of it, which are rounding errors, the sum of squares of u - P u is that of u - Q Q^T u - mean and of the
  /// sum of u_i h_i. A sum of squares term by term, it is not negative.
  bool fill_thin(local_matrix<vert_t<M>>& out, double size) {
    constexpr std::size_t d = base::dimension;
    const corner_gradients<M>& poly = this->poly_;
    const std::size_t n = poly.verts.size();
    thin_.find(poly.place, d == 2 ? poly.normal / norm(poly.normal) : vec3{}, d);
    if (!thin_.is_regular) return false;
    gradient_.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < 3; ++k) gradient_[i][k] = k < d ? dot(thin_.axis[k], poly.gradient[i]) : 0.0;
    for (int round = 0; round < 2; ++round) {
      vec3 mean, seen[3];
      for (std::size_t i = 0; i < n; ++i) {
        mean += gradient_[i] / static_cast<double>(n);
        for (std::size_t k = 0; k < d; ++k) seen[k] += thin_.q[i][k] * gradient_[i];
      }
      for (std::size_t i = 0; i < n; ++i) {
        gradient_[i] -= mean;
        for (std::size_t k = 0; k < d; ++k) gradient_[i] -= thin_.q[i][k] * seen[k];
      }
    }
    unseen_.assign(n, vec3{});
    double squares = 0, least = 0;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < d; ++k)
        for (std::size_t l = k; l < d; ++l) unseen_[i][k] += thin_.r[k][l] * gradient_[i][l];
      const vec3 linear = thin_.solve(thin_.q[i], d);
      gradient_[i] += linear;
      squares += dot(gradient_[i], gradient_[i]);
      least += dot(linear, linear);
    }
    const double factor = size * (d == 2 ? squares : least) * stiffening(static_cast<double>(n)), constant = factor / static_cast<double>(n);
    out.verts.assign(poly.verts.begin(), poly.verts.end());
    out.entries.resize(n * (n + 1) / 2);
    for (std::size_t i = 0; i < n; ++i) {
      double* const row = &out.at(i, 0);
      for (std::size_t j = 0; j <= i; ++j)
        row[j] = size * dot(gradient_[i], gradient_[j]) + factor * (dot(unseen_[i], unseen_[j]) - dot(thin_.q[i], thin_.q[j])) - constant;
      row[i] += factor;
    }
    return true;
  }
};

/// The mass: u . M u is the integral of the square of P u, exact over the poly as it is measured, plus the squares of u - P u times the factor by
/// which rectangles are bilinear elements. Simplices have the mass of linear elements.
/// Source: Ahmad et al. 2013, "Equivalent projectors for virtual element methods".
template<AnyMesh M>
  requires Embedded<M>
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
    if constexpr (SurfaceMesh<M>) add_polygon(poly);  // an area or a volume is integrated
    else add_polyhedron(p);
    const double factor = this->is_simplex() ? 0 : size / (9 * n);
    if (factor > 0)
      for (const vec3& y : poly.place) moments_.add(factor, y);
    this->fill(out, moments_, factor, size / (n * n));
    for (std::size_t i = 0; i < poly.verts.size(); ++i) {  // the mean of the verts is not the centre of mass
      const double ci = dot(poly.gradient[i], first_) / n;
      for (std::size_t j = 0; j <= i; ++j) out.at(i, j) += ci + dot(poly.gradient[j], first_) / n;
    }
  }

 private:
  symmetric3 moments_;  // the integral of y y^T, y seen from the mean of the verts
  vec3 first_;          // the integral of y

  void add_polygon(const corner_gradients<M>& poly) {
    const vec3 direction = poly.normal / norm(poly.normal);
    for (std::size_t i = 0, n = poly.place.size(); i < n; ++i) {
      const vec3 &a = poly.place[i], &b = poly.place[i + 1 < n ? i + 1 : 0];
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
