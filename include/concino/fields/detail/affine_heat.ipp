// Defines affine_heat.hpp.
#pragma once

#include <concino/fields/detail/affine_heat.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace concino::detail {

/// The cotangent of the angle opposite to side s.
inline double opposite_cotangent(const core::unfolded_triangles& t, int s) {
  const auto& p = t.apex[static_cast<std::size_t>(core::unfolded_triangles::previous(s))];
  return p.x / p.y;
}

inline transport_edge transport_along(const core::unfolded_triangles& t, const std::vector<core::tangent_frame>& frames, int s) {
  constexpr double smallest_weight = 0.01;  // heat also flows along edges whose cotangents sum to less
  const int far = core::unfolded_triangles::next(s), twin = t.twin[static_cast<std::size_t>(s)];
  const double weight = 0.5 * (opposite_cotangent(t, s) + (twin == s ? 0 : opposite_cotangent(t, twin)));
  transport_edge e{t.start(s), t.end(s), std::max(weight, smallest_weight), {}, {}, 1, 0, false};
  const core::tangent_frame &frame_a = frames[static_cast<std::size_t>(e.a)], &frame_b = frames[static_cast<std::size_t>(e.b)];
  e.reflects = frame_a.is_oriented_as_triangle(t, s) != frame_b.is_oriented_as_triangle(t, far);
  const double length = t.length[static_cast<std::size_t>(s)];
  const double at_a = frame_a.angle_of(t.fan_angle(s, 0)), at_b = frame_b.angle_of(t.fan_angle(far, t.angle[static_cast<std::size_t>(far)]));
  e.from_a = {length * std::cos(at_a), length * std::sin(at_a)};
  e.from_b = {length * std::cos(at_b), length * std::sin(at_b)};
  const double turn = std::numbers::pi + at_a + (e.reflects ? at_b : -at_b);
  e.cosine = std::cos(turn);
  e.sine = std::sin(turn);
  return e;
}

inline double mean_square_length(const core::unfolded_triangles& t) {
  double sum = 0, total = 0;
  for (std::size_t s = 0; s < t.vert.size(); ++s) {
    const double area = t.length[s] * t.apex[s].y;
    sum += area * t.length[s] * t.length[s];
    total += area;
  }
  return total > 0 ? sum / total : 1;
}

/// The masses plus the time times the Laplacian with these weights, of numbers or of vectors.
template<int N>
Eigen::SparseMatrix<double> heat_matrix_of(const affine_heat& h) {
  const auto n = static_cast<int>(h.size());
  std::vector<double> diagonal = h.mass;
  for (const transport_edge& e : h.edges) {
    diagonal[static_cast<std::size_t>(e.a)] += h.time * e.weight;
    diagonal[static_cast<std::size_t>(e.b)] += h.time * e.weight;
  }
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(N * n) + static_cast<std::size_t>(N * N) * h.edges.size());
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < N; ++k) entries.emplace_back(N * i + k, N * i + k, diagonal[static_cast<std::size_t>(i)]);
  for (const transport_edge& e : h.edges) {
    const double flow = -h.time * e.weight;
    if constexpr (N == 1) {
      entries.emplace_back(std::max(e.a, e.b), std::min(e.a, e.b), flow);
    } else {
      const tangent_vector columns[2] = {e.to_a({1, 0}), e.to_a({0, 1})};
      for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j) {
          const double entry = flow * (j == 0 ? columns[k].x : columns[k].y);  // in row j of a, column k of b
          const int row = 2 * e.a + j, column = 2 * e.b + k;
          entries.emplace_back(std::max(row, column), std::min(row, column), entry);
        }
    }
  }
  Eigen::SparseMatrix<double> a(N * n, N * n);
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

CONCINO_INLINE affine_heat make_affine_heat(const core::unfolded_triangles& t, const std::vector<core::tangent_frame>& frames, double time) {
  affine_heat h;
  h.mass.assign(t.around.size(), 0.0);
  h.is_used.assign(t.around.size(), 0);
  h.time = time > 0 ? time : mean_square_length(t);
  for (int s = 0; s < static_cast<int>(t.vert.size()); ++s) {
    const auto v = static_cast<std::size_t>(t.start(s));
    h.mass[v] += t.length[static_cast<std::size_t>(s)] * t.apex[static_cast<std::size_t>(s)].y / 6;
    h.is_used[v] = 1;
    if (t.twin[static_cast<std::size_t>(s)] < s) continue;
    h.edges.push_back(transport_along(t, frames, s));
    h.reflects = h.reflects || h.edges.back().reflects;
  }
  for (std::size_t v = 0; v < h.mass.size(); ++v)
    if (!h.is_used[v]) h.mass[v] = 1;
  Eigen::SparseMatrix<double> scalars = heat_matrix_of<1>(h), vectors = heat_matrix_of<2>(h);
  h.scalars.swap(scalars);
  h.vectors.swap(vectors);
  return h;
}

