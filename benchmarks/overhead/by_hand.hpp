// Measures what an adapter costs: the same work through the adapter, by a loop that uses the foreign library's own API, and by that library's own function
// where it has one. The loops use the same algorithms, heap, sets and solver as the library, so that only the adapter differs.
#pragma once

#include "../support/program.hpp"

#include <concino/fields.hpp>
#include <concino/graph.hpp>
#include <concino/operators.hpp>
#include <concino/solve/ldlt.hpp>

#include <memory>
#include <vector>

namespace bench::by_hand {

using concino::vec3;

// L is a struct of the program that measures a library. Its members, written with that library's API:
//   vert, poly                       handles; vert_at(i), poly_at(i), index(handle)
//   num_verts(), num_polys(), num_edges()
//   around(v, f)                     f(w) for each neighbour; around(p, f) for polys
//   corners(p, f)                    f(v) for each corner of p, in order
//   sides(p, f)                      f(index of edge) for each edge of p, in order, first the edge from corner 0 to corner 1
//   edges_at(v, f)                   f(index of edge, far end)
//   at(v)                            vec3

template<class L, class Node>
std::vector<int> bfs(const L& l, Node source, std::size_t n) {
  std::vector<int> hops(n, -1);
  const auto queue = std::make_unique_for_overwrite<Node[]>(n);
  std::size_t head = 0, tail = 0;
  hops[l.index(source)] = 0;
  queue[tail++] = source;
  while (head != tail) {
    const Node v = queue[head++];
    const int next = hops[l.index(v)] + 1;
    l.around(v, [&](Node w) {
      int& h = hops[l.index(w)];
      if (h >= 0) return;
      h = next;
      queue[tail++] = w;
    });
  }
  return hops;
}

template<class Node, class L, class NodeAt>
std::vector<int> components(const L& l, std::size_t n, NodeAt node_at) {
  concino::disjoint_sets sets(n);
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t mine = sets.root(i);
    l.around(node_at(i), [&](Node w) {
      const std::size_t j = l.index(w);
      if (j >= i) return;
      if (const std::size_t theirs = sets.root(j); theirs != mine) mine = sets.unite_roots(mine, theirs);
    });
  }
  std::vector<int> label(n, -1);
  int count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    int& number = label[sets.root(i)];
    if (number < 0) number = count++;
    label[i] = number;
  }
  return label;
}

template<class L, class Node, class At>
std::vector<double> dijkstra(const L& l, Node source, std::size_t n, At at) {
  std::vector<double> distance(n, std::numeric_limits<double>::infinity());
  concino::core::indexed_heap<Node> queue(distance);
  queue.decrease_key(source, l.index(source), 0);
  while (!queue.empty()) {
    const auto [v, slot, d] = queue.pop();
    l.around(v, [&, far = d, from = at(v)](Node w) {
      const std::size_t i = l.index(w);
      const double known = queue.key(i);
      if (known - far <= 0) return;
      const double length = concino::detail::distance_below(from, at(w), known - far);
      if (far + length < known) queue.decrease_key(w, i, far + length);
    });
  }
  return distance;
}

template<class L>
std::vector<vec3> centres(const L& l) {
  std::vector<vec3> c(l.num_polys());
  for (std::size_t i = 0; i < c.size(); ++i) {
    vec3 sum;
    l.corners(l.poly_at(i), [&](typename L::vert v) { sum += l.at(v); });
    c[i] = sum / 3;
  }
  return c;
}

/// For each edge, half the sum of the cotangents of the angles opposite to it; for triangles only.
template<class L>
std::vector<double> cotangents(const L& l) {
  std::vector<double> weight(l.num_edges());
  for (std::size_t i = 0; i < l.num_polys(); ++i) {
    vec3 x[3];
    std::size_t n = 0;
    l.corners(l.poly_at(i), [&](typename L::vert v) { x[n++] = l.at(v); });
    const vec3 side[3] = {x[1] - x[0], x[2] - x[1], x[0] - x[2]};
    const double factor = -0.5 / norm(cross(side[0], side[1]));
    n = 0;
    l.sides(l.poly_at(i), [&](std::size_t e) {
      weight[e] += factor * dot(side[(n + 1) % 3], side[(n + 2) % 3]);
      ++n;
    });
  }
  return weight;
}

