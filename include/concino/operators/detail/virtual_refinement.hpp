// The stiffness of one poly by virtual refinement: that of the triangles or tets around a virtual vert inside, whose
// value is a mean of the poly's values.
#pragma once

#include <concino/operators/corner_gradients.hpp>
#include <concino/operators/detail/simplex_weights.hpp>
#include <concino/operators/discretisation.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace concino::detail {

/// A sum of squares (x - c) . A (x - c), stored as its matrix and A c.
struct sum_of_squares {
  vec3 row[3];
  vec3 right;

  /// Adds the square of d . (x - c).
  void add(const vec3& d, const vec3& c) {
    for (std::size_t k = 0; k < 3; ++k) row[k] += d[k] * d;
    right += dot(d, c) * d;
  }

  /// The x that minimises the sum. Components in directions in which it does not grow, to 6 digits of a length, are 0.
  vec3 minimum() const {
    vec3 a[3] = {row[0], row[1], row[2]}, b = right, x;
    std::size_t order[3] = {0, 1, 2}, rank = 0;
    double largest = 0;
    for (; rank < 3; ++rank) {  // Gaussian elimination; the pivot is the largest diagonal entry
      for (std::size_t k = rank + 1; k < 3; ++k)
        if (a[order[k]][order[k]] > a[order[rank]][order[rank]]) std::swap(order[k], order[rank]);
      const std::size_t pivot = order[rank];
      if (rank == 0) largest = a[pivot][pivot];
      if (!(a[pivot][pivot] > 1e-12 * largest)) break;
      for (std::size_t k = rank + 1; k < 3; ++k) {
        const double factor = a[order[k]][pivot] / a[pivot][pivot];
        a[order[k]] -= factor * a[pivot];
        b[order[k]] -= factor * b[pivot];
      }
    }
    while (rank-- > 0) {
      const std::size_t pivot = order[rank];
      x[pivot] = (b[pivot] - dot(a[pivot], x)) / a[pivot][pivot];  // x[pivot] is still 0
    }
    return x;
  }
};

/// Fills in the positive semidefinite matrix P^T K P of one poly. The virtual vert of a polygon is the mean of its
/// verts that minimises the sum of the squared areas of the triangles to the edges. Of the weights that give this
/// point, it uses those with the smallest sum of squares. Polyhedra have such a vert in each face that is no triangle,
/// and one inside that minimises the squared volumes of the tets to the triangles on its faces. K is the cotangent
/// matrix of these triangles or tets; P computes the values at virtual verts. A triangle or tet has no virtual vert.
/// Needs:  EmbeddedMesh.      Cost: O(n^2) for a polygon of n verts, O(n^3) for a polyhedron; allocates only for the
///         largest poly.
/// Errors: invalid_mesh if the poly has no area or volume or a point is not finite; unsupported if it is not
///         star-shaped about its virtual vert: a virtual triangle or tet then has no measure, or is oriented opposite
///         to the poly.
/// Source: Bunge, Herholz, Kazhdan, Botsch 2020, "Polygon Laplacian made simple".
template<EmbeddedMesh M>
class virtual_refinement_element {
  static constexpr int dimension = dimension_v<M>;
  static constexpr std::size_t corners = static_cast<std::size_t>(dimension) + 1;

  const M& m_;
  std::vector<vec3> points_;                            // of verts, then of virtual verts, relative to the first
  std::vector<std::size_t> around_, support_, first_;  // first_[k]: where in support_ the verts begin whose mean is
                                                       // virtual vert k
  std::vector<double> weight_;                         // and their weights
  std::vector<std::array<std::size_t, 3>> triangles_;  // on the boundary of a polyhedron, oriented outward
  std::vector<std::array<std::size_t, corners>> simplices_;
  std::vector<double> measure_;                        // of each simplex, times 2 or 6, positive if oriented like the
                                                       // poly
  std::vector<std::size_t> slot_;                      // for polys of many verts

