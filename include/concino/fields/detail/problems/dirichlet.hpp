// Prescribed values at some verts (Dirichlet conditions): the numbering of the unknowns and the reduced system that is
// left for them.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/assembly.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/function_ref.hpp>
#include <concino/core/progress.hpp>
#include <concino/core/residual.hpp>
#include <concino/core/vec3.hpp>
#include <concino/fields/detail/problems/coupling_edges.hpp>
#include <concino/fields/detail/problems/field_values.hpp>
#include <concino/mesh/element_map.hpp>

#include <Eigen/SparseCore>

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::detail {

/// One right-hand side for each component of T.
template<field_value T>
using right_hand_sides = std::array<Eigen::VectorXd, component_count<T>>;

template<field_value T>
right_hand_sides<T> zeros(std::size_t size) {
  right_hand_sides<T> b;
  for (Eigen::VectorXd& component : b) component.setZero(static_cast<Eigen::Index>(size));
  return b;
}

[[noreturn, gnu::cold]] void throw_no_vert(const char* caller, const char* what);
[[noreturn, gnu::cold]] void throw_not_finite(const char* caller, std::size_t vert);
[[noreturn, gnu::cold]] void throw_two_values(const char* caller, std::size_t vert, double x, double y);
[[noreturn, gnu::cold]] void throw_not_constrained(const char* caller, std::size_t vert);
[[noreturn, gnu::cold]] void throw_no_value(const char* caller, std::size_t vert);
[[noreturn, gnu::cold]] void throw_unconstrained_component(const char* caller, std::size_t vert, std::size_t component);

enum : int { constrained_vert = -1, isolated_vert = -2 };

/// The unknown verts, numbered. The other verts are constrained to prescribed values, or isolated: they have no edges
/// that couple them with others.
template<class M>
struct constrained_verts {
  static constexpr int constrained = constrained_vert, isolated = isolated_vert;
  vert_map<M, int> unknown;       // number, constrained or isolated
  std::vector<vert_t<M>> prescribed;   // the constrained verts, each once
  std::vector<int> index;         // index_of of each unknown
  int unknowns = 0;
  std::size_t num_isolated = 0;

  explicit constrained_verts(const M& m) : unknown(make_vert_map<int>(m, isolated)) {}

  /// Constrains verts, or the first elements of pairs.      Errors: invalid_mesh if one is no vert of m.
  template<class R>
  void constrain(const M& m, const R& verts_or_pairs, const char* caller) {
    for (const auto& x : verts_or_pairs) {
      if constexpr (std::convertible_to<decltype(x), vert_t<M>>) {
        constrain_vert(m, x, caller, "a value is to be prescribed at");
      } else {
        const auto& [vert, value] = x;
        static_cast<void>(value);
        constrain_vert(m, vert, caller, "a value is given at");
      }
    }
  }

  /// Numbers the verts with edges.      Errors: solver_error if one cannot be reached from a constrained vert along
  /// edges.
  template<class D>
  void number_reached(const M& m, const coupling_edges<M, D>& edges, const char* caller) {
    const vert_map<M, int> hops = prescribed.empty() ? make_vert_map<int>(m, -1) : edges.bfs(prescribed);
    for (const vert_t<M> v : verts(m)) {
      if (unknown[v] == constrained) continue;
      if (hops[v] >= 0) {
        number(m, v);
      } else if (edges.has_any(v)) {
        std::size_t component = 0;
        const vert_map<M, int> from_v = edges.bfs({v});
        for (const vert_t<M> w : verts(m)) component += from_v[w] >= 0;
        throw_unconstrained_component(caller, index_of(m, v), component);
      } else {
        ++num_isolated;
      }
    }
  }

  /// Numbers the verts with edges, for systems that need no constrained vert.
  template<class D>
  void number_all(const M& m, const coupling_edges<M, D>& edges) {
    for (const vert_t<M> v : verts(m)) {
      if (unknown[v] == constrained) continue;
      if (edges.has_any(v)) number(m, v);
      else ++num_isolated;
    }
  }

 private:
  void number(const M& m, const vert_t<M>& v) {
    unknown[v] = unknowns++;
    index.push_back(static_cast<int>(index_of(m, v)));
  }

  void constrain_vert(const M& m, const vert_t<M>& v, const char* caller, const char* what) {
    if (!contains(m, v)) throw_no_vert(caller, what);
    if (unknown[v] == constrained) return;
    unknown[v] = constrained;
    prescribed.push_back(v);
  }
};

/// A map with the prescribed values at the constrained verts and isolated_value at all others.
/// Errors: invalid_mesh if a value is given at an element that is no vert of m; invalid_argument if a value is not
///         finite, a vert gets two, or the verts are not the constrained ones.
template<class T, class M, class D>
vert_map<M, T> prescribed_values(const M& m, const constrained_verts<M>& verts, const D& pairs, double isolated_value,
                                 const char* caller) {
  auto value = make_vert_map<T>(m, same_in_all_components<T>(isolated_value));
  // no value yet
  for (const vert_t<M>& v : verts.prescribed) field_component(value[v], 0) = std::numeric_limits<double>::quiet_NaN();
  std::size_t known = 0;
  for (const auto& [vert, number] : pairs) {
    const vert_t<M> v = vert;
    const T x = as_field_value<T>(number);
    if (!contains(m, v)) throw_no_vert(caller, "a value is given at");
    if (verts.unknown[v] != constrained_verts<M>::constrained) throw_not_constrained(caller, index_of(m, v));
    const bool again = !std::isnan(field_component(value[v], 0));
    for (std::size_t k = 0; k < component_count<T>; ++k) {
      if (!std::isfinite(field_component(x, k))) throw_not_finite(caller, index_of(m, v));
      if (again && field_component(value[v], k) != field_component(x, k))
        throw_two_values(caller, index_of(m, v), field_component(value[v], k), field_component(x, k));
    }
    known += !again;
    value[v] = x;
  }
  if (known != verts.prescribed.size())
    for (const vert_t<M>& v : verts.prescribed)
      if (std::isnan(field_component(value[v], 0))) throw_no_value(caller, index_of(m, v));
  return value;
}

/// The contribution of a constrained vert to the right-hand side of an adjacent unknown.
struct coupling {
  int row, vert;  // number of an unknown, index of a constrained vert
  double weight;  // minus the entry of the matrix
};

/// Extracts the rows and columns of the unknowns from a matrix over all verts that stores both triangles.
/// unknown: for each vert index its number, constrained_vert or isolated_vert; index: the inverse of this numbering.
void restrict_to_unknowns(const Eigen::SparseMatrix<double>& whole, const int* unknown, const std::vector<int>& index,
                          Eigen::SparseMatrix<double>& lower, std::vector<coupling>& couplings);

/// Solves for one right-hand side per component. value(k, index): component k of the value at a vert, prescribed or
/// unknown. load: see constrained_system::solve.
/// Errors: solver_error with the reason.
void solve_components(core::solver_ref solver, const Eigen::SparseMatrix<double>& lower, const std::vector<int>& index,
                      const std::vector<coupling>& couplings, std::size_t num_right_hand_sides,
                      function_ref<double(std::size_t k, int index)> load,
                      function_ref<double&(std::size_t k, int index)> value, const char* caller);

/// A x = b for the unknowns of a symmetric system over all verts. The contributions of constrained verts are on the
/// right-hand side.
template<class M>
struct constrained_system {
  constrained_verts<M> verts;
  Eigen::SparseMatrix<double> lower;  // triangle
  std::vector<coupling> couplings;

  explicit constrained_system(constrained_verts<M>&& constrained) : verts(std::move(constrained)) {}
  constrained_system(constrained_system&& other) noexcept
      : verts(std::move(other.verts)), couplings(std::move(other.couplings)) {
    lower.swap(other.lower);  // the move operations of Eigen 3.4 would copy
  }

  template<class Solver>
  void factorize(Solver& solver, const progress& on_progress, const char* caller) const {
    if (verts.unknowns == 0) return;
    report_progress(on_progress, 0.1, "factorising");
    core::factorize_over_verts(solver, lower, caller,
                               [&](Eigen::Index row) { return verts.index[static_cast<std::size_t>(row)]; });
  }

  /// Writes the solution into `value`, which contains the values of the constrained verts. load(k, index): the
  /// right-hand side of the unknown vert of that index, for component k of T.
  /// Errors: solver_error with the reason.
  template<class T, class Load>
  void solve(core::solver_ref solver, const Load& load, vert_map<M, T>& value, const char* caller) const {
    if (verts.unknowns == 0) return;
    T* const at = value.data();
    solve_components(
        solver, lower, verts.index, couplings, component_count<T>, load,
        [at](std::size_t k, int index) -> double& { return field_component(at[index], k); }, caller);
  }

  void restrict_to_unknowns(const Eigen::SparseMatrix<double>& whole) {
    detail::restrict_to_unknowns(whole, verts.unknown.data(), verts.index, lower, couplings);
  }
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/problems/dirichlet.ipp>
#endif