/// The matrix of the unknowns of a Laplace equation, or of all verts; the sign makes the diagonal positive or negative.
template<bool LowerOnly, class L>
Eigen::SparseMatrix<double> assemble(const L& l, const std::vector<double>& weight, const std::vector<int>& column, int size, double sign,
                                     Eigen::VectorXd* b, const std::vector<double>* given) {
  Eigen::SparseMatrix<double> a(size, size);
  int* const begin = a.outerIndexPtr();
  for (std::size_t i = 0; i < l.num_verts(); ++i) {
    const int c = column[i];
    if (c < 0) continue;
    int n = 1;
    l.edges_at(l.vert_at(i), [&](std::size_t, typename L::vert w) {
      if constexpr (LowerOnly) n += column[l.index(w)] >= c;
      else ++n;
    });
    begin[c + 1] = n;
  }
  for (int c = 0; c < size; ++c) begin[c + 1] += begin[c];
  a.resizeNonZeros(begin[size]);
  for (std::size_t i = 0; i < l.num_verts(); ++i) {
    const int c = column[i];
    if (c < 0) continue;
    const int first = begin[c];
    int at = first + 1;
    double sum = 0;
    l.edges_at(l.vert_at(i), [&](std::size_t e, typename L::vert w) {
      sum += weight[e];
      const int row = column[l.index(w)];
      if (LowerOnly && row < 0) (*b)[c] += weight[e] * (*given)[l.index(w)];
      if (LowerOnly && row < c) return;
      a.innerIndexPtr()[at] = row;
      a.valuePtr()[at++] = -sign * weight[e];
    });
    a.innerIndexPtr()[first] = c;
    a.valuePtr()[first] = sign * sum;
    concino::core::sort_column(a.innerIndexPtr() + first, a.valuePtr() + first, static_cast<std::size_t>(at - first));
  }
  return a;
}

template<class L>
Eigen::SparseMatrix<double> laplacian(const L& l) {
  std::vector<int> column(l.num_verts());
  for (std::size_t i = 0; i < column.size(); ++i) column[i] = static_cast<int>(i);
  return assemble<false>(l, cotangents(l), column, static_cast<int>(column.size()), -1, nullptr, nullptr);
}

/// The harmonic map that is 0 at vert 0 and 1 at the last vert.
template<class L>
std::vector<double> harmonic_map(const L& l) {
  const std::vector<int> hops = bfs(l, l.vert_at(0), l.num_verts());
  for (const int h : hops)
    if (h < 0) throw std::runtime_error("by hand: several components");
  std::vector<double> u(l.num_verts());
  u.back() = 1;
  std::vector<int> column(u.size(), -1);
  int unknowns = 0;
  for (std::size_t i = 1; i + 1 < u.size(); ++i) column[i] = unknowns++;
  Eigen::VectorXd b = Eigen::VectorXd::Zero(unknowns);
  const auto a = assemble<true>(l, cotangents(l), column, unknowns, 1, &b, &u);
  concino::ldlt solver;
  solver.factorize(a);
  const Eigen::VectorXd x = concino::core::solve_and_check(solver, a, b, "by hand");
  for (std::size_t i = 1; i + 1 < u.size(); ++i) u[i] = x[column[i]];
  return u;
}

template<class A, class B>
void expect_equal(const std::string& work, const A& a, const B& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto x = static_cast<double>(a[i]), y = static_cast<double>(b[i]);
    if (!(x == y || std::abs(x - y) <= 1e-9 * std::max(1.0, std::abs(x)))) throw std::runtime_error(work + ": results differ at " + std::to_string(i));
  }
}