  [[noreturn, gnu::noinline, gnu::cold]] void throw_not_star_shaped(const poly_t<M>& p) const {
    core::throw_joined<unsupported>({"Laplacian by virtual refinement: poly ", index_of(m_, p),
                               " is not star-shaped about its virtual vert; use virtual_elements, or split the poly"});
  }

  /// Adds the virtual vert: the mean of the verts in `around_` that is nearest to the minimum of the energy.
  template<class MakeEnergy>
  std::size_t add_virtual(const MakeEnergy& make_energy) {
    vec3 mean;
    for (const std::size_t i : around_) mean += points_[i];
    mean /= static_cast<double>(around_.size());
    sum_of_squares scatter = {};
    for (const std::size_t i : around_) scatter.add(points_[i] - mean, {});
    scatter.right = make_energy(mean).minimum();
    const vec3 slope = scatter.minimum();  // the weights with smallest squares for these sums are linear in position
    vec3 x;
    for (const std::size_t i : around_) {
      const double w = 1 / static_cast<double>(around_.size()) + dot(slope, points_[i] - mean);
      support_.push_back(i);
      weight_.push_back(w);
      x += w * points_[i];
    }
    first_.push_back(support_.size());
    points_.push_back(x);
    return points_.size() - 1;
  }

  /// The virtual vert of the polygon with the corners `around_`.
  std::size_t add_within_polygon() {
    return add_virtual([&](const vec3& mean) {
      sum_of_squares areas;
      for (std::size_t i = 0; i < around_.size(); ++i) {
        const vec3 a = points_[around_[i]] - mean, d = points_[around_[i + 1 < around_.size() ? i + 1 : 0]] - mean - a;
        // |d x (x - a)|^2 is the sum of the squares of its three coordinates
        areas.add({0, -d.z, d.y}, a);
        areas.add({d.z, 0, -d.x}, a);
        areas.add({-d.y, d.x, 0}, a);
      }
      return areas;
    });
  }

  void read_corners(const poly_t<M>& p, std::vector<vert_t<M>>& verts) {
    verts.clear();
    points_.clear();
    support_.clear();
    first_.assign(1, 0);
    weight_.clear();
    simplices_.clear();
    for (const vert_t<M> v : adj_p2v(m_, p)) {
      verts.push_back(v);
      points_.push_back(to_vec3(point(m_, v)));
    }
    if (points_.empty()) return;
    const vec3 origin = points_[0];
    for (vec3& x : points_) x -= origin;
  }

