// Projections of fields to gradients and to harmonic fields, on triangles and tets.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/core/error.hpp>
#include <concino/core/poly_chunks.hpp>
#include <concino/fields/detail/problems/closed_cochains.hpp>
#include <concino/fields/detail/problems/laplace_system.hpp>
#include <concino/geometry/normals.hpp>
#include <concino/graph/disjoint_sets.hpp>
#include <concino/operators/cotangent.hpp>
#include <concino/operators/divergence.hpp>
#include <concino/operators/gradient.hpp>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace concino::detail {

[[noreturn]] void throw_no_simplex(const char* caller, bool in_volume, std::size_t poly, std::size_t verts);
[[noreturn]] void throw_vector_not_finite(const char* caller, std::size_t poly);

/// All verts with edges but the first of each component, at which potentials are 0. Edges of no poly do not count.
template<class M, class D>
constrained_verts<M> all_but_one_vert(const M& m, const D& discretisation, const char* caller) {
  disjoint_sets sets(vert_index_bound(m));
  for (const poly_t<M> p : polys(m)) {
    const auto& corners = adj_p2v(m, p);
    for (const vert_t<M> v : corners) sets.unite(index_of(m, v), index_of(m, *corners.begin()));
  }
  constrained_verts<M> constrained(m);
  std::vector<vert_t<M>> first;
  for (const vert_t<M> v : verts(m))
    if (sets.root(index_of(m, v)) == index_of(m, v)) first.push_back(v);
  constrained.constrain(m, first, caller);
  constrained.number_reached(m, coupling_edges<M, D>(m, discretisation), caller);
  return constrained;
}

/// Fields are arrays by poly index. All computations are at a size near 1, which changes no projection.
template<class M>
class hodge_problem {
  static constexpr const char* caller = "hodge_decomposition";
  using field = std::vector<vec3>;

  const M& m_;
  const views::scaled<M> at_;
  std::vector<double> measure_;
  constrained_system<M> system_;

  static const M& require_simplices(const M& m) {
    for (const poly_t<M> p : polys(m)) {
      std::size_t n = 0;
      for ([[maybe_unused]] const vert_t<M> v : adj_p2v(m, p)) ++n;
      if (n != dimension_v<M> + 1) throw_no_simplex(caller, dimension_v<M> == 3, index_of(m, p), n);
    }
    return m;
  }

  poly_map<views::scaled<M>, vec3> as_map(const field& x) const {
    auto map = make_poly_map<vec3>(at_);
    for (const poly_t<M> p : polys(m_)) map[p] = x[index_of(m_, p)];
    return map;
  }

  /// The field whose scalar products with edges are the values of a closed cochain.
  field field_of(const std::vector<double>& cochain) const {
    field x = zero();
    core::poly_chunks<M>(m_).template for_each<poly_gradients<views::scaled<M>>>(
        [&](auto& local, const poly_t<M>& p, std::size_t) {
          local.visit(at_, p);
          const vert_t<M> origin = local.verts[0];
          for (const edge_t<M> e : adj_p2e(m_, p)) {
            const auto ends = end_verts(m_, e);
            if (!(ends.first == origin || ends.second == origin)) continue;
            const vert_t<M> other = ends.first == origin ? ends.second : ends.first;
            const double value = (ends.first == origin ? 1 : -1) * cochain[index_of(m_, e)];
            for (std::size_t k = 1; k < local.verts.size(); ++k)
              if (local.verts[k] == other) x[index_of(m_, p)] += value * local.gradient[k];
          }
          return 0;
        });
    return x;
  }

 public:
  explicit hodge_problem(const M& m)
      : m_(require_simplices(m)), at_(scaled_to_unit(m)), measure_(poly_index_bound(m)),
        system_(laplace_system(at_, all_but_one_vert(m, cotangent, caller), cotangent, 1, caller)) {
    for (const poly_t<M> p : polys(m)) measure_[index_of(m, p)] = std::abs(measure(at_, p));
  }

  template<class Solver>
  void factorize(Solver& solver, const progress& on_progress) const { system_.factorize(solver, on_progress, caller); }

  field zero() const { return field(measure_.size()); }
  double product(const field& a, const field& b) const {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += measure_[i] * dot(a[i], b[i]);
    return sum;
  }
  static void add(field& sum, double factor, const field& x) {
    for (std::size_t i = 0; i < x.size(); ++i) sum[i] += factor * x[i];
  }

  /// On surfaces, without the parts along the normals of triangles.
  template<class Field>
  field tangential(const Field& input) const {
    field x = zero();
    for (const poly_t<M> p : polys(m_)) {
      vec3& value = x[index_of(m_, p)];
      value = to_vec3(input[p]);
      if (!is_finite(value)) throw_vector_not_finite(caller, index_of(m_, p));
      if constexpr (dimension_v<M> == 2) value -= dot(normal(at_, p), value) * normal(at_, p);  // a tet has no normal
    }
    return x;
  }

  /// The gradient nearest to x. potential: unless null, its function.
  template<class Solver>
  field project_to_gradients(const Solver& solver, const field& x, vert_map<M, double>* potential) const {
    const auto outflow = divergence(at_, as_map(x));
    auto u = make_vert_map<double>(m_);
    system_.template solve<double>(solver, [&](std::size_t, int i) { return -outflow.data()[i]; }, u, caller);
    const auto g = gradient(at_, u);
    field result = zero();
    for (const poly_t<M> p : polys(m_)) result[index_of(m_, p)] = g[p];
    if (potential)
      for (const vert_t<M> v : verts(m_)) (*potential)[v] = std::ldexp(u[v], at_.exponent());
    return result;
  }

  /// An orthonormal basis of the fields that are locally gradients and orthogonal to all gradients.
  template<class Solver>
  std::vector<field> harmonic_fields(const Solver& solver) const {
    std::vector<field> basis;
    for (const std::vector<double>& cochain : closed_cochains(make_edge_complex(m_))) {
      field h = field_of(cochain);
      const double before = std::sqrt(product(h, h));
      add(h, -1, project_to_gradients(solver, h, nullptr));
      for (int twice = 0; twice < 2; ++twice)  // once loses digits where the fields are nearly dependent
        for (const field& b : basis) add(h, -product(h, b), b);
      const double size = std::sqrt(product(h, h));
      if (!(size > 1e-9 * before)) continue;  // rounding errors: the loop is closed by faces or edges without polys
                                              // only
      for (vec3& value : h) value /= size;
      basis.push_back(std::move(h));
    }
    return basis;
  }
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/problems/hodge_problem.ipp>
#endif
