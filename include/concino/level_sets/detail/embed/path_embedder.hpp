// Makes a path on a surface edges of it.
#pragma once

#include <concino/concepts/oriented_edges.hpp>
#include <concino/edit/replace_polys.hpp>
#include <concino/level_sets/detail/embed/add_edge_between.hpp>
#include <concino/level_sets/detail/embed/path_places.hpp>
#include <concino/level_sets/detail/embed/polygon_splitter.hpp>
#include <concino/level_sets/detail/embed/triangle_part.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

/// Reads the points of one path, and then cuts the polys of m along it.
template<class M>
class path_embedder {
  struct step {
    std::uint32_t from, to;  // places
  };
  static constexpr std::uint32_t is_new = 0x80000000;  // the bit of new verts, which are numbered after all others

  M& m_;
  path_places<M> path_;
  std::vector<step> steps_;  // along the path, each an edge of the result
  core::local_numbers poly_numbers_, vert_numbers_;
  std::vector<poly_t<M>> polys_;            // those that change
  std::vector<std::vector<step>> cuts_;     // by poly
  std::vector<vert_t<M>> verts_;
  std::vector<std::uint32_t> number_;       // of the vert at each place
  std::vector<vec3> points_;
  correspondence from_;
  std::vector<unsigned> corners_, ends_, more_corners_, more_ends_;  // of the first part of each poly, and of the
                                                                     // others
  std::vector<std::uint32_t> more_polys_;                            // by other part: its poly

 public:
  explicit path_embedder(M& m) : m_(m), path_(m) {}

  template<class X>
  void add_point(const X& x) { path_.add(x, path_.place_of_point.size()); }

  /// Fills in the edges, the verts by point, and the new verts.
  void run(bool closed, std::vector<edge_t<M>>& edges, std::vector<vert_t<M>>& verts,
           std::vector<vert_t<M>>& new_verts) {
    const auto& points = path_.place_of_point;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) add_segment(i, i + 1);
    if (closed && points.size() > 2) add_segment(points.size() - 1, 0);
    for (const edge_t<M>& e : path_.edges)
      for (const poly_t<M> p : adj_e2p(m_, e)) number_of_poly(p);
    divide_steps_along_edges();
    number_places();
    cut_polys();

