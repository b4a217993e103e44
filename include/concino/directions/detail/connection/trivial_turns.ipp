// Bodies of trivial_turns.hpp: strips of polys, the linear system of turns, and directions carried over polys.
#pragma once

#include <concino/directions/detail/connection/trivial_turns.hpp>
#include <concino/solve/ldlt.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace concino::detail {

CONCINO_INLINE std::vector<poly_strip> strips_of(const oriented_surface& s, const std::vector<std::uint32_t>& cotree,
                                                 const std::vector<std::uint32_t>& rest) {
  constexpr std::uint32_t none = oriented_surface::none;
  std::vector<unsigned char> is_crossed(s.num_edges);
  std::vector<std::uint32_t> side(s.num_edges, none), up(s.num_polys(), none), depth(s.num_polys(), none), queue;
  for (const std::uint32_t e : cotree) is_crossed[e] = 1;
  for (std::uint32_t c = 0; c < s.vert.size(); ++c) side[s.edge[c]] = c;
  for (std::uint32_t root = 0; root < s.num_polys(); ++root) {
    if (depth[root] != none) continue;
    depth[root] = 0;
    queue.assign(1, root);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const std::uint32_t p = queue[i];
      for (std::uint32_t c = s.first[p]; c < s.first[p + 1]; ++c) {
        const std::uint32_t q = s.poly[s.twin[c]];
        if (!is_crossed[s.edge[c]] || depth[q] != none) continue;
        depth[q] = depth[p] + 1;
        up[q] = s.twin[c];  // the corner in q, whose edge leads to p
        queue.push_back(q);
      }
    }
  }
  std::vector<poly_strip> strips;
  for (const std::uint32_t e : rest) {
    // across e, up from there, and down to the poly before e
    poly_strip strip{side[e]}, down;
    std::uint32_t a = s.poly[s.twin[side[e]]], b = s.poly[side[e]];
    while (a != b) {
      if (depth[a] >= depth[b]) {
        strip.push_back(up[a]);
        a = s.poly[s.twin[up[a]]];
      } else {
        down.push_back(s.twin[up[b]]);
        b = s.poly[s.twin[up[b]]];
      }
    }
    strip.insert(strip.end(), down.rbegin(), down.rend());
    strips.push_back(std::move(strip));
  }
  return strips;
}

/// In each poly a strip turns left by pi minus the angles that it leaves on its left, less pi.
CONCINO_INLINE double turn_of_strip(const oriented_surface& s, const poly_planes& planes, const poly_strip& strip) {
  double turn = 0;
  for (std::size_t i = 0; i < strip.size(); ++i) {
    const std::uint32_t in = s.twin[strip[i]], out = strip[(i + 1) % strip.size()];
    double exterior = 0;  // from the edge that the strip enters by to that by which it leaves, counter-clockwise
    for (std::uint32_t c = in; c != out;) {
      c = s.next[c];
      exterior += std::numbers::pi - planes.inside[c];
    }
    turn += exterior - std::numbers::pi;
  }
  return -turn;
}

CONCINO_INLINE std::vector<double> defects_of(const oriented_surface& s, const poly_planes& planes,
                                              const char* caller) {
  std::vector<double> defect(s.num_verts(), 0.0);
  for (std::size_t v = 0; v < defect.size(); ++v)
    if (s.component[v] != oriented_surface::none) defect[v] = 2 * std::numbers::pi;
  for (std::size_t p = 0; p < s.num_polys(); ++p) {
    double sum = 0;
    for (std::uint32_t c = s.first[p]; c < s.first[p + 1]; ++c) {
      sum += planes.inside[c];
      defect[s.vert[c]] -= planes.inside[c];
    }
    if (std::abs(sum - (static_cast<double>(s.first[p + 1] - s.first[p]) - 2) * std::numbers::pi) > 1)
      core::throw_joined<unsupported>({caller, ": poly ", s.poly_index[p],
                                       " crosses itself in the plane of its area; cut it by triangulate(m)"});
  }
  return defect;
}

/// One row for each vert but one of each component, and for each strip; one column for each edge.
struct turn_equations {
  std::vector<int> row;     // by vert; -1: none
  std::vector<int> column;  // by corner, of its edge
  Eigen::SparseMatrix<double> a;
  int num_vert_rows = 0;

