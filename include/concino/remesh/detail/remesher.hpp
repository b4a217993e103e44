// One round of remeshing: splits of long edges, collapses of short ones, flips towards regular verts, and verts that
// move over the surface.
//
// All lengths and points are unit points. A split keeps the points of the surface. Verts on lines stay where they are;
// a collapse on a line keeps one of its ends, so that all verts of a line lie on that of the input.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/core/small_array.hpp>
#include <concino/edit/edge_collapse.hpp>
#include <concino/edit/edge_flip.hpp>
#include <concino/edit/edge_split.hpp>
#include <concino/remesh/detail/flat_triangles.hpp>
#include <concino/remesh/detail/flip_weights.hpp>
#include <concino/remesh/detail/sized_surface.hpp>

#include <algorithm>
#include <vector>

namespace concino::detail {

template<class M>
class remesher : sized_surface<M> {
  using surface = sized_surface<M>;
  using surface::at, surface::direction, surface::follows_input, surface::has_good_length, surface::has_long_edge,
      surface::lines, surface::longest, surface::nearest, surface::normal_at;
  using surface::points_of, surface::ratio, surface::set, surface::shortest, surface::size_at, surface::turns,
      surface::vector_area, surface::would_break;
  using triangle = typename surface::triangle;

  M& m_;

  /// Which verts an edge and its neighbours on lines join, seen from v.
  void add_verts_of_lines(const vert_t<M>& v, core::small_array<vert_t<M>, 8>& found) const {
    for (const edge_t<M> e : adj_v2e(m_, v)) {
      if (!lines.has(m_, e)) continue;
      const auto ends = end_verts(m_, e);
      found.push_back(ends.first == v ? ends.second : ends.first);
    }
  }