/// Computes heat in rounds. Each one continues from the verts that are already reached, with all values scaled up, where they have become small.
class diffusion {
  static constexpr int half_range = 400;  // values of one round are between 2^-400 and 2^400
  const affine_heat& equations_;
  const core::solver_ref scalar_solver_, vector_solver_;
  const char* const caller_;
  std::vector<int> round_;  // by vert: the round in which it was reached, -1 before
  int now_ = 0;

  template<class T>
  struct field {
    std::vector<T> reached, last;  // the values at verts that are reached, in the scale of their round; those of the last round at all verts
    bool is_wanted = true;
  };

  static tangent_vector to_a(const transport_edge& e, const tangent_vector& x) { return e.to_a(x); }
  static tangent_vector to_b(const transport_edge& e, const tangent_vector& x) { return e.to_b(x); }
  static double to_a(const transport_edge&, double x) { return x; }
  static double to_b(const transport_edge&, double x) { return x; }
  static double scaled(double x, int power) { return std::ldexp(x, power); }
  static tangent_vector scaled(const tangent_vector& x, int power) { return {std::ldexp(x.x, power), std::ldexp(x.y, power)}; }

  bool is_reached(int v) const { return round_[static_cast<std::size_t>(v)] >= 0; }
  /// The value of a reached vert in the scale of this round.
  template<class T>
  T value(const field<T>& f, int v) const {
    const auto i = static_cast<std::size_t>(v);
    return scaled(f.reached[i], 2 * half_range * (now_ - round_[i]));
  }

  /// Adds to the right-hand side what makes the solution continue the reached values, and vanish where they are.
  template<class T>
  void add_continuation(const field<T>& f, std::vector<T>& rhs) const {
    const auto add = [&](const T& x, double factor, int v) { rhs[static_cast<std::size_t>(v)] = rhs[static_cast<std::size_t>(v)] + factor * x; };
    for (const transport_edge& e : equations_.edges) {
      if (is_reached(e.a) == is_reached(e.b)) continue;
      const double flow = equations_.time * e.weight;
      if (is_reached(e.a)) {
        add(to_b(e, value(f, e.a)), flow, e.b);
        add(to_a(e, scaled(f.last[static_cast<std::size_t>(e.b)], 2 * half_range)), -flow, e.a);
      } else {
        add(to_a(e, value(f, e.b)), flow, e.a);
        add(to_b(e, scaled(f.last[static_cast<std::size_t>(e.a)], 2 * half_range)), -flow, e.b);
      }
    }
  }

  void solve(const std::vector<double>& rhs, std::vector<double>& x) const {
    const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(rhs.data(), static_cast<Eigen::Index>(rhs.size()));
    const Eigen::VectorXd solution = scalar_solver_.solve(b);
    x.assign(solution.data(), solution.data() + solution.size());
  }
  void solve(const std::vector<tangent_vector>& rhs, std::vector<tangent_vector>& x) const {
    Eigen::VectorXd b(2 * static_cast<Eigen::Index>(rhs.size()));
    for (std::size_t i = 0; i < rhs.size(); ++i) {
      b[2 * static_cast<Eigen::Index>(i)] = rhs[i].x;
      b[2 * static_cast<Eigen::Index>(i) + 1] = rhs[i].y;
    }
    const Eigen::VectorXd solution = vector_solver_.solve(b);
    x.resize(rhs.size());
    for (std::size_t i = 0; i < rhs.size(); ++i) x[i] = {solution[2 * static_cast<Eigen::Index>(i)], solution[2 * static_cast<Eigen::Index>(i) + 1]};
  }

  template<class T>
  void next_round(field<T>& f, std::vector<T> rhs) const {
    if (!f.is_wanted) return;
    add_continuation(f, rhs);
    solve(rhs, f.last);
  }

  /// Heat that flows from b to a carries positions along: those seen from b and, in addition, the edge.
  std::vector<tangent_vector> carried_edges(const std::vector<unsigned char>& is_new) const {
    std::vector<tangent_vector> rhs(round_.size());
    const auto add = [&](const tangent_vector& along, double flow, int at, int from) {
      if (!is_new[static_cast<std::size_t>(at)]) return;
      const double heat = is_reached(from) ? value(heat_, from) : heat_.last[static_cast<std::size_t>(from)];
      rhs[static_cast<std::size_t>(at)] = rhs[static_cast<std::size_t>(at)] + (flow * heat) * along;
    };
    for (const transport_edge& e : equations_.edges) {
      add(e.from_a, equations_.time * e.weight, e.a, e.b);
      add(e.from_b, equations_.time * e.weight, e.b, e.a);
    }
    return rhs;
  }

