// Values prescribed at some verts: who is unknown then, and the system that is left for them. What all problems with such conditions share.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/assembly.hpp>
#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/progress.hpp>
#include <concino/core/residual.hpp>
#include <concino/core/vec3.hpp>
#include <concino/graph/bfs.hpp>
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
/// Of a readable map over elements X: numbers or else points.
template<class F, class X>
using field_value_at = std::conditional_t<std::convertible_to<decltype(std::declval<const F&>()[std::declval<const X&>()]), double>, double, vec3>;

/// A container or braces, which options are not.
template<class R> concept walkable = requires(const R& r) { r.begin(); r.end(); };

/// Elements X in a container or braces; or pairs of an X and a T, or anything else that comes apart in two.
template<class R, class X> concept holds_elements = walkable<R> && requires(const R& r) { requires std::convertible_to<decltype(*r.begin()), X>; };
template<class R> concept holds_pairs = walkable<R> && requires(const R& r) { (*r.begin()).first; (*r.begin()).second; };
template<class R, class X> concept holds_pairs_of = holds_pairs<R> && requires(const R& r) { requires std::convertible_to<decltype((*r.begin()).first), X>; };
template<class P> concept comes_apart = std::is_aggregate_v<P> || requires { std::tuple_size<P>::value; };
template<class R> concept holds_twos = walkable<R> && !holds_pairs<R> && requires(const R& r) { requires comes_apart<std::remove_cvref_t<decltype(*r.begin())>>; };
template<class R, class X> concept gives_values = !holds_elements<R, X> && (holds_pairs_of<R, X> || holds_twos<R>);
template<class R, class X> concept names_elements = holds_elements<R, X> || gives_values<R, X>;

/// One right-hand side for each part.
template<field_value T>
using right_hand_sides = std::array<Eigen::VectorXd, parts_of<T>>;

template<field_value T>
right_hand_sides<T> zeros(std::size_t size) {
  right_hand_sides<T> b;
  for (Eigen::VectorXd& part_of_b : b) part_of_b.setZero(static_cast<Eigen::Index>(size));
  return b;
}

[[noreturn, gnu::noinline, gnu::cold]] inline void throw_no_vert(const char* who, const char* what) {
  core::throw_joined<invalid_mesh>({who, ": ", what, " something that is no vert of the mesh; take verts from verts(m)"});
}
[[noreturn, gnu::noinline, gnu::cold]] inline void throw_not_finite(const char* who, std::size_t vert) {
  core::throw_joined<invalid_argument>({who, ": the value given at vert ", vert, " is not finite"});
}
[[noreturn, gnu::noinline, gnu::cold]] inline void throw_two_values(const char* who, std::size_t vert, double x, double y) {
  core::throw_joined<invalid_argument>({who, ": two values are given at vert ", vert, ", ", core::number_text(x), " and ", core::number_text(y), "; keep one"});
}
[[noreturn, gnu::noinline, gnu::cold]] inline void throw_not_held(const char* who, std::size_t vert) {
  core::throw_joined<invalid_argument>({who, ": a value is given at vert ", vert, ", which is none of those that were named when this was prepared"});
}
[[noreturn, gnu::noinline, gnu::cold]] inline void throw_no_value(const char* who, std::size_t vert) {
  core::throw_joined<invalid_argument>({who, ": no value is given at vert ", vert,
                                  ", which was named when this was prepared; give one at each of those verts"});
}
[[noreturn, gnu::noinline, gnu::cold]] inline void throw_nothing_given(const char* who, std::size_t vert, std::size_t component) {
  core::throw_joined<solver_error>({who, ": singular, because the component of vert ", vert, " (", component,
                              " verts) has no value prescribed; give one at any of its verts"});
}

/// The verts whose values are to be found, numbered; the others are held at given values, or are isolated: they have no edges.
template<class M>
struct held_verts {
  enum : int { held = -1, isolated = -2 };
  vert_map<M, int> unknown;       // number, held or isolated
  std::vector<vert_t<M>> given;   // the held ones, each once
  std::vector<int> index;         // by index_of, of each unknown
  int unknowns = 0;
  std::size_t num_isolated = 0;

  explicit held_verts(const M& m) : unknown(make_vert_map<int>(m, isolated)) {}

  /// Holds verts or what comes first in pairs.      Errors: invalid_mesh if one is no vert of m.
  template<class R>
  void hold(const M& m, const R& verts_or_pairs, const char* who) {
    for (const auto& x : verts_or_pairs) {
      if constexpr (std::convertible_to<decltype(x), vert_t<M>>) {
        hold_one(m, x, who, "what is to be prescribed is");
      } else {
        const auto& [vert, value] = x;
        static_cast<void>(value);
        hold_one(m, vert, who, "a value is given at");
      }
    }
  }

  /// Numbers the verts with edges.      Errors: solver_error if one cannot be reached from a held vert along edges.
  void number_reached(const M& m, const char* who) {
    const vert_map<M, int> hops = given.empty() ? make_vert_map<int>(m, -1) : concino::bfs(m, given);
    for (const vert_t<M> v : verts(m)) {
      if (unknown[v] == held) continue;
      if (hops[v] >= 0) {
        number(m, v);
      } else if (has_edges(m, v)) {
        std::size_t component = 0;
        const vert_map<M, int> from_v = concino::bfs(m, v);
        for (const vert_t<M> w : verts(m)) component += from_v[w] >= 0;
        throw_nothing_given(who, index_of(m, v), component);
      } else {
        ++num_isolated;
      }
    }
  }

