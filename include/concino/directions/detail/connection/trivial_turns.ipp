// Bodies of trivial_turns.hpp: strips of polys, the linear system of turns, and directions carried over polys.
#pragma once

#include <concino/directions/detail/connection/trivial_turns.hpp>
#include <concino/graph/disjoint_sets.hpp>
#include <concino/solve/ldlt.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace concino::detail {

CONCINO_INLINE std::vector<std::uint32_t> points_and_loops(const oriented_surface& s) {
  disjoint_sets sets(s.num_verts());
  for (std::uint32_t c = 0; c < s.vert.size(); ++c)
    if (s.twin[c] == oriented_surface::none) sets.unite(s.vert[c], s.vert[s.next[c]]);
  std::vector<std::uint32_t> place;
  for (std::size_t v = 0; v < s.num_verts(); ++v) place.push_back(static_cast<std::uint32_t>(sets.root(v)));
  return place;
}

/// A breadth-first tree of the polys of each component.
struct strip_tree {
  std::vector<std::uint32_t> up;     // by poly: the corner whose edge leads to the parent
  std::vector<std::uint32_t> depth;  // by poly

  explicit strip_tree(const oriented_surface& s)
      : up(s.num_polys(), oriented_surface::none), depth(s.num_polys(), oriented_surface::none) {
    std::vector<std::uint32_t> queue;
    for (std::uint32_t root = 0; root < s.num_polys(); ++root) {
      if (depth[root] != oriented_surface::none) continue;
      depth[root] = 0;
      queue.assign(1, root);
      for (std::size_t i = 0; i < queue.size(); ++i)
        for (std::uint32_t c = s.first[queue[i]]; c < s.first[queue[i] + 1]; ++c) {
          const std::uint32_t twin = s.twin[c];
          if (twin == oriented_surface::none || depth[s.poly[twin]] != oriented_surface::none) continue;
          depth[s.poly[twin]] = depth[queue[i]] + 1;
          up[s.poly[twin]] = twin;
          queue.push_back(s.poly[twin]);
        }
    }
  }

  /// Across the edge of corner c, up from there, and down to the poly of c.
  poly_strip strip_of(const oriented_surface& s, std::uint32_t c) const {
    poly_strip strip{c}, down;
    std::uint32_t a = s.poly[s.twin[c]], b = s.poly[c];
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
    return strip;
  }
};

