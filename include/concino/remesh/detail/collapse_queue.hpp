// The edges of a surface in the order in which a decimation collapses them.
#pragma once

#include <concino/edit/edge_collapse.hpp>
#include <concino/edit/invariants.hpp>
#include <concino/geometry/normals.hpp>
#include <concino/remesh/detail/quadric.hpp>
#include <concino/remesh/detail/unit_points.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace concino::detail {

struct quadric_options {
  double feature_angle_deg, boundary_weight;
  bool memoryless;
};

/// The quadrics of all verts and a heap of edges by cost. All points are unit points.
template<class M>
class collapse_queue {
  struct entry {
    double cost;
    edge_t<M> edge;
    std::uint32_t a, b;    // indices of its ends, the smaller one first
    std::uint32_t stamps;  // the sum of their stamps; it changes with each of them

    /// The least cost comes first. Equal ones come in an order that does not depend on that of the edges.
    bool operator<(const entry& other) const {
      if (cost != other.cost) return cost > other.cost;
      return a != other.a ? a > other.a : b > other.b;
    }
  };
  static constexpr double shape_weight = 1e-10;  // prefers short edges where the surface is flat

  quadric_options options_;
  double feature_cosine_;
  unit_points unit_;
  std::vector<quadric> quadrics_;
  std::vector<std::uint32_t> stamps_;  // of verts; they grow with each change
  static constexpr std::uint32_t removed_stamp = 1u << 31;
  std::vector<entry> heap_, refused_;
  permission last_refusal_{refusal::link_condition, "there is no edge"};
  bool any_since_refused_ = false;

  vec3 unit_point(const M& m, const vert_t<M>& v) const { return unit_.at(m, v); }

  /// The normal of a triangle, times twice its area.
  vec3 vector_area(const M& m, const poly_t<M>& p) const {
    vec3 x[3];
    std::size_t n = 0;
    for (const vert_t<M> v : adj_p2v(m, p)) {
      if (n == 3) return {};  // it stays, as its edges do
      x[n++] = unit_point(m, v);
    }
    return n == 3 ? cross(x[1] - x[0], x[2] - x[0]) : vec3{};
  }
  quadric quadric_of(const M& m, const poly_t<M>& p) const {
    const vec3 n = vector_area(m, p);
    const double length = norm(n);
    if (!(length > 0)) return {};
    return quadric(n / length, unit_point(m, *adj_p2v(m, p).begin()), length / 6);
  }
  /// Planes through e and orthogonal to its polys, if it is held in place.
  quadric quadric_of(const M& m, const edge_t<M>& e) const {
    vec3 normals[2];
    unsigned n = 0;
    for (const poly_t<M> p : adj_e2p(m, e)) {
      const vec3 area = vector_area(m, p);
      if (n < 2) normals[n] = norm(area) > 0 ? area / norm(area) : vec3{};
      ++n;
    }
    if (n == 2 && dot(normals[0], normals[1]) >= feature_cosine_) return {};
    const auto ends = end_verts(m, e);
    const vec3 a = unit_point(m, ends.first), along = unit_point(m, ends.second) - a;
    quadric q;
    for (unsigned k = 0; k < std::min(n, 2u); ++k) {
      const vec3 across = cross(along, normals[k]);
      if (norm(across) > 0) q += quadric(across / norm(across), a, options_.boundary_weight * dot(along, along));
    }
    return q;
  }
  void compute_quadric(const M& m, const vert_t<M>& v) {
    quadric q;
    for (const poly_t<M> p : adj_v2p(m, v)) q += quadric_of(m, p);
    for (const edge_t<M> e : adj_v2e(m, v)) q += quadric_of(m, e);
    quadrics_[index_of(m, v)] = q;
  }

  quadric sum_at(std::size_t a, std::size_t b) const {
    quadric q = quadrics_[a];
    return q += quadrics_[b];
  }
  /// Where the vert of an edge from a to b shall lie. An end that is clearly better is an end of a crease that is too
  /// shallow for min_near.
  vec3 best_point(const quadric& q, const vec3& a, const vec3& b) const {
    const vec3 x = q.min_near(0.5 * (a + b));
    const double cost = 0.5 * q(x), at_a = q(a), at_b = q(b);
    if (at_a < cost && at_a <= at_b) return a;
    return at_b < cost ? b : x;
  }

