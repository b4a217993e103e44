// Projections of 1-forms on the edges of a surface to differences of functions and to harmonic forms.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/core/error.hpp>
#include <concino/fields/detail/problems/closed_cochains.hpp>
#include <concino/fields/detail/problems/hodge_problem.hpp>
#include <concino/fields/detail/problems/laplace_system.hpp>
#include <concino/geometry/polygon.hpp>
#include <concino/operators/corner_gradients.hpp>
#include <concino/operators/de_goes.hpp>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace concino::detail {

[[noreturn]] void throw_edge_value_not_finite(const char* caller, std::size_t edge);

/// The values of a form at the edges of one polygon, along the polygon, and the vector nearest to them.
template<class M>
class form_on_polygon {
  std::vector<vec3> points_;

 public:
  std::vector<std::size_t> edges;  // indices
  std::vector<double> signs;       // 1 where the polygon is passed along an edge
  std::vector<vec3> steps;         // the edges as vectors, projected to the plane of the polygon
  std::vector<vec3> to_vector;     // the vector of a form is the sum of these times its values
  double area = 0;

  /// Errors: invalid_mesh that names a polygon without area or with points that are not finite.
  template<class Real>
  void visit(const M& m, const Real& real, const poly_t<Real>& p, const char* caller) {
    points_.clear(), edges.clear(), signs.clear(), steps.clear(), to_vector.clear();
    for (const vert_t<M> v : adj_p2v(m, p)) points_.push_back(to_vec3(point(m, v)));
    const auto& corners = adj_p2v(m, p);  // a range may own its elements
    auto it = corners.begin();
    for (const edge_t<M> e : adj_p2e(m, p)) {  // edge k joins verts k and k + 1
      const vert_t<M> v = *it;
      edges.push_back(index_of(m, e));
      signs.push_back(end_verts(m, e).first == v ? 1.0 : -1.0);
      ++it;
    }
    const polygon_shape shape = shape_of(m, adj_p2v(m, p));
    area = norm(shape.area);
    if (!(area > 0 && std::isfinite(area))) throw_no_measure(caller, real, p);
    const vec3 normal = shape.area / area;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const vec3 a = points_[k] - shape.mean, b = points_[(k + 1) % points_.size()] - shape.mean, step = b - a;
      steps.push_back(step - dot(step, normal) * normal);
      to_vector.push_back(cross(0.5 * (a + b), normal) / -area);
    }
  }

  vec3 vector_of(const std::vector<double>& form) const {
    vec3 sum;
    for (std::size_t k = 0; k < edges.size(); ++k) sum += signs[k] * form[edges[k]] * to_vector[k];
    return sum;
  }
};

/// Forms are arrays by edge index. The product of two forms is the sum over polygons of area times the scalar product
/// of their vectors, and of the products of what these vectors leave over at edges. It does not depend on the size of
/// the mesh.
template<class M>
class form_problem {
  static constexpr const char* caller = "hodge_decomposition";
  using form = std::vector<double>;

  const M& m_;
  const views::scaled<M> at_;
  constrained_system<M> system_;

 public:
  explicit form_problem(const M& m)
      : m_(m), at_(scaled_to_unit(m)),
        system_(laplace_system(at_, all_but_one_vert(m, de_goes, caller), de_goes, 1, caller)) {}

  template<class Solver>
  void factorize(Solver& solver, const progress& on_progress) const { system_.factorize(solver, on_progress, caller); }

  /// Errors: invalid_argument that names an edge whose value is not finite.
  template<class A>
  form read(const A& input) const {
    form a(edge_index_bound(m_));
    for (const edge_t<M> e : edges(m_)) {
      a[index_of(m_, e)] = static_cast<double>(input[e]);
      if (!std::isfinite(a[index_of(m_, e)])) throw_edge_value_not_finite(caller, index_of(m_, e));
    }
    return a;
  }

  /// The products of a form with the forms that are 1 at one edge.
  form apply(const form& a) const {
    form result(a.size());
    form_on_polygon<views::scaled<M>> local;
    for (const poly_t<M> p : polys(m_)) {
      local.visit(at_, m_, p, caller);
      const vec3 mean = local.vector_of(a);
      vec3 back = local.area * mean;
      for (std::size_t k = 0; k < local.edges.size(); ++k) {
        const double rest = local.signs[k] * a[local.edges[k]] - dot(local.steps[k], mean);
        result[local.edges[k]] += local.signs[k] * rest;
        back -= rest * local.steps[k];
      }
      for (std::size_t k = 0; k < local.edges.size(); ++k)
        result[local.edges[k]] += local.signs[k] * dot(local.to_vector[k], back);
    }
    return result;
  }
  static double dot_product(const form& a, const form& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  }
  static void add(form& sum, double factor, const form& a) {
    for (std::size_t i = 0; i < a.size(); ++i) sum[i] += factor * a[i];
  }

  /// The differences of a function at verts nearest to a, along edges. potential: unless null, the function.
  template<class Solver>
  form project_to_differences(const Solver& solver, const form& a, vert_map<M, double>* potential) const {
    const form products = apply(a);
    std::vector<double> load(vert_index_bound(m_));
    for (const edge_t<M> e : edges(m_)) {
      const auto ends = end_verts(m_, e);
      load[index_of(m_, ends.first)] -= products[index_of(m_, e)];
      load[index_of(m_, ends.second)] += products[index_of(m_, e)];
    }
    auto u = make_vert_map<double>(m_);
    system_.template solve<double>(
        solver, [&](std::size_t, int i) { return load[static_cast<std::size_t>(i)]; }, u, caller);
    form result(a.size());
    for (const edge_t<M> e : edges(m_)) {
      const auto ends = end_verts(m_, e);
      result[index_of(m_, e)] = u[ends.second] - u[ends.first];
    }
    if (potential) *potential = std::move(u);
    return result;
  }

  /// An orthonormal basis of the closed forms that are orthogonal to all differences.
  template<class Solver>
  std::vector<form> harmonic_forms(const Solver& solver) const {
    std::vector<form> basis, products;
    for (form h : closed_cochains(make_edge_complex(m_))) {
      const double before = std::sqrt(dot_product(h, apply(h)));
      add(h, -1, project_to_differences(solver, h, nullptr));
      for (int twice = 0; twice < 2; ++twice)  // once loses digits where the forms are nearly dependent
        for (std::size_t k = 0; k < basis.size(); ++k) add(h, -dot_product(h, products[k]), basis[k]);
      const double size = std::sqrt(dot_product(h, apply(h)));
      if (!(size > 1e-9 * before)) continue;  // rounding errors
      for (double& value : h) value /= size;
      products.push_back(apply(h));
      basis.push_back(std::move(h));
    }
    return basis;
  }
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/problems/form_problem.ipp>
#endif