  turn_equations(const oriented_surface& s, const std::vector<poly_strip>& strips)
      : row(s.num_verts(), -1), column(s.vert.size(), -1) {
    std::vector<unsigned char> has_free(s.num_components);
    for (std::size_t v = 0; v < s.num_verts(); ++v) {
      if (s.component[v] == oriented_surface::none) continue;
      if (has_free[s.component[v]]) row[v] = num_vert_rows++;
      has_free[s.component[v]] = 1;  // the row of the first vert follows from the others
    }
    int columns = 0;
    for (std::uint32_t c = 0; c < s.vert.size(); ++c)
      if (s.twin[c] > c) column[c] = column[s.twin[c]] = columns++;
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](int r, std::uint32_t c) { entries.emplace_back(r, column[c], sign(s, c)); };
    for (std::uint32_t c = 0; c < s.vert.size(); ++c)  // about a vert, edges are crossed from their left
      if (row[s.vert[s.next[c]]] >= 0) add(row[s.vert[s.next[c]]], c);
    for (std::size_t k = 0; k < strips.size(); ++k)
      for (const std::uint32_t c : strips[k]) add(num_vert_rows + static_cast<int>(k), c);
    a.resize(num_vert_rows + static_cast<int>(strips.size()), columns);
    a.setFromTriplets(entries.begin(), entries.end());
  }

  static double sign(const oriented_surface& s, std::uint32_t c) { return s.twin[c] > c ? 1 : -1; }

  /// The solution of the first rows with the smallest sum of squares.
  Eigen::VectorXd smallest(const Eigen::VectorXd& b) const {
    const Eigen::SparseMatrix<double> some = a.topRows(b.size());
    if (b.size() == 0) return Eigen::VectorXd::Zero(a.cols());
    const Eigen::SparseMatrix<double> transposed = some.transpose();
    ldlt solver;
    solver.factorize(some * transposed);
    Eigen::VectorXd x = transposed * solver.solve(b);
    constexpr int refinements = 2;
    for (int k = 0; k < refinements; ++k) x += transposed * solver.solve(b - some * x);
    return x;
  }
};

CONCINO_INLINE trivial_turns find_trivial_turns(const oriented_surface& s, const poly_planes& planes,
                                                const std::vector<double>& holonomy,
                                                const std::vector<double>& defects,
                                                const std::vector<poly_strip>& strips, std::vector<double> strip_turns,
                                                double step) {
  const turn_equations equations(s, strips);
  Eigen::VectorXd b(equations.a.rows());
  for (std::size_t v = 0; v < s.num_verts(); ++v)
    if (equations.row[v] >= 0) b[equations.row[v]] = holonomy[v] - defects[v];
  std::vector<double> parallel;
  for (const poly_strip& strip : strips) parallel.push_back(turn_of_strip(s, planes, strip));
  if (strip_turns.empty() && !strips.empty()) {
    const Eigen::VectorXd x = equations.a * equations.smallest(b.head(equations.num_vert_rows));
    for (std::size_t k = 0; k < strips.size(); ++k) {
      const double turn = parallel[k] + x[equations.num_vert_rows + static_cast<Eigen::Index>(k)];
      strip_turns.push_back(step * std::round(turn / step));
    }
  }
  for (std::size_t k = 0; k < strips.size(); ++k)
    b[equations.num_vert_rows + static_cast<Eigen::Index>(k)] = strip_turns[k] - parallel[k];
  const Eigen::VectorXd x = equations.smallest(b);
  trivial_turns r;
  r.turn.resize(s.vert.size());
  r.holonomy = defects;
  for (std::uint32_t c = 0; c < s.vert.size(); ++c) {
    r.turn[c] = turn_equations::sign(s, c) * x[equations.column[c]];
    r.holonomy[s.vert[s.next[c]]] += r.turn[c];
  }
  r.of_strip = std::move(parallel);
  for (std::size_t k = 0; k < strips.size(); ++k)
    for (const std::uint32_t c : strips[k]) r.of_strip[k] += r.turn[c];
  return r;
}

CONCINO_INLINE std::vector<double> carried_angles(const oriented_surface& s, const poly_planes& planes,
                                                  const trivial_turns& turns, std::uint32_t start, double angle) {
  std::vector<double> r(s.num_polys());
  std::vector<unsigned char> is_known(s.num_polys());
  std::vector<std::uint32_t> queue;
  const auto carry_from = [&](std::uint32_t root, double first) {
    if (is_known[root]) return;
    is_known[root] = 1;
    r[root] = first;
    queue.assign(1, root);
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (std::uint32_t c = s.first[queue[i]]; c < s.first[queue[i] + 1]; ++c) {
        const std::uint32_t other = s.twin[c], q = s.poly[other];
        if (is_known[q]) continue;
        is_known[q] = 1;
        r[q] = std::remainder(
            r[queue[i]] - planes.along[c] + planes.along[other] + std::numbers::pi + turns.turn[c],
            2 * std::numbers::pi);
        queue.push_back(q);
      }
  };
  carry_from(start, angle);
  for (std::uint32_t p = 0; p < s.num_polys(); ++p) carry_from(p, 0);
  return r;
}

}  // namespace concino::detail