  bool try_collapse(const edge_t<M>& e) {
    const auto [a, b] = end_verts(m_, e);
    const auto of_a = lines.freedom(m_, a), of_b = lines.freedom(m_, b);
    const bool is_on_line = lines.has(m_, e), a_is_on_line = of_a != vert_freedom::surface,
               b_is_on_line = of_b != vert_freedom::surface;
    if (a_is_on_line && b_is_on_line && (!is_on_line || (of_a == vert_freedom::none && of_b == vert_freedom::none)))
      return false;
    // the end that may move less remains; of two on a line the first
    const bool keeps_a = a_is_on_line && of_a >= of_b, keeps_b = b_is_on_line && !keeps_a;
    const double t = keeps_a ? 0 : keeps_b ? 1 : 0.5;
    const vec3 x = keeps_a ? at(a) : keeps_b ? at(b) : 0.5 * (at(a) + at(b));
    const double size = (1 - t) * size_at(a) + t * size_at(b);
    const vec3 normal = keeps_a ? normal_at(a) : keeps_b ? normal_at(b) : direction(normal_at(a) + normal_at(b));
    const double limit = allows_longer ? 1.45 : longest;
    if (has_long_edge(a, x, size, limit) || has_long_edge(b, x, size, limit)) return false;
    if (would_break(a, x, normal, b) || would_break(b, x, normal, a)) return false;
    core::small_array<vert_t<M>, 8> on_lines;
    add_verts_of_lines(a, on_lines);
    add_verts_of_lines(b, on_lines);
    if (is_on_line)  // two lines that would become one
      for (std::size_t i = 0; i < on_lines.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          if (on_lines[i] == on_lines[j]) return false;
    const auto r = edge_collapse(m_, e, {.at = t, .only_simplices = true});
    if (!r) return false;
    lines.set(m_, r.vert, std::max(of_a, of_b));
    set(r.vert, size, normal);
    for (const edge_t<M> f : adj_v2e(m_, r.vert)) {
      const auto ends = end_verts(m_, f);
      const vert_t<M> other = ends.first == r.vert ? ends.second : ends.first;
      bool has = false;
      for (std::size_t i = 0; i < on_lines.size(); ++i) has = has || on_lines[i] == other;
      lines.set(m_, f, has);
    }
    return true;
  }

  bool try_flip(const edge_t<M>& e) {
    if (lines.has(m_, e)) return false;
    const auto [a, b] = end_verts(m_, e);
    vert_t<M> opposite[2];
    vec3 sum;
    unsigned k = 0;
    for (const poly_t<M> p : adj_e2p(m_, e)) {
      triangle t;
      if (k == 2 || !points_of(p, t)) return false;
      const vec3 area = vector_area(t);
      sum += area;
      for (const vert_t<M> v : adj_p2v(m_, p))
        if (v != a && v != b) opposite[k] = v;
      ++k;
    }
    if (k != 2) return false;
    const auto [c, d] = opposite;
    const int now = irregularity(m_, a, 0) + irregularity(m_, b, 0) + irregularity(m_, c, 0) + irregularity(m_, d, 0);
    const vec3 xa = at(a), xb = at(b), xc = at(c), xd = at(d);
    const int then = irregularity(m_, a, -1) + irregularity(m_, b, -1) + irregularity(m_, c, 1) +
                     irregularity(m_, d, 1) + weight_of_shape(xa, xc, xd) + weight_of_shape(xb, xc, xd);
    const int shapes_now = weight_of_shape(xa, xb, xc) + weight_of_shape(xa, xb, xd);
    if (then + weight_of_length(has_good_length(ratio(c, d))) >=
        now + shapes_now + weight_of_length(has_good_length(ratio(e))))
      return false;
    const vec3 first = cross(xc - xa, xd - xa), second = cross(xd - xb, xc - xb);  // of equal orientation
    const bool is_reversed = dot(first, sum) < 0;
    const double sign = is_reversed ? -1 : 1;
    if (turns(sum, sign * first) || turns(sum, sign * second)) return false;
    const auto follows = [&](const vert_t<M>& x, const vert_t<M>& y, const vert_t<M>& z) {
      return follows_input({at(x), at(y), at(z)}, {normal_at(x), normal_at(y), normal_at(z)}, size_at(x));
    };
    if (is_reversed ? !follows(a, d, c) || !follows(b, c, d) : !follows(a, c, d) || !follows(b, d, c)) return false;
    const auto r = edge_flip(m_, e);
    if (r) lines.set(m_, r.edge, false);
    return bool(r);
  }

  /// Where v shall move: to the mean of the triangles at it within the tangent plane, and from there to the input.
  surface_sizes::sample wanted_sample(const vert_t<M>& v, bool tangential) const {
    vec3 x = at(v), area, mean;
    if (tangential) {
      double weights = 0;
      for (const poly_t<M> p : adj_v2p(m_, v)) {
        triangle t;
        if (!points_of(p, t)) return {at(v), normal_at(v), size_at(v)};
        const vec3 n = vector_area(t);
        double size = 0;
        for (const vert_t<M> w : adj_p2v(m_, p)) size += size_at(w);
        const double weight = norm(n) / (size * size);
        area += n;
        mean += weight / 3 * (t[0] + t[1] + t[2]);
        weights += weight;
      }
      const double length = norm(area);
      if (weights > 0 && length > 0) {
        const vec3 n = area / length, step = mean / weights - x;
        x += step - dot(step, n) * n;
      }
    }
    return nearest(x);
  }

 public:
  using surface::num_wanted;
  bool allows_longer = false;  // collapses may make edges that are a little too long: helps where all edges are too
                               // short to stay and too long to collapse
  std::size_t num_splits = 0, num_collapses = 0, num_flips = 0;

  /// is_named: see feature_lines.
  template<class F>
  remesher(M& m, const unit_points& unit, const surface_sizes& input, const F& is_named)
      : surface(m, unit, input, is_named), m_(m) {}

  /// What comes before the first round: flat triangles vanish, and sharp edges become lines. Normals of flat triangles
  /// say nothing about edges.
  void begin(const unit_points& unit, double feature_angle_deg) {
    flat_triangle_remover<M> flat(m_, unit, lines);
    flat.remove_all([this](const vec3& x) { return nearest(x).size; });
    num_splits += flat.num_splits, num_collapses += flat.num_collapses, num_flips += flat.num_flips;
    if (num_splits + num_collapses + num_flips > 0) this->find_places();
    this->add_sharp_lines(feature_angle_deg);
  }

  void split_long_edges() {
    using entry = std::pair<double, edge_t<M>>;
    const auto is_shorter = [](const entry& a, const entry& b) { return a.first < b.first; };
    std::vector<entry> found;
    for (const edge_t<M> e : edges(m_))
      if (const double x = ratio(e); x > longest) found.emplace_back(x, e);
    std::make_heap(found.begin(), found.end(), is_shorter);
    while (!found.empty()) {
      std::pop_heap(found.begin(), found.end(), is_shorter);
      const auto [x, e] = found.back();
      found.pop_back();
      if (!contains(m_, e) || ratio(e) != x) continue;  // it was split since
      const auto [a, b] = end_verts(m_, e);
      const bool is_on_line = lines.has(m_, e);
      const double size = 0.5 * (size_at(a) + size_at(b));
      const vec3 normal = direction(normal_at(a) + normal_at(b));
      const auto r = edge_split(m_, e, 0.5, {.only_simplices = true});
      if (!r) continue;
      ++num_splits;
      lines.split(m_, is_on_line, r.vert, a, b);
      set(r.vert, size, normal);
      for (const edge_t<M> f : adj_v2e(m_, r.vert))
        if (const double y = ratio(f); y > longest) {
          found.emplace_back(y, f);
          std::push_heap(found.begin(), found.end(), is_shorter);
        }
    }
  }

  void collapse_short_edges() {
    std::vector<std::pair<double, edge_t<M>>> found;
    for (const edge_t<M> e : edges(m_))
      if (const double x = ratio(e); x < shortest) found.emplace_back(x, e);
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [x, e] : found)
      if (contains(m_, e) && ratio(e) < shortest) num_collapses += try_collapse(e);
  }

  void flip_edges() {
    std::vector<edge_t<M>> all;
    for (const edge_t<M> e : edges(m_)) all.push_back(e);
    for (const edge_t<M>& e : all)
      if (contains(m_, e)) num_flips += try_flip(e);
  }

  void move_verts() {
    std::vector<vert_t<M>> moving;
    for (const vert_t<M> v : verts(m_))
      if (lines.freedom(m_, v) == vert_freedom::surface) moving.push_back(v);
    std::vector<surface_sizes::sample> places(moving.size());
    parallel_for(moving.size(), [&](std::size_t i) { places[i] = wanted_sample(moving[i], true); }, 256);
    for (std::size_t i = 0; i < moving.size(); ++i) {
      const vert_t<M>& v = moving[i];
      const auto is_possible = [&] { return !would_break(v, places[i].point, places[i].normal, v); };
      if (!is_possible()) {
        places[i] = wanted_sample(v, false);
        if (!is_possible()) continue;
      }
      set_point(m_, v, this->to_mesh(places[i].point));
      set(v, places[i]);
    }
  }

  /// The part of the edges off lines whose lengths are within a factor of 4/3 of what they shall be.
  double share_of_lengths() const {
    std::size_t all = 0, good = 0;
    for (const edge_t<M> e : edges(m_)) {
      if (lines.has(m_, e)) continue;
      const double x = ratio(e);
      ++all, good += has_good_length(x);
    }
    return all == 0 ? 1 : static_cast<double>(good) / static_cast<double>(all);
  }
};

}  // namespace concino::detail