    edges.reserve(steps_.size()), verts.reserve(points.size());
    new_verts.resize(points_.size());
    std::vector<poly_t<M>> made(ends_.size());
    const cavity<M> c{span(polys_), span(verts_), span(points_), span(corners_), span(ends_), {}, polys_.size(), 0};
    if (const permission p = can_replace_polys(m_, c); !p) core::throw_joined<unsupported>({"embed_path: ", p.why});
    replace_polys(m_, c, cavity_result<M>{new_verts.data(), made.data()}, from_, {}, [] {});
    const auto vert_at = [&](std::uint32_t place) {
      return number_[place] & is_new ? new_verts[number_[place] ^ is_new] : verts_[number_[place]];
    };
    for (const std::uint32_t place : points) verts.push_back(vert_at(place));
    for (const step& s : steps_) add_edge_between(m_, vert_at(s.from), vert_at(s.to), edges);
  }

 private:
  template<class T>
  static id_span<T> span(const std::vector<T>& v) { return {v.data(), v.data() + v.size()}; }

  std::size_t number_of_poly(const poly_t<M>& p) {
    const unsigned n = poly_numbers_.add(index_of(m_, p));
    if (n == polys_.size()) {
      polys_.push_back(p);
      cuts_.emplace_back();
    }
    return n;
  }
  unsigned number_of_vert(const vert_t<M>& v) {
    const unsigned n = vert_numbers_.add(index_of(m_, v));
    if (n == verts_.size()) verts_.push_back(v);
    return n;
  }

  void add_segment(std::size_t i, std::size_t next) {
    const std::uint32_t a = path_.place_of_point[i], b = path_.place_of_point[next];
    if (a == b) return;
    steps_.push_back({a, b});
    if (path_.common_edge(a, b)) return;
    const auto p = path_.common_poly(a, b);
    if (!p)
      core::throw_joined<invalid_argument>({"embed_path: no poly has both point ", i, " and point ", next,
                                            "; a path needs a point on each edge that it crosses"});
    cuts_[number_of_poly(*p)].push_back({a, b});
  }
  void divide_steps_along_edges() {
    std::vector<step> all;
    for (const step& s : steps_) {
      if (const auto e = path_.common_edge(s.from, s.to))
        path_.for_each_step(*e, s.from, s.to, [&](std::uint32_t a, std::uint32_t b) { all.push_back({a, b}); });
      else all.push_back(s);
    }
    steps_ = std::move(all);
  }

  void number_places() {
    for (const auto& x : path_.places) {
      if (x.vert) {
        number_.push_back(number_of_vert(*x.vert));
        continue;
      }
      number_.push_back(is_new | static_cast<std::uint32_t>(points_.size()));
      const auto ends = end_verts(m_, x.edge);
      const vec3 a = to_vec3(point(m_, ends.first)), b = to_vec3(point(m_, ends.second));
      points_.push_back(a + x.parameter * (b - a));
      from_.verts.add({{static_cast<std::uint32_t>(index_of(m_, ends.first)), 1 - x.parameter},
                       {static_cast<std::uint32_t>(index_of(m_, ends.second)), x.parameter}});
    }
  }

  /// Lists the corners of poly k, with the points on its edges. on_edges: for triangles, a bit for each edge on which a
  /// corner is.
  void read_corners(std::uint32_t k, std::vector<std::uint32_t>& corners, std::vector<unsigned char>& on_edges) {
    corners.clear(), on_edges.clear();
    unsigned edge = 0, before = 2;  // the last edge of a triangle
    for (const auto& [e, from, to] : oriented_edges(m_, polys_[k])) {
      corners.push_back(number_of_vert(from));
      on_edges.push_back(static_cast<unsigned char>(1u << edge | 1u << before));
      const auto inside = path_.places_on(e);
      const bool forward = end_verts(m_, e).first == from;
      for (std::size_t i = 0; i < inside.size(); ++i) {
        corners.push_back(number_[inside[forward ? i : inside.size() - 1 - i]]);
        on_edges.push_back(static_cast<unsigned char>(1u << edge));
      }
      before = edge;
      edge = (edge + 1) % 8;
    }
  }
  vec3 position(std::uint32_t n) const { return n & is_new ? points_[n ^ is_new] : to_vec3(point(m_, verts_[n])); }

  void cut_polys() {
    polygon_splitter splitter;
    std::vector<std::uint32_t> corners;
    std::vector<unsigned char> on_edges;
    std::vector<part_corner> part_corners;
    for (std::uint32_t k = 0; k < polys_.size(); ++k) {
      read_corners(k, corners, on_edges);
      splitter.start(corners);
      for (const step& s : cuts_[k])
        if (!splitter.split(number_[s.from], number_[s.to]))
          core::throw_joined<invalid_argument>({"embed_path: the path crosses itself inside poly ",
                                                index_of(m_, polys_[k]), "; embed its parts one after another"});
      bool is_first = true;
      for (std::size_t i = 0; i < splitter.num_parts(); ++i) {
        if constexpr (arity_v<M> == 0) {  // a part of a triangle is cut to triangles
          add_poly(k, splitter.part(i), is_first);
        } else {
          part_corners.clear();
          for (const std::uint32_t n : splitter.part(i))
            part_corners.push_back(
                {n, on_edges[static_cast<std::size_t>(std::find(corners.begin(), corners.end(), n) - corners.begin())],
                 position(n)});
          triangulate_part(part_corners,
                           [&](const std::array<std::uint32_t, 3>& triangle) { add_poly(k, triangle, is_first); });
        }
      }
      from_.polys.add(static_cast<std::uint32_t>(index_of(m_, polys_[k])));
    }
    for (const std::uint32_t k : more_polys_) from_.polys.add(static_cast<std::uint32_t>(index_of(m_, polys_[k])));
    for (const unsigned end : more_ends_) ends_.push_back(static_cast<unsigned>(corners_.size()) + end);
    corners_.insert(corners_.end(), more_corners_.begin(), more_corners_.end());
    for (unsigned& n : corners_)
      if (n & is_new) n = (n ^ is_new) + static_cast<unsigned>(verts_.size());
  }
  void add_poly(std::uint32_t old, std::span<const std::uint32_t> part, bool& is_first) {
    std::vector<unsigned>& corners = is_first ? corners_ : more_corners_;
    corners.insert(corners.end(), part.begin(), part.end());
    (is_first ? ends_ : more_ends_).push_back(static_cast<unsigned>(corners.size()));
    if (!is_first) more_polys_.push_back(old);
    is_first = false;
  }
};

}  // namespace concino::detail
