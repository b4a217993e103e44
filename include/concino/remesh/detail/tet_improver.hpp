// Rounds of tet improvement: flips and moves of verts for all bad tets, then collapses and new verts for those that are
// left.
#pragma once

#include <concino/edit/edge_collapse.hpp>
#include <concino/remesh/detail/tet_flips.hpp>
#include <concino/remesh/detail/tet_insertion.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace concino::detail {

template<class M>
class tet_improver {
  improvable_tets<M>& tets_;
  tet_flips<M> flips_;
  tet_insertion<M> insertion_;
  moving_vert surroundings_;
  double target_;
  std::vector<unsigned> moved_;  // by index of the vert: the round in which it was moved last

  bool was_moved(const vert_t<M>& v) {
    const std::size_t i = index_of(tets_.mesh, v);
    if (i >= moved_.size()) moved_.resize(std::max(i + 1, 2 * moved_.size()));
    return std::exchange(moved_[i], tets_.round) == tets_.round;
  }

  bool try_move(const vert_t<M>& v) {
    if (tets_.fixed.has(tets_.mesh, v) || was_moved(v)) return false;
    surroundings_.clear();
    for (const poly_t<M> p : adj_v2p(tets_.mesh, v)) {
      const tet_corners<M> t = tets_.corners(p);
      tets_.add_face(surroundings_, t, t.place_of(v));
    }
    vec3 x = tets_.at(v);
    const double before = surroundings_.quality_at(x);
    if (!is_better(surroundings_.maximise(x), before)) return false;
    set_point(tets_.mesh, v, tets_.to_mesh(x));
    tets_.mark_around(v);
    return true;
  }

  /// Collapses e into one of its ends, which stays as it is.
  bool try_collapse(const edge_t<M>& e, bool keeps_second) {
    M& m = tets_.mesh;
    const auto ends = end_verts(m, e);
    const vert_t<M> a = keeps_second ? ends.second : ends.first, b = keeps_second ? ends.first : ends.second;
    if (tets_.fixed.has(m, b)) return false;
    const vec3 x = tets_.at(a);
    double before = 1, after = 1;
    for (const poly_t<M> p : adj_v2p(m, b)) before = std::min(before, tets_.quality(p));
    for (const poly_t<M> p : adj_v2p(m, b)) {
      const tet_corners<M> t = tets_.corners(p);
      if (!t.has(a)) after = std::min(after, tets_.quality(t, t.place_of(b), x));
      if (!is_better(after, before)) return false;
    }
    if (!edge_collapse(m, e, {.at = keeps_second ? 1.0 : 0.0, .keeps_second = keeps_second})) return false;
    tets_.mark_around(a);
    return true;
  }
  bool try_collapse(const poly_t<M>& p) {
    core::small_array<edge_t<M>, 6> all;
    for (const edge_t<M> e : adj_p2e(tets_.mesh, p)) all.push_back(e);
    for (const edge_t<M>& e : all)
      if (try_collapse(e, false) || try_collapse(e, true)) return true;
    return false;
  }

  /// The tets that shall become better and near which something has changed, the worst first.
  std::vector<std::pair<double, poly_t<M>>> bad_tets() const {
    std::vector<std::pair<double, poly_t<M>>> found;
    for (const poly_t<M> p : polys(tets_.mesh)) {
      const tet_corners<M> t = tets_.corners(p);
      if (!tets_.has_changed(t)) continue;
      if (const double q = tets_.quality(t); q < target_) found.emplace_back(q, p);
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return found;
  }

  /// Calls f for all bad tets that are still as they were, until it returns false.
  template<class F>
  void for_each_bad(const F& f) {
    const auto all = bad_tets();
    for (std::size_t i = 0; i < all.size(); ++i)
      if (contains(tets_.mesh, all[i].second) && tets_.quality(all[i].second) == all[i].first)
        f(all[i].second, static_cast<double>(i) / static_cast<double>(all.size()));
  }

 public:
  std::size_t num_flips = 0, num_moves = 0, num_collapses = 0, num_new_verts = 0;

  tet_improver(improvable_tets<M>& tets, double target)
      : tets_(tets), flips_(tets), insertion_(tets), target_(target) {}

  std::size_t num_edits() const { return num_flips + num_moves + num_collapses + num_new_verts; }

  /// report(the part of the step that is done)
  template<class F>
  void flip_and_move(const F& report) {
    for_each_bad([&](const poly_t<M>& p, double done) {
      report(done);
      if (flips_.improve(p)) {
        ++num_flips;
        return;
      }
      for (const vert_t<M>& v : tets_.corners(p).verts) num_moves += try_move(v);
    });
  }
  template<class F>
  void collapse_and_insert(bool may_insert, const F& report) {
    for_each_bad([&](const poly_t<M>& p, double done) {
      report(done);
      if (try_collapse(p)) ++num_collapses;
      else if (may_insert && insertion_.improve(p)) ++num_new_verts;
    });
  }
};

}  // namespace concino::detail