  /// Numbers the verts with edges, for systems that need no value held.
  void number_all(const M& m) {
    for (const vert_t<M> v : verts(m)) {
      if (unknown[v] == held) continue;
      if (has_edges(m, v)) number(m, v);
      else ++num_isolated;
    }
  }

 private:
  void number(const M& m, const vert_t<M>& v) {
    unknown[v] = unknowns++;
    index.push_back(static_cast<int>(index_of(m, v)));
  }
  static bool has_edges(const M& m, const vert_t<M>& v) {
    const auto& around = adj_v2v(m, v);
    return around.begin() != around.end();
  }

  void hold_one(const M& m, const vert_t<M>& v, const char* who, const char* what) {
    if (!contains(m, v)) throw_no_vert(who, what);
    if (unknown[v] == held) return;
    unknown[v] = held;
    given.push_back(v);
  }
};

/// A map with the given values at the held verts and isolated_value at all others.
/// Errors: invalid_mesh if a value is given at what is no vert of m; invalid_argument if a value is not finite, a vert gets two, or the verts are
///         not those that are held.
template<class T, class M, class D>
vert_map<M, T> prescribed_values(const M& m, const held_verts<M>& verts, const D& pairs, double isolated_value, const char* who) {
  auto value = make_vert_map<T>(m, same_in_all_parts<T>(isolated_value));
  for (const vert_t<M>& v : verts.given) part(value[v], 0) = std::numeric_limits<double>::quiet_NaN();  // none yet
  std::size_t known = 0;
  for (const auto& [vert, number] : pairs) {
    const vert_t<M> v = vert;
    const T x = as_field_value<T>(number);
    if (!contains(m, v)) throw_no_vert(who, "a value is given at");
    if (verts.unknown[v] != held_verts<M>::held) throw_not_held(who, index_of(m, v));
    const bool again = !std::isnan(part(value[v], 0));
    for (std::size_t k = 0; k < parts_of<T>; ++k) {
      if (!std::isfinite(part(x, k))) throw_not_finite(who, index_of(m, v));
      if (again && part(value[v], k) != part(x, k)) throw_two_values(who, index_of(m, v), part(value[v], k), part(x, k));
    }
    known += !again;
    value[v] = x;
  }
  if (known != verts.given.size())
    for (const vert_t<M>& v : verts.given)
      if (std::isnan(part(value[v], 0))) throw_no_value(who, index_of(m, v));
  return value;
}

/// A x = b for the unknowns of a symmetric system over all verts. What held verts contribute goes to the right-hand side.
template<class M>
struct held_system {
  struct coupling {
    int row, vert;  // number of an unknown, index of a held vert
    double weight;  // minus the entry of the matrix
  };
  held_verts<M> verts;
  Eigen::SparseMatrix<double> lower;  // triangle
  std::vector<coupling> couplings;

  template<class Solver>
  void factorize(Solver& solver, const progress& told, const char* who) const {
    if (verts.unknowns == 0) return;
    tell(told, 0.1, "factorising");
    core::factorize_over_verts(solver, lower, who, [&](Eigen::Index row) { return verts.index[static_cast<std::size_t>(row)]; });
  }

  /// Puts the solution into `value`, which has the values of the held verts. load(k, index): what stands on the right of the
  /// unknown vert of that index, for part k of T.
  /// Errors: solver_error with the reason.
  template<class T, class Solver, class Load>
  void solve(const Solver& solver, const Load& load, vert_map<M, T>& value, const char* who) const {
    if (verts.unknowns == 0) return;
    const auto n = static_cast<std::size_t>(verts.unknowns);
    T* const at = value.values().data();
    Eigen::VectorXd b(verts.unknowns);
    for (std::size_t k = 0; k < parts_of<T>; ++k) {
      for (std::size_t i = 0; i < n; ++i) b[static_cast<Eigen::Index>(i)] = load(k, verts.index[i]);
      for (const coupling& c : couplings) b[c.row] += c.weight * part(at[c.vert], k);
      const Eigen::VectorXd u = core::solve_and_check(solver, lower, b, who);
      for (std::size_t i = 0; i < n; ++i) part(at[verts.index[i]], k) = u[static_cast<Eigen::Index>(i)];
    }
  }

  /// Takes the rows and columns of the unknowns from a matrix over all verts with both triangles.
  void restrict_to_unknowns(const Eigen::SparseMatrix<double>& whole) {
    const int n = verts.unknowns;
    lower.resize(n, n);
    lower.resizeNonZeros(whole.nonZeros());
    const int* const unknown = verts.unknown.values().data();
    int* const rows = lower.innerIndexPtr();
    double* const entries = lower.valuePtr();
    int at = 0;
    for (int c = 0; c < n; ++c) {
      const int first = at, from = verts.index[static_cast<std::size_t>(c)];
      for (int l = whole.outerIndexPtr()[from]; l < whole.outerIndexPtr()[from + 1]; ++l) {
        const int i = whole.innerIndexPtr()[l], row = unknown[i];
        const double x = whole.valuePtr()[l];
        if (row == held_verts<M>::held) couplings.push_back({c, i, -x});
        if (row < c) continue;
        rows[at] = row;
        entries[at++] = x;
      }
      core::sort_column(rows + first, entries + first, static_cast<std::size_t>(at - first));
      lower.outerIndexPtr()[c + 1] = at;
    }
    lower.resizeNonZeros(at);
  }
};

}  // namespace concino::detail