  entry entry_of(const M& m, const edge_t<M>& e) const {
    const auto ends = end_verts(m, e);
    const auto a = static_cast<std::uint32_t>(index_of(m, ends.first)),
               b = static_cast<std::uint32_t>(index_of(m, ends.second));
    const vec3 x = unit_point(m, ends.first), y = unit_point(m, ends.second);
    const quadric q = sum_at(a, b);
    return {q(best_point(q, x, y)) + shape_weight * q.trace() * dot(x - y, x - y), e, std::min(a, b), std::max(a, b),
            stamps_[a] + stamps_[b]};
  }
  bool is_current(const entry& x) const {
    return stamps_[x.a] + stamps_[x.b] == x.stamps && !((stamps_[x.a] | stamps_[x.b]) & removed_stamp);
  }
  void push(const M& m, const edge_t<M>& e) {
    heap_.push_back(entry_of(m, e));
    std::push_heap(heap_.begin(), heap_.end());
  }
  /// Edges that were refused are tried again once other edges were collapsed. Returns false if there are none to try.
  bool refill() {
    if (!any_since_refused_) return false;
    any_since_refused_ = false;
    for (const entry& x : refused_)
      if (is_current(x)) heap_.push_back(x);
    refused_.clear();
    std::make_heap(heap_.begin(), heap_.end());
    return !heap_.empty();
  }

  /// After a collapse, a is what remains.
  void update(const M& m, const vert_t<M>& a, std::size_t removed) {
    const std::size_t i = index_of(m, a);
    if (!options_.memoryless) quadrics_[i] += quadrics_[removed];
    stamps_[removed] |= removed_stamp;
    ++stamps_[i];
    if (options_.memoryless) {
      compute_quadric(m, a);
      for (const vert_t<M> v : adj_v2v(m, a)) {
        compute_quadric(m, v);
        ++stamps_[index_of(m, v)];
      }
      for (const vert_t<M> v : adj_v2v(m, a))
        for (const edge_t<M> e : adj_v2e(m, v)) push(m, e);
    } else {
      for (const edge_t<M> e : adj_v2e(m, a)) push(m, e);
    }
  }

 public:
  collapse_queue(const M& m, const quadric_options& options)
      : options_(options),
        feature_cosine_(
            options.feature_angle_deg >= 180 ? -2 : std::cos(options.feature_angle_deg * std::numbers::pi / 180)),
        unit_(m, "decimate"), quadrics_(vert_index_bound(m)), stamps_(vert_index_bound(m)) {
    for (const poly_t<M> p : polys(m)) {
      const quadric q = quadric_of(m, p);
      for (const vert_t<M> v : adj_p2v(m, p)) quadrics_[index_of(m, v)] += q;
    }
    for (const edge_t<M> e : edges(m)) {
      const quadric q = quadric_of(m, e);
      if (q.trace() == 0) continue;
      const auto ends = end_verts(m, e);
      quadrics_[index_of(m, ends.first)] += q;
      quadrics_[index_of(m, ends.second)] += q;
    }
    heap_.reserve(num_edges(m));
    for (const edge_t<M> e : edges(m)) heap_.push_back(entry_of(m, e));
    std::make_heap(heap_.begin(), heap_.end());
  }

  /// Collapses the edge of least cost that can be. Returns the last refusal if there is none.
  permission collapse_next(M& m, edge_collapse_options& options) {
    while (!heap_.empty() || refill()) {
      std::pop_heap(heap_.begin(), heap_.end());
      const entry x = heap_.back();
      heap_.pop_back();
      if (!is_current(x)) continue;
      const auto ends = end_verts(m, x.edge);
      const vec3 a = unit_point(m, ends.first), b = unit_point(m, ends.second);
      const vec3 at = best_point(sum_at(x.a, x.b), a, b);
      const double along = dot(at - a, b - a), whole = dot(b - a, b - a);
      options.at = along > 0 && whole > 0 ? std::min(along / whole, 1.0) : 0;
      options.point = unit_.to_mesh(at);
      const vert_result<M> r = edge_collapse(m, x.edge, options);
      if (!r) {
        last_refusal_ = r;
        refused_.push_back(x);
        continue;
      }
      any_since_refused_ = true;
      update(m, r.vert, index_of(m, r.vert) == x.a ? x.b : x.a);
      return {};
    }
    return last_refusal_;
  }
};

}  // namespace concino::detail
