// Diffusion of heat, and of what it carries along, in rounds; see affine_heat.hpp.
#pragma once

#include <concino/fields/detail/heat/affine_heat.hpp>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace concino::detail {

/// Computes heat in rounds. Each one continues from the verts that are already reached, with all values scaled up,
/// where they have become small.
class diffusion {
  static constexpr int half_range = 400;  // values of one round are between 2^-400 and 2^400
  const affine_heat& equations_;
  const core::solver_ref scalar_solver_, vector_solver_;
  const char* const caller_;
  std::vector<int> round_;  // by vert: the round in which it was reached, -1 before
  int now_ = 0;

  /// N numbers at each vert.
  template<int N>
  struct field {
    Eigen::VectorXd reached, last;  // the values at verts that are reached, in the scale of their round; those of the
                                    // last round at all verts
    bool is_wanted = true;
  };
  field<1> heat_, second_heat_, square_;
  field<2> first_, second_, offset_;

  static tangent_vector get(const Eigen::VectorXd& x, int v, field<2>*) { return {x[2 * v], x[2 * v + 1]}; }
  static double get(const Eigen::VectorXd& x, int v, field<1>*) { return x[v]; }
  static void add_to(Eigen::VectorXd& x, int v, const tangent_vector& y) {
    x[2 * v] += y.x;
    x[2 * v + 1] += y.y;
  }
  static void add_to(Eigen::VectorXd& x, int v, double y) { x[v] += y; }
  static tangent_vector to_a(const transport_edge& e, const tangent_vector& x) { return e.to_a(x); }
  static tangent_vector to_b(const transport_edge& e, const tangent_vector& x) { return e.to_b(x); }
  static double to_a(const transport_edge&, double x) { return x; }
  static double to_b(const transport_edge&, double x) { return x; }

  bool is_reached(int v) const { return round_[static_cast<std::size_t>(v)] >= 0; }
  /// The value of a reached vert in the scale of this round.
  template<int N>
  auto value(const field<N>& f, int v) const {
    return std::ldexp(1.0, 2 * half_range * (now_ - round_[static_cast<std::size_t>(v)])) *
           get(f.reached, v, static_cast<field<N>*>(nullptr));
  }
  /// The value of another vert in the last round, in the scale of this round.
  template<int N>
  auto value_before(const field<N>& f, int v) const {
    return std::ldexp(1.0, 2 * half_range) * get(f.last, v, static_cast<field<N>*>(nullptr));
  }

  /// Adds to the right-hand side what makes the solution continue the reached values, and vanish where they are.
  template<int N>
  void add_continuation(const field<N>& f, Eigen::VectorXd& rhs) const {
    for (const transport_edge& e : equations_.edges) {
      if (is_reached(e.a) == is_reached(e.b)) continue;
      const double flow = equations_.time * e.weight;
      if (is_reached(e.a)) {
        add_to(rhs, e.b, flow * to_b(e, value(f, e.a)));
        add_to(rhs, e.a, -flow * to_a(e, value_before(f, e.b)));
      } else {
        add_to(rhs, e.a, flow * to_a(e, value(f, e.b)));
        add_to(rhs, e.b, -flow * to_b(e, value_before(f, e.a)));
      }
    }
  }

  /// rhs: that of the first round; afterwards zero.
  template<int N>
  void next_round(field<N>& f, Eigen::VectorXd& rhs) const {
    if (!f.is_wanted) return;
    if (now_ > 0) add_continuation(f, rhs);
    f.last = (N == 1 ? scalar_solver_ : vector_solver_).solve(rhs);
  }

  /// The value of this round's solution at a vert, or what it continues.
  template<int N>
  auto value_now(const field<N>& f, int v) const {
    return is_reached(v) ? value(f, v) : get(f.last, v, static_cast<field<N>*>(nullptr));
  }

  /// Heat that flows from b to a carries positions along: those seen from b and, in addition, the edge. add(edge, flow
  /// from b to a, seen from a).
  template<class F>
  void for_each_flow(const F& add) const {
    for (const transport_edge& e : equations_.edges) {
      if (!is_reached(e.a)) add(e, e.a, e.b, true);
      if (!is_reached(e.b)) add(e, e.b, e.a, false);
    }
  }
  void add_carried_edges(Eigen::VectorXd& rhs) const {
    for_each_flow([&](const transport_edge& e, int to, int from, bool to_a) {
      add_to(rhs, to, (equations_.time * e.weight * value_now(heat_, from)) * (to_a ? e.from_a : e.from_b));
    });
  }
  /// Of the squared length of the sum of both, the part that is not the square seen from the other end.
  void add_carried_squares(Eigen::VectorXd& rhs) const {
    for_each_flow([&](const transport_edge& e, int to, int from, bool to_a) {
      const tangent_vector seen = value_now(offset_, from), edge = to_a ? e.from_a : e.from_b,
                           turned = to_a ? e.to_a(seen) : e.to_b(seen);
      rhs[to] += equations_.time * e.weight * (2 * dot(edge, turned) + dot(edge, edge) * value_now(heat_, from));
    });
  }

