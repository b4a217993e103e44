// The windows on shortest paths, each with the window or vert from which it comes.
#pragma once

#include <concino/core/unfolded_triangles.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace concino::detail {

/// A tree of windows. It keeps only the ancestors of arrivals and of windows that are still to be crossed.
///
/// The predecessor of a path is one number: a node of the tree, at_vert(v), at_point (the source inside a triangle), or
/// none (a source vert).
class path_tree {
 public:
  static constexpr int at_point = std::numeric_limits<int>::min();
  static constexpr int none = at_point + 1;
  static constexpr int at_vert(int v) { return -1 - v; }

  /// A window on a side. The (virtual) source lies at x along the side and y perpendicular to it, away from the
  /// triangle of the side.
  struct node {
    double x, y;
    int side, from;
  };
  /// A point of a path: at a vert; or along a side if vert is -1; or at the position of the source if side is -1 too.
  struct stop {
    int vert, side;
    double along;
  };

 private:
  struct counted {
    node window;
    int uses;
  };
  std::vector<counted> nodes_;
  std::vector<int> unused_, arrival_;
  stop source_point_{-1, -1, 0};

  counted& at(int i) { return nodes_[static_cast<std::size_t>(i)]; }
  void use(int i) {
    if (i >= 0) ++at(i).uses;
  }

 public:
  explicit path_tree(std::size_t num_verts) : arrival_(num_verts, none) {}

  /// Adds a window that is still to be crossed. Call release(node) once it has been crossed.
  int add(const node& window) {
    int i = static_cast<int>(nodes_.size());
    if (unused_.empty()) {
      nodes_.push_back({window, 1});
    } else {
      i = unused_.back();
      unused_.pop_back();
      at(i) = {window, 1};
    }
    use(window.from);
    return i;
  }
  void release(int i) {
    while (i >= 0 && --at(i).uses == 0) {
      unused_.push_back(i);
      i = at(i).window.from;
    }
  }
  /// The source lies on a side, at this fraction of its length.
  void start_on(int side, double along) { source_point_ = {-1, side, along}; }
  /// Records `from` as the predecessor of the shortest known path to vert v.
  void arrive(int v, int from) {
    use(from);
    release(std::exchange(arrival_[static_cast<std::size_t>(v)], from));
  }

  /// The path from its source to vert v, which must have been reached. Its pieces are straight; each lies in one
  /// triangle or along an edge.
  std::vector<stop> path_to(const core::unfolded_triangles& t, int v) const {
    std::vector<stop> r{{v, -1, 0}};
    int from = arrival_[static_cast<std::size_t>(v)];
    while (from != none) {
      if (from == at_point) {
        r.push_back(source_point_);
        break;
      }
      if (from < 0) {
        add_stop(r, {-1 - from, -1, 0});
        from = arrival_[static_cast<std::size_t>(-1 - from)];
      } else {
        from = straight_from(t, from, r);
      }
    }
    std::reverse(r.begin(), r.end());
    return r;
  }

 private:
  static void add_stop(std::vector<stop>& r, const stop& s) {
    if (s.vert < 0 || r.back().vert != s.vert) r.push_back(s);
  }

  /// Follows a path from the apex of a window's triangle back through the preceding windows, on the straight line to
  /// their source.
  int straight_from(const core::unfolded_triangles& t, int i, std::vector<stop>& r) const {
    constexpr double at_end = 1e-14;  // as a fraction of a side: points nearer to an end are at the vert
    const node* w = &nodes_[static_cast<std::size_t>(i)].window;
    core::unfolded_triangles::plane_point p = t.apex[static_cast<std::size_t>(w->side)];
    while (true) {
      const double size = t.length[static_cast<std::size_t>(w->side)];
      const double part = std::clamp((w->x + (p.x - w->x) * (w->y / (w->y + p.y))) / size, 0.0, 1.0);
      if (part <= at_end) add_stop(r, {t.start(w->side), -1, 0});
      else if (part >= 1 - at_end) add_stop(r, {t.end(w->side), -1, 0});
      else r.push_back({-1, w->side, part});
      if (w->from < 0) return w->from;
      const node* before = &nodes_[static_cast<std::size_t>(w->from)].window;
      const auto edge = [&](int s) { return t.edge[static_cast<std::size_t>(s)]; };
      const int right = core::unfolded_triangles::next(before->side);
      const bool is_right = edge(right) == edge(w->side);
      const int side = is_right ? right : core::unfolded_triangles::previous(before->side);
      // fraction along the same edge, from the start of this side
      const double along = t.start(side) == t.start(w->side) ? part : 1 - part;
      const core::unfolded_triangles::plane_point top = t.apex[static_cast<std::size_t>(before->side)];
      const double base = t.length[static_cast<std::size_t>(before->side)];
      p = is_right ? core::unfolded_triangles::plane_point{base + along * (top.x - base), along * top.y}
                   : core::unfolded_triangles::plane_point{(1 - along) * top.x, (1 - along) * top.y};
      w = before;
    }
  }
};

}  // namespace concino::detail
