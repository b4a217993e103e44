// The corners of all polys of a mesh: a vert and its neighbours in one poly, two in surfaces, three in volumes, and the
// shape that this corner has in a regular poly. All verts are numbered in the order of verts(m).
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/core/small_array.hpp>
#include <concino/core/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace concino::detail {

/// The matrix that maps the ideal corner to a corner with points x[0], its tip, and x[1] ... has the columns s[j] = sum
/// of weights[i][j] x[i].
struct ideal_corner {
  std::array<unsigned, 3> face_sizes;
  std::array<std::array<double, 3>, 4> weights;
};

/// The inverse of the lower triangular matrix whose rows are the edges of the ideal corner, of unit length, with the
/// angles of regular polygons between them.
inline ideal_corner ideal_corner_of(const std::array<unsigned, 3>& face_sizes, unsigned dimension) {
  double angle[3], sum = 0;
  for (unsigned i = 0; i < 3; ++i)
    angle[i] = std::numbers::pi * (1 - 2.0 / std::max(face_sizes[i], 3u)), sum += angle[i];
  // three large polygons have no convex corner: smaller angles, in proportion
  if (dimension == 3 && sum > 1.85 * std::numbers::pi)
    for (double& x : angle) x *= 1.85 * std::numbers::pi / sum;
  const double ab = std::cos(angle[0]), bc = std::cos(angle[1]), ca = std::cos(angle[2]), sine = std::sqrt(1 - ab * ab);
  double edge[3][3] = {{1, 0, 0}, {ab, sine, 0}, {ca, (bc - ca * ab) / sine, 0}};
  edge[2][2] = std::sqrt(std::max(1 - edge[2][0] * edge[2][0] - edge[2][1] * edge[2][1], 0.01));
  ideal_corner c{face_sizes, {}};
  for (unsigned j = 0; j < dimension; ++j) {  // column j of the inverse of the transposed
    double x[3] = {};
    for (unsigned i = dimension; i-- > 0;) {
      x[i] = i == j ? 1 : 0;
      for (unsigned k = i + 1; k < dimension; ++k) x[i] -= edge[k][i] * x[k];
      x[i] /= edge[i][i];
    }
    for (unsigned i = 0; i < dimension; ++i) c.weights[i + 1][j] = x[i], c.weights[0][j] -= x[i];
  }
  return c;
}

struct corner_frame {
  unsigned verts[4];  // the tip, and its neighbours; in volumes counter-clockwise seen from outside
  unsigned ideal;
  bool is_of_general_poly;  // with more verts than a quad or a hex: a reflex corner is no mistake there
};

template<class M>
class corner_frames {
  static constexpr unsigned few_verts = dimension_v<M> == 2 ? 4 : 8;

  std::vector<std::size_t> first_;  // by vert
  std::vector<unsigned> at_;
  std::vector<std::size_t> end_of_poly_;  // by number of the poly: behind the last of its frames
  core::small_array<std::array<unsigned, 3>, 64> of_faces_;  // the corners of the faces of one poly: vert before, vert,
                                                             // vert after
  core::small_array<unsigned, 64> sizes_;

  unsigned ideal(const std::array<unsigned, 3>& face_sizes) {
    for (std::size_t i = 0; i < ideals.size(); ++i)
      if (ideals[i].face_sizes == face_sizes) return static_cast<unsigned>(i);
    ideals.push_back(ideal_corner_of(face_sizes, dimension_v<M>));
    return static_cast<unsigned>(ideals.size() - 1);
  }

  template<class Range>
  void read_cycle(const M& m, const Range& cycle, const std::vector<unsigned>& number, bool is_reversed) {
    core::small_array<unsigned, 16> v;
    for (const vert_t<M> x : cycle) v.push_back(number[index_of(m, x)]);
    if (is_reversed) std::reverse(v.begin(), v.end());
    const auto n = static_cast<unsigned>(v.size());
    for (unsigned i = 0; i < n; ++i) {
      of_faces_.push_back({v[(i + n - 1) % n], v[i], v[(i + 1) % n]});
      sizes_.push_back(n);
    }
  }