  void split(const poly_t<M>& p, const std::vector<vert_t<M>>& verts) {
    const std::size_t n = verts.size();
    if (n == corners) {
      simplices_.emplace_back();
      for (std::size_t i = 0; i < n; ++i) simplices_[0][i] = i;
      return;
    }
    if constexpr (SurfaceMesh<M>) {  // polygons are refined into triangles, polyhedra into tets
      around_.clear();
      for (std::size_t i = 0; i < n; ++i) around_.push_back(i);
      const std::size_t within = add_within_polygon();
      for (std::size_t i = 0; i < n; ++i) simplices_.push_back({within, i, i + 1 < n ? i + 1 : 0});
    } else {
      const bool by_table = n > 32;
      if (by_table) {
        slot_.resize(vert_index_bound(m_));
        for (std::size_t i = 0; i < n; ++i) slot_[index_of(m_, verts[i])] = i;
      }
      triangles_.clear();
      for (const face_t<M> f : adj_p2f(m_, p)) {
        around_.clear();
        for (const vert_t<M> v : adj_f2v(m_, f)) {
          std::size_t i = 0;
          if (by_table) i = slot_[index_of(m_, v)];
          else while (i < n && !(verts[i] == v)) ++i;
          around_.push_back(i);
        }
        const std::size_t k = around_.size();
        const bool outward = face_is_outward(m_, p, f);
        const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
          triangles_.push_back({a, outward ? b : c, outward ? c : b});
        };
        if (k == 3) {
          add(around_[0], around_[1], around_[2]);
          continue;
        }
        const std::size_t within = add_within_polygon();
        for (std::size_t i = 0; i < k; ++i) add(within, around_[i], around_[i + 1 < k ? i + 1 : 0]);
      }
      around_.clear();
      for (std::size_t i = 0; i < n; ++i) around_.push_back(i);
      const std::size_t within = add_virtual([&](const vec3& mean) {
        sum_of_squares volumes;
        for (const auto& [a, b, c] : triangles_)
          volumes.add(cross(points_[b] - points_[a], points_[c] - points_[a]), points_[a] - mean);
        return volumes;
      });
      for (const auto& [a, b, c] : triangles_) simplices_.push_back({within, a, b, c});
    }
  }

  /// Checks that every simplex has a positive part of the measure of the poly.
  void check(const poly_t<M>& p) {
    measure_.clear();
    double whole = 0;
    if constexpr (SurfaceMesh<M>) {  // triangles share a normal, tets have a sign
      vec3 sum;
      const auto normal = [&](const auto& s) {
        return cross(points_[s[1]] - points_[s[0]], points_[s[2]] - points_[s[0]]);
      };
      for (const auto& s : simplices_) sum += normal(s);
      whole = norm(sum);
      const vec3 direction = sum / whole;
      for (const auto& s : simplices_) measure_.push_back(dot(normal(s), direction));
    } else {
      for (const auto& [o, a, b, c] : simplices_) {
        measure_.push_back(dot(cross(points_[a] - points_[o], points_[b] - points_[o]), points_[c] - points_[o]));
        whole += measure_.back();
      }
      if (whole < 0)  // inverted, like all its parts
        for (double& x : measure_) x = -x;
      whole = std::abs(whole);
    }
    if (!(std::isfinite(whole) && whole > 0)) throw_no_measure("Laplacian by virtual refinement", m_, p);
    for (const double x : measure_)
      if (!(x > 1e-14 * whole)) throw_not_star_shaped(p);  // smaller values are rounding errors
  }

 public:
  explicit virtual_refinement_element(const M& m) : m_(m) {}

  void operator()(const poly_t<M>& p, local_matrix<vert_t<M>>& out) {
    read_corners(p, out.verts);
    const std::size_t n = points_.size();
    if (n < corners) throw_no_measure("Laplacian by virtual refinement", m_, p);
    split(p, out.verts);
    check(p);
    // of the virtual verts too, until they are eliminated
    out.entries.assign(points_.size() * (points_.size() + 1) / 2, 0.0);
    for (const auto& s : simplices_) {
      std::array<vec3, corners> x;
      for (std::size_t i = 0; i < corners; ++i) x[i] = points_[s[i]];
      const simplex_weights<dimension> weight(x);
      for (std::size_t i = 0; i < corners; ++i)
        for (std::size_t j = 0; j < corners; ++j)
          if (s[j] <= s[i]) out.at(s[i], s[j]) -= weight(i, j);
    }
    // Expresses virtual verts by those before them, the last one first.
    for (std::size_t k = points_.size(); k-- > n;) {
      const std::size_t begin = first_[k - n], end = first_[k - n + 1];
      for (std::size_t a = begin; a < end; ++a) {
        const std::size_t i = support_[a];
        const double w = weight_[a];
        for (std::size_t j = 0; j < k; ++j) out.at(j > i ? j : i, j > i ? i : j) += (j == i ? 2 : 1) * w * out.at(k, j);
        for (std::size_t b = begin; b < end; ++b)
          if (support_[b] <= i) out.at(i, support_[b]) += w * weight_[b] * out.at(k, k);
      }
    }
    out.entries.resize(n * (n + 1) / 2);
  }
};

}  // namespace concino::detail
