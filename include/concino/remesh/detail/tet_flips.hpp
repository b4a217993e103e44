// Flips that improve tets: of a face with its two tets (2-3), and of an edge with any number of tets around it, which
// become two for each triangle of the best triangulation of the polygon around the edge.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/edit/connected_verts.hpp>
#include <concino/edit/simplex_cavity.hpp>
#include <concino/remesh/detail/improvable_tets.hpp>

#include <array>

namespace concino::detail {

template<class M>
class tet_flips {
  static constexpr unsigned max_ring = 9;
  using triangle = std::array<unsigned, 3>;

  /// The tets around an edge: (a, b, verts[i], verts[i + 1]) is polys[i].
  struct ring {
    vert_t<M> a, b, verts[max_ring];
    poly_t<M> polys[max_ring];
    unsigned size = 0;
    double quality = 1;  // the least one
    triangle triangles[max_ring];  // those that improve it
  };
  struct face_pair {
    poly_t<M> polys[2];
    tet_corners<M> first;
    unsigned place = 0;  // of the vert of the first that is opposite to the face
    vert_t<M> opposite;  // of the second
  };

  improvable_tets<M>& tets_;
  ring ring_, best_ring_;
  face_pair pair_, best_pair_;

  /// Whether (a, b, c, d) is an even permutation of t.
  static bool is_even(const tet_corners<M>& t, const vert_t<M>& a, const vert_t<M>& b, const vert_t<M>& c) {
    static constexpr bool even[4][4][4] = {{{}, {0, 0, 1, 0}, {0, 0, 0, 1}, {0, 1, 0, 0}},
                                           {{0, 0, 0, 1}, {}, {1, 0, 0, 0}, {0, 0, 1, 0}},
                                           {{0, 1, 0, 0}, {0, 0, 0, 1}, {}, {1, 0, 0, 0}},
                                           {{0, 0, 1, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {}}};
    return even[t.place_of(a)][t.place_of(b)][t.place_of(c)];
  }

  /// Reads the tets around e; false if they are too many or not a closed ring of tets that run in the same direction.
  bool read_ring(const edge_t<M>& e) {
    ring& r = ring_;
    const auto ends = end_verts(tets_.mesh, e);
    r.a = ends.first, r.b = ends.second, r.size = 0, r.quality = 1;
    poly_t<M> polys[max_ring];
    vert_t<M> from[max_ring], to[max_ring];
    for (const poly_t<M> p : adj_e2p(tets_.mesh, e)) {
      if (r.size == max_ring) return false;
      const tet_corners<M> t = tets_.corners(p);
      vert_t<M> two[2];
      unsigned n = 0;
      for (const vert_t<M>& v : t.verts)
        if (v != r.a && v != r.b && n < 2) two[n++] = v;
      if (n != 2) return false;
      const bool is_forward = is_even(t, r.a, r.b, two[0]);
      polys[r.size] = p, from[r.size] = two[!is_forward], to[r.size] = two[is_forward];
      r.quality = std::min(r.quality, tets_.quality(t));
      ++r.size;
    }
    if (r.size < 3) return false;
    vert_t<M> next = from[0];
    for (unsigned k = 0; k < r.size; ++k) {
      unsigned i = 0;
      while (i < r.size && from[i] != next) ++i;
      if (i == r.size || (k > 0 && i == 0)) return false;
      r.verts[k] = next, r.polys[k] = polys[i], next = to[i];
    }
    return next == r.verts[0];
  }

  /// The quality of the best triangulation of the ring, which it writes; if it is at most `threshold`, some value up to
  /// `threshold`.
  double triangulate_ring(double threshold) {
    ring& r = ring_;
    const unsigned n = r.size;
    vec3 x[max_ring];
    for (unsigned i = 0; i < n; ++i) x[i] = tets_.at(r.verts[i]);
    const vec3 a = tets_.at(r.a), b = tets_.at(r.b);
    double best[max_ring][max_ring];  // of the part of the polygon between two verts
    unsigned between[max_ring][max_ring];
    for (unsigned i = 0; i + 1 < n; ++i) best[i][i + 1] = 1;
    for (unsigned length = 2; length < n; ++length)
      for (unsigned i = 0; i + length < n; ++i) {
        const unsigned k = i + length;
        best[i][k] = -3, between[i][k] = i + 1;
        for (unsigned j = i + 1; j < k; ++j) {
          double q = std::min(best[i][j], best[j][k]);
          if (q <= threshold || q <= best[i][k]) continue;
          q = std::min({q, tet_quality(a, x[i], x[j], x[k]), tet_quality(b, x[i], x[k], x[j])});
          if (q > best[i][k]) best[i][k] = q, between[i][k] = j;
        }
      }
    if (best[0][n - 1] <= threshold) return best[0][n - 1];
    unsigned made = 0;
    std::array<unsigned, 2> open[max_ring] = {{0, n - 1}};
    for (unsigned depth = 1; depth > 0;) {
      const auto [i, k] = open[--depth];
      const unsigned j = between[i][k];
      r.triangles[made++] = {i, j, k};
      if (j > i + 1) open[depth++] = {i, j};
      if (k > j + 1) open[depth++] = {j, k};
    }
    return best[0][n - 1];
  }

  bool is_new_face_or_edge(const ring& r) const {
    const M& m = tets_.mesh;
    if (r.size == 3) return !are_joined(m, r.verts[0], r.verts[1], r.verts[2]);
    for (unsigned k = 0; k + 2 < r.size; ++k) {
      const auto [a, b, c] = r.triangles[k];
      for (const auto& [i, j] : {std::array{a, b}, std::array{b, c}, std::array{a, c}}) {
        const unsigned apart = j - i;
        if (apart > 1 && apart + 1 < r.size && are_joined(m, r.verts[i], r.verts[j])) return false;
      }
    }
    return true;
  }

  bool apply_ring() {
    const ring& r = best_ring_;
    if (!is_new_face_or_edge(r)) return false;
    simplex_cavity<M> c(tets_.mesh);
    for (unsigned i = 0; i < r.size; ++i) c.add_old(r.polys[i]);
    const unsigned a = c.vert(r.a), b = c.vert(r.b);
    for (unsigned k = 0; k + 2 < r.size; ++k) {
      unsigned v[3];
      for (unsigned i = 0; i < 3; ++i) v[i] = c.vert(r.verts[r.triangles[k][i]]);
      const unsigned below[] = {a, v[0], v[1], v[2]}, above[] = {b, v[0], v[2], v[1]};
      c.add_new(below, 0);
      c.add_new(above, 0);
    }
    c.keep(std::min(r.size, 2 * (r.size - 2)));
    c.mix_origins();
    c.apply(tets_.mesh);
    tets_.mark(r.a), tets_.mark(r.b);
    for (unsigned i = 0; i < r.size; ++i) tets_.mark(r.verts[i]);
    return true;
  }

  /// Reads the two tets at f, the first of which is p.
  bool read_pair(const poly_t<M>& p, const tet_corners<M>& t, const face_t<M>& f) {
    const M& m = tets_.mesh;
    unsigned n = 0;
    for (const poly_t<M> x : adj_f2p(m, f))
      if (x != p) pair_.polys[1] = x, ++n;
    if (n != 1) return false;
    pair_.polys[0] = p, pair_.first = t;
    const tet_corners<M> second = tets_.corners(pair_.polys[1]);
    unsigned found = 0;
    for (unsigned i = 0; i < 4; ++i) {
      if (!second.has(t.verts[i])) pair_.place = i, ++found;
      if (!t.has(second.verts[i])) pair_.opposite = second.verts[i];
    }
    if (found != 1) return false;
    tet_corners<M> reversed = second;  // with the vert of the first: it runs in the other direction
    reversed.verts[second.place_of(pair_.opposite)] = t.verts[pair_.place];
    return !is_even(t, reversed.verts[0], reversed.verts[1], reversed.verts[2]);
  }

  double quality_of_pair(double threshold) const {
    const vec3 x = tets_.at(pair_.opposite);
    double q = 1;
    for (unsigned i = 0; i < 4 && q > threshold; ++i)
      if (i != pair_.place) q = std::min(q, tets_.quality(pair_.first, i, x));
    return q;
  }

  bool apply_pair() {
    const face_pair& f = best_pair_;
    const vert_t<M> first = f.first.verts[f.place];
    if (are_joined(tets_.mesh, first, f.opposite)) return false;
    simplex_cavity<M> c(tets_.mesh);
    c.add_old(f.polys[0]);
    c.add_old(f.polys[1]);
    const unsigned by = c.vert(f.opposite);
    for (unsigned i = 0; i < 4; ++i)
      if (i != f.place) c.add_new(0, c.vert(f.first.verts[i]), by);
    c.keep(2);
    c.mix_origins();
    c.apply(tets_.mesh);
    for (const vert_t<M>& v : f.first.verts) tets_.mark(v);
    tets_.mark(f.opposite);
    return true;
  }

 public:
  explicit tet_flips(improvable_tets<M>& tets) : tets_(tets) {}

  /// Makes the flip at a face or an edge of p that is best for the worst of the tets that it replaces.
  bool improve(const poly_t<M>& p) {
    const M& m = tets_.mesh;
    const tet_corners<M> t = tets_.corners(p);
    const double now = tets_.quality(t);
    double best = now;
    bool is_ring = false, is_pair = false;
    for (const edge_t<M> e : adj_p2e(m, p)) {
      if (tets_.fixed.has(m, e) || !read_ring(e)) continue;
      if (const double q = triangulate_ring(best); q > best && is_better(q, ring_.quality))
        best = q, best_ring_ = ring_, is_ring = true;
    }
    for (const face_t<M> f : adj_p2f(m, p)) {
      if (tets_.fixed.has(m, f) || !read_pair(p, t, f)) continue;
      const double before = std::min(now, tets_.quality(pair_.polys[1]));
      if (const double q = quality_of_pair(best); q > best && is_better(q, before))
        best = q, best_pair_ = pair_, is_pair = true;
    }
    return is_pair ? apply_pair() : is_ring && apply_ring();
  }
};

}  // namespace concino::detail