  template<int N>
  static void keep(field<N>& f, int v) {
    if (!f.is_wanted) return;
    for (int k = N * v; k < N * v + N; ++k) f.reached[k] = f.last[k];
  }

  /// Returns how many verts were reached in this round.
  std::size_t accept() {
    std::size_t n = 0;
    const double least = std::ldexp(1.0, -half_range);
    for (int v = 0; v < static_cast<int>(round_.size()); ++v) {
      if (is_reached(v) || !(heat_.last[v] >= least)) continue;
      round_[static_cast<std::size_t>(v)] = now_;
      ++n;
      if (now_ > 0)
        keep(heat_, v), keep(second_heat_, v), keep(square_, v), keep(first_, v), keep(second_, v), keep(offset_, v);
    }
    return n;
  }

  /// Most meshes need one round only, so its values are copied only if there is another.
  void keep_first_round(bool is_complete) {
    const auto take = [&](auto& f) {
      if (is_complete) f.reached.swap(f.last);
      else f.reached = f.last;
    };
    take(heat_), take(second_heat_), take(square_), take(first_), take(second_), take(offset_);
  }

  /// Whether heat is known wherever it can flow. Where the next round starts, the last one must have computed it to all
  /// digits.
  bool is_complete() const {
    bool is = true;
    const double smallest = std::ldexp(1.0, -half_range - 100), largest = std::ldexp(1.0, half_range / 2);
    for (const transport_edge& e : equations_.edges) {
      if (is_reached(e.a) == is_reached(e.b)) continue;
      is = false;
      const auto [from, to] = is_reached(e.a) ? std::pair(e.a, e.b) : std::pair(e.b, e.a);
      const double reached = now_ == 0 ? heat_.last[from] : value(heat_, from);
      if (!(reached < largest && heat_.last[to] > smallest)) throw_too_short();
    }
    return is;
  }

  [[noreturn, gnu::cold]] void throw_too_short() const {
    core::throw_joined<invalid_argument>(
        {caller_,
         ": the time is so short that heat vanishes between a vert and the next; leave it at 0 for the default"});
  }

  /// The right-hand side of the first round. part(source): what starts there.
  template<class F>
  Eigen::VectorXd starts(int numbers, bool is_wanted, const std::vector<vector_source>& sources, const F& part) const {
    Eigen::VectorXd rhs;
    if (!is_wanted) return rhs;
    rhs.setZero(numbers * static_cast<Eigen::Index>(round_.size()));
    for (const vector_source& s : sources) add_to(rhs, s.vert, part(s));
    return rhs;
  }

 public:
  diffusion(const affine_heat& equations, core::solver_ref scalar_solver, core::solver_ref vector_solver,
            const diffusion_outputs& extra, const char* caller)
      : equations_(equations), scalar_solver_(scalar_solver), vector_solver_(vector_solver), caller_(caller),
        round_(equations.size(), -1) {
    second_heat_.is_wanted = extra.second_heat;
    second_.is_wanted = extra.second;
    offset_.is_wanted = square_.is_wanted = extra.offset;
  }

  diffused run(const std::vector<vector_source>& sources) {
    double total = 0;
    for (const double x : equations_.mass) total += x;
    const double unit = std::ldexp(total / static_cast<double>(round_.size()), half_range);
    Eigen::VectorXd heat = starts(1, true, sources, [&](const vector_source&) { return unit; });
    Eigen::VectorXd lengths =
        starts(1, second_heat_.is_wanted, sources, [&](const vector_source& s) { return unit * norm(s.vector); });
    Eigen::VectorXd vectors = starts(2, true, sources, [&](const vector_source& s) { return unit * s.vector; });
    Eigen::VectorXd turned = starts(2, second_.is_wanted, sources, [&](const vector_source& s) {
      return unit * tangent_vector(-s.vector.y, s.vector.x);
    });
    while (true) {
      next_round(heat_, heat);
      next_round(second_heat_, lengths);
      next_round(first_, vectors);
      next_round(second_, turned);
      if (offset_.is_wanted) {
        vectors.setZero();  // in the same memory
        add_carried_edges(vectors);
        next_round(offset_, vectors);
        heat.setZero();
        add_carried_squares(heat);
        next_round(square_, heat);
      }
      if (accept() == 0) throw_too_short();
      const bool complete = is_complete();
      if (now_ == 0) keep_first_round(complete);
      if (complete) break;
      ++now_;
      heat.setZero(), lengths.setZero(), vectors.setZero(), turned.setZero();
    }
    diffused r;
    r.heat.swap(heat_.reached);
    r.second_heat.swap(second_heat_.reached);
    r.square.swap(square_.reached);
    r.first.swap(first_.reached);
    r.second.swap(second_.reached);
    r.offset.swap(offset_.reached);
    r.round.swap(round_);
    return r;
  }
};

CONCINO_INLINE diffused diffuse(const affine_heat& equations, core::solver_ref scalar_solver,
                                core::solver_ref vector_solver, const std::vector<vector_source>& sources,
                                const diffusion_outputs& extra, const char* caller) {
  return diffusion(equations, scalar_solver, vector_solver, extra, caller).run(sources);
}

}  // namespace concino::detail
