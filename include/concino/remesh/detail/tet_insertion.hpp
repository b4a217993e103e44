// Insertion of a vert that improves tets: a few tets around a bad one are replaced by those that join the new vert to
// their outer faces. Splits of tets, faces and edges are the smallest cases.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/core/small_array.hpp>
#include <concino/edit/simplex_cavity.hpp>
#include <concino/remesh/detail/improvable_tets.hpp>

#include <algorithm>

namespace concino::detail {

template<class M>
class tet_insertion {
  static constexpr unsigned max_tets = 40;

  /// An outer face of the cavity, opposite to a corner of one of its tets.
  struct outer_face {
    face_t<M> face;
    unsigned tet, place;
    double quality;  // of the tet that joins it to the new vert
  };
  struct old_tet {
    poly_t<M> poly;
    tet_corners<M> corners;
  };

  improvable_tets<M>& tets_;
  core::small_array<old_tet, max_tets + 12> old_;
  core::small_array<outer_face, 128> faces_;
  double before_ = 1;  // the least quality of the old tets
  vec3 x_;

  void clear() {
    old_.clear(), faces_.clear();
    before_ = 1;
  }
  void add(const poly_t<M>& p, const tet_corners<M>& t) {
    const M& m = tets_.mesh;
    const auto k = static_cast<unsigned>(old_.size());
    old_.push_back({p, t});
    before_ = std::min(before_, tets_.quality(t));
    for (const face_t<M> f : adj_p2f(m, p)) {
      std::size_t i = 0;
      while (i < faces_.size() && !(faces_[i].face == f)) ++i;
      if (i < faces_.size()) {  // it lies inside now
        faces_[i] = faces_.back();
        faces_.resize(faces_.size() - 1, faces_.back());
        continue;
      }
      unsigned place = 6;  // the sum of all places
      for (const vert_t<M> v : adj_f2v(m, f)) place -= t.place_of(v);
      faces_.push_back({f, k, place, tets_.quality(t, place, x_)});
    }
  }

  const outer_face& worst_face() const {
    return *std::min_element(faces_.begin(), faces_.end(),
                             [](const outer_face& a, const outer_face& b) { return a.quality < b.quality; });
  }

  /// Begins with p, or with all tets at an edge of it.
  void begin(const poly_t<M>& p, const edge_t<M>* e) {
    clear();
    if (!e) return add(p, tets_.corners(p));
    for (const poly_t<M> q : adj_e2p(tets_.mesh, *e))
      if (old_.size() < max_tets) add(q, tets_.corners(q));
  }

  /// Adds the tet behind the worst outer face as long as this helps; then goes back to the best cavity.
  void grow(const poly_t<M>& p, const edge_t<M>* e) {
    begin(p, e);
    std::size_t best_size = old_.size();
    double best = worst_face().quality;
    while (old_.size() < max_tets) {
      const outer_face f = worst_face();
      if (tets_.fixed.has(tets_.mesh, f.face)) break;
      bool has_grown = false;
      for (const poly_t<M> q : adj_f2p(tets_.mesh, f.face))
        if (!(q == old_[f.tet].poly)) {
          add(q, tets_.corners(q));
          has_grown = true;
          break;
        }
      if (!has_grown || faces_.empty()) break;
      if (const double q = worst_face().quality; q > best) best = q, best_size = old_.size();
    }
    if (best_size == old_.size() && !faces_.empty()) return;
    core::small_array<old_tet, max_tets + 12> kept;
    for (std::size_t i = 0; i < best_size; ++i) kept.push_back(old_[i]);
    clear();
    for (const old_tet& t : kept) add(t.poly, t.corners);
  }

  void read_faces(moving_vert& vert) const {
    vert.clear();
    for (const outer_face& f : faces_) tets_.add_face(vert, old_[f.tet].corners, f.place);
  }

