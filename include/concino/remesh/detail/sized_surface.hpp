// A surface while it is remeshed: the sizes at its verts, its feature lines, and whether changes keep it near the
// input.
//
// All lengths and points are unit points.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/remesh/detail/feature_lines.hpp>
#include <concino/remesh/detail/surface_sizes.hpp>
#include <concino/remesh/detail/unit_points.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace concino::detail {

template<class M>
class sized_surface {
  static constexpr double min_cosine = 0.5;  // between the normals of triangles before and after a change
  static constexpr double max_offset = 0.3;  // between triangles and the input, as a multiple of the wanted length

  const M& m_;
  const unit_points& unit_;
  const surface_sizes& input_;
  struct vert_data {
    double size = 0;  // the length of the edges there
    vec3 normal;      // of the input; zero on lines and where it is not known
  };
  std::vector<vert_data> verts_;  // by index

 public:
  static constexpr double longest = 4.0 / 3, shortest = 4.0 / 5;  // of the wanted length, for edges that remain
  static bool has_good_length(double ratio) { return ratio >= 0.75 && ratio <= longest; }
  using triangle = std::array<vec3, 3>;

  feature_lines<M> lines;

  /// is_named: see feature_lines. Sharp edges become lines later.
  template<class F>
  sized_surface(const M& m, const unit_points& unit, const surface_sizes& input, const F& is_named)
      : m_(m), unit_(unit), input_(input), verts_(vert_index_bound(m)), lines(m, 180, is_named) {
    find_places();
  }
  void find_places() {
    for (const vert_t<M> v : verts(m_)) set(v, nearest(at(v)));
  }
  void add_sharp_lines(double feature_angle_deg) {
    lines =
        feature_lines<M>(m_, feature_angle_deg, [kept = lines, this](const edge_t<M>& e) { return kept.has(m_, e); });
    for (const vert_t<M> v : verts(m_)) set(v, size_at(v), normal_at(v));
  }

  vec3 at(const vert_t<M>& v) const { return unit_.at(m_, v); }
  double size_at(const vert_t<M>& v) const { return verts_[index_of(m_, v)].size; }
  const vec3& normal_at(const vert_t<M>& v) const { return verts_[index_of(m_, v)].normal; }
  void set(const vert_t<M>& v, double size, vec3 normal) {
    const std::size_t i = index_of(m_, v);
    if (i >= verts_.size()) verts_.resize(std::max(i + 1, 2 * verts_.size()));
    verts_[i] = {size, lines.freedom(m_, v) == vert_freedom::surface ? normal : vec3{}};
  }
  void set(const vert_t<M>& v, const surface_sizes::sample& x) { set(v, x.size, x.normal); }
  vec3 to_mesh(const vec3& x) const { return unit_.to_mesh(x); }
  surface_sizes::sample nearest(const vec3& x) const { return input_.nearest(x); }
  /// The length of an edge, as a multiple of that which it shall have.
  double ratio(const vert_t<M>& a, const vert_t<M>& b) const {
    return distance(at(a), at(b)) / (0.5 * (size_at(a) + size_at(b)));
  }
  double ratio(const edge_t<M>& e) const {
    const auto ends = end_verts(m_, e);
    return ratio(ends.first, ends.second);
  }

  /// About how many triangles have edges of these lengths. A triangle without area is cut at its longest edge.
  double num_wanted() const {
    double sum = 0;
    for (const poly_t<M> p : polys(m_)) {
      triangle t;
      if (!points_of(p, t)) continue;
      double size = 0;
      for (const vert_t<M> v : adj_p2v(m_, p)) size += size_at(v) / 3;
      const double by_area = norm(vector_area(t)) / size * (2 / std::sqrt(3.0)) / size;
      const double by_length = std::max({distance(t[0], t[1]), distance(t[1], t[2]), distance(t[2], t[0])}) / size;
      sum += std::max(by_area, by_length);
    }
    return sum;
  }

  static vec3 vector_area(const triangle& t) { return cross(t[1] - t[0], t[2] - t[0]); }
  static vec3 direction(const vec3& x) { return norm(x) > 0 ? x / norm(x) : vec3{}; }
  static bool turns(const vec3& before, const vec3& after) {
    return !(dot(before, after) > min_cosine * norm(before) * norm(after));
  }

  /// The points of a triangle; false for other polys.
  bool points_of(const poly_t<M>& p, triangle& t) const {
    std::size_t n = 0;
    for (const vert_t<M> v : adj_p2v(m_, p)) {
      if (n == 3) return false;
      t[n++] = at(v);
    }
    return n == 3;
  }
  /// Whether a triangle lies as the input does at its corners, and near it.
  bool follows_input(const triangle& t, const std::array<vec3, 3>& normals, double size) const {
    const vec3 area = vector_area(t);
    const double length = norm(area);
    bool is_near = true;  // where the normals are about those of the input, the distances are small
    for (const vec3& n : normals) {
      const double cosine = dot(area, n);
      if (dot(n, n) > 0 && !(cosine > 0)) return false;
      is_near = is_near && cosine > 0.8 * length;
    }
    if (is_near) return true;
    for (const vec3& x : {(t[0] + t[1] + t[2]) / 3, 0.5 * (t[0] + t[1]), 0.5 * (t[1] + t[2]), 0.5 * (t[2] + t[0])})
      if (input_.distance_to(x) > max_offset * size) return false;
    return true;
  }

  /// Whether a triangle at v would turn, or leave the input, if v moved to x, where the input has this normal; those
  /// that have `without` do not count, as they vanish.
  bool would_break(const vert_t<M>& v, const vec3& x, const vec3& normal, const vert_t<M>& without) const {
    for (const poly_t<M> p : adj_v2p(m_, v)) {
      triangle before, after;
      std::array<vec3, 3> normals_before, normals_after;
      std::size_t n = 0;
      bool vanishes = false;
      for (const vert_t<M> w : adj_p2v(m_, p)) {
        if (n == 3) return true;
        vanishes = vanishes || (w == without && w != v);
        before[n] = at(w), normals_before[n] = normal_at(w);
        after[n] = w == v ? x : before[n], normals_after[n] = w == v ? normal : normals_before[n];
        ++n;
      }
      if (n != 3) return true;
      const vec3 area = vector_area(before);
      if (vanishes || !(norm(area) > 0)) continue;
      if (turns(area, vector_area(after))) return true;
      // what is wrong already may stay so
      if (!follows_input(after, normals_after, size_at(v)) && follows_input(before, normals_before, size_at(v)))
        return true;
    }
    return false;
  }

  /// Whether an edge of v would be longer than this, as a multiple of the wanted length, if v moved to x.
  bool has_long_edge(const vert_t<M>& v, const vec3& x, double size, double limit) const {
    for (const vert_t<M> w : adj_v2v(m_, v))
      if (distance(x, at(w)) > limit * 0.5 * (size + size_at(w))) return true;
    return false;
  }
};

}  // namespace concino::detail