  template<class T>
  void keep(field<T>& f, std::size_t v) const {
    if (f.is_wanted) f.reached[v] = f.last[v];
  }

  /// Returns how many verts were reached in this round.
  std::size_t accept() {
    std::size_t n = 0;
    const double least = std::ldexp(1.0, -half_range);
    std::vector<int> after = round_;
    for (std::size_t v = 0; v < round_.size(); ++v) {
      if (round_[v] >= 0 || !(heat_.last[v] >= least)) continue;
      after[v] = now_;
      keep(heat_, v), keep(second_heat_, v), keep(first_, v), keep(second_, v), keep(offset_, v);
      ++n;
    }
    round_.swap(after);
    return n;
  }

  /// Whether heat is known wherever it can flow. Where the next round starts, the last one must have computed it to all digits.
  bool is_complete() const {
    bool is = true;
    const double smallest = std::ldexp(1.0, -half_range - 100), largest = std::ldexp(1.0, half_range / 2);
    for (const transport_edge& e : equations_.edges) {
      if (is_reached(e.a) == is_reached(e.b)) continue;
      is = false;
      const auto [from, to] = is_reached(e.a) ? std::pair(e.a, e.b) : std::pair(e.b, e.a);
      if (!(value(heat_, from) < largest && heat_.last[static_cast<std::size_t>(to)] > smallest)) throw_too_short();
    }
    return is;
  }

  [[noreturn, gnu::cold]] void throw_too_short() const {
    core::throw_joined<invalid_argument>({caller_, ": the time is so short that heat vanishes between a vert and the next; leave it at 0 for the default"});
  }

  field<double> heat_, second_heat_;
  field<tangent_vector> first_, second_, offset_;

 public:
  diffusion(const affine_heat& equations, core::solver_ref scalar_solver, core::solver_ref vector_solver, const diffused_parts& parts, const char* caller)
      : equations_(equations), scalar_solver_(scalar_solver), vector_solver_(vector_solver), caller_(caller), round_(equations.size(), -1) {
    heat_.reached.resize(round_.size());
    for (auto* f : {&first_, &second_, &offset_}) f->reached.resize(round_.size());
    second_heat_.reached.resize(round_.size());
    second_heat_.is_wanted = parts.second_heat;
    second_.is_wanted = parts.second;
    offset_.is_wanted = parts.offset;
  }

  diffused run(const std::vector<vector_source>& sources) {
    const std::size_t n = round_.size();
    std::vector<double> heat(n), lengths(n);
    std::vector<tangent_vector> vectors(n), turned(n);
    double total = 0;
    for (const double x : equations_.mass) total += x;
    const double unit = std::ldexp(total / static_cast<double>(n), half_range);
    for (const vector_source& s : sources) {
      const auto v = static_cast<std::size_t>(s.vert);
      heat[v] += unit;
      lengths[v] += unit * norm(s.vector);
      vectors[v] = vectors[v] + unit * s.vector;
      turned[v] = turned[v] + unit * tangent_vector(-s.vector.y, s.vector.x);
    }
    while (true) {
      std::vector<unsigned char> is_new(n);
      for (std::size_t v = 0; v < n; ++v) is_new[v] = round_[v] < 0;
      next_round(heat_, std::move(heat));
      next_round(second_heat_, std::move(lengths));
      next_round(first_, std::move(vectors));
      next_round(second_, std::move(turned));
      if (offset_.is_wanted) next_round(offset_, carried_edges(is_new));
      if (accept() == 0) throw_too_short();
      heat.assign(n, 0), lengths.assign(n, 0), vectors.assign(n, {}), turned.assign(n, {});
      if (is_complete()) break;
      ++now_;
    }
    diffused r{std::move(heat_.reached), std::move(second_heat_.reached), std::move(first_.reached), std::move(second_.reached), std::move(offset_.reached), {}};
    for (const int round : round_) r.is_reached.push_back(round >= 0);
    return r;
  }
};

CONCINO_INLINE diffused diffuse(const affine_heat& equations, core::solver_ref scalar_solver, core::solver_ref vector_solver, const std::vector<vector_source>& sources,
                                const diffused_parts& parts, const char* caller) {
  return diffusion(equations, scalar_solver, vector_solver, parts, caller).run(sources);
}

}  // namespace concino::detail