  /// The corner of a cell at the tip of corner k of its faces, if three of its faces are there. All three find it; the
  /// first one adds it.
  bool add_corner_of_cell(unsigned k) {
    const auto [before, tip, after] = of_faces_[k];
    unsigned found = 0, second = k, third = k;
    for (unsigned i = 0; i < of_faces_.size(); ++i) {
      if (of_faces_[i][1] != tip) continue;
      if (i < k) return false;
      ++found;
      if (of_faces_[i][0] == after) second = i;
      if (of_faces_[i][2] == before) third = i;
    }
    if (found != 3 || second == k || third == k || second == third || of_faces_[second][2] != of_faces_[third][0])
      return false;
    frames.push_back(
        {{tip, before, after, of_faces_[second][2]}, ideal({sizes_[k], sizes_[second], sizes_[third]}), false});
    return true;
  }

  void read_poly(const M& m, const poly_t<M>& p, const std::vector<unsigned>& number) {
    of_faces_.clear(), sizes_.clear();
    const std::size_t begin = frames.size();
    if constexpr (dimension_v<M> == 2) {  // a poly is its only cycle
      read_cycle(m, adj_p2v(m, p), number, false);
      for (std::size_t k = 0; k < of_faces_.size(); ++k) {
        const auto [before, tip, after] = of_faces_[k];
        frames.push_back({{tip, after, before, 0}, ideal({sizes_[k], 0, 0}), false});
        if (of_faces_.size() == 3) break;  // all corners of a simplex have the same matrix, up to rotations
      }
    } else {
      for (const face_t<M> f : adj_p2f(m, p)) read_cycle(m, adj_f2v(m, f), number, !face_is_outward(m, p, f));
      for (unsigned k = 0; k < of_faces_.size(); ++k)
        if (add_corner_of_cell(k) && of_faces_.size() == 12) break;
    }
    if (num_elements(adj_p2v(m, p)) > few_verts)
      for (std::size_t i = begin; i < frames.size(); ++i) frames[i].is_of_general_poly = true;
  }

 public:
  std::vector<corner_frame> frames;
  std::vector<ideal_corner> ideals;

  explicit corner_frames(const M& m) {
    std::vector<unsigned> number(vert_index_bound(m));
    unsigned n = 0;
    for (const vert_t<M> v : verts(m)) number[index_of(m, v)] = n++;
    end_of_poly_.reserve(num_polys(m));
    for (const poly_t<M> p : polys(m)) read_poly(m, p, number), end_of_poly_.push_back(frames.size());
    first_.assign(n + 1, 0);
    for (const corner_frame& f : frames)
      for (unsigned i = 0; i <= dimension_v<M>; ++i) ++first_[f.verts[i] + 1];
    for (unsigned v = 0; v < n; ++v) first_[v + 1] += first_[v];
    at_.resize(first_[n]);
    std::vector<std::size_t> end(first_.begin(), first_.end() - 1);
    for (unsigned k = 0; k < frames.size(); ++k)
      for (unsigned i = 0; i <= dimension_v<M>; ++i) at_[end[frames[k].verts[i]]++] = k;
  }

  /// Pointers to the numbers of the frames that have vert number v; place(k) tells all of them apart.
  const unsigned* begin(unsigned v) const { return at_.data() + first_[v]; }
  const unsigned* end(unsigned v) const { return at_.data() + first_[v + 1]; }
  std::size_t place(const unsigned* k) const { return static_cast<std::size_t>(k - at_.data()); }
  /// The number, in polys(m), of the poly of a frame.
  unsigned poly_of(unsigned frame) const {
    const auto at = std::upper_bound(end_of_poly_.begin(), end_of_poly_.end(), frame);
    return static_cast<unsigned>(at - end_of_poly_.begin());
  }
  std::size_t num_places() const { return at_.size(); }
};

}  // namespace concino::detail