/// Measures one work: by hand, through the adapter, and by the library's own function unless that is empty. The row is "overhead." followed by `name`.
/// values(result) returns the numbers of the adapter's result, which must be those of the loop.
template<class Hand, class Ours, class Values, class Own = std::nullptr_t>
void compare(const program& p, const std::string& name, Hand hand, Ours ours, Values values, Own own = nullptr) {
  const std::string work = "overhead." + name;
  if (!p.wants(work)) return;
  expect_equal(work, hand(), values(ours()));
  const auto timed = [](auto& f) { return [&f] { return seconds_of(f); }; };
  std::vector<contender> them = {{"by-hand", timed(hand)}, {"concino", timed(ours)}};
  if constexpr (!std::is_null_pointer_v<Own>) them.push_back({"own", timed(own)});
  p.print(bench::compare(work, p.rounds, them));
}

/// Measures all work on the mesh m. l is the same mesh by the library's own API.
template<class L, class M>
void compare_all(const program& p, const std::string& library, const L& l, const M& m) {
  using vert = typename L::vert;
  using poly = typename L::poly;
  const vert v = l.vert_at(0);
  const poly q = l.poly_at(0);
  const auto values = [](const auto& r) {
    if constexpr (requires { r.labels; }) return r.labels.values();
    else return r.values();
  };
  compare(p, library + ".bfs.primal", [&] { return bfs(l, v, l.num_verts()); }, [&] { return concino::bfs(m, v); }, values);
  compare(p, library + ".bfs.dual", [&] { return bfs(l, q, l.num_polys()); }, [&] { return concino::bfs(m, q); }, values);
  compare(p, library + ".components.primal", [&] { return components<vert>(l, l.num_verts(), [&](std::size_t i) { return l.vert_at(i); }); },
          [&] { return concino::connected_components(m); }, values);
  compare(p, library + ".components.dual", [&] { return components<poly>(l, l.num_polys(), [&](std::size_t i) { return l.poly_at(i); }); },
          [&] { return concino::connected_components(concino::dual(m)); }, values);
  compare(p, library + ".dijkstra.primal", [&] { return dijkstra(l, v, l.num_verts(), [&](vert w) { return l.at(w); }); },
          [&] { return concino::dijkstra(m, v); }, values);
  compare(p, library + ".dijkstra.dual", [&] {
            const auto c = centres(l);
            return dijkstra(l, q, l.num_polys(), [&](poly w) { return c[l.index(w)]; });
          },
          [&] { return concino::dijkstra(m, q); }, values);
  const auto entries = [](const Eigen::SparseMatrix<double>& a) { return std::vector<double>(a.valuePtr(), a.valuePtr() + a.nonZeros()); };
  if (const std::string work = "overhead." + library + ".laplacian"; p.wants(work)) {
    const auto hand = [&] { return laplacian(l); };
    const auto ours = [&] { return concino::laplacian(m, concino::cotangent); };
    expect_equal(work, entries(hand()), entries(ours()));
    p.print(bench::compare(work, p.rounds,
                           {{"by-hand", [&] { return seconds_of(hand); }}, {"concino", [&] { return seconds_of(ours); }}}));
  }
}

/// Measures a harmonic map. Use a smaller mesh, since solving takes long.
template<class L, class M>
void compare_harmonic(const program& p, const std::string& library, const L& l, const M& m) {
  const std::vector<std::pair<typename L::vert, double>> given = {{l.vert_at(0), 0.0}, {l.vert_at(l.num_verts() - 1), 1.0}};
  compare(p, library + ".harmonic", [&] { return harmonic_map(l); },
          [&] { return concino::harmonic_map(m, given, concino::cotangent); }, [](const auto& u) { return u.values(); });
}

}  // namespace bench::by_hand