/// Of the edges that the tree of polys does not cross, those that are in no tree of the places.
CONCINO_INLINE std::vector<poly_strip> generating_strips(const oriented_surface& s,
                                                         const std::vector<std::uint32_t>& place) {
  const strip_tree tree(s);
  disjoint_sets joined(s.num_verts());
  std::vector<poly_strip> strips;
  for (std::uint32_t c = 0; c < s.vert.size(); ++c) {
    const std::uint32_t twin = s.twin[c];
    if (twin == oriented_surface::none || twin < c || tree.up[s.poly[c]] == c || tree.up[s.poly[twin]] == twin)
      continue;
    if (!joined.unite(place[s.vert[c]], place[s.vert[s.next[c]]])) strips.push_back(tree.strip_of(s, c));
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
                                              const std::vector<std::uint32_t>& place, const char* caller) {
  std::vector<double> defect(s.num_verts(), 0.0);
  for (std::size_t v = 0; v < defect.size(); ++v)
    if (s.component[v] != oriented_surface::none)
      defect[place[v]] += (s.on_boundary[v] ? 1 : 2) * std::numbers::pi;
  for (std::size_t p = 0; p < s.num_polys(); ++p) {
    double sum = 0;
    for (std::uint32_t c = s.first[p]; c < s.first[p + 1]; ++c) {
      sum += planes.inside[c];
      defect[place[s.vert[c]]] -= planes.inside[c];
    }
    if (std::abs(sum - (static_cast<double>(s.first[p + 1] - s.first[p]) - 2) * std::numbers::pi) > 1)
      core::throw_joined<unsupported>({caller, ": poly ", s.poly_index[p],
                                       " crosses itself in the plane of its area; cut it by triangulate(m)"});
  }
  return defect;
}

/// One column for each edge inside the surface. The rows are places and strips: first those whose holonomy is given,
/// then those that turn least. One place of each component has no row, as its holonomy follows from the others: one
/// that is not given if there is one.
struct turn_equations {
  std::vector<int> row;            // by place; -1: none
  std::vector<int> column;         // by corner, of its edge; -1 at the boundary
  std::vector<int> row_of_strip;
  int num_known = 0, num_rows = 0;
  Eigen::SparseMatrix<double> a;

  turn_equations(const oriented_surface& s, const std::vector<poly_strip>& strips, const wanted_turns& wanted)
      : row(s.num_verts(), -1), column(s.vert.size(), -1) {
    number_rows(s, strips.size(), wanted);
    int columns = 0;
    for (std::uint32_t c = 0; c < s.vert.size(); ++c)
      if (s.twin[c] != oriented_surface::none && s.twin[c] > c) column[c] = column[s.twin[c]] = columns++;
    std::vector<Eigen::Triplet<double>> entries;
    for (std::uint32_t c = 0; c < s.vert.size(); ++c)  // about a vert, edges are crossed from their left
      if (const int r = row[wanted.place[s.vert[s.next[c]]]]; r >= 0 && column[c] >= 0)
        entries.emplace_back(r, column[c], sign(s, c));
    for (std::size_t k = 0; k < strips.size(); ++k)
      for (const std::uint32_t c : strips[k]) entries.emplace_back(row_of_strip[k], column[c], sign(s, c));
    a.resize(num_rows, columns);
    a.setFromTriplets(entries.begin(), entries.end());
  }

  void number_rows(const oriented_surface& s, std::size_t num_strips, const wanted_turns& wanted) {
    const auto is_place = [&](std::size_t v) {
      return s.component[v] != oriented_surface::none && wanted.place[v] == v;
    };
    std::vector<std::size_t> without_row(s.num_components, s.num_verts());
    for (std::size_t v = 0; v < s.num_verts(); ++v)
      if (is_place(v) && (!wanted.holonomy[v] || without_row[s.component[v]] == s.num_verts()))
        without_row[s.component[v]] = v;
    for (const bool is_known : {true, false}) {
      for (std::size_t v = 0; v < s.num_verts(); ++v)
        if (is_place(v) && wanted.holonomy[v].has_value() == is_known && without_row[s.component[v]] != v)
          row[v] = num_rows++;
      for (std::size_t k = 0; k < num_strips && wanted.of_strip.empty() != is_known; ++k)
        row_of_strip.push_back(num_rows++);
      if (is_known) num_known = num_rows;
    }
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
                                                const std::vector<double>& defects,
                                                const std::vector<poly_strip>& strips, const wanted_turns& wanted) {
  const turn_equations equations(s, strips, wanted);
  Eigen::VectorXd parallel(equations.num_rows), turn = Eigen::VectorXd::Zero(equations.num_rows);
  trivial_turns r;
  for (std::size_t v = 0; v < s.num_verts(); ++v)
    if (const int k = equations.row[v]; k >= 0) {
      parallel[k] = defects[v];
      turn[k] = wanted.holonomy[v].value_or(0);
    }
  for (std::size_t k = 0; k < strips.size(); ++k) {
    r.of_strip.push_back(turn_of_strip(s, planes, strips[k]));
    parallel[equations.row_of_strip[k]] = r.of_strip[k];
    if (!wanted.of_strip.empty()) turn[equations.row_of_strip[k]] = wanted.of_strip[k];
  }
  if (equations.num_known < equations.num_rows) {
    const Eigen::VectorXd free =
        parallel + equations.a * equations.smallest((turn - parallel).head(equations.num_known));
    for (int k = equations.num_known; k < equations.num_rows; ++k)
      turn[k] = wanted.step * std::round(free[k] / wanted.step);
  }
  const Eigen::VectorXd x = equations.smallest(turn - parallel);
  r.turn.assign(s.vert.size(), 0.0);
  r.holonomy = defects;
  for (std::uint32_t c = 0; c < s.vert.size(); ++c) {
    if (equations.column[c] < 0) continue;
    r.turn[c] = turn_equations::sign(s, c) * x[equations.column[c]];
    r.holonomy[wanted.place[s.vert[s.next[c]]]] += r.turn[c];
  }
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
        const std::uint32_t other = s.twin[c];
        if (other == oriented_surface::none || is_known[s.poly[other]]) continue;
        const std::uint32_t q = s.poly[other];
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
