// Bodies of volume_exits.hpp: where a line along a field leads on from a vert or an edge of a volume: into a cell,
// along a face, or along an edge.
#pragma once

#include <concino/core/small_array.hpp>
#include <concino/lines/detail/cells/line_signs.hpp>
#include <concino/lines/detail/cells/volume_exit_search.hpp>
#include <concino/lines/detail/cells/volume_exits.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace concino::detail {

CONCINO_INLINE bool is_side(const incident_triangle& t, const incident_key& edge) {
  return t.side_a == edge || t.side_b == edge;
}

/// The cells around an edge, with the two triangles of each at the edge. Reuses its memory from edge to edge.
class cells_around_edge {
  struct numbers_among_all {
    std::size_t cell = 0;
    std::vector<std::size_t> triangles;
  };

  std::vector<incident_cell> cells_;
  std::vector<numbers_among_all> numbers_;
  std::size_t size_ = 0;  // those in front are of the edge

 public:
  void find(const incident_key& edge, std::span<const incident_cell> all) {
    size_ = 0;
    for (std::size_t c = 0; c < all.size(); ++c) {
      if (size_ == cells_.size()) {
        cells_.emplace_back();
        numbers_.emplace_back();
      }
      incident_cell& part = cells_[size_];
      numbers_among_all& numbers = numbers_[size_];
      part.field = all[c].field;
      part.triangles.clear();
      numbers.cell = c;
      numbers.triangles.clear();
      for (std::size_t t = 0; t < all[c].triangles.size(); ++t)
        if (is_side(all[c].triangles[t], edge)) {
          part.triangles.push_back(all[c].triangles[t]);
          numbers.triangles.push_back(t);
        }
      if (!part.triangles.empty()) ++size_;
    }
  }

  std::span<const incident_cell> cells() const { return std::span(cells_).first(size_); }

  /// The exit with the numbers of cell and triangle among all.
  volume_exit among_all(volume_exit x) const {
    const numbers_among_all& numbers = numbers_[x.cell];
    x.triangle = numbers.triangles[x.triangle];
    x.cell = numbers.cell;
    return x;
  }

  /// Whether each face at the edge has two cells.
  bool is_closed() const {
    core::small_array<incident_key, 64> faces;
    for (const incident_cell& c : cells())
      for (const incident_triangle& t : c.triangles) faces.push_back(t.face);
    std::sort(faces.begin(), faces.end());
    for (std::size_t i = 0; i < faces.size(); i += 2)
      if (i + 1 == faces.size() || faces[i] != faces[i + 1] || (i + 2 < faces.size() && faces[i] == faces[i + 2]))
        return false;
    return true;
  }
};

/// Whether the field of a cell leads into it from the edge at which it has two triangles.
CONCINO_INLINE bool leads_between(const vec3& from, const incident_key& edge, const incident_cell& c) {
  if (c.triangles.size() != 2) return false;
  const incident_triangle &one = c.triangles[0], &two = c.triangles[1];
  const bool below_one = side_of_line(c.field, one.a, one.b, from).sign < 0,
             below_two = side_of_line(c.field, two.a, two.b, from).sign < 0;
  const bool is_reflex = side_of_line((one.side_a == edge ? one.b : one.a) - from, two.a, two.b, from).sign > 0;
  return is_reflex ? below_one || below_two : below_one && below_two;
}

/// The speed along the edge of what does not lead off it: of a field exactly along the edge, else, inside, the mean of
/// all.
CONCINO_INLINE double speed_along_edge(const vec3& from, const vec3& to, const cells_around_edge& around) {
  const double length = distance(from, to);
  core::small_array<double, 32> speeds;
  double parallel = 0;
  for (const incident_cell& c : around.cells()) {
    bool is_parallel = c.field != vec3();
    for (const incident_triangle& t : c.triangles)
      is_parallel = is_parallel && side_of_line(c.field, t.a, t.b, from).sign == 0;
    const double speed = dot(c.field, to - from) / length;
    speeds.push_back(speed);
    if (is_parallel && std::abs(speed) > std::abs(parallel)) parallel = speed;
  }
  if (parallel != 0 || !around.is_closed()) return parallel;
  std::sort(speeds.begin(), speeds.end());  // so that their order does not change the sum
  double sum = 0;
  for (const double s : speeds) sum += s;
  return sum / static_cast<double>(speeds.size());
}

/// The exit from an edge between incident cells, with both directions along it.
CONCINO_INLINE volume_exit exit_from_edge(const vec3& from, const vec3& to, const incident_key& edge,
                                          std::span<const incident_cell> all, cells_around_edge& around) {
  around.find(edge, all);
  const std::span<const incident_cell> cells = around.cells();
  if (from == to || cells.empty()) return {};
  volume_exit_search search(from, cells);
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (const vec3& g = cells[c].field; leads_between(from, edge, cells[c]))
      search.keep_if_faster(volume_exit::kind::cell, c, 0, norm(g), g);
  search.for_each_slide([&](const incident_facet& f, const vec3& velocity) {
    const incident_triangle& t = search.triangle(f);
    const bool edge_is_a = t.side_a == edge;
    const int s = side_in_plane(velocity, edge_is_a ? t.a : t.b, cross(t.a - from, t.b - from), from).sign;
    if (edge_is_a ? s < 0 : s > 0)
      search.keep_if_faster(volume_exit::kind::triangle, f.cell, f.triangle, norm(velocity), velocity);
  });
  volume_exit best = search.best();
  if (best.to != volume_exit::kind::none) return around.among_all(best);
  const double speed = speed_along_edge(from, to, around);
  if (speed == 0) return {};
  best.to = speed > 0 ? volume_exit::kind::edge : volume_exit::kind::edge_back;
  best.velocity = speed / distance(from, to) * (to - from);
  best.along_a = cells[0].triangles[0].side_a == edge;
  return around.among_all(best);
}

CONCINO_INLINE volume_exit steepest_exit(const vec3& from, const vec3& to, const incident_key& edge,
                                         std::span<const incident_cell> cells) {
  cells_around_edge around;
  return exit_from_edge(from, to, edge, cells, around);
}

CONCINO_INLINE volume_exit steepest_exit(const vec3& from, std::span<const incident_cell> cells) {
  volume_exit_search search(from, cells);
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (search.leads_into(cells[c]))
      search.keep_if_faster(volume_exit::kind::cell, c, 0, norm(cells[c].field), cells[c].field);
  search.for_each_slide([&](const incident_facet& f, const vec3& velocity) {
    if (search.leads_along_triangle(search.triangle(f), velocity))
      search.keep_if_faster(volume_exit::kind::triangle, f.cell, f.triangle, norm(velocity), velocity);
  });
  std::vector<incident_key> asked;
  cells_around_edge around;
  for (const incident_cell& c : cells)
    for (const incident_triangle& t : c.triangles)
      for (const auto& [edge, to] : {std::pair(t.side_a, t.a), std::pair(t.side_b, t.b)}) {
        if (std::find(asked.begin(), asked.end(), edge) != asked.end()) continue;
        asked.push_back(edge);
        const volume_exit x = exit_from_edge(from, to, edge, cells, around);
        if (x.to == volume_exit::kind::edge)
          search.keep_if_faster(x.to, x.cell, x.triangle, norm(x.velocity), x.velocity, x.along_a);
      }
  return search.best();
}

}  // namespace concino::detail
