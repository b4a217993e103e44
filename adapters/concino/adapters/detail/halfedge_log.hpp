// A log of what verts, half-edges, polys and points were before edits of a mesh of another library. The struct K
// of halfedge_edge_plan.hpp and halfedge_rewire.hpp also has:
//
//   using point = ..., points = ...;                                  // `points` finds a point fast
//   static points find_points(mesh&);                           static point& point_of(mesh&, points, unsigned v);
//   static unsigned num_verts(const mesh&), num_polys(const mesh&);   // index bounds, as num_edges
//   static void resize(mesh&, unsigned verts, unsigned edges, unsigned polys);
//   static bool is_removed_vert(const mesh&, unsigned), is_removed_edge(...), is_removed_poly(...);
//   // Removed ones, in the order of their removal, are elements again. May add an element of each kind, which resize()
//   removes. static void revive(mesh&, removed_elements verts, removed_elements edges, removed_elements polys);
//   static bool set_recycling(mesh&, bool);                           // whether indices of removed elements are used
//   again; returns what was set before
#pragma once

#include <concino/adapters/detail/halfedge_rewire.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace concino::detail {

struct halfedge_bounds {
  unsigned verts = 0, edges = 0, polys = 0;
};
using removed_elements = id_span<unsigned>;

/// The state of elements and points before steps, each of which is an edit.
template<class K>
class halfedge_log {
  enum class kind : unsigned char { vert, halfedge, poly };
  struct row {
    kind what;
    unsigned index, a, b, c;  // vert: half-edge; half-edge: next, target, poly; poly: half-edge
  };
  struct moved_point {
    unsigned vert;
    typename K::point at;
  };
  struct step {
    std::size_t rows, points, verts, edges, polys;  // where its entries begin
    halfedge_bounds bounds;
  };
  using mesh = typename K::mesh;
  using points = typename K::points;

  std::vector<row> rows_;
  std::vector<moved_point> points_;
  std::vector<unsigned> removed_verts_, removed_edges_, removed_polys_;
  std::vector<step> steps_;

  template<class T>
  static void make_room(std::vector<T>& v, std::size_t n) {
    if (v.capacity() - v.size() < n) v.reserve(std::max(v.size() + n, 2 * v.size()));
  }
  static removed_elements from(const std::vector<unsigned>& v, std::size_t first) {
    return {v.data() + first, v.data() + v.size()};
  }
  static halfedge_bounds bounds_of(const mesh& m) { return {K::num_verts(m), K::num_edges(m), K::num_polys(m)}; }

  static void write(mesh& m, const row& r) {
    if (r.what == kind::vert) K::set_halfedge_from(m, r.index, r.a);
    else if (r.what == kind::poly) K::set_halfedge_of(m, r.index, r.a);
    else K::set_next(m, r.index, r.a), K::set_target(m, r.index, r.b), K::set_poly(m, r.index, r.c);
  }
  void restore(mesh& m, points p, const step& s) const noexcept {
    K::revive(m, from(removed_verts_, s.verts), from(removed_edges_, s.edges), from(removed_polys_, s.polys));
    for (std::size_t i = rows_.size(); i > s.rows; --i) write(m, rows_[i - 1]);
    for (std::size_t i = points_.size(); i > s.points; --i) K::point_of(m, p, points_[i - 1].vert) = points_[i - 1].at;
    K::resize(m, s.bounds.verts, s.bounds.edges, s.bounds.polys);  // rows of later steps may refer to elements that are
                                                                   // added by earlier ones
  }
  static bool is_removed(const mesh& m, kind k, unsigned i) {
    return k == kind::vert   ? K::is_removed_vert(m, i)
           : k == kind::poly ? K::is_removed_poly(m, i)
                             : K::is_removed_edge(m, i >> 1);
  }
  void save(const mesh& m, kind k, unsigned i) {
    if (k == kind::vert) rows_.push_back({k, i, K::halfedge_from(m, i), 0, 0});
    else if (k == kind::poly) rows_.push_back({k, i, K::halfedge_of(m, i), 0, 0});
    else rows_.push_back({k, i, K::next(m, i), K::target(m, i), K::poly_of(m, i)});
  }

