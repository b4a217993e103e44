// Systems with prescribed values; see dirichlet.hpp.
#pragma once

#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>
#include <concino/fields/detail/problems/dirichlet.hpp>

#include <cstddef>
#include <vector>

namespace concino::detail {

[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_no_vert(const char* caller, const char* what) {
  core::throw_joined<invalid_mesh>(
      {caller, ": ", what, " something that is not a vert of the mesh; take verts from verts(m)"});
}
[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_not_finite(const char* caller, std::size_t vert) {
  core::throw_joined<invalid_argument>({caller, ": the value given at vert ", vert, " is not finite"});
}
[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_two_values(const char* caller, std::size_t vert,
                                                                            double x, double y) {
  core::throw_joined<invalid_argument>({caller, ": two values are given at vert ", vert, ", ", core::number_text(x),
                                        " and ", core::number_text(y), "; keep one"});
}
[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_not_constrained(const char* caller, std::size_t vert) {
  core::throw_joined<invalid_argument>({caller, ": a value is given at vert ", vert,
                                        ", which is not among those that were named when the solver was prepared"});
}
[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_no_value(const char* caller, std::size_t vert) {
  core::throw_joined<invalid_argument>({caller, ": no value is given at vert ", vert,
                                  ", which was named when the solver was prepared; give one at each of those verts"});
}
[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_unconstrained_component(const char* caller,
                                                                                         std::size_t vert,
                                                                                         std::size_t component) {
  core::throw_joined<solver_error>({caller, ": the system is singular, because the component of vert ", vert, " (",
                                    component, " verts) has no prescribed value; give one at any of its verts"});
}

CONCINO_INLINE void restrict_to_unknowns(const Eigen::SparseMatrix<double>& whole, const int* unknown,
                                         const std::vector<int>& index, Eigen::SparseMatrix<double>& lower,
                                         std::vector<coupling>& couplings) {
  const int n = static_cast<int>(index.size());
  lower.resize(n, n);
  lower.resizeNonZeros(whole.nonZeros());
  int* const rows = lower.innerIndexPtr();
  double* const entries = lower.valuePtr();
  int at = 0;
  for (int c = 0; c < n; ++c) {
    const int first = at, from = index[static_cast<std::size_t>(c)];
    for (int l = whole.outerIndexPtr()[from]; l < whole.outerIndexPtr()[from + 1]; ++l) {
      const int i = whole.innerIndexPtr()[l], row = unknown[i];
      const double x = whole.valuePtr()[l];
      if (row == constrained_vert) couplings.push_back({c, i, -x});
      if (row < c) continue;
      rows[at] = row;
      entries[at++] = x;
    }
    core::sort_column(rows + first, entries + first, static_cast<std::size_t>(at - first));
    lower.outerIndexPtr()[c + 1] = at;
  }
  lower.resizeNonZeros(at);
}

CONCINO_INLINE void solve_components(core::solver_ref solver, const Eigen::SparseMatrix<double>& lower,
                                     const std::vector<int>& index, const std::vector<coupling>& couplings,
                                     std::size_t num_right_hand_sides,
                                     function_ref<double(std::size_t k, int index)> load,
                                     function_ref<double&(std::size_t k, int index)> value, const char* caller) {
  const std::size_t n = index.size();
  Eigen::VectorXd b(static_cast<Eigen::Index>(n));
  for (std::size_t k = 0; k < num_right_hand_sides; ++k) {
    for (std::size_t i = 0; i < n; ++i) b[static_cast<Eigen::Index>(i)] = load(k, index[i]);
    for (std::size_t i = 0; i < couplings.size(); ++i)
      b[couplings[i].row] += couplings[i].weight * value(k, couplings[i].vert);
    const Eigen::VectorXd u = core::solve_and_check(solver, lower, b, caller);
    for (std::size_t i = 0; i < n; ++i) value(k, index[i]) = u[static_cast<Eigen::Index>(i)];
  }
}

}  // namespace concino::detail