  /// Whether the outer faces are one sphere that has all verts of the old tets.
  bool is_sphere() const {
    core::small_array<vert_t<M>, 64> of_tets, of_faces;
    core::small_array<edge_t<M>, 256> edges_of_faces;
    const auto add_to = [](auto& list, const auto& x) {
      for (const auto& y : list)
        if (y == x) return;
      list.push_back(x);
    };
    for (const old_tet& t : old_)
      for (const vert_t<M>& v : t.corners.verts) add_to(of_tets, v);
    const M& m = tets_.mesh;
    core::small_array<unsigned, 256> uses, part_of_edge, parts;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      parts.push_back(static_cast<unsigned>(i));
      for (const vert_t<M> v : adj_f2v(m, faces_[i].face)) add_to(of_faces, v);
      for (const edge_t<M> e : adj_f2e(m, faces_[i].face)) {
        std::size_t k = 0;
        while (k < edges_of_faces.size() && !(edges_of_faces[k] == e)) ++k;
        if (k == edges_of_faces.size()) {
          edges_of_faces.push_back(e), uses.push_back(1), part_of_edge.push_back(static_cast<unsigned>(i));
          continue;
        }
        if (++uses[k] > 2) return false;
        const unsigned from = parts[i], to = parts[part_of_edge[k]];
        for (unsigned& x : parts)
          if (x == from) x = to;
      }
    }
    for (const unsigned n : uses)
      if (n != 2) return false;
    for (const unsigned x : parts)
      if (x != parts[0]) return false;
    return of_faces.size() == of_tets.size() && of_faces.size() + faces_.size() == edges_of_faces.size() + 2;
  }

  /// The new vert takes its values from the edge of the first tet that is nearest.
  vert_origin origin_of_point(simplex_cavity<M>& c) const {
    const tet_corners<M>& t = old_[0].corners;
    vert_origin nearest{};
    double least = 0;
    for (unsigned i = 0; i < 4; ++i)
      for (unsigned k = 0; k < i; ++k) {
        const vec3 a = tets_.at(t.verts[k]), d = tets_.at(t.verts[i]) - a;
        const double squared = dot(d, d), at = squared > 0 ? std::clamp(dot(x_ - a, d) / squared, 0.0, 1.0) : 0,
                     far = norm(a + at * d - x_);
        if ((i == 1 && k == 0) || far < least) least = far, nearest = {c.vert(t.verts[k]), c.vert(t.verts[i]), at};
      }
    return nearest;
  }

  void apply() {
    simplex_cavity<M> c(tets_.mesh);
    for (const old_tet& t : old_) c.add_old(t.poly);
    c.add_point(tets_.to_mesh(x_), origin_of_point(c));
    for (const outer_face& f : faces_) c.add_new(f.tet, c.vert(old_[f.tet].corners.verts[f.place]), c.added);
    c.keep(std::min(old_.size(), faces_.size()));
    c.apply(tets_.mesh);
    tets_.mark_around(c.new_vert());
  }

  bool try_at(const vec3& x, const poly_t<M>& p, const edge_t<M>* e) {
    x_ = x;
    moving_vert vert;
    for (unsigned pass = 0; pass < 2; ++pass) {
      grow(p, e);
      if (faces_.empty()) return false;
      read_faces(vert);
      const double q = vert.maximise(x_);
      if (!(q > -1) || !is_better(q, before_) || !is_sphere()) continue;  // inverted tets are no improvement
      apply();
      return true;
    }
    return false;
  }

 public:
  explicit tet_insertion(improvable_tets<M>& tets) : tets_(tets) {}

  /// Inserts a vert near p if this improves the worst of the tets that it replaces.
  bool improve(const poly_t<M>& p) {
    const tet_corners<M> t = tets_.corners(p);
    vec3 sum;
    for (const vert_t<M>& v : t.verts) sum += tets_.at(v);
    if (try_at(0.25 * sum, p, nullptr)) return true;
    for (const edge_t<M> e : adj_p2e(tets_.mesh, p)) {
      if (tets_.fixed.has(tets_.mesh, e)) continue;
      const auto ends = end_verts(tets_.mesh, e);
      if (try_at(0.5 * (tets_.at(ends.first) + tets_.at(ends.second)), p, &e)) return true;
    }
    return false;
  }
};

}  // namespace concino::detail
