// Values prescribed at some verts: who is unknown then, and the system that is left for them. What all problems with such conditions share.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/detail/message.hpp>
#include <concino/detail/number_text.hpp>
#include <concino/geometry/vec3.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/operators/detail/assembly.hpp>
#include <concino/progress.hpp>
#include <concino/solve/detail/residual.hpp>

#include <Eigen/SparseCore>

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::detail {

/// What a field may have at a vert: a number, or a vector, which is solved for part by part with one factorisation.
template<class T>
concept field_value = std::same_as<T, double> || std::same_as<T, vec3>;

template<field_value T>
inline constexpr std::size_t parts_of = std::same_as<T, double> ? 1 : 3;
inline double& part(double& x, std::size_t) { return x; }
inline double part(const double& x, std::size_t) { return x; }
inline double& part(vec3& x, std::size_t k) { return x[k]; }
inline double part(const vec3& x, std::size_t k) { return x[k]; }

template<field_value T, class X>
T as_field_value(const X& x) {
  if constexpr (std::same_as<T, double>) return static_cast<double>(x);
  else return to_vec3(x);
}
template<field_value T>
T same_in_all_parts(double x) {
  if constexpr (std::same_as<T, double>) return x;
  else return {x, x, x};
}

/// One right-hand side for each part.
template<field_value T>
using right_hand_sides = std::array<Eigen::VectorXd, parts_of<T>>;

/// The verts whose values are to be found, numbered; the others are prescribed or stand alone.
template<class M, class T = double>
struct dirichlet_problem {
  enum : int { prescribed = -1, isolated = -2, reached = -3 };
  vert_map<M, T> value;
  vert_map<M, int> unknown;  // number, prescribed or isolated; before they are numbered, reached
  int unknowns = 0;

  /// Adds to `front` all verts that can be reached from it, and marks them.
  void reach(const M& m, std::vector<vert_t<M>>& front) {
    for (std::size_t i = 0; i < front.size(); ++i) {
      const vert_t<M> v = front[i];
      for (const vert_t<M> w : adj_v2v(m, v)) {
        if (unknown[w] != isolated) continue;
        unknown[w] = reached;
        front.push_back(w);
      }
    }
  }

  right_hand_sides<T> no_load() const {
    right_hand_sides<T> b;
    for (Eigen::VectorXd& part_of_b : b) part_of_b.setZero(unknowns);
    return b;
  }
  /// Adds x times the value of a prescribed vert to the right-hand side in this row.
  void add_prescribed(right_hand_sides<T>& b, int row, const T& given, double x) const {
    for (std::size_t k = 0; k < b.size(); ++k) b[k][row] += x * part(given, k);
  }
};

[[noreturn, gnu::noinline, gnu::cold]] inline void throw_not_finite(const char* who, std::size_t vert) {
  throw_joined<invalid_argument>({who, ": the value given at vert ", vert, " is not finite"});
}
[[noreturn, gnu::noinline, gnu::cold]] inline void throw_two_values(const char* who, std::size_t vert, double x, double y) {
  throw_joined<invalid_argument>({who, ": two values are given at vert ", vert, ", ", number_text(x), " and ", number_text(y), "; keep one"});
}
[[noreturn, gnu::noinline, gnu::cold]] inline void throw_nothing_given(const char* who, std::size_t vert, std::size_t component) {
  throw_joined<solver_error>({who, ": singular, because the component of vert ", vert, " (", component,
                              " verts) has no value prescribed; give one at any of its verts"});
}

/// Errors: invalid_mesh if a value is given at what is no vert of m; invalid_argument if a value is not finite or a vert gets two;
///         solver_error if a component that has edges has no value prescribed.
template<class T, class M, class D>
dirichlet_problem<M, T> dirichlet(const M& m, const D& given, double isolated_value, const char* who) {
  using problem = dirichlet_problem<M, T>;
  problem r{make_vert_map<T>(m, same_in_all_parts<T>(isolated_value)), make_vert_map<int>(m, problem::isolated)};
  std::vector<vert_t<M>> front;
  for (const auto& [vert, number] : given) {
    const vert_t<M> v = vert;
    const T x = as_field_value<T>(number);
    if (!contains(m, v)) throw_joined<invalid_mesh>({who, ": a value is given at something that is no vert of the mesh; take verts from verts(m)"});
    const bool again = r.unknown[v] == problem::prescribed;
    for (std::size_t k = 0; k < parts_of<T>; ++k) {
      if (!std::isfinite(part(x, k))) throw_not_finite(who, index_of(m, v));
      if (again && part(r.value[v], k) != part(x, k)) throw_two_values(who, index_of(m, v), part(r.value[v], k), part(x, k));
    }
    if (!again) front.push_back(v);
    r.unknown[v] = problem::prescribed;
    r.value[v] = x;
  }
  r.reach(m, front);
  for (const vert_t<M> v : verts(m)) {
    if (r.unknown[v] == problem::prescribed) continue;
    if (r.unknown[v] == problem::isolated) {
      const auto& around = adj_v2v(m, v);
      if (!(around.begin() != around.end())) continue;
      front.clear();
      front.push_back(v);
      r.unknown[v] = problem::reached;
      r.reach(m, front);
      throw_nothing_given(who, index_of(m, v), front.size());
    }
    r.unknown[v] = r.unknowns++;
  }
  return r;
}

/// The rows and columns of the unknowns, lower triangle; what the prescribed values contribute goes to b.
template<class T, class M>
Eigen::SparseMatrix<double> restrict_to_unknowns(const Eigen::SparseMatrix<double>& k, const M& m, const dirichlet_problem<M, T>& problem, right_hand_sides<T>& b) {
  Eigen::SparseMatrix<double> r(problem.unknowns, problem.unknowns);
  r.resizeNonZeros(k.nonZeros());
  std::vector<int> column(static_cast<std::size_t>(problem.unknowns));
  for (const vert_t<M> v : verts(m))
    if (const int c = problem.unknown[v]; c >= 0) column[static_cast<std::size_t>(c)] = static_cast<int>(index_of(m, v));
  const int* const unknown = problem.unknown.values().data();
  const T* const value = problem.value.values().data();
  int* const rows = r.innerIndexPtr();
  double* const entries = r.valuePtr();
  int at = 0;
  for (int c = 0; c < problem.unknowns; ++c) {
    const int first = at, from = column[static_cast<std::size_t>(c)];
    for (int l = k.outerIndexPtr()[from]; l < k.outerIndexPtr()[from + 1]; ++l) {
      const int i = k.innerIndexPtr()[l], row = unknown[i];
      const double x = k.valuePtr()[l];
      if (row < 0) problem.add_prescribed(b, c, value[i], -x);
      if (row < c) continue;
      rows[at] = row;
      entries[at++] = x;
    }
    sort_column(rows + first, entries + first, static_cast<std::size_t>(at - first));
    r.outerIndexPtr()[c + 1] = at;
  }
  r.resizeNonZeros(at);
  return r;
}

/// Factorises, solves for each part and puts the values in their places.
/// Errors: solver_error with the reason; cancelled.
template<class T, class M, class Solver>
void solve_unknowns(const M& m, dirichlet_problem<M, T>& problem, const Eigen::SparseMatrix<double>& a, const right_hand_sides<T>& b, Solver& solver,
                    const char* who, const progress& told) {
  if (problem.unknowns == 0) return;
  tell(told, 0.1, "factorising");
  factorize_symmetric(solver, a);
  tell(told, 0.9, "solving");
  for (std::size_t k = 0; k < b.size(); ++k) {
    const Eigen::VectorXd u = solve_and_check(solver, a, b[k], who);
    for (const vert_t<M> v : verts(m))
      if (const int i = problem.unknown[v]; i >= 0) part(problem.value[v], k) = u[i];
  }
}

}  // namespace concino::detail
