// Bodies of affine_heat.hpp: heat flow of tangent vectors, and of positions seen from each vert, over a surface of
// triangles.
#pragma once

#include <concino/fields/detail/heat/affine_heat.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace concino::detail {

/// The cotangent of the angle opposite to side s.
inline double opposite_cotangent(const core::unfolded_triangles& t, int s) {
  const auto& p = t.apex[static_cast<std::size_t>(core::unfolded_triangles::previous(s))];
  return p.x / p.y;
}

inline transport_edge transport_along(const core::unfolded_triangles& t, const std::vector<core::tangent_frame>& frames,
                                      int s) {
  constexpr double smallest_weight = 0.01;  // heat also flows along edges whose cotangents sum to less
  const int far = core::unfolded_triangles::next(s), twin = t.twin[static_cast<std::size_t>(s)];
  const double weight = 0.5 * (opposite_cotangent(t, s) + (twin == s ? 0 : opposite_cotangent(t, twin)));
  transport_edge e{t.start(s), t.end(s), std::max(weight, smallest_weight), {}, {}, 1, 0, false};
  const core::tangent_frame &frame_a = frames[static_cast<std::size_t>(e.a)],
                            &frame_b = frames[static_cast<std::size_t>(e.b)];
  e.reflects = frame_a.is_oriented_as_triangle(t, s) != frame_b.is_oriented_as_triangle(t, far);
  const double length = t.length[static_cast<std::size_t>(s)];
  const double at_a = frame_a.angle_of(t.fan_angle(s, 0)),
               at_b = frame_b.angle_of(t.fan_angle(far, t.angle[static_cast<std::size_t>(far)]));
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

/// For each vert its edges to verts with larger numbers, in their order.
struct edges_below {
  struct entry {
    int row, edge;
  };
  std::vector<std::size_t> first;
  std::vector<entry> entries;

  explicit edges_below(const affine_heat& h) : first(h.size() + 1), entries(h.edges.size()) {
    for (const transport_edge& e : h.edges) ++first[static_cast<std::size_t>(std::min(e.a, e.b)) + 1];
    for (std::size_t v = 0; v < h.size(); ++v) first[v + 1] += first[v];
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for (std::size_t k = 0; k < h.edges.size(); ++k) {
      const transport_edge& e = h.edges[k];
      entries[next[static_cast<std::size_t>(std::min(e.a, e.b))]++] = {std::max(e.a, e.b), static_cast<int>(k)};
    }
    for (std::size_t v = 0; v < h.size(); ++v)
      std::sort(entries.begin() + static_cast<std::ptrdiff_t>(first[v]),
                entries.begin() + static_cast<std::ptrdiff_t>(first[v + 1]),
                [](const entry& x, const entry& y) { return x.row < y.row; });
  }
};

/// Appends entries column by column. Two entries that follow each other in the same place are added.
class column_writer {
  Eigen::SparseMatrix<double> a_;
  int count_ = 0, column_ = 0;

 public:
  column_writer(int size, std::size_t entries) : a_(size, size) {
    a_.resizeNonZeros(static_cast<Eigen::Index>(entries));
  }

  void begin_column() { a_.outerIndexPtr()[column_++] = count_; }
  void add(int row, double value) {
    if (count_ > a_.outerIndexPtr()[column_ - 1] && a_.innerIndexPtr()[count_ - 1] == row) {
      a_.valuePtr()[count_ - 1] += value;
      return;
    }
    a_.innerIndexPtr()[count_] = row;
    a_.valuePtr()[count_++] = value;
  }
  void finish_into(Eigen::SparseMatrix<double>& to) {
    a_.outerIndexPtr()[column_] = count_;
    a_.resizeNonZeros(count_);
    to.swap(a_);
  }
};

/// Whether several edges join the same verts, next to each other in the list.
inline bool is_followed_by_same(const edges_below& below, std::size_t k, std::size_t end) {
  return k + 1 < end && below.entries[k + 1].row == below.entries[k].row;
}

/// The masses plus the time times the Laplacian, of numbers and of vectors.
inline void assemble_heat(affine_heat& h) {
  const auto n = static_cast<int>(h.size());
  std::vector<double> diagonal = h.mass;
  for (const transport_edge& e : h.edges) {
    diagonal[static_cast<std::size_t>(e.a)] += h.time * e.weight;
    diagonal[static_cast<std::size_t>(e.b)] += h.time * e.weight;
  }
  const edges_below below(h);
  column_writer scalars(n, h.size() + h.edges.size()), vectors(2 * n, 2 * h.size() + 4 * h.edges.size());
  for (int c = 0; c < n; ++c) {
    const std::size_t begin = below.first[static_cast<std::size_t>(c)],
                      end = below.first[static_cast<std::size_t>(c) + 1];
    scalars.begin_column();
    scalars.add(c, diagonal[static_cast<std::size_t>(c)]);
    for (std::size_t k = begin; k < end; ++k)
      scalars.add(below.entries[k].row, -h.time * h.edges[static_cast<std::size_t>(below.entries[k].edge)].weight);
    for (const int part : {0, 1}) {
      vectors.begin_column();
      vectors.add(2 * c + part, diagonal[static_cast<std::size_t>(c)]);
      for (std::size_t k = begin; k < end; ++k) {
        tangent_vector sum;
        const int row = below.entries[k].row;
        for (bool more = true; more; k += more) {
          const transport_edge& e = h.edges[static_cast<std::size_t>(below.entries[k].edge)];
          const tangent_vector axis(1 - part, part), turned = e.a == row ? e.to_a(axis) : e.to_b(axis);
          sum = sum + (-h.time * e.weight) * turned;
          more = is_followed_by_same(below, k, end);
        }
        vectors.add(2 * row, sum.x);
        vectors.add(2 * row + 1, sum.y);
      }
    }
  }
  scalars.finish_into(h.scalars);
  vectors.finish_into(h.vectors);
}

CONCINO_INLINE affine_heat make_affine_heat(const core::unfolded_triangles& t,
                                            const std::vector<core::tangent_frame>& frames, double time) {
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
  assemble_heat(h);
  return h;
}

}  // namespace concino::detail