 public:
  std::size_t num_steps() const { return steps_.size(); }

  /// Begins a step that saves and removes at most so many elements.
  void begin_step(const mesh& m, std::size_t num_rows, std::size_t num_points, std::size_t verts, std::size_t edges,
                  std::size_t polys) {
    make_room(rows_, num_rows), make_room(points_, num_points);
    make_room(removed_verts_, verts), make_room(removed_edges_, edges), make_room(removed_polys_, polys);
    make_room(steps_, 1);
    steps_.push_back({rows_.size(), points_.size(), removed_verts_.size(), removed_edges_.size(), removed_polys_.size(),
                      bounds_of(m)});
  }
  void save_vert(const mesh& m, unsigned v) { save(m, kind::vert, v); }
  void save_halfedge(const mesh& m, unsigned h) { save(m, kind::halfedge, h); }
  void save_poly(const mesh& m, unsigned p) { save(m, kind::poly, p); }
  void save_point(mesh& m, points p, unsigned v) { points_.push_back({v, K::point_of(m, p, v)}); }
  void add_removed_vert(unsigned v) { removed_verts_.push_back(v); }
  void add_removed_edge(unsigned e) { removed_edges_.push_back(e); }
  void add_removed_poly(unsigned p) { removed_polys_.push_back(p); }

  void roll_back(mesh& m, points p, std::size_t to_step) noexcept {
    if (to_step == steps_.size()) return;
    const step s = steps_[to_step];
    restore(m, p, s);
    rows_.resize(s.rows), removed_verts_.resize(s.verts), removed_edges_.resize(s.edges),
        removed_polys_.resize(s.polys), steps_.resize(to_step);
    points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(s.points), points_.end());
  }
  /// Restores the state before the first step, and keeps the log.
  void restore_before(mesh& m, points p) const noexcept {
    if (!steps_.empty()) restore(m, p, steps_[0]);
  }

  /// A log of the state of m now, from the state before the first step.
  halfedge_log of_changes(mesh& m, points p) const {
    halfedge_log after;
    after.steps_.push_back({0, 0, 0, 0, 0, bounds_of(m)});
    if (steps_.empty()) return after;
    const auto save = [&](kind k, unsigned i) {
      if (!is_removed(m, k, i)) after.save(m, k, i);
    };
    for (const row& r : rows_) save(r.what, r.index);
    const halfedge_bounds &before = steps_[0].bounds, now = bounds_of(m);
    for (unsigned v = before.verts; v < now.verts; ++v) save(kind::vert, v), after.save_point(m, p, v);
    for (unsigned h = 2 * before.edges; h < 2 * now.edges; ++h) save(kind::halfedge, h);
    for (unsigned q = before.polys; q < now.polys; ++q) save(kind::poly, q);
    for (const moved_point& x : points_) after.save_point(m, p, x.vert);
    after.removed_verts_ = removed_verts_, after.removed_edges_ = removed_edges_, after.removed_polys_ = removed_polys_;
    return after;
  }
  /// Restores the state that such a log describes.
  void restore_after(mesh& m, points p) const {
    const halfedge_bounds &b = steps_[0].bounds, now = bounds_of(m);
    K::reserve(m, b.verts - now.verts, b.edges - now.edges, b.polys - now.polys, false);
    K::resize(m, b.verts, b.edges, b.polys);
    for (const row& r : rows_) write(m, r);
    for (const moved_point& x : points_) K::point_of(m, p, x.vert) = x.at;
    for (const unsigned e : removed_edges_) K::remove_edge(m, e);
    for (const unsigned q : removed_polys_) K::remove_poly(m, q);
    for (const unsigned v : removed_verts_) K::remove_vert(m, v);
  }
};

}  // namespace concino::detail
